"""An operator's way from the card to the filed verdict, and on to the next part."""

from __future__ import annotations

from dataclasses import replace

from measureapp.data.dimension import Verdict
from measureapp.errors import DeviceError
from measureapp.project.folder import ProjectFolder
from measureapp.project.identification_file import read_identification
from measureapp.project.series.store import SeriesStore
from tests.ui.conftest import graphics_are_missing
from tests.ui.operator.conftest import Ticket
from ui.controllers.operator_nouns import UNREASONED
from ui.messages import STOPPED
from ui.session import RunNow


def test_after_identification_three_presses_lead_to_the_next_part(workshop):
    workshop.identify("GC-0001")
    screens = workshop.screens
    screens.identify.next.click()  # the identification is complete
    presses = []
    workshop.wait(lambda: workshop.operator.obstacles is not None)
    screens.load.confirm.done = True
    screens.load.confirm.held.emit()
    presses.append("held")
    screens.load.start.click()
    presses.append("start")
    assert screens.screens.currentWidget() is screens.verdict and screens.verdict.band.word.text() == "PASS"
    workshop.wait(lambda: workshop.operator.filed is not None)
    screens.verdict.next.click()
    presses.append("next part")
    assert screens.screens.currentWidget() is screens.identify and len(presses) == 3
    assert screens.identify.fields["serial"].text() == ""  # never offered again


def test_the_result_and_its_report_are_filed_under_the_serial_number(workshop):
    workshop.verdicts = ("pass", "fail", "pass", "not measured")
    workshop.identify("GC-0002")
    workshop.screens.identify.fields["order"].setText("A-77")
    workshop.screens.identify.fields["operator"].setText("Ada")
    workshop.screens.identify.next.click()
    workshop.load_and_start()
    workshop.wait(lambda: workshop.operator.filed is not None)
    (run,) = SeriesStore("Gypsum cross").runs(serial_number="GC-0002")
    assert run.verdict is Verdict.FAIL
    assert (run.identification.order, run.identification.operator, run.identification.drawing) == ("A-77", "Ada", "D-1807")
    report = workshop.operator.filed.report
    assert report.name == "GC-0002 run-1 fail.pdf" and report.read_bytes().startswith(b"%PDF")
    folder = workshop.requests[0].folder
    assert read_identification(folder).serial_number == "GC-0002"
    assert ProjectFolder.open(folder).name == "Gypsum cross GC-0002"


def test_a_part_that_fails_looks_failed_wherever_its_result_is_shown(workshop):
    workshop.verdicts = ("pass", "fail", "not proven", "pass")
    workshop.begin("GC-0003")
    screens = workshop.screens
    assert screens.verdict.band.verdict == "fail" and screens.verdict.band.word.text() == "FAIL"
    assert screens.verdict.band.accessibleName().startswith("FAIL.")
    assert "b  Fail" in [label.text for label in screens.verdict.view.view._labels]
    workshop.wait(lambda: workshop.operator.filed is not None)
    workshop.wait(lambda: workshop.operator.runs)
    screens.verdict.details.click()
    assert screens.details.names[0] == "b"
    screens.details.back.click()
    assert screens.strip.counts["fail"].text() == "1 fail"
    workshop.operator.go_home()
    workshop.wait(lambda: any(button.card.last is not None for button in screens.home.grid.buttons))
    assert [button.card.last.verdict for button in screens.home.grid.buttons if button.card.last] == [Verdict.FAIL]


def test_the_worst_dimension_decides_and_without_any_nothing_passes(workshop):
    words = {
        ("pass", "not measured", "pass", "pass"): "NOT MEASURED",
        ("not measured", "not proven", "pass", "pass"): "NOT PROVEN",
        ("not measured", "not proven", "fail", "pass"): "FAIL",
        (): "NOT MEASURED",
    }
    for number, (verdicts, word) in enumerate(words.items()):
        workshop.verdicts = verdicts
        workshop.begin(f"GC-004{number}")
        assert workshop.screens.verdict.band.word.text() == word
        workshop.wait(lambda: workshop.operator.filed is not None)


def test_a_part_is_measured_again_only_with_an_answer_why_and_both_runs_are_kept(workshop):
    workshop.verdicts = ("fail", "pass", "pass", "pass")
    workshop.begin("GC-0005")
    workshop.wait(lambda: workshop.operator.filed is not None)
    workshop.wait(lambda: workshop.operator.runs)
    screens = workshop.screens
    screens.verdict.again.click()
    assert not screens.repeat.again.isEnabled()
    screens.repeat.reasons.buttons[UNREASONED].click()
    screens.repeat.again.click()
    workshop.verdicts = ("pass", "pass", "pass", "pass")
    workshop.load_and_start()
    workshop.wait(lambda: workshop.operator.filed is not None and workshop.operator.filed.run is not None)
    workshop.wait(lambda: len(workshop.operator.runs) == 2)
    assert not workshop.operator.counts()  # a FAIL is not replaced without a reason
    assert "first run" in screens.verdict.filed.text()
    screens.verdict.next.click()
    screens.identify.fields["serial"].setText("GC-0005")
    assert screens.identify.known.isVisible() and not screens.identify.next.isEnabled()
    assert "an earlier run counts: FAIL" in screens.identify.before.text()
    screens.identify.result.click()
    assert screens.details.title.text().startswith("GC-0005") and screens.details.title.text().endswith("PASS")
    screens.details.back.click()


