"""The whole window: the demo from its button, cancel, messages, help, roles."""

from __future__ import annotations

import threading
from types import SimpleNamespace

import pytest
from PySide6.QtWidgets import QApplication

from measureapp.acquire import events as e
from measureapp.errors import InputError
from measureapp.pipeline import events as p
from ui.app import Reporter, open_demo
from ui.main_window import PAGES
from ui.widgets.properties_panel import Properties


@pytest.fixture
def demo(monkeypatch, measurement):
    """Replaces the real demo: sends its events, waits at the gate, reports on."""
    state = SimpleNamespace(gate=threading.Event(), requests=[], error=None)

    def scan_into_project(request, on_event, progress, _control, _held):
        state.requests.append(request)
        progress.report(0, 4, "Calibrating")
        on_event(p.CalibrationReady(measurement.calibration))
        on_event(e.RunStarted("six views", tuple(view.viewpoint_id for view in measurement.views)))
        for view in measurement.views:
            on_event(e.ViewpointStarted(view.viewpoint_id))
            on_event(e.ViewpointStored(view.viewpoint_id, 1.0))
            on_event(p.ViewReady(view))
        assert state.gate.wait(10)
        progress.report(3, 4, "Stitching")
        if state.error is not None:
            raise state.error
        on_event(p.StitchReady(measurement.stitched))
        on_event(p.InspectionReady(measurement.inspection))
        on_event(e.RunEnded("done"))
        return SimpleNamespace(measurement=measurement, document={}, files={}, filters=None)

    monkeypatch.setattr("measureapp.pipeline.run.scan_into_project", scan_into_project)
    yield state
    state.gate.set()


@pytest.fixture
def started(application, window, rig, demo, monkeypatch):
    monkeypatch.setattr(application.controllers.documents, "preview", lambda: None)
    application.session.set_rig(rig)
    window.pages["rig"].run_demo.click()
    return application


def idle(application) -> bool:
    return not application.controllers.jobs.queue.busy and not application.session.busy_with


def test_the_demo_runs_from_its_button_and_ends_with_dimensions_shown(started, window, demo, qtbot):
    session = started.session
    qtbot.waitUntil(lambda: len(session.views) == 6, timeout=10_000)
    assert session.calibration is not None
    assert window.strip.cancel.isVisible()
    assert window.strip.title.text() == "Demo: gypsum"
    assert not window.pages["rig"].run_demo.isEnabled()
    window.show_page("scan")
    assert window.pages["scan"].tiles.words().count("Processed") == 5
    demo.gate.set()
    qtbot.waitUntil(lambda: idle(started), timeout=10_000)
    window.show_page("inspection")
    assert [row[-2] for row in window.pages["inspection"].side.table.texts()] == ["Pass", "Fail", "Not proven", "Not measured"]
    assert "demo is complete" in window.strip.words
    assert not window.strip.cancel.isVisible()
    request = demo.requests[0]
    assert request.rig.driver_settings == {"part": "gypsum", "seed": 1, "conditions": "usual"} and request.rig.cameras[0].width_px == 648
    assert len(request.plan) == 8 and request.calibrate and request.resume
    assert "gypsum" in request.folder.name and request.created.nominal.is_file()


def test_cancel_stops_the_demo_and_keeps_what_is_known(started, window, demo, qtbot):
    session = started.session
    qtbot.waitUntil(lambda: len(session.views) == 6, timeout=10_000)
    window.strip.cancel.click()
    assert window.strip.cancel.text().strip() == "Stopping…"
    qtbot.waitUntil(lambda: "when the present step ends" in window.strip.note.text(), timeout=10_000)  # which takes long
    demo.gate.set()
    qtbot.waitUntil(lambda: idle(started), timeout=10_000)
    assert session.measurement is None
    assert len(session.views) == 6
    assert session.messages[-1].text == "Cancelled."
    assert window.pages["rig"].run_demo.isEnabled()


def test_a_failure_is_shown_with_its_remedy(started, window, demo, qtbot):
    demo.error = InputError("The disk is full.", "Free some space.")
    demo.gate.set()
    qtbot.waitUntil(lambda: idle(started), timeout=10_000)
    assert window.strip.words == "The disk is full. Free some space."
    assert started.session.messages[-1].level == "error"


def test_a_second_demo_waits_for_the_first(started, demo, qtbot):
    started.controllers.demo.run()
    assert "still running" in started.session.messages[-1].text
    demo.gate.set()
    qtbot.waitUntil(lambda: idle(started), timeout=10_000)
    assert len(demo.requests) == 1


def test_closing_during_a_job_asks_once_without_blocking_and_can_be_refused(started, window, demo, qtbot):
    assert not window.close()
    assert window.isVisible() and window.closing.isVisible()
    assert "still running" in window.closing.words.text()
    assert window.header.stop.isVisible() and window.header.stop.isEnabled()
    assert QApplication.activeModalWidget() is None
    window.closing.stay.click()
    assert not window.closing.isVisible()
    assert not window.close()
    demo.gate.set()
    window.closing.stop_and_close.click()
    assert not window.isVisible()
    running = started.controllers.jobs.queue.running
    assert running is None or running.isFinished()
    qtbot.waitUntil(lambda: idle(started), timeout=10_000)


