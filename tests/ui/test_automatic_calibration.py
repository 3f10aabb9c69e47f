"""Calibrate automatically: what is shown before, during and after the run, which a quick one stands in for."""

from __future__ import annotations

import threading
from types import SimpleNamespace

import numpy as np
import pytest

from measureapp.acquire import events as e
from measureapp.errors import CalibrationError
from measureapp.project.folder import ProjectFolder, ProjectSettings

PATIENCE_MS = 20_000


@pytest.fixture
def quick(monkeypatch, calibration):
    """Takes the place of the run: sends images, waits at the gate, and answers."""
    made = SimpleNamespace(gate=threading.Event(), requests=[], helds=[], error=None)

    def calibrate(request, on_event, progress, held=None):
        made.requests.append(request)
        made.helds.append(held)
        on_event(e.ImageTaken("pose01", "left", 40_000, np.full((486, 648), 90, np.uint8)))
        progress.report(1, 10, "Images of the board from pose01")
        while not made.gate.wait(0.01):
            progress.check()
        if made.error is not None:
            raise made.error
        project = ProjectFolder.create(request.folder, ProjectSettings(name=request.folder.name, part="board", rig=request.rig))
        verdict = SimpleNamespace(
            level="good", sentence="Adds 0.060 mm (k = 2): good.", reason="Up to 0.1 mm is good.", remedy="", reasons=()
        )
        solution = SimpleNamespace(calibration=calibration, not_observable=(), residuals=())
        solved = SimpleNamespace(solution=solution, verdict=verdict, refused=())
        return SimpleNamespace(solved=solved, taken=("pose01",), kept=("pose02", "pose03"), failed=(), unseen={}), project

    monkeypatch.setattr("measureapp.pipeline.rig_calibration.calibrate_into_project", calibrate)
    yield made
    made.gate.set()


@pytest.fixture
def automatic(application, calibration_page, quick, tmp_path):
    calibration_page.open_automatic()
    calibration_page.automatic.folder.setValue(tmp_path / "board")
    return calibration_page.automatic


def ended(application):
    return lambda: not application.controllers.jobs.queue.busy


def test_what_to_prepare_comes_first_and_the_window_blocks_nothing(automatic):
    assert not automatic.isModal()
    assert "centre of the table" in automatic.found.items[0].words
    assert automatic.start.isVisible() and not automatic.stop.isVisible()


def test_the_run_shows_images_and_then_the_verdict(application, automatic, quick, qtbot, calibration, tmp_path):
    automatic.start.click()
    qtbot.waitUntil(lambda: not automatic.pictures.is_empty, timeout=PATIENCE_MS)
    assert automatic.stop.isVisible() and not automatic.start.isVisible()
    quick.gate.set()
    qtbot.waitUntil(ended(application), timeout=PATIENCE_MS)
    first, last = automatic.found.items[0], automatic.found.items[-1]
    assert (first.kind, first.words.replace("\u00a0", " ")) == ("good", "Adds 0.060 mm (k = 2): good.")
    assert last.words == "1 view taken, 2 stored before."
    assert application.session.calibration is calibration
    assert application.session.folder == tmp_path / "board"
    assert quick.requests[0].board.columns == 14


def test_stop_keeps_what_was_taken_and_says_how_to_go_on(application, automatic, quick, qtbot):
    automatic.start.click()
    qtbot.waitUntil(lambda: not automatic.pictures.is_empty, timeout=PATIENCE_MS)
    automatic.stop.click()
    qtbot.waitUntil(ended(application), timeout=PATIENCE_MS)
    assert automatic.state.text() == "Stopped. Views taken so far are kept; Start continues."
    assert automatic.start.isVisible()


def test_the_board_is_not_changed_during_a_run_and_is_afterwards_that_of_the_project_that_was_made(
    application, automatic, quick, qtbot, rig, tmp_path
):
    automatic.start.click()
    qtbot.waitUntil(lambda: not automatic.pictures.is_empty, timeout=PATIENCE_MS)
    assert not automatic.board.isEnabled()
    ProjectFolder.create(tmp_path / "board", ProjectSettings(name="board", part="board", rig=rig))  # as the run does
    automatic.stop.click()
    qtbot.waitUntil(ended(application), timeout=PATIENCE_MS)
    assert automatic.board_note.text() == "The board of this project." and not automatic.board.isEnabled()


def test_a_board_that_is_not_seen_is_shown_with_what_to_do(application, automatic, quick, qtbot):
    quick.error = CalibrationError("No camera detects the board from pose01.", "Put the board on its stand.")
    quick.gate.set()
    automatic.start.click()
    qtbot.waitUntil(ended(application), timeout=PATIENCE_MS)
    assert [(item.words, item.remedy) for item in automatic.found.items] == [(quick.error.message, quick.error.hint)]
    assert "Start continues" in automatic.state.text()


def test_an_existing_project_keeps_its_board(automatic, quick, rig, tmp_path):
    ProjectFolder.create(tmp_path / "old", ProjectSettings(name="old", part="p", rig=rig))
    automatic.folder.setValue(tmp_path / "old")
    assert not automatic.board.isEnabled() and "this project" in automatic.board_note.text()
    automatic.folder.setValue(tmp_path / "new")
    assert automatic.board.isEnabled()


def test_the_connected_rig_is_used(application, automatic, quick, qtbot):
    application.session.connection = connected = SimpleNamespace(close=lambda: None)
    automatic.start.click()
    quick.gate.set()
    qtbot.waitUntil(ended(application), timeout=PATIENCE_MS)
    assert quick.helds == [connected]
    application.session.connection = None
