"""The window with a rig, a plan and a measurement, in which every page has something to show."""

from __future__ import annotations

import pytest


@pytest.fixture
def filled(application, window, measurement, plan, rig, qtbot):
    """Return the window after a measurement, with 3-D pictures where the graphics libraries are installed."""
    from ui.viewport.backend import missing_graphics

    session = application.session
    session.set_graphics("failed" if missing_graphics() else "ready", "No graphics in this test.")
    session.open_project("gypsum-4711", "gypsum", None)
    session.set_rig(rig)
    session.set_plan(plan)
    session.set_measurement(measurement, {})
    qtbot.wait(50)
    return window
