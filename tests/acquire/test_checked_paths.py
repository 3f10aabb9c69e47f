"""A session drives checked paths: every viewpoint of calibration and scan on the virtual rig, detours, refusals."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from measureapp.acquire.motion import checked
from measureapp.acquire.session import RigSession
from measureapp.data.cell import CellDescription, Fixture
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.rig import Rig
from measureapp.errors import LimitError
from measureapp.planning.calibration_views import calibration_viewpoints
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.routes import NoRoute
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig
from measureapp.simulate.parts import make_part
from measureapp.simulate.world import World

RIG = read_rig("paper")
PLAN = plan_around_part(RIG, "part", radius_mm=90.0, height_mm=90.0, count=8, arm=arm_of(RIG))


@pytest.fixture
def rig() -> Iterator[Rig]:
    made: Any = load_driver(None, "virtual_rig", "rig").module.rig_of(World(RIG, make_part("gypsum"), 3))
    yield made
    made.close()


def test_the_virtual_rig_reaches_every_viewpoint_of_calibration_and_scan_from_where_it_starts(rig: Rig) -> None:
    views = calibration_viewpoints(RIG, PLAN, motions=("robot",), arm=arm_of(RIG))
    for part, viewpoints in ((PartSolid.board_on_stand(), views), (PartSolid.enclosing(90.0, 90.0), PLAN)):
        with RigSession(checked(rig, part)) as session:
            for viewpoint in viewpoints:
                session.move_axes(viewpoint)
                session.confirm_reached(viewpoint)


def test_a_viewpoint_that_touches_is_refused_the_rig_stays_usable_and_nothing_moves(rig: Rig) -> None:
    x_mm, y_mm, z_mm = PLAN[0].flange.position_mm
    low, high = (x_mm - 30.0, y_mm - 30.0, 1.0), (x_mm + 30.0, y_mm + 30.0, z_mm)
    tower = CellDescription(fixtures=(Fixture(name="tower", low_mm=low, high_mm=high),))
    blocked = checked(replace(rig, description=RIG.model_copy(update={"cell": tower})), None)
    before = rig.readback()
    with RigSession(blocked) as session:
        with pytest.raises(NoRoute, match=r"view01 cannot be approached: .*the tower") as caught:
            session.move_axes(PLAN[0])
        after = session.readback()
    assert isinstance(caught.value, LimitError)
    assert "nothing was moved" in caught.value.hint
    np.testing.assert_array_equal(after.base_from_flange.matrix, before.base_from_flange.matrix)


def test_a_rig_without_paths_is_driven_as_before(rig: Rig) -> None:
    with RigSession(rig) as session:
        session.move_axes(PLAN[0])
        session.confirm_reached(PLAN[0])
