"""Checks of many viewpoints end between two of them when they are cancelled."""

from __future__ import annotations

import pytest

from measureapp.planning.calibration_views import calibration_viewpoints
from measureapp.planning.collision.cell import Cell
from measureapp.planning.collision.check import check_in
from measureapp.progress import Cancelled
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig

RIG = read_rig("paper")


class CancelledSoon:
    """Is cancelled at its third question."""

    def __init__(self) -> None:
        self.asked = 0

    def report(self, done: float, total: float, note: str = "") -> None:
        self.check()

    def check(self) -> None:
        self.asked += 1
        if self.asked == 3:
            raise Cancelled


def test_the_choice_of_calibration_viewpoints_can_be_cancelled():
    with pytest.raises(Cancelled):
        calibration_viewpoints(RIG, arm=arm_of(RIG), progress=CancelledSoon())


def test_a_check_of_collisions_can_be_cancelled():
    views = calibration_viewpoints(RIG, motions=("table",))
    with pytest.raises(Cancelled):
        check_in(Cell.of(RIG, arm_of(RIG)), views, progress=CancelledSoon())
