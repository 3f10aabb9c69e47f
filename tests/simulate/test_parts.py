"""The sample parts have the dimensions they state, and closed, clean surfaces."""

from __future__ import annotations

from math import pi, sin

import numpy as np
import pytest
import trimesh
from scipy.spatial import cKDTree

from measureapp.errors import InputError
from measureapp.resources import resource
from measureapp.simulate.part import Part
from measureapp.simulate.parts import SAMPLES, make_part, stl_bytes
from measureapp.simulate.solids import CHORD_ERROR_MM


@pytest.fixture(scope="module", params=sorted(SAMPLES))
def part(request: pytest.FixtureRequest) -> Part:
    return make_part(request.param)


def corners_of(part: Part) -> np.ndarray:
    return part.mesh.vertices_mm


def test_a_sample_part_is_one_closed_surface_facing_outwards(part: Part) -> None:
    mesh = trimesh.Trimesh(part.mesh.vertices_mm, part.mesh.triangles, process=False)
    assert part.watertight
    assert mesh.is_watertight
    assert mesh.is_winding_consistent
    assert mesh.volume > 0
    assert mesh.body_count == 1


def test_a_sample_part_stands_on_its_origin(part: Part) -> None:
    low, high = corners_of(part).min(axis=0), corners_of(part).max(axis=0)
    np.testing.assert_allclose((low + high)[:2], 0.0, atol=0.01)
    assert low[2] == 0.0


def test_the_nominal_file_holds_the_surface_that_is_simulated(part: Part) -> None:
    """To float32; which diagonal halves a facet between points on one circle may differ between processors."""
    stored = trimesh.load(resource(f"parts/{part.name}/nominal.stl"), force="mesh")
    simulated = trimesh.Trimesh(part.mesh.vertices_mm, part.mesh.triangles, process=False)
    assert len(stored.faces) == len(simulated.faces)
    for first, second in ((stored, simulated), (simulated, stored)):
        assert cKDTree(first.vertices).query(second.vertices)[0].max() < 1e-5
    assert stored.volume == pytest.approx(simulated.volume, rel=1e-6)
    assert stored.area == pytest.approx(simulated.area, rel=1e-6)


def test_an_stl_file_holds_every_triangle_in_single_precision(part: Part) -> None:
    record = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    records = np.frombuffer(stl_bytes(part)[84:], record)
    np.testing.assert_array_equal(records["corners"], part.mesh.vertices_mm[part.mesh.triangles].astype(np.float32))
    np.testing.assert_allclose(np.linalg.norm(records["normal"], axis=1), 1.0, atol=1e-6)


def test_the_gypsum_has_the_volume_of_its_dimensions() -> None:
    part = make_part("gypsum")
    volume = trimesh.Trimesh(part.mesh.vertices_mm, part.mesh.triangles).volume
    a, b, c, d = (part.dimensions[name] for name in "abcd")
    assert volume == pytest.approx((a * c + (b - c) * c) * 50.0 + c * c * d)
    np.testing.assert_array_equal(np.ptp(corners_of(part), axis=0), [a, b, 50.0 + d])


def section_of(part: Part, height_mm: float) -> np.ndarray:
    """Places (N, 2), evenly dense along the walls at one height."""
    lines = trimesh.intersections.mesh_plane(
        trimesh.Trimesh(part.mesh.vertices_mm, part.mesh.triangles, process=False), [0, 0, 1], [0, 0, height_mm]
    )
    starts, steps = lines[:, 0, :2], np.diff(lines[:, :, :2], axis=1)[:, 0]
    number = np.repeat(np.arange(len(lines)), np.ceil(np.linalg.norm(steps, axis=1) / 0.002).astype(int))
    return starts[number] + np.random.default_rng(0).random((len(number), 1)) * steps[number]


