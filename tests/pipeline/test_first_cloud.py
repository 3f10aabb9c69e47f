"""A part that is not where the plan assumes it is noticed after the first cloud."""

from __future__ import annotations

import pytest

from measureapp.data.measurement import ViewResult
from measureapp.data.part_pose import PartPose
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.pipeline.first_cloud import displacement
from measureapp.pipeline.prediction.uncertainty import exposing_of
from measureapp.pipeline.prediction.views import PredictedScene, standing_on_table
from tests.pipeline.predicted_rig import box, joined, nominal_rig, plan_for

PART = joined(box((120.0, 60.0, 20.0)), box((30.0, 60.0, 50.0), (-45.0, 0.0, 20.0)))
RIG = nominal_rig()


def view_of(pose: PartPose) -> ViewResult:
    plan, surface = plan_for(RIG.description, 3), NominalSurface(PART)
    scene = PredictedScene.of(RIG, surface, standing_on_table(surface, RIG, pose))
    view = scene.predict(plan[0], exposing_of(plan)(plan[0]))
    assert view is not None
    return view


@pytest.mark.parametrize("pose", [PartPose(), PartPose.upside_down(), PartPose(rotation_deg=(0, 0, 3.0), position_mm=(3.0, -2.0, 0.0))])
def test_a_part_that_is_as_planned_or_nearly_so_is_not_mentioned(pose: PartPose) -> None:
    planned = PartPose() if pose.position_mm is not None else pose
    assert displacement(view_of(pose), PART, planned, RIG.calibration, RIG.description) == ""


def test_a_part_on_its_head_is_noticed_in_words() -> None:
    said = displacement(view_of(PartPose.upside_down()), PART, None, RIG.calibration, RIG.description)
    assert "not where the plan assumes it" in said and "turned by" in said


def test_a_displaced_part_is_noticed_with_how_far_it_is() -> None:
    moved = PartPose(position_mm=(0.0, 60.0, 0.0))
    said = displacement(view_of(moved), PART, None, RIG.calibration, RIG.description)
    assert "not where the plan assumes it" in said
