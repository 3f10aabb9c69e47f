"""The tour at the first start: from nothing to a report in a few clicks, on a sample project."""

from __future__ import annotations

import time

import pytest

from tests.ui.journey.user import User, answering
from ui.pages.page import SAMPLE
from ui.shell.project_menu import SAMPLES
from ui.shell.tour import STEPS

MOST_CLICKS, MOST_S = 12, 900.0
PATIENCE_S = 120.0


def test_from_the_first_start_to_a_report_in_a_few_clicks(application, window, heartbeat, qtbot, tmp_path):
    user, tour, session = User(qtbot, heartbeat, "tour"), window.tour, application.session
    began = time.monotonic()
    window.resize(1280, 720)
    tour.offer()
    user.look_at(window, "welcome")
    user.click(tour.bar.next)
    user.wait(lambda: session.measurement is not None and not session.busy_with, PATIENCE_S, "opening the sample")
    for step in STEPS[1:]:
        user.click(tour.bar.next)
        assert window.page.name == step.page
        assert not window.page.is_empty
        user.look_at(window, step.page)
    report, target = window.pages["report"], tmp_path / "first report.pdf"
    user.wait(lambda: bool(report.pages), PATIENCE_S, "preview of the report")
    with answering(target):
        user.click(report.exports["pdf"])
    user.wait(target.exists, PATIENCE_S, "exporting the report")
    user.click(tour.bar.next)
    assert not tour.bar.isVisible()
    assert target.read_bytes().startswith(b"%PDF-") and target.stat().st_size > 100_000
    assert user.clicks <= MOST_CLICKS
    assert time.monotonic() - began < MOST_S


def test_the_tour_is_offered_once_and_taken_again_from_help(application, window, qtbot):
    tour = window.tour
    tour.offer()
    assert tour.bar.isVisible() and tour.bar.next.hasFocus()
    tour.bar.end.click()
    assert not tour.bar.isVisible()
    tour.offer()
    assert not tour.bar.isVisible()
    window.help.show_page("rig")
    window.help.tour.click()
    assert tour.bar.isVisible() and not window.help.isVisible()
    tour.end()
    window.actions_.perform("tour")
    assert tour.bar.isVisible()


def test_an_operator_is_offered_no_tour(application, window):
    application.session.set_role("operator")
    window.tour.offer()
    assert not window.tour.bar.isVisible()


def test_the_tour_goes_back_and_follows_no_other_project(application, window, qtbot, measurement):
    session, tour = application.session, window.tour
    tour.offer()
    session.open_project("another", "gypsum", None)
    assert tour.step.page == ""
    tour._waits = True
    session.open_project("sample", "gypsum", application.settings.folder("projects"))
    assert tour.step is STEPS[0] and not tour.bar.back.isVisible()
    tour.bar.next.click()
    assert window.page.name == "calibration"
    tour.bar.back.click()
    assert window.page.name == "rig"


def test_pages_of_results_offer_the_sample(application, window, qtbot, monkeypatch):
    opened = []
    monkeypatch.setattr(type(application.controllers.project), "open_sample", lambda _self, name: opened.append(name))
    for name in ("clouds", "inspection", "report"):
        window.show_page(name)
        window.pages[name].sample.click()
    assert opened == [SAMPLE] * 3


def test_every_shipped_sample_is_in_the_menu(application, window, qtbot):
    from measureapp.pipeline.samples import sample_names

    assert set(SAMPLES) == set(sample_names())
    window.project_menu.fill(window.header.menu, window.actions_)
    entry = next(action for action in window.header.menu.actions() if action.text() == "Open a sample")
    assert len(entry.menu().actions()) == len(SAMPLES)


@pytest.mark.parametrize("busy", [True, False])
def test_work_in_the_background_waits_for_a_job_that_somebody_waits_for(busy, monkeypatch):
    from measureapp.progress import NoProgress
    from ui.controllers import startup

    monkeypatch.setattr(startup, "LONGEST_YIELD_S", 0.3)
    began = time.monotonic()
    startup.Yielding(NoProgress(), lambda: busy).report(0, 1)
    assert (time.monotonic() - began >= 0.3) == busy
