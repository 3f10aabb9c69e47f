"""The checked path is the driven path: the controller receives the joint angles that were planned, detours included."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Any

import abb_cell
import numpy as np
import pytest
from acquire.fake_rig import Cell as FakeCell
from acquire.fake_rig import fake_rig, released

from measureapp.acquire.motion import checked
from measureapp.acquire.session import RigSession
from measureapp.data.cell import CellDescription, Fixture
from measureapp.devices.robot import JointRobot
from measureapp.errors import LimitError
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell_paths import placement_of
from measureapp.planning.collision.check import check_in
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig

RIG = read_rig("paper")
PART = PartSolid.enclosing(60.0, 80.0)
PLAN = plan_around_part(RIG, "part", radius_mm=60.0, height_mm=80.0, count=6, arm=arm_of(RIG))


@pytest.fixture
def driven() -> Iterator[tuple[Any, list[np.ndarray], Any]]:
    """A rig with the ABB driver, and the joint goals that its controller begins to move to, in degrees."""
    goals: list[np.ndarray] = []
    with abb_cell.running() as (controller, robot), released(fake_rig(FakeCell())) as rig:
        move = controller.machine.axes.move

        def record(goal: Any, *rest: Any) -> float:
            goals.append(np.array(goal, float))
            return float(move(goal, *rest))

        controller.machine.axes.move = record
        yield replace(rig, robot=robot, description=RIG), goals, controller


def planned_deg(rig: Any, viewpoints: Any) -> list[np.ndarray]:
    cell = rig.paths.cell
    start = placement_of(cell, rig.readback(), rig.robot.joints_rad())
    report = check_in(cell, tuple(viewpoints), start)
    assert report.problems == ()
    return [np.rad2deg(leg.goal.joints_rad) for move in report.moves for leg in move.route.legs if leg.axis == "robot"]


def test_the_controller_receives_the_planned_joint_angles_one_after_the_other(driven: Any) -> None:
    plain, goals, _ = driven
    rig = checked(plain, PART)
    assert isinstance(rig.robot, JointRobot)
    expected = planned_deg(rig, PLAN)
    with RigSession(rig) as session:
        for viewpoint in PLAN:
            session.move_axes(viewpoint)
    reached = [goal for before, goal in pairwise([np.full(6, np.inf), *goals]) if not np.allclose(before, goal, atol=1e-3)]
    assert len(reached) == len(expected) >= 2
    np.testing.assert_allclose(reached, expected, atol=1e-3)  # the controller's numbers have 23 bits


def test_a_viewpoint_that_would_touch_is_refused_and_nothing_moves(driven: Any) -> None:
    plain, goals, _ = driven
    tower = Fixture(name="tower", shape="cylinder", low_mm=(300.0, -60.0, 1.0), high_mm=(420.0, 60.0, 560.0))
    rig = checked(replace(plain, description=RIG.model_copy(update={"cell": CellDescription(fixtures=(tower,))})), PART)
    with RigSession(rig) as session, pytest.raises(LimitError, match="the tower") as caught:
        session.move_axes(PLAN[0])
    assert "nothing was moved" in caught.value.hint
    assert goals == []


def test_a_model_of_another_arm_is_noticed_before_anything_moves(driven: Any) -> None:
    plain, goals, _ = driven
    rig = checked(plain, PART)
    arm = rig.paths.cell.arm
    longer = np.array(arm.last_from_flange)
    longer[2, 3] += 50.0
    other = replace(rig.paths.cell, arm=replace(arm, last_from_flange=longer))
    rig.paths.cell = other
    with RigSession(rig) as session, pytest.raises(LimitError, match="off the one of"):
        session.move_axes(PLAN[0])
    assert goals == []
