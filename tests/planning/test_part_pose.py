"""How a part stands on the table: turned, put down, or placed."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.part_pose import PartPose
from measureapp.data.plan import ScanPlan
from measureapp.errors import PlanError
from measureapp.pipeline.part_on_table import solid_of
from measureapp.planning.collision.cell import Cell
from measureapp.planning.coverage.extent import standing
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig
from tests.planning.coverage.parts import casting

PART = casting()


def test_a_part_on_its_head_stands_on_the_table_with_its_top() -> None:
    placed = standing(PART, PartPose.upside_down()).apply(PART.vertices_mm)
    upright = standing(PART).apply(PART.vertices_mm)
    assert placed[:, 2].min() == pytest.approx(0.0) and placed[:, 2].max() == pytest.approx(upright[:, 2].max())
    top = PART.vertices_mm[:, 2] == PART.vertices_mm[:, 2].max()
    assert placed[top][:, 2] == pytest.approx(0.0)


@pytest.mark.parametrize("seed", range(3))
def test_a_pose_made_of_a_transform_gives_that_transform(seed: int) -> None:
    rng = np.random.default_rng(seed)
    pose = PartPose(rotation_deg=tuple(rng.uniform(-80, 80, 3)), position_mm=tuple(rng.uniform(-50, 50, 3)))
    first = pose.transform(PART.vertices_mm)
    again = PartPose.of(first).transform(PART.vertices_mm)
    assert np.allclose(again.matrix, first.matrix, atol=1e-6)


def test_a_plan_keeps_the_pose_and_older_plans_have_none() -> None:
    plan = plan_around_part(read_rig("paper"), "ring", radius_mm=100.0, height_mm=70.0, count=4)
    turned = plan.model_copy(update={"part_pose": PartPose.upside_down()})
    assert ScanPlan.model_validate_json(turned.model_dump_json()).part_pose == PartPose.upside_down()
    old = plan.model_dump(mode="json", exclude_none=True) | {"schema_version": 2}
    assert ScanPlan.model_validate(old).part_pose is None


def test_collisions_are_those_of_the_part_where_it_is() -> None:
    rig = read_rig("paper")
    Cell.of(rig, arm_of(rig), solid_of(PART))
    with pytest.raises(PlanError, match="too large"):
        Cell.of(rig, arm_of(rig), solid_of(PART, PartPose(position_mm=(220.0, 0.0, 0.0))))
