"""A message ends when its cause ends; the badge counts those that are open."""

from __future__ import annotations

import json
import zipfile

import pytest
from PySide6.QtWidgets import QFileDialog

from ui.messages import CALIBRATION, MOMENT, MOST, Messages
from ui.session import CellState


def open_texts(application) -> list[str]:
    return [message.text for message in application.session.messages.open]


def test_warnings_of_a_project_end_with_it(application, window):
    session = application.session
    session.tell("The filters do not fit.", "", "warning")
    session.tell("All is well.", "", "done")
    assert open_texts(application) == ["The filters do not fit."] and window.strip.all.text().strip() == "1"
    session.open_project("another", "gear", None)
    assert open_texts(application) == [] and window.strip.all.text() == ""


def test_a_refusal_ends_with_the_job_that_caused_it(application, window, tmp_path):
    session = application.session
    session.set_busy("Demo: gypsum")
    application.controllers.project.open(tmp_path)
    assert open_texts(application) == ["Demo: gypsum is still running."]
    assert not application.controllers.jobs.queue.busy
    session.set_busy("")
    assert open_texts(application) == [] and window.strip.words == ""


def test_a_stopped_rig_and_a_new_calibration_end_what_was_told_of_the_old(application, calibration):
    session = application.session
    session.set_cell(CellState(stopped="Stop was pressed."))
    session.tell("Everything was stopped.", "", "warning", cause="stopped")
    session.tell("Camera left moved.", "", "error", cause=CALIBRATION)
    session.set_cell(CellState())
    assert open_texts(application) == ["Camera left moved."]
    session.set_calibration(calibration)
    assert open_texts(application) == []


def test_a_failed_job_is_open_until_one_of_its_kind_succeeds(application, qtbot, tmp_path, window):
    from measureapp.errors import InputError

    def fail(_job):
        raise InputError("The disk is full.", "Free some space.")

    jobs, session = application.controllers.jobs, application.session
    jobs.run("Exporting", fail, session.set_comparison)
    qtbot.waitUntil(lambda: not jobs.queue.busy)
    assert open_texts(application) == ["The disk is full."]
    jobs.run("Exporting", lambda _job: None, session.set_comparison)
    qtbot.waitUntil(lambda: not jobs.queue.busy)
    assert open_texts(application) == []


def test_the_same_words_are_open_once_and_a_moment_never():
    messages = Messages()
    for _ in range(3):
        messages.add("No rig.", "Choose one.", "warning")
    messages.add("Cancelled.", "", "warning", cause=MOMENT)
    assert len(messages) == 4 and len(messages.open) == 1
    messages.dismiss(messages.open[0].id)
    assert messages.open == ()
    for number in range(MOST + 10):
        messages.add(f"{number}", "", "error")
    assert len(messages) == MOST == len(messages.open)


def test_the_message_centre_offers_the_remedy_and_closes_what_was_seen_to(application, window, qtbot):
    session, centre = application.session, window.messages
    session.set_busy("Demo: gypsum")
    session.refuse_during_job()
    session.tell("A cable is loose.", "Fasten it.", "warning")
    centre.begin()
    assert [row[3] for row in centre.table.texts()] == ["Still open", "Still open"]
    centre.table.selectRow(1)
    assert centre.remedy.text() == "Cancel the running job" and centre.remedy.isVisible()
    centre.remedy.click()
    centre.table.selectRow(0)
    assert not centre.remedy.isVisible()
    centre.dismiss.click()
    assert open_texts(application) == ["Demo: gypsum is still running."]
    session.set_busy("")
    centre.which.setValue("open")
    assert centre.table.texts() == []
    centre.close()


def test_the_log_for_support_holds_messages_settings_versions_and_graphics(application, window, qtbot, tmp_path, monkeypatch):
    target = tmp_path / "support.zip"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(target), ""))
    application.session.tell("The rig is not connected.", "Press Connect.", "warning")
    window.save_log()
    qtbot.waitUntil(lambda: application.session.messages[-1].text.startswith("The log is saved"), timeout=20_000)
    with zipfile.ZipFile(target) as archive:
        texts = {name: archive.read(name).decode() for name in archive.namelist()}
    assert "The rig is not connected. Press Connect." in texts["messages.txt"]
    assert "schema = " in texts["settings.txt"] and "PySide6" in texts["versions.txt"]
    assert texts["graphics.txt"].strip() and json.dumps(texts)


@pytest.mark.parametrize(("width", "most"), [(1280, 40), (1920, 20)])
def test_the_step_of_a_job_is_never_cut(window, qtbot, width, most):
    note = "Capturing viewpoint 14 of 26 with 4 exposures from 5 to 80 ms; 11 viewpoints are stored, and the table turns by 40° next"
    window.resize(width, 720)
    window.strip.show_job("Scanning: impeller, all sides")
    window.strip.show_progress(0.4, note)
    qtbot.wait(20)
    shown = window.strip.note
    assert shown.text() == note
    needed = shown.heightForWidth(shown.width())
    assert needed <= shown.height() and needed <= most


def test_every_remedy_that_a_message_names_is_an_action(window):
    from ui import messages

    for remedy in (messages.CANCEL, messages.SHOW_RIG, messages.SHOW_CALIBRATION, messages.OPEN_PROJECT, messages.RECOMPUTE):
        assert window.actions_.action(remedy) is not None
