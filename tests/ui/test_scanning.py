"""The page Scan with a run that is quick: choose, check, start, pause, resume, skip, retake, stop, and go on later."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QThread

from measureapp.acquire import events as e
from measureapp.acquire.run_states import ViewpointState
from measureapp.data.storage_rules import StorageRules
from measureapp.errors import PlanError, StorageError
from measureapp.pipeline import events as p
from measureapp.pipeline.preflight import Preflight
from measureapp.project.folder import ProjectFolder, ProjectSettings
from tests.ui.scan_runs import QuickRun
from ui.controllers.scan_choices import ScanChoices
from ui.pages.scan.page import left_words, state_words

PATIENCE_MS = 20_000


@pytest.fixture
def quick(monkeypatch, measurement):
    views = {view.viewpoint_id: view for view in measurement.views}
    made = QuickRun(views.__getitem__)
    monkeypatch.setattr("measureapp.pipeline.run.scan_into_project", made.scan_into_project)
    monkeypatch.setattr("measureapp.pipeline.run.rehearse", lambda *_: made.found)
    made.found = Preflight((), (), 3_600_000_000, 190.0)
    yield made
    made.gate.set()


@pytest.fixture
def page(application, window, rig, plan, quick):
    application.session.set_rig(rig.at_resolution("quarter").model_copy(update={"driver_settings": {"part": "flat"}}))
    application.session.set_plan(plan)
    window.show_page("scan")
    return window.pages["scan"]


@pytest.fixture
def idle(application, qtbot):
    def wait() -> None:
        qtbot.waitUntil(
            lambda: not application.controllers.jobs.queue.busy and application.session.run.state == "idle", timeout=PATIENCE_MS
        )

    return wait


@pytest.fixture
def running(application, page, quick, tmp_path, qtbot):
    page.empty.button.click()
    page.setup.setValue(ScanChoices(tmp_path / "scan", part="wheel"))
    page.setup.start.click()
    qtbot.waitUntil(lambda: "Capturing" in page.tiles.words(), timeout=PATIENCE_MS)
    return page


def test_choices_are_edited_and_given_back(page, tmp_path):
    chosen = ScanChoices(
        tmp_path / "a b", "Wheel", tmp_path / "n.stl", tmp_path / "p.toml", tmp_path / "c", tmp_path / "q.toml", "each", 7.5, "compress"
    )
    page.setup.setValue(chosen)
    assert page.setup.value() == chosen


def test_start_needs_a_folder_and_a_plan(application, page, tmp_path):
    page.empty.button.click()
    page.setup.setValue(ScanChoices())
    assert not page.setup.start.isEnabled() and "project folder" in page.setup.start.toolTip()
    page.setup.folder.setValue(tmp_path / "scan")
    assert page.setup.start.isEnabled()
    application.session.set_plan(None)
    assert not page.setup.start.isEnabled()


def test_a_scan_connects_the_rig_and_shows_every_state(application, running, quick, idle, qtbot, tmp_path):
    assert application.session.cell.connected
    assert quick.helds == [application.session.connection]  # not connected a second time
    request = quick.requests[0]
    assert (request.folder, request.created.part, request.bracket_s) == (tmp_path / "scan", "wheel", None)
    assert running.tiles.words()[0] == "Capturing" and running.tiles.words()[1:] == ["Waiting"] * 5
    assert running.bar.pause.isVisible() and not running.bar.resume.isVisible()
    assert "left" in running.bar.words.text()
    quick.gate.set()
    idle()
    assert running.state.text() == "5 of 6 viewpoints processed, 1 failed."
    assert not running.bar.pause.isVisible()


def test_a_scan_that_is_over_before_the_window_looks_again_ends_in_the_window_too(page, quick, idle, tmp_path, monkeypatch):
    def start_and_wait(job):
        QThread.start(job)
        assert job.wait(PATIENCE_MS)

    page.empty.button.click()
    page.setup.setValue(ScanChoices(tmp_path / "scan", part="wheel"))
    quick.gate.set()
    monkeypatch.setattr("ui.workers.job.Job.start", start_and_wait)
    page.setup.start.click()
    idle()
    assert len(quick.requests) == 1 and "5 of 6" in page.state.text()


def test_problems_are_listed_with_their_remedies_and_nothing_starts(application, page, quick, idle, tmp_path):
    quick.found = Preflight((PlanError("view-03 is out of reach.", "Bring it nearer."),), ("The calibration is old.",), 1, 1.0)
    page.empty.button.click()
    page.setup.setValue(ScanChoices(tmp_path / "scan"))
    page.setup.start.click()
    idle()
    assert [(item.kind, item.words, item.remedy) for item in page.setup.found.items[:2]] == [
        ("problem", "view-03 is out of reach.", "Bring it nearer."),
        ("warning", "The calibration is old.", ""),
    ]
    assert quick.requests == []
    assert "prevents the scan" in application.session.messages[-1].text


def test_check_starts_nothing(page, quick, idle, tmp_path):
    page.empty.button.click()
    page.setup.setValue(ScanChoices(tmp_path / "scan"))
    page.setup.check.click()
    idle()
    assert page.setup.found.items[0].words == "Nothing prevents the scan."
    assert quick.requests == []


def test_pause_says_why_and_resume_goes_on(application, running, quick, idle, qtbot):
    running.bar.pause.click()
    assert not running.bar.pause.isEnabled()
    quick.gate.set()
    qtbot.waitUntil(lambda: application.session.run.state == "paused", timeout=PATIENCE_MS)
    assert running.bar.words.text() == "Paused by the user. Resume the run to go on."
    assert not running.bar.pause.isVisible()
    running.bar.resume.click()
    idle()
    assert "Waiting" not in running.tiles.words()


def test_a_pause_before_the_scan_begins_is_kept_until_it_does(application, page, quick, idle, tmp_path, qtbot):
    quick.before.clear()
    page.empty.button.click()
    page.setup.setValue(ScanChoices(tmp_path / "scan", part="wheel"))
    page.setup.start.click()
    qtbot.waitUntil(lambda: len(quick.controls) == 1, timeout=PATIENCE_MS)
    page.bar.pause.click()
    assert page.bar.words.text() == "The scan pauses before its first viewpoint; what comes before it can only be cancelled."
    assert application.session.messages == [] or "not started" not in application.session.messages[-1].text
    quick.before.set()
    qtbot.waitUntil(lambda: application.session.run.cause == "", timeout=PATIENCE_MS)
    quick.gate.set()
    qtbot.waitUntil(lambda: application.session.run.state == "paused", timeout=PATIENCE_MS)
    page.bar.resume.click()
    idle()


def test_a_waiting_viewpoint_is_skipped_and_a_stored_one_taken_again(application, running, quick, idle, qtbot):
    running.tiles.tileClicked.emit("view-03")
    assert running.tiles.chosen == "view-03" and not running.bar.retake.isVisible()
    running.bar.skip.click()
    snapshot = quick.controls[0].snapshot()
    assert snapshot.viewpoints["view-03"] is ViewpointState.SKIPPED and "view-03" not in snapshot.waiting
    quick.gate.set()
    idle()
    assert running.tiles.words()[2] == "Waiting"  # the quick run reports nothing about skipped ones


def test_a_request_that_makes_no_sense_is_answered_in_words(application, running):
    application.controllers.scanning.retake("view-01")
    assert application.session.messages[-1].text == "Viewpoint view-01 is being taken."
    application.controllers.scanning.skip("nowhere")
    assert "no viewpoint 'nowhere'" in application.session.messages[-1].text


def test_stop_ends_the_run_at_once(application, running, window, idle):
    assert window.header.stop.isVisible()
    window.header.stop.click()
    idle()
    assert not running.bar.pause.isVisible()


def test_a_project_that_another_window_uses_is_refused_with_its_holder(application, running, quick, idle):
    quick.error = StorageError("/p is in use by another window or command.", "Wait until it has finished.")
    quick.gate.set()
    idle()
    assert application.session.messages[-1].text == "/p is in use by another window or command."


def test_an_interrupted_scan_goes_on_with_what_is_missing(application, page, quick, idle, tmp_path, plan, monkeypatch):
    rig = application.session.rig
    project = ProjectFolder.create(tmp_path / "kept", ProjectSettings(name="kept", part="wheel", rig=rig))
    project.save_plan(plan)
    application.session.open_project("kept", "wheel", project.path)
    application.session.set_plan(plan)
    for name in ("view-01", "view-02"):
        application.session.set_viewpoint(name, "stored")
    assert page.go_on.isVisible() and page.go_on.toolTip() == "2 viewpoints are stored and kept, 4 missing are taken"
    quick.gate.set()
    page.go_on.click()
    idle()
    request = quick.requests[0]
    assert (request.folder, request.resume, request.created, request.retake) == (project.path, True, None, ())


def test_stored_viewpoints_keep_their_tiles_when_a_scan_goes_on(application, plan):
    session = application.session
    session.set_plan(plan)
    session.set_viewpoint("view-01", "stored")
    session.await_viewpoints(("view-04", "view-02"))
    assert list(session.viewpoints) == [viewpoint.id for viewpoint in plan]
    assert session.viewpoints["view-01"].status == "stored"


def test_after_the_scan_a_viewpoint_is_taken_again_on_request(application, page, quick, idle, tmp_path, plan):
    project = ProjectFolder.create(tmp_path / "kept", ProjectSettings(name="kept", part="wheel", rig=application.session.rig))
    application.session.open_project("kept", "wheel", project.path)
    application.session.set_plan(plan)
    application.session.set_viewpoint("view-05", "failed", "too dark")
    page.tiles.tileClicked.emit("view-05")
    assert page.bar.retake.isVisible()
    quick.gate.set()
    page.bar.retake.click()
    idle()
    assert quick.requests[0].retake == ("view-05",)


def test_the_share_of_saturated_pixels_is_stated(application, page):
    pixels = np.full((486, 648), 90, np.uint8)
    pixels[:, :324] = 255
    page.show_images((e.ImageTaken("view-02", "left", 80_000, pixels),))
    assert page.pictures.images["left"].caption.replace("\u00a0", " ") == "left · 80 ms · 50.0 % saturated"


def test_words_about_progress_and_time():
    assert state_words(["processed", "stored", "failed", "skipped", "waiting"]) == (
        "1 of 5 viewpoints processed, 2 stored, 1 failed, 1 skipped."
    )
    left = SimpleNamespace(expected_s=100.0, bound_s=170.0)
    assert left_words(left).replace("\u00a0", " ").startswith("About 2 min left, at most 3 min")


def test_a_run_that_is_cancelled_leaves_no_thread(application, running, idle):
    application.controllers.jobs.cancel()
    idle()
    assert application.controllers.scanning.left() is None


def test_of_many_images_that_arrive_at_once_only_the_newest_is_converted(application, page, monkeypatch):
    shown = []
    monkeypatch.setattr(page.pictures, "show_image", lambda camera, pixels, *_: shown.append((camera, int(pixels[0, 0]))))
    for level in range(50):
        application.session.images.put("left", e.ImageTaken("view-01", "left", 80_000, np.full((4, 4), level, np.uint8)))
    page._take_images()
    assert shown == [("left", 49)]


@pytest.fixture
def scanned(application, page, tmp_path, plan, measurement):
    """The page after a scan of a project with a nominal."""
    project = ProjectFolder.create(tmp_path / "kept", ProjectSettings(name="kept", part="wheel", rig=application.session.rig))
    project.save_plan(plan)
    (project.path / "inspection").mkdir()
    (project.path / "inspection" / "nominal.stl").write_bytes(b"")
    application.session.open_project("kept", "wheel", project.path)
    application.session.set_plan(plan)
    application.session.set_measurement(measurement, {})
    return page


@pytest.fixture
def proposed(plan, monkeypatch):
    further = plan.viewpoints[0].model_copy(update={"id": "more-01"})
    found = SimpleNamespace(
        sufficient=0.93,
        accessible=0.98,
        expected=0.96,
        median_sigma_mm=0.0112,
        shares=lambda: {"too dark": 0.04},
        proposals=(SimpleNamespace(viewpoint=further, share=0.03, seconds=41.0, reason="sees the slot"),),
        plan=plan.model_copy(update={"viewpoints": (*plan.viewpoints, further)}),
    )
    monkeypatch.setattr("measureapp.pipeline.closed_loop.of_project.find_next_views", lambda *_, **__: found)
    return found


def test_what_is_missing_is_listed_with_causes_and_views_that_pay_which_are_scanned_on_request(application, scanned, proposed, quick, idle):
    assert scanned.missing.isVisible()
    scanned.missing.click()
    idle()
    words = [item.words.replace("\u00a0", " ") for item in scanned.missing_dialog.list.items]
    assert words == [
        "93.0 % of the surface is measured, of 98.0 % that does not touch the support.",
        "4.0 % is missing: too dark.",
        "more-01: + 3.0 % in 50 s.",
        "With all of them 96.0 % are expected.",
    ]
    quick.gate.set()
    quick.view_of = lambda name: application.session.views[0]
    scanned.missing_dialog.scan.click()
    idle()
    assert [viewpoint.id for viewpoint in quick.requests[0].plan][-1] == "more-01"
    assert quick.requests[0].resume and ProjectFolder.open(quick.requests[0].folder).plan() == proposed.plan


def test_a_new_scan_of_the_same_part_begins_with_its_documents_and_calibration(application, scanned):
    scanned.new.click()
    chosen = scanned.setup.value()
    folder = application.session.folder
    assert (chosen.part, chosen.nominal, chosen.calibrated) == ("wheel", folder / "inspection" / "nominal.stl", folder)
    assert chosen.folder is not None and not chosen.folder.exists()
    assert scanned.back.isVisible()
    scanned.back.click()
    assert scanned.new.isVisible()


def test_exposures_chosen_by_a_probe_are_reported(application):
    application.controllers.scanning._events.apply(p.ExposuresChosen((80_000, 20_000), 0.91, 0.84, "", "view-02"))
    said = application.session.messages[-1].text.replace("\u00a0", " ")
    assert said == "Viewpoint view-02: exposures of 80, 20 ms chosen by a probe: 91.0 % of the lit pixels decodable, 84.0 % as planned."


def test_a_project_without_nominal_and_program_gets_them_with_the_scan_and_one_that_has_them_keeps_them(
    application, page, quick, idle, tmp_path
):
    project = ProjectFolder.create(tmp_path / "board", ProjectSettings(name="board", part="wheel", rig=application.session.rig))
    page.set_up()
    page.setup.setValue(ScanChoices(project.path, nominal=tmp_path / "n.stl"))
    assert page.setup.nominal.isVisible() and not page.setup.part.isVisible()
    quick.gate.set()
    page.setup.start.click()
    idle()
    created = quick.requests[0].created
    assert (created.name, created.part, created.nominal) == ("board", "wheel", tmp_path / "n.stl")
    (project.path / "inspection").mkdir()
    (project.path / "inspection" / "nominal.stl").write_bytes(b"")
    page.set_up()
    assert not page.setup.nominal.isVisible()


def test_a_scan_that_was_stopped_says_so_on_the_page_rig(application, running, window, idle, qtbot):
    application.session.connection.latch.set("Stop was pressed.")
    application.controllers.jobs.cancel()
    idle()
    qtbot.waitUntil(lambda: application.session.cell.stopped == "Stop was pressed.", timeout=PATIENCE_MS)


def test_of_a_bracket_the_longest_exposure_that_is_hardly_saturated_stays(page):
    def send(exposure_us, level, viewpoint="view-01"):
        page.show_images((e.ImageTaken(viewpoint, "left", exposure_us, np.full((486, 648), level, np.uint8)),))
        return page.pictures.images["left"].caption.replace("\u00a0", " ")

    assert send(100_000, 255) == "left · 100 ms · 100.0 % saturated"
    assert send(40_000, 200) == "left · 40 ms"
    assert send(20_000, 100) == "left · 40 ms"
    assert send(100_000, 120, "view-02") == "left · 100 ms"


def test_a_scan_of_which_everything_is_stored_has_no_time_left(application, page):
    scanning = application.controllers.scanning
    scanning._apply(e.RunStarted("six views", ()))
    assert scanning.left() is None


def test_raw_images_are_compressed_after_the_scan_as_the_project_states(application, running, quick, idle, monkeypatch, measurement, qtbot):
    from measureapp.pipeline.raw_keeping import RawOutcome
    from measureapp.pipeline.run import Outcome

    folder = application.session.folder
    project = ProjectFolder.create(folder, ProjectSettings(name="kept", part="wheel", rig=application.session.rig))
    project.save_storage_rules(StorageRules(raw="compress"))
    monkeypatch.setattr("measureapp.pipeline.raw_keeping.apply_raw_policy", lambda *_: RawOutcome("compress", ("view-01",), 5_000_000))
    quick.outcome = Outcome(measurement, {}, {})
    quick.gate.set()
    idle()
    qtbot.waitUntil(lambda: "5 MB freed" in application.session.messages[-1].text, timeout=PATIENCE_MS)


def test_a_scan_writes_its_report_in_the_language_of_reports(application, running, quick, idle):
    quick.gate.set()
    idle()
    application.settings.set_text("report_language", "zh_CN")
    running.setup.start.click()
    idle()
    assert [request.language for request in quick.requests] == ["en", "zh_CN"]