def test_what_is_required_is_asked_for(workshop):
    workshop.identify("")
    screens = workshop.screens
    assert not screens.identify.next.isEnabled() and "*" in screens.identify._names["serial"].text()
    screens.identify.fields["serial"].setText("   ")
    assert not screens.identify.next.isEnabled()
    screens.identify.fields["serial"].setText("GC-0006")
    assert screens.identify.next.isEnabled()


def test_after_a_fault_it_says_what_is_kept_and_resumes_in_the_same_folder(workshop):
    workshop.fault = DeviceError("The projector does not answer.", "Check its cable.")
    workshop.begin("GC-0007")
    run = workshop.screens.run
    assert run.cause.text() == "The projector does not answer." and run.remedy.text() == "For the engineer: Check its cable."
    assert run.kept.text() == "1 of 6 viewpoints are stored and kept."
    following = list(workshop.requests[0].plan)[1].id
    assert following in run.press.text()
    workshop.fault = None
    run.resume.held.emit()
    assert workshop.requests[1].folder == workshop.requests[0].folder and workshop.requests[1].resume
    assert workshop.screens.verdict.band.word.text() == "PASS"
    workshop.wait(lambda: workshop.operator.filed is not None)


def test_a_stop_before_the_first_viewpoint_offers_what_it_speaks_of(workshop, monkeypatch):
    session = workshop.application.session

    def stop(_title, make, _subject) -> None:
        request = make(Ticket())
        workshop.requests.append(request)
        session.set_run(RunNow("running"))
        session.set_plan(request.plan)
        session.tell("Cancelled.", "Data stored so far is kept.", "warning")
        session.set_run(RunNow("idle"))

    monkeypatch.setattr(workshop.application.controllers.scanning, "run", stop)
    workshop.begin("GC-0011")
    run = workshop.screens.run
    assert run.cause.text() == "The measurement was stopped." and not run.remedy.isVisible()
    assert run.kept.text() == "No viewpoint was stored yet."
    assert "hold Resume" in run.press.text() and run.resume.isVisible()
    run.resume.held.emit()
    assert workshop.requests[1].folder == workshop.requests[0].folder  # with the calibration that was begun there


def test_stop_is_answered_at_once_and_an_operator_is_not_sent_to_a_page_he_has_not(workshop, monkeypatch):
    session = workshop.application.session
    monkeypatch.setattr(workshop.application.controllers.scanning, "run", lambda *_: session.set_run(RunNow("running")))
    workshop.begin("GC-0012")
    run = workshop.screens.run
    session.set_run(RunNow("paused", "The project folder is gone.", "Connect its disk again."))
    run.stop.click()
    session.set_run(RunNow("running"))
    assert run.words.text() == "Stopping…" and not run.stop.isEnabled() and not run.pause.isEnabled()
    session.tell("Cancelled.", "Data stored so far is kept.", "warning")
    session.tell("Everything was stopped.", "Reset the stop on the Rig page before anything moves again.", "warning", cause=STOPPED)
    session.set_run(RunNow("idle"))
    assert run.cause.text() == "The measurement was stopped." and run.remedy.text() == "For the engineer: The project folder is gone."


def test_what_is_gone_with_its_folder_is_not_said_to_be_kept(workshop):
    workshop.fault, workshop.is_folder_lost = DeviceError("The project folder is gone.", ""), True
    workshop.begin("GC-0016")
    run = workshop.screens.run
    workshop.wait(lambda: workshop.operator.fault.is_lost)
    assert run.kept.text() == "The folder of this part is gone, with all that was stored in it."
    assert run.press.text() == "When it is back, hold Resume. Otherwise start again." and run.resume.isVisible()


def test_the_engineer_can_be_called_while_a_run_is_paused(workshop, monkeypatch):
    session = workshop.application.session
    monkeypatch.setattr(workshop.application.controllers.scanning, "run", lambda *_: session.set_run(RunNow("running")))
    workshop.begin("GC-0017")
    run = workshop.screens.run
    assert not run.help.isVisible()
    session.set_run(RunNow("paused", "The project folder is gone.", "Connect its disk again."))
    run.help.click()
    assert "The project folder is gone." in workshop.screens.call.words.text()


def test_a_fault_of_many_words_leaves_the_buttons_where_they_are_pressed(workshop):
    workshop.fault = DeviceError("Seven devices cannot be connected. " + "Camera left: no camera with this serial number answers. " * 12)
    workshop.window.resize(1280, 720)
    workshop.begin("GC-0013")
    run, call = workshop.screens.run, workshop.screens.call
    run.call.click()
    workshop.qtbot.wait(20)
    buttons = (run.resume, run.again, run.home, run.call)
    assert all(button.height() >= 56 for button in buttons) and run.cause.height() >= run.cause.heightForWidth(run.cause.width())
    places = [button.mapTo(workshop.window, button.rect().topLeft()).y() for button in (run.resume, run.again, run.call)]
    assert places[0] + run.resume.height() <= places[1] and places[1] + run.again.height() <= places[2]
    assert call.isVisible() and call.height() < 160


