"""Reach by joint angles: what the arm's limits and singularities forbid is told, and planners look for what it can reach."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.errors import InputError, PlanError
from measureapp.geometry.kinematics.inverse import inverse
from measureapp.planning.calibration_views import calibration_viewpoints
from measureapp.planning.reach import check_reach, limit_violations
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig

RIG = read_rig("paper")
ARM = arm_of(RIG)
REPLACED = {"pose02", "pose04", "pose06", "pose08", "pose12", "pose14", "pose16"}  # beyond the joints' limits, or head against arm


def viewpoint_of(joints_deg: tuple[float, ...]) -> Viewpoint:
    return Viewpoint(id="here", flange=FlangePose.of(ARM.forward(np.deg2rad(joints_deg))), guide_mm=0.0, table_deg=0.0)


def test_a_pose_within_the_joints_limits_is_reachable() -> None:
    assert limit_violations(viewpoint_of((10, 20, -10, 40, 50, 60)), RIG, ARM) == ()


def test_a_pose_beyond_a_joints_limit_is_told_with_joint_and_excess_though_the_flange_is_in_reach() -> None:
    narrow = replace(ARM, limits_rad=np.vstack([np.deg2rad([[-5.0, 5.0]]), ARM.limits_rad[1:]]))
    viewpoint = viewpoint_of((10, 20, -10, 40, 50, 60))
    assert limit_violations(viewpoint, RIG) == ()
    (reason,) = limit_violations(viewpoint, RIG, narrow)
    assert "needs joint 1 at 10.0°, outside -3…3°, 7.0° too far" in reason
    with pytest.raises(PlanError, match=r"here: .* needs joint 1"):
        check_reach([viewpoint], RIG, narrow)


def test_a_pose_that_is_singular_in_every_configuration_is_told() -> None:
    (reason,) = limit_violations(viewpoint_of((10, 20, -81.5, 40, 50, 60)), RIG, ARM)
    assert "every configuration is near a singularity, such as the elbow 1.68° from the straight arm" in reason


def test_a_pose_beyond_the_reach_is_told_once() -> None:
    far = Viewpoint(id="far", flange=FlangePose(position_mm=(2000, 0, 400), quaternion_wxyz=(1, 0, 0, 0)), guide_mm=0.0, table_deg=0.0)
    assert len(limit_violations(far, RIG, ARM)) == 1


def test_a_rig_without_a_model_file_has_no_arm_and_a_wrong_name_is_refused() -> None:
    def rig(model_file: str):
        return RIG.model_copy(update={"robot": RIG.robot.model_copy(update={"model_file": model_file})})

    assert arm_of(rig("")) is None
    assert arm_of(RIG) is ARM
    with pytest.raises(InputError, match="irb9"):
        arm_of(rig("irb9"))
    with pytest.raises(InputError, match=r"nowhere\.toml"):
        arm_of(rig("nowhere.toml"))


def test_poses_of_a_calibration_that_no_joint_angles_reach_are_replaced_by_neighbours() -> None:
    by_reach = {viewpoint.id: viewpoint for viewpoint in calibration_viewpoints(RIG)}
    by_joints = {viewpoint.id: viewpoint for viewpoint in calibration_viewpoints(RIG, arm=ARM)}
    check_reach(by_joints.values(), RIG, ARM)
    assert by_joints.keys() >= by_reach.keys()
    assert {name for name, viewpoint in by_reach.items() if viewpoint != by_joints[name]} == REPLACED


def test_with_the_guide_at_zero_no_pose_is_lost_either() -> None:
    by_reach = {viewpoint.id for viewpoint in calibration_viewpoints(RIG, motions=("robot",), guide_at_zero=True)}
    by_joints = calibration_viewpoints(RIG, motions=("robot",), guide_at_zero=True, arm=ARM)
    check_reach(by_joints, RIG, ARM)
    assert {viewpoint.id for viewpoint in by_joints} >= by_reach
    joints = [max(one.limit_margin_rad for one in inverse(ARM, viewpoint.flange.transform())) for viewpoint in by_joints]
    assert min(joints) >= np.deg2rad(2.0)  # the ABB driver refuses less
    assert {viewpoint.guide_mm for viewpoint in by_joints if viewpoint.id.startswith("pose")} == {0.0}


@pytest.mark.parametrize("count", [4, 12, 36])
def test_plans_around_parts_on_the_reference_rig_need_no_change_for_the_joints(count: int) -> None:
    size = {"radius_mm": 140.0, "height_mm": 60.0, "count": count}
    assert plan_around_part(RIG, "part", **size, arm=ARM) == plan_around_part(RIG, "part", **size)
