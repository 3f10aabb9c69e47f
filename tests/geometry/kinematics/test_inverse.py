"""Inverse kinematics: every solution reaches the pose, none is lost, and refusals say why."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from measureapp.errors import FrameMismatch, LimitError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.choice import by_preference
from measureapp.geometry.kinematics.closed_form import all_branches
from measureapp.geometry.kinematics.inverse import SEEDS, JointSolution, inverse
from measureapp.geometry.kinematics.ortho_parallel import ortho_parallel
from measureapp.geometry.kinematics.refine import refine, seeds
from measureapp.geometry.kinematics.turns import distinct
from measureapp.geometry.transform import RigidTransform
from tests.geometry.kinematics.arms import IRB_DEG_MM, LIMITS_DEG, arm, irb1200, offset_wrist, ortho_parallel_arms, random_joints

CLOSE = 1e-9  # mm and rad
ROW_3_DEG = (30, 20, -10, 40, 50, 60)


def joints_of(solutions: tuple[JointSolution, ...]) -> np.ndarray:
    return np.array([solution.joints_rad for solution in solutions])


def assert_all_reach(model: ArmModel, pose: RigidTransform, solutions: tuple[JointSolution, ...]) -> None:
    joints_rad = joints_of(solutions)
    assert np.abs(model.forward_matrices(joints_rad) - pose.matrix).max() < CLOSE
    assert (joints_rad >= model.limits_rad[:, 0]).all() and (joints_rad <= model.limits_rad[:, 1]).all()


def holds(solutions: tuple[JointSolution, ...], joints_rad: np.ndarray, within_rad: float = 1e-7) -> bool:
    return bool(np.abs(joints_of(solutions) - joints_rad).max(axis=1).min() < within_rad)


@pytest.mark.parametrize("count", [800, pytest.param(3000, marks=pytest.mark.slow)])
def test_every_solution_of_random_poses_reaches_them_and_the_original_joints_are_among_them(count):
    model = irb1200()
    for joints_rad in random_joints(model, count, seed=4):
        pose = model.forward(joints_rad)
        solutions = inverse(model, pose)
        assert_all_reach(model, pose, solutions)
        assert holds(solutions, joints_rad)


def test_random_poses_have_eight_branches_all_of_which_reach_them():
    model = irb1200()
    poses = model.forward_matrices(random_joints(model, 3000, seed=5))
    branches = all_branches(ortho_parallel(model), poses, np.zeros(6))
    assert np.isfinite(branches).all()
    assert np.abs(model.forward_matrices(branches) - poses[:, None]).max() < CLOSE


def test_the_published_pose_has_its_published_branches():
    model = irb1200()
    solutions = inverse(model, model.forward(np.deg2rad(ROW_3_DEG)))
    found = {tuple(np.round(np.rad2deg(one.joints_rad[:3]), 4)): one.posture for one in solutions}
    words = {joints: (posture.shoulder, posture.elbow) for joints, posture in found.items()}
    assert words == {
        (30, 20, -10): ("front", "up"),
        (30, 93.6002, -156.3531): ("front", "down"),
        (-150, -93.6002, -10): ("back", "down"),
        (-150, -20, -156.3531): ("back", "up"),
    }
    for wrist_deg in ((32.0045, 111.7067, 101.3562), (-147.9955, -111.7067, -78.6438)):
        assert holds(solutions, np.deg2rad([30, 93.6002, -156.3531, *wrist_deg]), within_rad=2e-6)
    assert {one.posture.wrist for one in solutions} == {"positive", "flipped"}


def test_solutions_whole_turns_apart_are_all_given():
    model = irb1200()
    solutions = inverse(model, model.forward(np.deg2rad(ROW_3_DEG)))
    assert holds(solutions, np.deg2rad([30, 20, -10, 40, 50, -300]))
    assert holds(solutions, np.deg2rad([30, 20, -10, 220, -50, 240]))
    turned = inverse(model, model.forward(np.deg2rad([0, 30, -196.4, 0, 60, 0])))
    assert holds(turned, np.deg2rad([0, 30, -196.4, 0, 60, 0]))  # 163.6° is beyond the limit of joint 3
    assert holds(turned, np.deg2rad([0, 30, -196.4, 0, 60, 360]))


@settings(max_examples=60, deadline=None)
@given(ortho_parallel_arms(), st.integers(0, 2**31))
def test_arms_of_any_lengths_zeros_and_senses_are_solved_in_closed_form(model: ArmModel, seed: int):
    geometry = ortho_parallel(model)
    assert geometry is not None
    for joints_rad in random_joints(model, 5, seed):
        pose = model.forward(joints_rad)
        branches = all_branches(geometry, pose.matrix[None], np.zeros(6))[0]
        reached = branches[np.isfinite(branches).all(axis=1)]
        assert len(reached) in (4, 8)  # with an offset shoulder, the way round the back may be too far
        assert np.abs(model.forward_matrices(reached) - pose.matrix).max() < 1e-8  # angles at a stretched elbow lose half their digits
        solutions = inverse(model, pose)
        assert_all_reach(model, pose, solutions)
        assert holds(solutions, joints_rad, within_rad=1e-5)


def test_a_wrist_that_is_not_spherical_is_solved_numerically():
    model = offset_wrist()
    assert ortho_parallel(model) is None
    for joints_rad in random_joints(model, 20, seed=6):
        pose = model.forward(joints_rad)
        solutions = inverse(model, pose)
        assert_all_reach(model, pose, solutions)
        assert holds(solutions, joints_rad)
        assert solutions[0].posture is None


def test_the_numerical_solver_finds_the_eight_solutions_of_the_closed_form():
    model = irb1200()
    for joints_rad in random_joints(model, 20, seed=7):
        pose = model.forward_matrices(joints_rad)
        refined = refine(model, pose, seeds(model.limits_rad, SEEDS))
        found, exact = distinct(refined.joints_rad[refined.reached]), all_branches(ortho_parallel(model), pose[None], np.zeros(6))[0]
        assert len(found) == 8
        assert len(distinct(np.vstack([exact, found]))) == 8


@pytest.mark.parametrize("seed", range(5))
def test_a_calibrated_arm_whose_axes_deviate_slightly_is_solved_exactly(seed):
    noise = np.random.default_rng(seed).normal(0.0, [0.02, 0.1, 0.1, 0.02], (6, 4))
    model = arm([tuple(row) for row in np.array(IRB_DEG_MM) + noise])
    assert ortho_parallel(model) is not None
    for joints_rad in random_joints(model, 40, seed):
        pose = model.forward(joints_rad)
        solutions = inverse(model, pose)
        assert_all_reach(model, pose, solutions)
        assert holds(solutions, joints_rad, within_rad=1e-6)


def test_at_the_wrist_singularity_joint_4_keeps_its_angle():
    model = irb1200()
    joints_rad = np.deg2rad([10, 20, -10, 35, 0, -20])
    pose = model.forward(joints_rad)
    solutions = inverse(model, pose, current_rad=joints_rad)
    assert holds(solutions, joints_rad)
    assert_all_reach(model, pose, solutions)
    assert holds(inverse(model, pose), np.deg2rad([10, 20, -10, 0, 0, 15]))
    assert min(one.posture.wrist_margin_rad for one in solutions) < 1e-12


def test_at_the_shoulder_singularity_joint_1_keeps_its_angle():
    model = irb1200()
    geometry, elbow_rad = ortho_parallel(model), 2.0
    inner_rad = np.arctan2(geometry.fore_mm * np.sin(elbow_rad), geometry.upper_mm + geometry.fore_mm * np.cos(elbow_rad))
    joints_rad = np.array([0.5, -inner_rad, elbow_rad - geometry.fore_rad, 0.4, 0.8, 0.2])  # the wrist is above the shoulder
    solutions = inverse(model, model.forward(joints_rad), current_rad=joints_rad)
    assert holds(solutions, joints_rad)
    assert min(one.posture.shoulder_margin_mm for one in solutions) < 1e-9


def test_a_stretched_arm_is_still_reachable():
    model = irb1200()
    joints_rad = np.array([0.2, 0.7, -ortho_parallel(model).fore_rad, 0.3, 0.9, 0.1])
    pose = model.forward(joints_rad)
    solutions = inverse(model, pose)
    assert_all_reach(model, pose, solutions)
    assert holds(solutions, joints_rad, within_rad=1e-5)
    assert min(one.posture.elbow_margin_rad for one in solutions) < 1e-5


def test_joints_at_their_limits_are_within_them():
    model = irb1200()
    joints_rad = model.limits_rad[:, 1] * [1, 1, 1, 1, 1, 0.5]
    solution = by_preference(model, model.forward(joints_rad), joints_rad)[0]
    assert np.abs(solution.joints_rad - joints_rad).max() < 1e-8
    assert solution.limit_margin_rad < 1e-8


def test_margins_are_distances_to_limits_and_singularities():
    model = irb1200()
    solution = by_preference(model, model.forward(np.deg2rad(ROW_3_DEG)), np.deg2rad(ROW_3_DEG))[0]
    assert np.rad2deg(solution.limit_margin_rad) == pytest.approx(80)  # joint 3 to 70°, joint 5 to 130°
    assert np.rad2deg(solution.posture.wrist_margin_rad) == pytest.approx(50)
    assert np.rad2deg(solution.posture.elbow_margin_rad) == pytest.approx(83.176 - 10, abs=1e-3)
    wrist_mm = model.link_frames(np.deg2rad(ROW_3_DEG))[4, :2, 3]
    assert solution.posture.shoulder_margin_mm == pytest.approx(np.hypot(*wrist_mm))


def test_the_nearest_solution_is_the_one_that_is_reached_first():
    model = irb1200()
    pose = model.forward(np.deg2rad(ROW_3_DEG))
    solutions = inverse(model, pose)
    for solution in solutions:
        np.testing.assert_array_equal(by_preference(model, pose, solution.joints_rad + 0.01)[0].joints_rad, solution.joints_rad)
    times_s = np.abs(joints_of(solutions)) / [1.0, 1.0, 1.0, 1e-3, 1e-3, 1e-3]  # a slow wrist
    slow_wrist = by_preference(replace(model, speeds_rad_s=np.array([1.0, 1.0, 1.0, 1e-3, 1e-3, 1e-3])), pose, np.zeros(6))[0]
    np.testing.assert_array_equal(slow_wrist.joints_rad, solutions[int(times_s.max(axis=1).argmin())].joints_rad)


def test_a_pose_out_of_reach_is_refused_with_the_distance_that_is_missing():
    model = irb1200()
    pose = RigidTransform.from_parts(np.eye(3), [600.0, 0.0, 399.1 + 82.0 + 800.0], "base", "flange")
    with pytest.raises(LimitError, match=r"would be 1000 mm from the shoulder; the arm reaches 4…704 mm: 296\.5 mm too far") as refused:
        inverse(model, pose)
    assert "closer to the robot" in refused.value.hint
    inside = RigidTransform.from_parts(np.eye(3), [0.0, 0.0, 399.1 + 82.0 + 1.0], "base", "flange")
    with pytest.raises(LimitError, match="mm too near"):
        inverse(model, inside)


def test_a_pose_between_axis_1_and_a_lateral_wrist_is_refused():
    model = arm([IRB_DEG_MM[0], (-90, 100, 350, 0), *IRB_DEG_MM[2:]])
    with pytest.raises(LimitError, match=r"30\.0 mm from axis 1; .* at least 100\.0 mm away: 70\.0 mm too near"):
        inverse(model, RigidTransform.from_parts(np.eye(3), [30.0, 0.0, 900.0], "base", "flange"))


def test_a_pose_that_only_limits_forbid_is_refused_with_the_joint():
    allowed = irb1200()
    narrow = arm(IRB_DEG_MM, [*LIMITS_DEG[:4], (-20, 20), LIMITS_DEG[5]])
    pose = allowed.forward(np.deg2rad([0, 0, 0, 0, 30, 0]))
    with pytest.raises(LimitError, match=r"needs joint 5 at -?30\.0°, outside -20…20°, 10\.0° too far"):
        inverse(narrow, pose)


def test_a_pose_out_of_reach_of_the_numerical_solver_is_refused_with_what_is_missing():
    pose = RigidTransform.from_parts(np.eye(3), [3000.0, 0.0, 500.0], "base", "flange")
    with pytest.raises(LimitError, match=r"the nearest miss it by .* mm"):
        inverse(offset_wrist(), pose)


def test_a_pose_in_other_frames_is_refused():
    with pytest.raises(FrameMismatch, match="guide_from_camera"):
        inverse(irb1200(), RigidTransform.identity("guide", "camera"))
