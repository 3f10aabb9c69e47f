"""From the first start to the report of a part that was scanned on the virtual rig just now, in clicks and minutes."""

from __future__ import annotations

import time

import pytest

from tests.ui.journey.user import User, answering

MOST_CLICKS, MOST_S = 12, 900.0


@pytest.mark.slow
@pytest.mark.timed
def test_a_first_part_is_scanned_and_reported_in_a_few_clicks(application, window, heartbeat, qtbot, tmp_path):
    user, session, began = User(qtbot, heartbeat, "first"), application.session, time.monotonic()
    window.resize(1280, 720)
    application.controllers.startup.begin()
    window.tour.offer()
    user.click(window.tour.bar.end)
    rig = window.pages["rig"]
    user.wait(lambda: session.rig is not None and rig.run_demo.isVisible(), 60.0, "loading the rig")
    user.click(rig.form._resolution.button("quarter"))
    user.click(rig.run_demo)
    user.wait(lambda: session.measurement is not None and not session.busy_with, MOST_S, "demo")
    user.look_at(window, "demo")
    user.click(window.rail.buttons["report"])
    report, target = window.pages["report"], tmp_path / "report.pdf"
    user.wait(lambda: bool(report.pages), 120.0, "preview of the report")
    with answering(target):
        user.click(report.exports["pdf"])
    user.wait(target.exists, 120.0, "exporting the report")
    user.tell(f"{time.monotonic() - began:.0f} s")
    assert target.read_bytes().startswith(b"%PDF-")
    assert user.clicks <= MOST_CLICKS
    assert time.monotonic() - began < MOST_S
