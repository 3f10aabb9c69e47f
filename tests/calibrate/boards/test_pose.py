"""The board's pose from several cameras, with an honest covariance; derivatives of the projection."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.boards.pose import board_pose, triangulate
from measureapp.calibrate.poses import change_between
from measureapp.calibrate.projection import apply_intrinsic_changes, intrinsic_names, project_with_derivatives
from measureapp.errors import CalibrationError
from measureapp.geometry.pinhole import PinholeCamera


def test_the_information_of_a_pose_predicts_its_scatter(head, board, simulate, generator):
    truth = simulate.board_pose(generator)
    squares = []
    for _ in range(60):
        pose = board_pose(simulate.corners(head, board, truth, 0.1, generator), head, board, 0.1)
        change = change_between(truth.matrix[None], pose.camera_from_board.matrix[None])[0]
        squares.append(change @ pose.information @ change)
    assert np.mean(squares) == pytest.approx(6.0, abs=4 * np.sqrt(12 / 60))  # chi square of six parameters


def test_one_camera_is_enough_and_three_are_better(head, board, simulate, generator):
    corners = simulate.corners(head, board, simulate.board_pose(generator), 0.1, generator)
    one, all_three = (board_pose(chosen, head, board) for chosen in ({"right": corners["right"]}, corners))
    assert np.linalg.det(all_three.information) > np.linalg.det(one.information)
    distance = np.linalg.norm(one.camera_from_board.translation_mm - all_three.camera_from_board.translation_mm)
    assert distance < 6 * np.sqrt(np.linalg.inv(one.information)[3:, 3:].trace())


def test_triangulated_corners_lie_where_the_board_is(head, board, simulate, generator):
    truth = simulate.board_pose(generator)
    points = triangulate(simulate.corners(head, board, truth, 0.0, generator), head)
    np.testing.assert_allclose(points, truth.apply(board.corners_mm), atol=1e-4)


def test_a_camera_that_is_not_calibrated_is_named(head, board):
    with pytest.raises(CalibrationError, match="'front' is not calibrated"):
        board_pose({"front": np.zeros((154, 2))}, head, board)
    with pytest.raises(CalibrationError, match="No camera"):
        board_pose({}, head, board)


@pytest.mark.parametrize("count", [4, 5, 8])
def test_derivatives_of_the_projection_agree_with_differences(count, generator):
    distortion = np.array([0.1, -0.2, 0.001, 0.002, 0.05, 0.01, 0.02, 0.03])[:count]
    camera = PinholeCamera(640, 480, np.array([[600, 0, 320], [0, 610, 240], [0, 0, 1.0]]), distortion)
    points = generator.normal(size=(5, 3)) * 50 + [0, 0, 500]
    _, by_point, by_lens = project_with_derivatives(camera, points)
    for axis, step in enumerate(np.eye(3) * 1e-3):
        np.testing.assert_allclose((camera.project(points + step) - camera.project(points - step)) / 2e-3, by_point[:, :, axis], atol=1e-7)
    assert by_lens.shape[2] == len(intrinsic_names(count))
    for index, step in enumerate(np.eye(4 + count) * 1e-4):
        change = apply_intrinsic_changes(camera, step).project(points) - apply_intrinsic_changes(camera, -step).project(points)
        np.testing.assert_allclose(change / 2e-4, by_lens[:, :, index], atol=1e-7)
