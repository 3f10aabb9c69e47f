"""`calibrate run`: refusals in words; the whole run is slow and proved on the virtual rig."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from measureapp.cli import main
from measureapp.errors import CalibrationError
from tests.cli.rig_files import write_binned_rig


def test_a_recording_has_no_devices_to_calibrate(tmp_path: Path, capsys) -> None:
    rig = write_binned_rig(tmp_path / "rig.toml", 'part = "flat"')
    rig.write_text(rig.read_text(encoding="utf-8").replace('driver = "virtual_rig"', 'driver = "recorded"'), encoding="utf-8")
    assert main(["calibrate", "run", "--rig", str(rig), "--project", str(tmp_path / "p"), "--json"]) == 2
    assert "is a recording" in json.loads(capsys.readouterr().out)["error"]["message"]
    assert not (tmp_path / "p").exists()


def test_half_a_board_is_refused(tmp_path: Path, capsys) -> None:
    rig = write_binned_rig(tmp_path / "rig.toml", 'part = "flat"')
    assert main(["calibrate", "run", "--rig", str(rig), "--project", str(tmp_path / "p"), "--board", "9x6", "--json"]) == 2
    assert "--square-mm" in json.loads(capsys.readouterr().out)["error"]["message"]


def test_a_board_that_is_not_seen_is_an_answer_in_words(tmp_path: Path, capsys, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object) -> None:
        raise CalibrationError("No camera detects the board from pose01.", "Put the board on its stand.")

    monkeypatch.setattr("measureapp.pipeline.rig_calibration.calibrate_into_project", fail)
    assert main(["calibrate", "run", "--rig", "paper", "--project", str(tmp_path / "p"), "--json"]) == 2
    assert json.loads(capsys.readouterr().out)["error"]["hint"] == "Put the board on its stand."


@pytest.mark.slow
def test_one_command_takes_and_solves_everything_and_a_second_call_takes_nothing_again(tmp_path: Path, capsys) -> None:
    rig, project = write_binned_rig(tmp_path / "rig.toml", 'part = "flat"'), tmp_path / "p"
    assert main(["calibrate", "run", "--rig", str(rig), "--project", str(project), "--json"]) == 0
    first = json.loads(capsys.readouterr().out)
    assert first["verdict"]["level"] == "good" and first["verdict"]["expanded_mm"] < 0.5
    assert {"flange_from_camera", "guide", "axis", "covariance", "cameras"} <= set(first)
    assert len(first["views"]["taken"]) > 50 and first["views"]["without_board"] == {}
    assert main(["calibrate", "run", "--rig", str(rig), "--project", str(project), "--json"]) == 0
    second = json.loads(capsys.readouterr().out)
    assert second["views"]["taken"] == [] and second["views"]["kept"] == sorted(first["views"]["taken"])
    assert second["flange_from_camera"] == pytest.approx(first["flange_from_camera"])
