"""The Plan page does not stall: with a part and its prediction, and with ten thousand viewpoints."""

from __future__ import annotations

from pathlib import Path

import pytest

from measureapp.data.plan import FlangePose, ScanPlan, StationPose, Viewpoint, ViewpointGroup
from measureapp.geometry.transform import RigidTransform
from measureapp.planning import edit
from measureapp.resources import resource

PATIENCE_MS = 60_000
pytestmark = [pytest.mark.slow, pytest.mark.timed]
GYPSUM = Path(str(resource("parts"))) / "gypsum" / "nominal.stl"


def _idle(application) -> bool:
    return not any(runner.queue.busy for runner in application.controllers.runners)


def _settle(application, qtbot, heart, place: str, act) -> None:
    with heart.at(place):
        act()
        qtbot.wait(200)  # until the check after an edit begins
        qtbot.waitUntil(lambda: _idle(application), timeout=PATIENCE_MS)
        qtbot.wait(100)


def test_the_first_picture_and_edits_of_a_plan_with_a_part(application, filled, heartbeat, qtbot):
    page, planning = filled.pages["plan"], application.controllers.planning
    planning.part.choose(GYPSUM)
    qtbot.waitUntil(lambda: _idle(application), timeout=PATIENCE_MS)
    heartbeat.stalls.clear()
    _settle(application, qtbot, heartbeat, "first picture", lambda: filled.show_page("plan"))
    _settle(application, qtbot, heartbeat, "selecting", lambda: page.tree.select(("view-03",)))
    _settle(application, qtbot, heartbeat, "other colours", lambda: page.shown.setValue("selected"))
    _settle(
        application,
        qtbot,
        heartbeat,
        "editing",
        lambda: planning.edit("Turn", lambda plan: edit.change(plan, ("view-03",), table_deg=33.0)),
    )
    _settle(application, qtbot, heartbeat, "undo", planning.undo)
    _settle(application, qtbot, heartbeat, "other page", lambda: filled.show_page("rig"))
    _settle(application, qtbot, heartbeat, "coming back", lambda: filled.show_page("plan"))
    heartbeat.check()


@pytest.mark.parametrize("grouped", [False, True], ids=["single", "grouped"])
def test_two_thousand_viewpoints_are_edited(application, filled, heartbeat, qtbot, grouped):
    page, planning = filled.pages["plan"], application.controllers.planning
    flange = FlangePose.of(RigidTransform.from_vector([0, 2.2, 0], [450, 0, 500], "base", "flange"))
    if grouped:
        poses = tuple(StationPose(flange=flange, guide_mm=number * 1.0) for number in range(20))
        groups = (ViewpointGroup(id="ring", poses=poses, table_deg=tuple(18.0 * step for step in range(20))),)
        large = ScanPlan(name="large", viewpoints=(Viewpoint(id="one", flange=flange, guide_mm=0.0, table_deg=0.0),), groups=groups)
    else:
        points = tuple(Viewpoint(id=f"v{i:05d}", flange=flange, guide_mm=i * 0.01, table_deg=i * 0.03) for i in range(2_000))
        large = ScanPlan(name="large", viewpoints=points)
    name = next(iter(large)).id
    filled.show_page("plan")
    qtbot.waitUntil(lambda: _idle(application), timeout=PATIENCE_MS)  # the report of the measurement, which is composed beside
    heartbeat.stalls.clear()
    with heartbeat.at("opening"):
        application.session.set_plan(large)
        qtbot.wait(400)
    for angle in (12.0, 13.0):
        with heartbeat.at("editing"):
            planning.edit("Turn", lambda plan, angle=angle: edit.change(plan, (name,), table_deg=angle))
            qtbot.wait(400)
    with heartbeat.at("renaming"):
        planning.edit("Rename", lambda plan: edit.rename(plan, name, "first"), ("first",))
        qtbot.wait(400)
    with heartbeat.at("selecting all"):
        page.tree.selectAll()
        qtbot.wait(400)
    with heartbeat.at("undo"):
        planning.undo()
        qtbot.wait(400)
    planning.prediction.stop()
    qtbot.waitUntil(lambda: _idle(application), timeout=PATIENCE_MS)
    heartbeat.check()