def test_the_question_about_closing_goes_with_the_job(started, window, demo, qtbot):
    window.close()
    demo.gate.set()
    qtbot.waitUntil(lambda: idle(started), timeout=10_000)
    assert not window.closing.isVisible()


def test_an_error_nobody_caught_is_shown_as_a_sentence(application, window):
    report = Reporter(application.session)
    error = InputError("The plan is damaged.", "Plan again.")
    report(InputError, error, None)
    assert window.strip.words == "The plan is damaged. Plan again."
    report(ValueError, ValueError("x"), None)
    assert "ValueError" in application.session.messages[-1].text


def test_a_click_on_the_strip_opens_all_messages(application, window):
    application.session.tell("First.")
    application.session.tell("Second.", "Do this.", "warning")
    window.strip.message.click()
    assert [row[1] for row in window.messages.table.texts()] == ["Second.", "First."]
    window.messages.close()


def test_help_opens_at_the_page_one_is_on(window):
    for name, page in window.pages.items():
        window.show_page(name)
        window.header.helpClicked.emit()
        assert window.help.browser.toPlainText().startswith(page.word)
    window.help.close()


def test_every_link_of_the_help_leads_to_a_page():
    import re

    from measureapp.resources import resource

    pages = {path.name: path.read_text(encoding="utf-8") for path in resource("help").glob("*.md")}
    for text in pages.values():
        for target in re.findall(r"\]\(([^)]+)\)", text):
            assert target in pages


def test_the_rail_changes_pages_and_the_properties_fold(window):
    window.rail.buttons["clouds"].click()
    assert window.page.name == "clouds"
    assert window.properties.folded
    window.rail.buttons["calibration"].click()
    assert not window.properties.folded
    window.properties.toggle()
    assert window.properties.folded


def test_the_panel_shows_properties_of_the_page_in_sight_only(window):
    window.show_page("scan")  # once, when it shows what it has
    window.show_page("calibration")
    shown = window.properties.shown
    window.pages["scan"].show_properties(Properties("Out of sight"))
    assert window.properties.shown is shown
    window.show_page("scan")
    assert window.properties.shown.title == "Out of sight"


def test_pages_are_made_when_they_are_asked_for_and_the_rest_in_idle_moments(window, qtbot):
    def made():
        return [page.name for page in window.pages.made]

    assert made() == ["rig"]
    window.show_page("report")
    assert made() == ["rig", "report"] and len(window.pages) == len(PAGES)
    assert list(window.pages.words) == list(window.pages) == [kind.name for kind in PAGES]
    window.make_pages()
    qtbot.waitUntil(lambda: len(made()) == len(PAGES))
    assert made()[2:] == ["calibration", "plan", "scan", "clouds", "inspection"]


def test_the_theme_changes_while_the_window_is_open(application, window):
    before = window.grab().toImage().pixelColor(300, 400).lightness()
    application.look.set_shade("dark")
    assert window.grab().toImage().pixelColor(300, 400).lightness() < before - 100


def test_the_smallest_window_cuts_nothing_off(window):
    window.resize(1366, 768)
    assert window.minimumSizeHint().width() <= 1366
    assert window.minimumSizeHint().height() <= 768


def test_the_demo_project_is_open_before_it_has_run(application, window):
    open_demo(application)
    assert application.session.part == "gypsum"
    assert "demo-gypsum" in window.header.project.toolTip()


def test_a_folder_that_is_no_project_is_refused_in_words(application, window, qtbot, tmp_path):
    application.controllers.project.open(tmp_path)
    qtbot.waitUntil(lambda: idle(application), timeout=10_000)
    assert application.session.messages[-1].level == "error"
    assert str(tmp_path) in application.session.messages[-1].text


def test_the_name_of_the_project_is_shortened_only_where_it_does_not_fit(application, window, qtbot):
    name = "Demo: gypsum, half resolution, 8 views, seed 1, three close pitches"
    application.session.open_project(name, "gypsum", None)
    window.resize(1366, 768)
    qtbot.waitUntil(lambda: window.header.project.text().endswith("…"))
    assert window.header.project.toolTip() == name
    window.resize(1900, 768)
    qtbot.waitUntil(lambda: window.header.project.text() == name)


def test_a_quiet_job_that_ends_does_not_hide_the_running_one(application, qtbot):
    session, controllers = application.session, application.controllers
    gate = threading.Event()
    controllers.jobs.run("Demo: gear", lambda _job: gate.wait(10) and None, session.set_comparison)
    qtbot.waitUntil(lambda: session.busy_with == "Demo: gear", timeout=5_000)
    quiet = controllers.background.run("Comparing", lambda _job: None, session.set_comparison, quiet=True)
    with qtbot.waitSignal(controllers.background.queue.emptied, timeout=5_000):
        assert quiet.title == "Comparing"
    assert session.busy_with == "Demo: gear"
    gate.set()
    qtbot.waitUntil(lambda: idle(application), timeout=5_000)
