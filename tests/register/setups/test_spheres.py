"""Set-ups joined by reference spheres that are fastened to the part."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.register.setups.join import JoinRequest, join_setups
from measureapp.register.setups.spheres import Sphere, find_spheres, match_spheres
from tests.register.setups.scanned_setups import bracket, put, set_up
from tests.register.setups.test_join import error_mm

DIAMETER_MM = 20.0
PLACES = ((78.0, -20.0, 28.0), (-76.0, 30.0, 40.0), (12.0, 62.0, 33.0), (-25.0, -66.0, 45.0))
NAMES = ("up", "down")
SIGMA_MM = 0.005


def with_spheres(places: tuple[tuple[float, float, float], ...]) -> Any:
    import trimesh

    balls = []
    for place in places:
        ball = trimesh.creation.icosphere(4, DIAMETER_MM / 2)
        ball.apply_translation(place)
        balls.append(ball)
    return trimesh.util.concatenate([bracket(), *balls])


def spheres_at(centres: np.ndarray) -> list[Sphere]:
    return [Sphere(centre, SIGMA_MM**2 * np.eye(3), DIAMETER_MM / 2, np.arange(0)) for centre in centres]


@pytest.fixture(scope="module")
def scanned():
    mesh = with_spheres(PLACES)
    upright, part_from_nominal = put(mesh, (0.0, 0.0, 0.0))
    flipped, other_from_nominal = put(mesh, (180.0, 0.0, 25.0), (4.0, -3.0))
    return set_up("up", upright, 6), set_up("down", flipped, 7), part_from_nominal, other_from_nominal


def test_the_spheres_of_a_scan_are_found_at_their_places(scanned) -> None:
    up, _, part_from_nominal, _ = scanned
    found = find_spheres(up.stitched, DIAMETER_MM)
    expected = part_from_nominal.apply(np.array(PLACES))
    assert len(found) == len(PLACES)
    for sphere in found:
        off = np.linalg.norm(expected - sphere.centre_mm, axis=1).min()
        assert off < 0.02 + 4 * np.sqrt(np.linalg.eigvalsh(sphere.covariance_mm2)[-1])  # the facets lie inside the sphere


def test_set_ups_are_joined_by_their_spheres(scanned) -> None:
    up, down, part_from_nominal, other_from_nominal = scanned
    setup = join_setups([up, down], ("a", "a"), JoinRequest("spheres", sphere_diameter_mm=DIAMETER_MM)).setups[1]
    assert setup.method == "spheres"
    assert error_mm(setup.part_from_setup, part_from_nominal @ other_from_nominal.inverse()) < 0.05
    assert setup.sigma_mm < 0.02


@pytest.mark.parametrize("seed", range(20))
def test_the_assignment_is_found_for_any_motion_and_any_order(seed: int) -> None:
    rng = np.random.default_rng(seed)
    centres = np.array(PLACES)
    motion = RigidTransform.from_vector(rng.normal(size=3), rng.normal(0, 100, 3), "target", "source")
    order = rng.permutation(len(centres))
    moved = motion.inverse().apply(centres)[order] + SIGMA_MM * rng.normal(size=centres.shape)
    (match,) = match_spheres(spheres_at(centres), spheres_at(moved), NAMES)
    assert sorted(zip(match.target, match.source, strict=True)) == sorted((int(order[k]), k) for k in range(len(centres)))
    assert np.linalg.norm(RigidTransform(match.target_from_source, "target", "source").apply(moved) - centres[order], axis=1).max() < 0.05


def test_a_sphere_that_was_moved_contradicts_the_others() -> None:
    moved = np.array(PLACES)
    moved[2, 0] += 0.6
    with pytest.raises(RegistrationError, match=r"contradict each other: the sphere at \(.* mm is 0\.\d+ mm off the others"):
        match_spheres(spheres_at(np.array(PLACES)), spheres_at(moved), NAMES)


def test_spheres_of_another_arrangement_do_not_correspond() -> None:
    other = 1.2 * np.array(PLACES)
    with pytest.raises(RegistrationError, match="no three have the same distances"):
        match_spheres(spheres_at(np.array(PLACES)), spheres_at(other), NAMES)


def test_two_spheres_are_too_few() -> None:
    with pytest.raises(RegistrationError, match=r"Only 2 reference spheres were found in down; at least 3"):
        match_spheres(spheres_at(np.array(PLACES)), spheres_at(np.array(PLACES[:2])), NAMES)


def test_spheres_at_equal_distances_can_be_assigned_in_several_ways() -> None:
    centres = np.array([rotation_about([0, 0, 1], angle) @ [60.0, 0.0, 20.0] for angle in np.radians([0, 120, 240])])
    found = match_spheres(spheres_at(centres), spheres_at(centres), NAMES)
    assert len(found) == 6  # three rotations, each also turned over


def test_a_part_without_spheres_is_refused(turned_over) -> None:
    with pytest.raises(RegistrationError, match="reference spheres were found in up"):
        join_setups([turned_over.up, turned_over.down], ("a", "a"), JoinRequest("spheres", sphere_diameter_mm=DIAMETER_MM))


def test_spheres_of_another_diameter_are_not_taken_for_them(scanned) -> None:
    assert find_spheres(scanned[0].stitched, 31.0) == []
