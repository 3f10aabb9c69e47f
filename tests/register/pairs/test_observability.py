"""Motions that the surface does not hold are named."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.register.pairs.observability import find_unconstrained_motions
from measureapp.register.stitch import stitch

CENTRE = np.array([30.0, 0.0, 20.0])


def information(points: np.ndarray, normals: np.ndarray, sigma_mm: float = 0.05) -> np.ndarray:
    """Of shift and turn about CENTRE, from distances across a surface known to ``sigma_mm`` each."""
    jacobian = np.column_stack([normals, np.cross(points - CENTRE, normals)])
    return jacobian.T @ jacobian / sigma_mm**2


def test_a_plane_leaves_two_shifts_and_the_turn_about_its_normal() -> None:
    points = np.random.default_rng(0).uniform(-40, 40, (500, 3)) * [1, 1, 0] + CENTRE
    found = find_unconstrained_motions(information(points, np.tile([0.0, 0, 1], (500, 1))), CENTRE, 30.0, 0.1)
    assert len(found) == 3
    assert all("(0.00, 0.00, 1.00)" in one or "0.00)" in one for one in found)


def test_a_shaft_leaves_the_turn_about_its_own_axis_and_the_shift_along_it() -> None:
    rng = np.random.default_rng(1)
    angle, height = rng.uniform(0, 2 * np.pi, 800), rng.uniform(0, 40, 800)
    normals = np.column_stack([np.cos(angle), np.sin(angle), np.zeros(800)])
    points = 25 * normals + [[0, 0, 1]] * height[:, None]  # about the z axis, 30 mm beside the view's centre
    found = find_unconstrained_motions(information(points, normals), CENTRE, 30.0, 0.1)
    assert len(found) == 2
    held = information(points, normals) + np.diag([0, 0, 1e4, 0, 0, 0])  # a shoulder holds the shift
    assert find_unconstrained_motions(held, CENTRE, 30.0, 0.1) == ("rotation about (0.00, 0.00, 1.00) through (0, 0, 20) mm",)


def test_a_surface_that_holds_everything_leaves_nothing() -> None:
    rng = np.random.default_rng(2)
    normals = rng.normal(size=(400, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    assert find_unconstrained_motions(information(rng.uniform(-40, 40, (400, 3)) + CENTRE, normals), CENTRE, 30.0, 0.1) == ()


def test_a_turned_part_says_that_only_the_axes_hold_its_turn(scanned) -> None:
    import trimesh

    disc = trimesh.util.concatenate([trimesh.creation.cylinder(60, 20, sections=720), trimesh.creation.cylinder(25, 60, sections=360)])
    scan = scanned(disc, [60.0 * turn for turn in range(6)], [40.0], step_mm=1.0, station_mm=0.2, station_deg=0.01)
    for placement in stitch(scan.clouds, scan.kinematic).placements:
        assert len(placement.unconstrained_motions) == 1
        assert placement.unconstrained_motions[0].startswith("rotation about (0.00, 0.00, 1.00) through (")
        x, y, _ = (float(value) for value in placement.unconstrained_motions[0].rsplit("(", 1)[1].split(")")[0].split(","))
        assert np.hypot(x, y) < 3.0  # its own axis


@pytest.mark.parametrize("seed", [1, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (2, 3))])
def test_an_impeller_is_constrained_by_its_blades(scanned, impeller_mesh, seed: int) -> None:
    scan = scanned(impeller_mesh, [0.0, 60.0, 120.0, 180.0, 240.0, 300.0], [45.0], step_mm=1.0, seed=seed)
    assert all(not placement.unconstrained_motions for placement in stitch(scan.clouds, scan.kinematic).placements)
