"""How board poses move with the cameras is what solving them again with other cameras shows."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.boards.pose import board_pose
from measureapp.calibrate.cameras.prior import perturb_cameras, pose_camera_jacobian
from measureapp.calibrate.poses import change_between

STEPS = {"left.fx": 0.5, "left.cy": 0.3, "right.k1": 1e-3, "right.rotation_y_rad": 1e-4, "upper.x_mm": 0.05, "upper.p1": 1e-4}


@pytest.mark.parametrize("label", STEPS)
@pytest.mark.parametrize("partly", [False, True])
def test_the_pose_moves_as_predicted(head, board, simulate, label, partly):
    pose = simulate.board_pose(np.random.default_rng(3))
    corners = simulate.corners(head, board, pose, 0.0, np.random.default_rng(0))
    ids = {name: np.arange(0, len(pixels), 2) if partly and name == "upper" else None for name, pixels in corners.items()}
    corners = {name: pixels if ids[name] is None else pixels[ids[name]] for name, pixels in corners.items()}
    given = {name: chosen for name, chosen in ids.items() if chosen is not None}
    found = board_pose(corners, head, board, 0.1, given)
    labels = tuple(STEPS)
    predicted = pose_camera_jacobian(found, ids, head, board, labels)[:, labels.index(label)]
    change = np.array([STEPS[label] * (one == label) for one in labels])
    there, back = (board_pose(corners, perturb_cameras(head, labels, sign * change), board, 0.1, given) for sign in (1, -1))
    seen = change_between(back.camera_from_board.matrix[None], there.camera_from_board.matrix[None])[0] / (2 * STEPS[label])
    scale = np.linalg.norm(seen[:3]), np.linalg.norm(seen[3:])
    np.testing.assert_allclose(predicted[:3], seen[:3], atol=2e-3 * scale[0] + 1e-10)
    np.testing.assert_allclose(predicted[3:], seen[3:], atol=2e-3 * scale[1] + 1e-8)


def test_a_camera_that_did_not_see_the_board_does_not_move_it(head, board, simulate):
    pose = simulate.board_pose(np.random.default_rng(3))
    corners = simulate.corners(head, board, pose, 0.0, np.random.default_rng(0))
    del corners["upper"]
    found = board_pose(corners, head, board)
    moved = pose_camera_jacobian(found, dict.fromkeys(corners), head, board, ("upper.fx", "left.fx"))
    assert not moved[:, 0].any()
    assert moved[:, 1].any()
