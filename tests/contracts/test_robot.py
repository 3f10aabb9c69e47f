"""What every robot driver must do."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from measureapp.devices.robot import Robot
from measureapp.errors import DeviceTimeout, LimitError
from measureapp.geometry.transform import RigidTransform

TOLERANCE_MM, TOLERANCE_RAD = 0.01, 1e-5


def shifted(robot: Robot, millimetres: float) -> RigidTransform:
    return robot.pose() @ RigidTransform.from_vector([0.05, 0.0, 0.02], [0.0, 0.0, -millimetres], "flange", "flange")


def test_the_pose_is_that_of_the_flange_in_the_base(robot: Robot) -> None:
    pose = robot.pose()
    assert (pose.to_frame, pose.from_frame) == ("base", "flange")


def test_the_robot_reads_back_the_pose_it_was_sent_to(robot: Robot) -> None:
    goal = shifted(robot, 20.0)
    robot.move_to(goal, timeout_s=10.0)
    off = robot.pose().inverse() @ goal
    assert np.linalg.norm(off.translation_mm) < TOLERANCE_MM
    assert off.angle_rad < TOLERANCE_RAD


def test_a_pose_out_of_reach_is_refused_before_moving(robot: Robot) -> None:
    before = robot.pose().matrix
    far = RigidTransform.from_parts(np.eye(3), [5000.0, 0.0, 0.0], "base", "flange")
    with pytest.raises(LimitError):
        robot.move_to(far, timeout_s=10.0)
    np.testing.assert_array_equal(robot.pose().matrix, before)


def test_a_move_that_takes_too_long_is_a_timeout(slow_robot: Robot) -> None:
    with pytest.raises(DeviceTimeout):
        slow_robot.move_to(shifted(slow_robot, 100.0), timeout_s=0.01)


def test_a_stop_from_another_thread_cancels_the_move(slow_robot: Robot, cancelled_by: Callable[..., bool]) -> None:
    goal = shifted(slow_robot, 100.0)
    assert cancelled_by(slow_robot.stop, lambda: slow_robot.move_to(goal, timeout_s=30.0))
    assert np.linalg.norm(slow_robot.pose().translation_mm - goal.translation_mm) > TOLERANCE_MM  # it stops on the way


def test_a_stop_while_nothing_moves_leaves_the_next_move_alone(robot: Robot) -> None:
    robot.stop()
    goal = shifted(robot, 1.0)
    robot.move_to(goal, timeout_s=10.0)
    assert np.linalg.norm(robot.pose().translation_mm - goal.translation_mm) < TOLERANCE_MM


def test_the_robot_tells_its_state(robot: Robot) -> None:
    assert robot.status().ready
    assert robot.status().text
