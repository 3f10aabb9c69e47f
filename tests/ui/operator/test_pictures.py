"""Every screen of operator mode in both themes, both languages and three sizes, as pictures."""

from __future__ import annotations

import pytest

from tests.ui.gallery import ON_DEMAND, every_wall
from ui.viewport.backend import missing_graphics

pytestmark = ON_DEMAND


@every_wall
@pytest.mark.parametrize("verdict", ["pass", "fail", "not proven"])
def test_screens(workshop, qtbot, wall, verdict):
    workshop.window.resize(*wall.size)
    wall.dress(workshop.application)
    workshop.verdicts = ("pass", verdict, "pass", "pass")
    screens = workshop.screens
    workshop.application.session.set_graphics("failed" if missing_graphics() else "ready", "No graphics in this test.")
    qtbot.wait(50)
    wall.keep(workshop.window, "operator-1-cards")
    workshop.identify("GC-0001")
    qtbot.wait(50)
    wall.keep(workshop.window, "operator-2-identify")
    screens.identify.next.click()
    workshop.wait(lambda: workshop.operator.obstacles is not None)
    qtbot.wait(50)
    wall.keep(workshop.window, "operator-3-load")
    workshop.load_and_start()
    workshop.wait(lambda: workshop.operator.filed is not None)
    qtbot.wait(2000)
    wall.keep(workshop.window, f"operator-4-{verdict.replace(' ', '-')}")
