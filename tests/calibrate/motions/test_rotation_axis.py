"""The axis is recovered by every method, and refused where the data do not show it."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.boards.pose import board_pose
from measureapp.calibrate.motions.axis_circles import distance_weights, fit_arcs, line_through
from measureapp.calibrate.motions.rotation_axis import AxisProblem, problem_from_poses, shortfalls, solve
from measureapp.data.calibration import RotationAxis
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform

AXIS = RotationAxis(np.array([170.0, 90.0, 600.0]), np.array([0.05, -0.8, -0.6]), "camera")
ANGLES = np.deg2rad(np.arange(-60.0, 61.0, 15.0))
START = RigidTransform.from_vector([0.3, -0.25, 0.1], [90, -20, 560], "camera", "board")


def turned_corners(board, angles=ANGLES, start=START):
    return np.array([AXIS.turned(angle).apply(start.apply(board.corners_mm)) for angle in angles])


def off_axis_mm(axis) -> float:
    away = axis.point_mm - AXIS.point_mm
    return float(np.linalg.norm(away - AXIS.direction * (away @ AXIS.direction)))


def angle_between(axis) -> float:
    return float(np.linalg.norm(np.cross(axis.direction, AXIS.direction)))


def test_every_method_is_exact_without_noise(board):
    solution = solve(AxisProblem(turned_corners(board), ANGLES))
    assert tuple(solution.estimates) == ("least_squares", "distance_weighted", "maximum_likelihood")
    for estimate in solution.estimates.values():
        assert angle_between(estimate.axis) < 1e-7
        assert off_axis_mm(estimate.axis) < 1e-5
        assert estimate.axis.direction @ AXIS.direction > 0


def test_errors_stay_within_the_predicted_standard_deviations(board):
    errors: dict[str, list[tuple[float, float]]] = {}
    for seed in range(12):
        noisy = turned_corners(board) + np.random.default_rng(seed).normal(scale=0.03, size=(9, 154, 3))
        for name, estimate in solve(AxisProblem(noisy, ANGLES)).estimates.items():
            axis = estimate.axis
            ratios = (angle_between(axis) / axis.direction_sigma_rad, off_axis_mm(axis) / axis.point_sigma_mm)
            errors.setdefault(name, []).append(ratios)
    for ratios in errors.values():  # two coordinates, of which the larger deviation counts: between 1 and √2
        assert np.all(np.sqrt(np.mean(np.square(ratios), axis=0)) < 1.8)
        assert np.all(np.sqrt(np.mean(np.square(ratios), axis=0)) > 0.6)


def test_pixels_of_all_cameras_give_a_better_axis_than_circles(head, board, simulate, generator):
    poses = [
        board_pose(simulate.corners(head, board, AXIS.turned(angle) @ START_IN_CAMERA, 0.05, generator), head, board, 0.05)
        for angle in ANGLES
    ]
    solution = solve(problem_from_poses(poses, board, list(ANGLES)))
    likely = solution.best.axis
    assert angle_between(likely) < 4 * likely.direction_sigma_rad
    assert off_axis_mm(likely) < 4 * likely.point_sigma_mm
    assert likely.direction_sigma_rad < solution.estimates["distance_weighted"].axis.direction_sigma_rad


START_IN_CAMERA = RigidTransform(START.matrix, "camera", "board")


def test_angles_are_estimated_where_none_were_read(board, generator):
    noisy = turned_corners(board) + generator.normal(scale=0.02, size=(9, 154, 3))
    solution = solve(AxisProblem(noisy))
    np.testing.assert_allclose(solution.best.angles_rad, ANGLES - ANGLES[0], atol=2e-4)
    assert angle_between(solution.best.axis) < 4 * solution.best.axis.direction_sigma_rad


def test_falling_angles_turn_the_direction_round(board):
    assert solve(AxisProblem(turned_corners(board), -ANGLES)).best.axis.direction @ AXIS.direction < -0.99
    assert solve(AxisProblem(turned_corners(board)[::-1])).best.axis.direction @ AXIS.direction < -0.99
    assert solve(AxisProblem(turned_corners(board)[::-1], ANGLES[::-1])).best.axis.direction @ AXIS.direction > 0.99


def test_a_whole_turn_keeps_its_sense(board):
    angles = np.deg2rad(np.arange(0.0, 360.0, 30.0))
    for sign in (1, -1):
        solution = solve(AxisProblem(turned_corners(board, angles), sign * angles))
        assert solution.best.axis.direction @ AXIS.direction * sign > 0.99


def test_weights_follow_the_chord_lengths():
    corners = np.array([[[1.0, 0, 0], [3.0, 0, 0]], [[0, 1.0, 0], [0, 3.0, 0]], [[-1.0, 0, 0], [-3.0, 0, 0]]])
    np.testing.assert_allclose(distance_weights(corners, 2.0), [0.25, 2.25])  # chords 1 : 3, mean 2
    np.testing.assert_allclose(distance_weights(corners, 0.0), [1.0, 1.0])


def test_three_positions_give_the_circle_through_them():
    angles = np.array([0.1, 0.9, 2.0])
    corners = np.column_stack([5 + 2 * np.cos(angles), 1 + 2 * np.sin(angles), np.full(3, 7.0)])[:, None]
    arcs = fit_arcs(corners)
    np.testing.assert_allclose(arcs.centres_mm, [[5, 1, 7]], atol=1e-12)
    np.testing.assert_allclose(arcs.radii_mm, [2.0])


def test_a_heavy_centre_draws_the_line_towards_it():
    centres = np.array([[0, 0, 0], [0, 0, 1], [1, 0, 2.0]])
    light, heavy = (line_through(centres, np.array([1.0, 1.0, weight]))[0] for weight in (1.0, 10.0))
    assert heavy[0] > light[0]


def test_a_board_perpendicular_to_the_axis_leaves_only_maximum_likelihood(board, generator):
    flat = RigidTransform.from_parts(np.column_stack([*_across(), AXIS.direction]), AXIS.point_mm, "camera", "board")
    noisy = turned_corners(board, start=flat) + generator.normal(scale=0.02, size=(9, 154, 3))
    solution = solve(AxisProblem(noisy, ANGLES))
    assert set(solution.refused) == {"least_squares", "distance_weighted"}
    assert "steeply" in solution.refused["distance_weighted"]
    assert angle_between(solution.best.axis) < 4 * solution.best.axis.direction_sigma_rad


def _across():
    first = np.cross(AXIS.direction, [1.0, 0, 0])
    first /= np.linalg.norm(first)
    return first, np.cross(AXIS.direction, first)


def test_two_positions_are_too_few(board):
    with pytest.raises(CalibrationError, match="at least 3"):
        solve(AxisProblem(turned_corners(board)[:2], ANGLES[:2]))


def test_a_board_that_did_not_turn_is_refused(board, generator):
    with pytest.raises(CalibrationError, match="turned by only"):
        solve(AxisProblem(turned_corners(board, np.zeros(4)) + generator.normal(scale=0.001, size=(4, 154, 3))))


def test_short_arcs_are_reported(board):
    angles = np.deg2rad([0.0, 5.0, 10.0])
    assert "span only 10°" in solve(AxisProblem(turned_corners(board, angles), angles)).warnings[0]


def test_angles_that_contradict_the_board_are_refused(board):
    with pytest.raises(CalibrationError, match="its angle says"):
        solve(AxisProblem(turned_corners(board), np.deg2rad(ANGLES)))


def test_too_few_positions_and_a_short_sweep_are_said(head, board, simulate, generator):
    assert shortfalls(problem_from_poses([], board)) == ("3 more table positions are needed.",)
    angles = np.deg2rad([0.0, 5.0, 10.0])
    poses = [board_pose(simulate.corners(head, board, AXIS.turned(angle) @ START, 0.05, generator), head, board) for angle in angles]
    assert "turn it by 30°" in shortfalls(problem_from_poses(poses, board, angles))[0]
    assert shortfalls(problem_from_poses(poses[:2], board, angles[:2])) == ("1 more table positions are needed.",)
