"""Kinematics of the arm: joint angles and poses belong to each other, the nearest configuration is taken, and refusals say why."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st
from robot_requests import plugin_module

from measureapp.errors import LimitError
from measureapp.geometry.transform import RigidTransform
from measureapp.peers.rws.arm import LIMITS_DEG, flange_pose
from measureapp.project.geometry.robot_file import read_robot

arms = plugin_module("robot_abb", "arm")
ARM = arms.Arm.read("irb1200_7_07", 2.0)
INSIDE = st.tuples(*(st.floats(low + 2.5, high - 2.5) for low, high in LIMITS_DEG)).map(np.array)
START = np.array([0.0, 0.0, 0.0, 0.0, 30.0, 0.0])


@given(INSIDE)
def test_the_pose_is_that_of_the_virtual_controller_which_states_the_arm_itself(joints: np.ndarray) -> None:
    np.testing.assert_allclose(ARM.pose(joints).matrix, flange_pose(joints).matrix, atol=1e-9)


@given(INSIDE)
def test_a_pose_seen_from_its_own_joints_has_these_joints(joints: np.ndarray) -> None:
    assume(abs(joints[4]) > 1.0)
    bend = abs(joints[2] + 90.0 - np.degrees(np.arctan2(42.0, 351.0)))
    assume(1.0 < bend < 179.0)
    wrist = ARM.pose(joints).translation_mm - ARM.pose(joints).rotation[:, 2] * 82.0
    assume(np.hypot(wrist[0], wrist[1]) > 10.0)
    np.testing.assert_allclose(ARM.joints_for(ARM.pose(joints), joints), joints, atol=1e-6)


@given(INSIDE, INSIDE)
def test_whatever_is_returned_is_inside_the_limits_and_has_the_pose(joints: np.ndarray, present: np.ndarray) -> None:
    try:
        found = ARM.joints_for(ARM.pose(joints), present)
    except LimitError:
        return
    np.testing.assert_allclose(ARM.pose(found).matrix, ARM.pose(joints).matrix, atol=1e-6)
    assert (found >= LIMITS_DEG[:, 0] + 2.0).all()
    assert (found <= LIMITS_DEG[:, 1] - 2.0).all()


def test_the_configuration_nearest_to_the_present_joints_is_taken() -> None:
    flipped = np.array([10.0, 20.0, -10.0, 160.0, -40.0, 200.0])
    near = flipped + 3.0
    np.testing.assert_allclose(ARM.joints_for(ARM.pose(flipped), near), flipped, atol=1e-6)
    from_start = ARM.joints_for(ARM.pose(flipped), START)
    np.testing.assert_allclose(from_start, [10.0, 20.0, -10.0, -20.0, 40.0, 20.0], atol=1e-6)


@pytest.mark.parametrize(
    ("pose", "words"),
    [
        (RigidTransform.from_parts(np.eye(3), [5000.0, 0.0, 0.0], "base", "flange"), r"reaches \d+\.\d…\d+\.\d mm: \d+\.\d mm too far"),
        (RigidTransform.from_parts(np.eye(3), [300.0, 0.0, -100.0], "base", "flange"), "violate joint limits"),
    ],
    ids=["reach", "limits"],
)
def test_a_pose_that_cannot_be_taken_is_refused_with_its_reason(pose: RigidTransform, words: str) -> None:
    with pytest.raises(LimitError, match=words):
        ARM.joints_for(pose, START)


def test_at_a_singularity_of_the_wrist_joint_4_stays_where_it_is() -> None:
    present = np.array([0.0, 0.0, 0.0, 25.0, 2.0, -20.0])
    found = ARM.joints_for(ARM.pose(np.zeros(6)), present)
    np.testing.assert_allclose(ARM.pose(found).matrix, ARM.pose(np.zeros(6)).matrix, atol=1e-6)
    np.testing.assert_allclose(found, [0.0, 0.0, 0.0, 25.0, 0.0, -25.0], atol=1e-6)


def test_a_pose_beyond_a_joints_limit_is_refused_with_joint_and_excess() -> None:
    wide = read_robot("irb1200_7_07")
    arm = arms.Arm(replace(wide, limits_rad=np.deg2rad([[-10.0, 10.0], *np.rad2deg(wide.limits_rad)[1:]])), 2.0)
    with pytest.raises(LimitError, match=r"the best exceeds that of joint 1 by \d+\.\d°"):
        arm.joints_for(arm.pose(np.array([50.0, 0.0, 0.0, 0.0, 30.0, 0.0])), START)
