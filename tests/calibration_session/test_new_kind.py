"""Adding a calibration: a file of its own and two lines in tables make it known to sessions, commands and wizards."""

from __future__ import annotations

import importlib
import json
import re
from pathlib import Path

import cv2
import numpy as np
import pytest

from measureapp.calibrate.draft.draft import Setup
from measureapp.calibrate.draft.verdict import compare, evaluate
from measureapp.calibrate.guidance.advise import advise
from measureapp.calibrate.kinds.table import KINDS
from measureapp.calibration_session.accepting import accept, read_result
from measureapp.calibration_session.session import CalibrationSession
from measureapp.cli import main
from measureapp.data.board import CheckerboardDescription
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.camera_file import write_cameras
from tests.calibrate.virtual_board import shot
from tests.calibration_session.toy_kind import register

BOARD = CheckerboardDescription(columns=14, rows=11, square_mm=12.0)


@pytest.fixture
def standoff(monkeypatch):
    return register(monkeypatch)


@pytest.fixture
def camera():
    pinhole = shot(BOARD).camera
    return CameraArrayCalibration("left", {"left": CameraCalibration("left", pinhole, RigidTransform.identity("camera", "left"))})


def test_a_kind_in_the_table_is_collected_solved_assessed_and_compared(standoff, camera, tmp_path):
    session = CalibrationSession.create(tmp_path / "session", Setup(standoff, BOARD, ("left",), camera))
    shown = [shot(BOARD, 20, towards, 10) for towards in (40, 130, 220)]
    for view in shown[:1]:
        session.add({"left": view.image})
    assert advise(session.draft).sentences == ("One more view is needed.",)
    for view in shown[1:]:
        session.add({"left": view.image})
    session.solve()
    true = np.mean([view.camera_from_board.apply(BOARD.middle_mm)[2] for view in shown])
    assert session.solved.solution.distance_mm == pytest.approx(true, rel=1e-3)
    assert evaluate(session.draft).sentence.startswith("Places the board to")
    assert compare(session.solved.solution, session.draft).on_part_mm == 0.0
    assert CalibrationSession.open(session.folder).setup.kind is standoff
    accepted = accept(session, tmp_path / "standoff.json")
    assert read_result(tmp_path / "standoff.json").distance_mm == accepted.distance_mm


def test_the_command_line_knows_it_at_once(standoff, camera, tmp_path, capsys):
    for number, towards in enumerate((40, 130, 220)):
        cv2.imwrite(str(tmp_path / f"left{number}.png"), shot(BOARD, 20, towards, 10).image)
    write_cameras(tmp_path / "cameras.json", camera)
    board = ["--board", f"{BOARD.columns}x{BOARD.rows}", "--square-mm", str(BOARD.square_mm)]
    images = ["--images", f"left={tmp_path}/left*.png", "--cameras", str(tmp_path / "cameras.json")]
    code = main(
        ["calibrate", "collect", "standoff", "--session", str(tmp_path / "session"), *images, *board, "--solve", "--coach", "--json"]
    )
    answer = json.loads(capsys.readouterr().out)
    assert code in (0, 1), answer
    assert answer["estimates"][0]["name"] == "standoff"
    assert answer["verdict"]["sentence"].startswith("Places the board to")


def test_no_code_outside_their_files_compares_kinds_by_name():
    """Whoever asks which kind it is would have to be changed for the next one."""
    root = Path(importlib.import_module("measureapp").__file__).parent.parent
    compared = re.compile(r"kind(\.name)?\s*(==|!=|in|not in)\s*[({\[]?\s*[\"'](" + "|".join(KINDS) + r")[\"']")
    rooms = ("measureapp/calibrate", "measureapp/calibration_session", "measureapp/cli", "measureapp/pipeline", "measureapp/planning", "ui")
    sources = [path for room in rooms for path in (root / room).rglob("*.py")]
    assert len(sources) > 200
    assert [str(path) for path in sources if compared.search(path.read_text(encoding="utf-8"))] == []
