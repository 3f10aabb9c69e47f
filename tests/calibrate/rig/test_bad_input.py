"""Sightings of the rig that cannot belong together are named, with what to do."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.calibrate.rig.joint import solve_rig
from measureapp.data.fringe import AxisReadback
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform


@pytest.fixture(scope="module")
def observations(rig, simulate):
    return tuple(simulate.observations(rig, np.random.default_rng(7)))


def changed(observations, change):
    """Return the sightings with other read-backs."""
    return [replace(one, readback=change(one.readback)) for one in observations]


def scaled(pose: RigidTransform, factor: float) -> RigidTransform:
    return RigidTransform.from_parts(pose.rotation, pose.translation_mm * factor, pose.to_frame, pose.from_frame)


def robot(change):
    return lambda read: AxisReadback(change(read.base_from_flange), read.guide_mm, read.table_rad)


def inverted(pose: RigidTransform) -> RigidTransform:
    return RigidTransform(pose.inverse().matrix, pose.to_frame, pose.from_frame)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (robot(lambda pose: scaled(pose, 1e-3)), "robot poses seem to be in metres"),
        (robot(inverted), "flange_from_base"),
        (lambda read: AxisReadback(read.base_from_flange, read.guide_mm / 1000, read.table_rad), "guide positions in mm"),
        (lambda read: AxisReadback(read.base_from_flange, read.guide_mm, float(np.rad2deg(read.table_rad))), "unit (degrees)"),
    ],
)
def test_read_backs_in_another_unit_or_direction_are_named(rig, observations, change, said):
    with pytest.raises(CalibrationError) as refused:
        solve_rig(changed(observations, change), rig.head)
    assert said in str(refused.value)


def test_board_poses_in_metres_are_named(rig, observations):
    metres = [replace(one, board=replace(one.board, camera_from_board=scaled(one.board.camera_from_board, 1e-3))) for one in observations]
    with pytest.raises(CalibrationError, match="in metres"):
        solve_rig(metres, rig.head)


def test_inverted_board_poses_are_named(rig, observations):
    wrong = [replace(one, board=replace(one.board, camera_from_board=inverted(one.board.camera_from_board))) for one in observations]
    with pytest.raises(CalibrationError, match="board_from_camera"):
        solve_rig(wrong, rig.head)


def test_images_in_another_order_are_named(rig, observations):
    boards = [one.board for one in observations[:20]][::-1]
    shuffled = [replace(one, board=board) for one, board in zip(observations, boards, strict=False)]
    with pytest.raises(CalibrationError, match="same order"):
        solve_rig([*shuffled, *observations[20:]], rig.head)


def test_robot_poses_that_all_turn_about_one_axis_are_named(rig, observations):
    still = [one for one in observations if not one.id.startswith("pose")]
    with pytest.raises(CalibrationError, match=r"poses turned|same axis|turn the camera"):
        solve_rig(still, rig.head)


def test_residuals_far_beyond_the_stated_noise_are_reported(rig, observations):
    from measureapp.calibrate.motions.axis_noise import AxisNoise

    strict = solve_rig(observations, rig.head, noise=AxisNoise(robot_mm=0.01, robot_rad=1e-5))
    assert "times as large as expected" in strict.warnings[0]
    assert solve_rig(observations, rig.head).warnings == ()