def test_start_again_says_why_it_cannot(workshop):
    workshop.fault = DeviceError("The robot was stopped.", "")
    workshop.begin("GC-0014")
    session = workshop.application.session
    session.set_cell(replace(session.cell, stopped="The door is open."))
    workshop.screens.run.again.click()
    assert len(workshop.requests) == 1 and "The rig was stopped: The door is open." in workshop.screens._words.text()
    assert workshop.screens.words.isVisible()


def test_start_is_disabled_with_the_reason_in_sight(workshop, monkeypatch):
    monkeypatch.setattr("ui.controllers.operator_work.RESERVE_BYTES", 1e18)
    workshop.identify("GC-0008")
    workshop.screens.identify.next.click()
    workshop.wait(lambda: workshop.operator.obstacles is not None)
    load = workshop.screens.load
    load.confirm.done = True
    load.confirm.held.emit()
    assert load.start.isVisible() and not load.start.isEnabled()
    assert "GB free" in load.why.text() and "Call the engineer." in load.why.text()
    load.call.click()
    assert workshop.screens.call.isVisible() and "GB free" in workshop.screens.call.words.text()


def test_a_check_before_the_start_that_takes_a_moment_is_no_error(workshop):
    workshop.identify("GC-0010")
    workshop.screens.identify.next.click()
    load, operator = workshop.screens.load, workshop.operator
    workshop.wait(lambda: operator.obstacles is not None)
    operator.obstacles = None
    operator.obstaclesChanged.emit()
    assert load.why.text() == "The calibration and the disk are being checked." and load.why.property("op") == "strong"
    operator.obstacles = ("The disk is full.",)
    operator.obstaclesChanged.emit()
    assert load.why.text() == "The disk is full." and load.why.property("op") == "error"


def test_a_rig_without_calibration_does_not_start(workshop, rig):
    real = rig.model_copy(update={"driver": "recorded", "name": "Cell 2"})
    workshop.application.session.set_rig(real)
    workshop.identify("GC-0009")
    workshop.screens.identify.next.click()
    workshop.wait(lambda: workshop.operator.obstacles is not None)
    assert workshop.operator.why_not() == ("Cell 2 has no calibration. Call the engineer.",)


def test_the_calibration_of_one_run_of_the_virtual_rig_serves_the_next_ones(workshop):
    for number in (1, 2):
        workshop.begin(f"GC-010{number}")
        workshop.wait(lambda: workshop.operator.filed is not None and workshop.operator.shelf.settings.calibrated)
    first, second = workshop.requests
    assert first.calibrate and first.calibrated is None
    assert not second.calibrate and second.calibrated == first.folder
    assert second.rig.driver_settings["part"] == "gypsum" and second.rig.camera("left").width_px == 648


def test_a_damaged_program_file_is_a_card_that_says_so(workshop, tmp_path):
    (tmp_path / "MeasureApp" / "programs" / "bracket.mpart").write_bytes(b"PK nothing")
    workshop.operator.stock.reload()
    workshop.wait(lambda: len(workshop.operator.shelf.cards) == 3)
    last = workshop.operator.shelf.cards[-1]
    assert last.name == "bracket.mpart" and "cannot be read as a part program" in last.problem
    workshop.screens.home.grid.buttons[-1].click()
    assert workshop.operator.step == "home" and "cannot be read" in workshop.screens._words.text()


def test_until_the_first_viewpoint_the_screen_says_what_happens(workshop, monkeypatch):
    session = workshop.application.session
    session.set_graphics("failed" if graphics_are_missing() else "ready", "No graphics in this test.")
    monkeypatch.setattr(workshop.application.controllers.scanning, "run", lambda *_: session.set_run(RunNow("running")))
    workshop.begin("4711-9")
    run = workshop.screens.run
    workshop.wait(run.isVisible)
    assert run.words.text() == "The measurement is being prepared"  # a calibration may be there already
    workshop.application.controllers.jobs.progressed.emit(0.0, "Preparing the scan")
    assert run.words.text() == "Preparing the scan"  # nor is it read at once
    workshop.operator.run.calibrates = True
    workshop.application.controllers.jobs.progressed.emit(0.01, "Images of the board from pose01")
    assert run.words.text() == "The rig is calibrated first"
    workshop.operator.run.calibrates = False
    workshop.application.controllers.jobs.progressed.emit(0.01, "joint registration: 3 of 8")
    assert run.words.text() == "Joint registration"
    assert not run.pause.isEnabled()  # images are no longer taken
    assert run.time.text().endswith(" s so far")
    shown = run.view.view._stack.currentWidget()
    if not graphics_are_missing():
        workshop.wait(lambda: run.view.view.is_live)
        assert shown.text().startswith("The measured points appear here")
        colours = {shown.grab().toImage().pixelColor(x, shown.height() // 2).name() for x in range(shown.width())}
        assert len(colours) > 3  # letters