def test_the_impeller_s_blades_are_as_thick_and_as_far_apart_as_stated() -> None:
    part = make_part("impeller")
    top = corners_of(part)[np.isclose(corners_of(part)[:, 2], 52.0)]
    radius = np.hypot(top[:, 0], top[:, 1])
    on_end, on_hub = np.isclose(radius, 130.0, atol=1e-4), np.isclose(radius, 45.0, atol=1e-4)
    flanks = top[~on_end & ~on_hub]
    gamma = 2 * pi * np.arange(7) / 7
    centres = 90.0 * np.column_stack([np.cos(gamma), np.sin(gamma)])
    distances = np.linalg.norm(flanks[:, None, :2] - centres, axis=2)
    off = np.minimum(np.abs(distances - 107.5), np.abs(distances - 112.5)).min(axis=1)
    np.testing.assert_allclose(off, 0.0, atol=CHORD_ERROR_MM)
    assert part.dimensions["blade_thickness"] == 112.5 - 107.5
    assert part.dimensions["blade_pitch"] == pytest.approx(86.776748, abs=1e-6)
    assert part.dimensions["blade_pitch"] == pytest.approx(2 * 100 * sin(pi / 7))
    assert on_end.any()


@pytest.mark.parametrize(
    ("name", "radius_mm", "height_mm"),
    [("impeller", 140.0, 6.0), ("impeller", 20.0, 30.0), ("impeller", 45.0, 58.0), ("gear", 35.0, 33.0)],
)
def test_round_walls_are_round_within_the_chord_error_and_on_average_exactly(name: str, radius_mm: float, height_mm: float) -> None:
    cut = section_of(make_part(name), height_mm)
    radius = np.hypot(*cut.T)
    on_wall = np.abs(radius - radius_mm) < 0.001
    assert np.abs(radius[on_wall] - radius_mm).max() <= CHORD_ERROR_MM
    assert abs(radius[on_wall].mean() - radius_mm) < CHORD_ERROR_MM / 50


def test_the_flanks_of_the_blades_are_on_average_where_they_are_stated() -> None:
    cut = section_of(make_part("impeller"), 30.0)
    cut = cut[np.abs(np.hypot(*cut.T) - 90.0) < 35.0]
    distances = np.linalg.norm(cut - [90.0, 0.0], axis=1)
    for radius_mm in (107.5, 112.5):
        flank = distances[(np.abs(distances - radius_mm) < 0.001) & (cut[:, 1] > 0)]
        assert len(flank) > 100
        assert abs(flank.mean() - radius_mm) < CHORD_ERROR_MM / 50


def test_the_gear_has_24_teeth_and_a_shiny_centre() -> None:
    part = make_part("gear")
    corners = corners_of(part)
    top = corners[np.isclose(corners[:, 2], 30.0) & np.isclose(np.hypot(corners[:, 0], corners[:, 1]), 80.0)]
    angles = np.sort(np.arctan2(top[:, 1], top[:, 0]))
    assert np.sum(np.diff(np.append(angles, angles[0] + 2 * pi)) > np.deg2rad(8.0)) == 24
    centres = part.mesh.vertices_mm[part.mesh.triangles].mean(axis=1)
    shiny = part.material == 1
    assert np.hypot(centres[shiny, 0], centres[shiny, 1]).max() < 45.0
    assert part.materials[1].gloss > part.materials[0].gloss


def test_the_spheres_are_round_to_a_few_micrometres_on_average_without_bias() -> None:
    part = make_part("sphere_plate")
    for centre in ((-80.0, -55.0), (0.0, 0.0), (80.0, 55.0)):
        middles = part.mesh.vertices_mm[part.mesh.triangles].mean(axis=1) - [*centre, 28.0]
        radius = np.linalg.norm(middles, axis=1)
        ball = radius[(np.abs(radius - 20.0) < 0.1) & (middles[:, 2] > -17.0)]
        assert np.abs(ball - 20.0).max() < 0.006
        assert abs(ball.mean() - 20.0) < 0.003
    assert part.dimensions["distance_1_2"] == 160.0
    assert part.dimensions["distance_1_5"] == pytest.approx(np.hypot(160.0, 110.0))


def test_an_unknown_name_is_refused_with_the_known_ones() -> None:
    with pytest.raises(InputError, match="gypsum"):
        make_part("teapot")
