"""Commands that use a calibration say whether it may be used."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from demo_fixture import Demo, linked_copy

from measureapp.cli import main
from measureapp.project import upkeep
from measureapp.project.folder import ProjectFolder


def answer(capsys: pytest.CaptureFixture[str], *arguments: object) -> tuple[int, dict, str]:
    code = main([*map(str, arguments), "--json"])
    told = capsys.readouterr()
    return code, json.loads(told.out), told.err


@pytest.fixture
def copy(demo: Demo, tmp_path: Path) -> Path:
    """The demo's project; files are links, so that they are replaced and never written into."""
    return linked_copy(demo.folder, tmp_path / "project")


def edit_settings(folder: Path, **world: object) -> None:
    settings = json.loads((folder / "project.json").read_text(encoding="utf-8"))
    settings["rig"]["driver_settings"]["world"] = world
    (folder / "project.json").unlink()
    (folder / "project.json").write_text(json.dumps(settings), encoding="utf-8")
    upkeep.accept_changes(folder, ["project.json"])


def own_history(folder: Path) -> None:
    text = (folder / "calibration" / "history.jsonl").read_text(encoding="utf-8")
    (folder / "calibration" / "history.jsonl").unlink()
    (folder / "calibration" / "history.jsonl").write_text(text, encoding="utf-8")


def test_a_check_on_the_rig_of_a_project_joins_its_history(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    own_history(copy)
    code, document, _ = answer(capsys, "calibrate", "check", "--project", copy)
    assert (code, document["good"], document["not_tested"]) == (0, True, [])
    assert len(document["views"]) >= 3
    code, document, _ = answer(capsys, "calibrate", "history", copy)
    assert code == 0
    assert [(line["kind"], line["standing"]) for line in document["checks"]] == [("scan", "good"), ("board check", "good")]
    assert {line["calibration"] for line in document["checks"]} == {document["calibration"]}


def test_a_check_after_a_knock_ends_with_exit_code_one_and_blames_the_cameras(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    own_history(copy)
    edit_settings(copy, knocked_deg={"upper": [0.0, 0.1, 0.0]})
    code, document, _ = answer(capsys, "calibrate", "check", "--project", copy)
    assert (code, document["good"], document["suspect"]) == (1, False, "cameras")
    assert ProjectFolder.open(copy).calibration_history()[-1].status == "drifted"


@pytest.mark.parametrize(("option", "value"), [("--cameras", "cameras.json"), ("--angles", "angles.csv")])
def test_files_do_not_go_with_the_rig_of_a_project(copy: Path, option: str, value: str, capsys: pytest.CaptureFixture[str]) -> None:
    code, document, _ = answer(capsys, "calibrate", "check", "--project", copy, option, value)
    assert code == 2 and f"{option} does not go with --project" in document["error"]["message"]


def test_a_check_without_project_or_files_names_what_is_missing(capsys: pytest.CaptureFixture[str]) -> None:
    code, document, _ = answer(capsys, "calibrate", "check", "--board", "9x6", "--square-mm", "12")
    assert code == 2 and "--calibration is missing" in document["error"]["message"]
    assert "--project" in document["error"]["hint"]


def test_connecting_a_rig_can_ask_whether_a_calibration_is_of_its_cameras(demo: Demo, capsys: pytest.CaptureFixture[str]) -> None:
    code, document, _ = answer(capsys, "rig", "check", "paper", "--calibration", demo.folder)
    assert code == 2 and "2592 × 1944 px, 648 × 486 px were calibrated" in document["error"]["message"]
    code, document, _ = answer(capsys, "rig", "check", "paper")
    assert code == 0 and "calibration" not in document
    assert "35.0 °C" in document["devices"][0]["state"]


def test_a_calibration_that_was_changed_by_hand_is_refused(copy: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = copy / "calibration" / "cameras.json"
    cameras = json.loads(path.read_text(encoding="utf-8"))
    cameras["cameras"]["left"]["matrix"][0][0] += 1.0
    path.unlink()
    path.write_text(json.dumps(cameras), encoding="utf-8")
    code, document, _ = answer(capsys, "calibrate", "check", "--project", copy)
    assert code == 2 and "cameras.json is not what was stored" in document["error"]["message"]
