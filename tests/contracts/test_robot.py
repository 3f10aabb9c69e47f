"""What every robot driver must do."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from measureapp.devices.rig import Rig
from measureapp.errors import DeviceTimeout, LimitError
from measureapp.geometry.transform import RigidTransform

TOLERANCE_MM, TOLERANCE_RAD = 0.01, 1e-5


def shifted(rig: Rig, millimetres: float) -> RigidTransform:
    return rig.robot.pose() @ RigidTransform.from_vector([0.05, 0.0, 0.02], [0.0, 0.0, -millimetres], "flange", "flange")


def test_the_pose_is_that_of_the_flange_in_the_base(rig: Rig) -> None:
    pose = rig.robot.pose()
    assert (pose.to_frame, pose.from_frame) == ("base", "flange")


def test_the_robot_reads_back_the_pose_it_was_sent_to(rig: Rig) -> None:
    goal = shifted(rig, 20.0)
    rig.robot.move_to(goal, timeout_s=10.0)
    off = rig.robot.pose().inverse() @ goal
    assert np.linalg.norm(off.translation_mm) < TOLERANCE_MM
    assert off.angle_rad < TOLERANCE_RAD


def test_a_pose_out_of_reach_is_refused_before_moving(rig: Rig) -> None:
    before = rig.robot.pose().matrix
    far = RigidTransform.from_parts(np.eye(3), [5000.0, 0.0, 0.0], "base", "flange")
    with pytest.raises(LimitError):
        rig.robot.move_to(far, timeout_s=10.0)
    np.testing.assert_array_equal(rig.robot.pose().matrix, before)


def test_a_move_that_takes_too_long_is_a_timeout(slow_rig: Rig) -> None:
    with pytest.raises(DeviceTimeout):
        slow_rig.robot.move_to(shifted(slow_rig, 100.0), timeout_s=0.01)


def test_a_stop_from_another_thread_cancels_the_move(slow_rig: Rig, cancelled_by: Callable[..., bool]) -> None:
    before = slow_rig.robot.pose().matrix
    goal = shifted(slow_rig, 100.0)
    assert cancelled_by(slow_rig.robot.stop, lambda: slow_rig.robot.move_to(goal, timeout_s=30.0))
    np.testing.assert_allclose(slow_rig.robot.pose().matrix, before)


def test_a_stop_while_nothing_moves_leaves_the_next_move_alone(rig: Rig) -> None:
    rig.robot.stop()
    goal = shifted(rig, 1.0)
    rig.robot.move_to(goal, timeout_s=10.0)
    assert np.linalg.norm(rig.robot.pose().translation_mm - goal.translation_mm) < TOLERANCE_MM
