"""The plan of a project with images may grow by viewpoints; no other change is stored."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from measureapp.arrays import read_only
from measureapp.data.fringe import AxisReadback, FringeStack
from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.data.plan import ExposureBracket, ScanPlan
from measureapp.errors import InputError
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig


def plan_of(count: int) -> ScanPlan:
    return plan_around_part(read_rig("paper"), "growing", radius_mm=60.0, height_mm=60.0, count=count)


@pytest.fixture
def project(tmp_path: Path) -> ProjectFolder:
    """A project with the images of the first of two viewpoints."""
    made = ProjectFolder.create(tmp_path / "p", ProjectSettings(name="growing", part="box", rig=read_rig("paper")))
    plan = plan_of(2)
    made.save_plan(plan)
    first = plan[0]
    images = np.zeros((1, plan.patterns.count, 6, 8), np.uint8)
    readback = AxisReadback(first.flange.transform(), first.guide_mm, float(np.deg2rad(first.table_deg)))
    made.frames.store(FringeStack(first.id, plan.patterns, (100_000,), {"left": read_only(images)}, 255, readback))
    return made


def test_viewpoints_with_new_ids_are_added(project: ProjectFolder) -> None:
    plan = plan_of(2)
    added = plan[0].model_copy(update={"id": "next01", "table_deg": 33.0, "exposures_us": (200_000,)})
    longer = plan.model_copy(update={"viewpoints": (*plan.viewpoints, added)})
    project.save_plan(longer)
    assert project.plan() == longer
    assert project.stored_viewpoints() == (plan[0].id,)


def test_the_same_plan_may_be_stored_again(project: ProjectFolder) -> None:
    project.save_plan(plan_of(2))


@pytest.mark.parametrize(
    "change",
    [
        lambda plan: plan.model_copy(update={"viewpoints": plan.viewpoints[:1]}),
        lambda plan: plan.model_copy(update={"viewpoints": (plan[0].model_copy(update={"table_deg": 1.0}), plan[1])}),
        lambda plan: plan.model_copy(update={"viewpoints": (plan[0].model_copy(update={"guide_mm": 1.0}), plan[1])}),
        lambda plan: plan.model_copy(update={"bracket": ExposureBracket(exposures_us=(90_000,))}),
        lambda plan: plan.model_copy(update={"patterns": PATTERN_SETS["paper"]}),
        lambda plan: plan.model_copy(update={"settle_s": 3.0}),
    ],
    ids=["fewer viewpoints", "another angle", "another place of the guide", "other exposures", "other patterns", "another settling time"],
)
def test_any_other_change_is_refused(project: ProjectFolder, change) -> None:
    with pytest.raises(InputError, match="images of another plan"):
        project.save_plan(change(plan_of(2)))
    assert project.plan() == plan_of(2)


def test_a_project_without_images_takes_any_plan(tmp_path: Path) -> None:
    made = ProjectFolder.create(tmp_path / "p", ProjectSettings(name="growing", part="box", rig=read_rig("paper")))
    made.save_plan(plan_of(4))
    made.save_plan(plan_of(3))
    assert made.plan() == plan_of(3)
