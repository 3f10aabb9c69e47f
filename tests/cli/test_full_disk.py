"""A disk without room: refused before anything is written, or nothing half written is left."""

from __future__ import annotations

import errno
import os
import shutil
from pathlib import Path

import numpy as np
import pytest

from measureapp.geometry.transform import RigidTransform
from measureapp.project.tables import write_poses
from tests.cli.refusal import filled, refused


def test_a_demo_that_does_not_fit_on_the_disk_is_refused_before_anything_is_written(tmp_path: Path, capsys, monkeypatch) -> None:
    monkeypatch.setattr("shutil.disk_usage", lambda _: shutil._ntuple_diskusage(10**9, 10**9 - 10**6, 10**6))
    said = refused(capsys, ["demo", "--viewpoints", "2", "--out", str(tmp_path / "out")])
    assert "0.0 GB free" in said and "Free some space" in said
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "line",
    [
        "decode MANIFEST --out OUT",
        "calibrate hand-eye --robot-poses ROBOT --board-poses BOARD --out OUT/x.json",
    ],
)
def test_a_disk_that_runs_full_leaves_no_half_written_file(line: str, shelf: Path, tmp_path: Path, capsys, monkeypatch) -> None:
    if "ROBOT" in line:
        line = _hand_eye_tables(line, tmp_path)

    def full(_: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("os.fsync", full)
    said = refused(capsys, filled(line, shelf, tmp_path / "out", ""))
    assert "No space left on device" in said
    assert [path for path in (tmp_path / "out").rglob("*") if path.is_file()] == []


def _hand_eye_tables(line: str, folder: Path) -> str:
    rng = np.random.default_rng(4)
    robot, board = {}, {}
    flange_from_camera = RigidTransform.from_vector([0.1, 0.2, 0.3], [10, 20, 80], "flange", "camera")
    base_from_board = RigidTransform.from_vector([0.3, -0.2, 0.1], [600, 20, 80], "base", "board")
    for number in range(8):
        base_from_flange = RigidTransform.from_vector(rng.normal(0, 0.5, 3), rng.normal(0, 200, 3), "base", "flange")
        robot[f"p{number}"] = base_from_flange
        board[f"p{number}"] = (base_from_flange @ flange_from_camera).inverse() @ base_from_board
    write_poses(folder / "robot.csv", robot)
    write_poses(folder / "board.csv", board)
    return line.replace("ROBOT", str(folder / "robot.csv")).replace("BOARD", str(folder / "board.csv"))
