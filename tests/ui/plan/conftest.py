"""The Plan page with a plan, checked, and with a part."""

from __future__ import annotations

import pytest

from measureapp.data.plan import ScanPlan
from measureapp.resources import resource
from tests.ui.plan.page_steps import SAMPLE, check_at_once, end

LATER_MS = 1_000_000


@pytest.fixture
def page(application, window, rig, qtbot):
    """Return the page with the viewpoints `hub-01` … `hub-07` as single ones, and the group `rim`."""
    application.controllers.planning.prediction._timer.setInterval(LATER_MS)  # most tests need no check
    application.session.set_rig(rig)
    window.show_page("plan")
    hub, rim = SAMPLE.groups[2], SAMPLE.groups[0]
    shown = window.pages["plan"]
    shown.planning._push("Begin", ScanPlan(name="p", viewpoints=hub.viewpoints(), groups=(rim,)))
    yield shown
    end(application, qtbot)


@pytest.fixture
def checked(page, qtbot):
    check_at_once(page)
    qtbot.waitUntil(lambda: page.planning.prediction.is_current, timeout=20_000)
    return page


@pytest.fixture
def on_impeller(page, qtbot):
    """Return the page with the impeller, whose coverage is predicted."""
    check_at_once(page)
    page.planning.part.choose(resource("parts/impeller/nominal.stl"))
    prediction = page.planning.prediction
    qtbot.waitUntil(lambda: prediction.is_current and prediction.now.coverage is not None, timeout=60_000)
    return page
