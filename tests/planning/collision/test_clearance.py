"""Distances of bodies with known answers, along moves too."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from measureapp.data.rig import RigDescription
from measureapp.planning.collision.bodies import FIXED, FLANGE, Body, Kind
from measureapp.planning.collision.clearance import Encounter, Scene, Sweep
from measureapp.planning.collision.motion import Mechanism, Placement
from measureapp.planning.collision.solids import Solid, box, capsule, cylinder, hull
from measureapp.project.rig_file import read_rig

RIG: RigDescription = read_rig("paper")
CUBE = box((-50, -50, -50), (50, 50, 50))


def scene(moving: Solid, standing: Solid, clearance_mm: float = 15.0) -> Scene:
    bodies = (Body("cube", Kind.HEAD, FLANGE, moving, np.eye(4)), Body("post", Kind.OBSTACLE, FIXED, standing, np.eye(4)))
    return Scene.of(bodies, clearance_mm, Mechanism(RIG, None))


def at(x_mm: float, y_mm: float = 0.0, z_mm: float = 0.0, rotation: np.ndarray | None = None, guide_mm: float = 0.0) -> Placement:
    pose = np.eye(4)
    pose[:3, 3] = x_mm, y_mm, z_mm
    if rotation is not None:
        pose[:3, :3] = rotation
    return Placement(pose, None, guide_mm, 0.0)


def least_mm(moving: Solid, standing: Solid, place: Placement) -> float:
    return max(0.0, float(Sweep(scene(moving, standing), place, place).distances_mm()[0]))


def encounter(standing: Solid, start: Placement, end: Placement, *, leaving: bool = False) -> Encounter | None:
    return Sweep(scene(CUBE, standing), start, end).first_encounter(leaving=leaving)


@pytest.mark.parametrize(
    ("standing", "place", "expected_mm"),
    [
        (box((100, -10, -10), (120, 10, 10)), at(0), 50.0),
        (box((100, -10, -10), (120, 10, 10), 10.0), at(0), 40.0),
        (box((80, 90, -10), (120, 120, 10)), at(0), 50.0),  # edge to edge: 30, 40
        (cylinder((200, 0, -300), 60, 600), at(0), 90.0),
        (cylinder((0, 0, 70), 60, 100), at(10, 20), 20.0),
        (capsule((150, 0, -200), (150, 0, 200), 30), at(0), 70.0),
        (capsule((100, 0, 250), (300, 0, 250), 10), at(0, 0, 160), np.hypot(50.0, 40.0) - 10.0),
        (hull(np.array([[80.0, 0, 0], [180, 90, 0], [180, -90, 0], [180, 0, 90], [180, 0, -90]])), at(0), 30.0),
        (box((40, -10, -10), (60, 10, 10)), at(0), 0.0),
    ],
)
def test_distances_of_solids_are_the_known_ones(standing: Solid, place: Placement, expected_mm: float) -> None:
    assert least_mm(CUBE, standing, place) == pytest.approx(expected_mm, abs=1e-3)


def test_a_hull_of_many_points_never_lies_inside_them() -> None:
    points = np.random.default_rng(5).normal(size=(20_000, 3)) * [100.0, 60.0, 30.0]
    found = hull(points)
    for direction in np.vstack([np.eye(3), -np.eye(3)]):
        apart_mm = float((points @ direction).max()) + 100.0
        distance_mm = least_mm(box((-1, -1, -1), (1, 1, 1)), found, at(*(direction * (apart_mm + 1.0))))
        assert distance_mm <= 100.0 + 1e-6 + np.hypot(100, 100)
    assert found.margin_mm < 20.0


def test_a_move_that_is_free_at_both_ends_and_hits_between_is_found_with_its_place() -> None:
    post = box((290, -30, -200), (310, 30, 200))
    assert encounter(post, at(0), at(0)) is None
    assert encounter(post, at(600), at(600)) is None
    found = encounter(post, at(0), at(600))
    assert found is not None
    assert (found.first, found.second, found.kept_mm) == ("cube", "post", 15.0)
    assert found.share * 600.0 == pytest.approx(225.0, abs=3.0)  # 15 mm in front of the post
    assert "the cube would come within 1" in found.words()


def test_what_passes_beside_keeps_its_clearance_or_is_told() -> None:
    post = box((290, 70, -200), (310, 90, 200))
    assert encounter(post, at(0), at(600)) is None  # 20 mm
    found = encounter(post, at(0, 10), at(600, 10))  # 10 mm
    assert found is not None
    assert found.distance_mm == pytest.approx(np.hypot(10.0, 290 - 50 - found.share * 600.0), abs=0.5)


def test_a_turn_is_followed_although_the_corners_move_further_than_the_middle() -> None:
    blade = box((-400, -5, -5), (400, 5, 5))
    post = box((280, 280, -20), (300, 300, 20))
    ends = at(0), at(0, rotation=Rotation.from_euler("z", 90, degrees=True).as_matrix())
    assert all(Sweep(scene(blade, post), end, end).first_encounter() is None for end in ends)
    found = Sweep(scene(blade, post), *ends).first_encounter()
    assert found is not None
    assert 30.0 < found.share * 90.0 < 45.0


def test_the_guide_carries_what_the_robot_holds() -> None:
    post = box((-20, 290, -20), (20, 310, 20))
    assert encounter(post, at(0), at(0, guide_mm=600.0)) is not None
    assert encounter(post, at(0), at(0, guide_mm=200.0)) is None


def test_bodies_that_are_too_close_may_move_apart_but_not_closer() -> None:
    post = box((58, -10, -10), (70, 10, 10))  # 8 mm
    assert encounter(post, at(0), at(-100)) is not None
    assert encounter(post, at(0), at(-100), leaving=True) is None
    assert encounter(post, at(0), at(5), leaving=True) is not None
    overlapping = box((40, -10, -10), (70, 10, 10))
    assert encounter(overlapping, at(0), at(-100), leaving=True) is None


boxes = st.tuples(*[st.floats(5, 120)] * 3).map(np.array)
spots = st.tuples(*[st.floats(-400, 400)] * 3).map(np.array)
turns = st.tuples(*[st.floats(-3, 3)] * 3).map(lambda vector: Rotation.from_rotvec(vector).as_matrix())


@settings(deadline=None, max_examples=30)
@given(boxes, boxes, spots, spots, turns, turns)
def test_no_sample_of_a_free_move_of_random_boxes_is_closer_than_allowed(half, other, start, end, first, last) -> None:
    """Compared with the separating axes of two boxes, which python-fcl has no part in."""
    made = scene(box(-half, half), box(-other, other))
    places = at(*start, rotation=first), at(*end, rotation=last)
    found = Sweep(made, *places).first_encounter()
    shares = np.linspace(0.0, 1.0, 41)
    frames = made.mechanism.frames(*places, shares)[:, FLANGE]
    gaps = np.array([separation_mm(half, other, frame) for frame in frames])
    if found is None:
        assert gaps.max() > 0.0
        assert (np.array([true_gap_mm(half, other, frame) for frame in frames]) > 15.0 - 2.0 - 0.1).all()
    else:
        hit = made.mechanism.frames(*places, np.array([found.share]))[0, FLANGE]
        assert separation_mm(half, other, hit) <= 15.0 + 1e-3


@settings(deadline=None)
@given(boxes, boxes, spots, turns)
def test_the_distance_of_random_boxes_is_that_of_their_nearest_points(half, other, spot, turn) -> None:
    place = at(*spot, rotation=turn)
    expected_mm = true_gap_mm(half, other, place.base_from_flange)
    assume(expected_mm > 0.1)
    found_mm = least_mm(box(-half, half), box(-other, other), place)
    assert expected_mm - 0.05 - 0.003 * expected_mm < found_mm < expected_mm + 1e-3


def separation_mm(half: np.ndarray, other: np.ndarray, pose: np.ndarray) -> float:
    """Largest gap of the projections on the 15 axes that can separate two boxes: a lower bound of their distance; negative if they overlap."""
    rotation, offset = pose[:3, :3], pose[:3, 3]
    axes = [*np.eye(3), *rotation.T, *(np.cross(one, two) for one in np.eye(3) for two in rotation.T)]
    gaps = []
    for axis in axes:
        if (length := np.linalg.norm(axis)) > 1e-6:
            unit = axis / length
            gaps.append(abs(offset @ unit) - np.abs(unit) @ other - np.abs(rotation.T @ unit) @ half)
    return float(max(gaps))


@pytest.mark.parametrize("offset", [(0, 0, 30), (0, 0, -115), (30, 0, 40), (200, 5, 0), (-80, 60, 0)])
def test_boxes_square_to_each_other_are_not_further_apart_than_they_are(offset: tuple[int, int, int]) -> None:
    """python-fcl alone states up to 60 mm too much for some of these."""
    half, other = np.array([5.0, 5.0, 5.0]), np.array([38.0, 6.0, 5.0])
    place = at(*offset)
    assert least_mm(box(-half, half), box(-other, other), place) == pytest.approx(
        true_gap_mm(half, other, place.base_from_flange), abs=1e-3
    )


def true_gap_mm(half: np.ndarray, other: np.ndarray, pose: np.ndarray) -> float:
    """Distance of two boxes as a bounded least-squares problem; 0 if they overlap."""
    from scipy.optimize import lsq_linear

    matrix = np.hstack([pose[:3, :3], -np.eye(3)])
    bound = np.concatenate([half, other])
    return float(np.linalg.norm(lsq_linear(matrix, -pose[:3, 3], (-bound, bound), tol=1e-12).fun))
