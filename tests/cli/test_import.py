"""`import`: what it answers, what it refuses, and that it leaves a whole project or nothing."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from measureapp.cli import main
from measureapp.data.recording import Recording
from measureapp.errors import InputError
from measureapp.pipeline.recording.store import import_recording
from measureapp.progress import CallbackProgress, Cancelled
from measureapp.project.calibration.camera_file import write_cameras
from measureapp.project.calibration.certificate_file import certify
from measureapp.project.folder import DEFAULT_BOARD, ProjectFolder
from measureapp.resources import resource
from tests.cli.fringe_sets import write_paper_set
from tests.cli.refusal import cut_in_half, refused
from tests.cli.test_reconstruct import flat_cameras

POSE = "base_from_flange = { position_mm = [500, 0, 600], quaternion_wxyz = [0, 1, 0, 0] }\nguide_mm = 0.0\n"
BOARD = '[board]\nkind = "checkerboard"\ninner_corners = [14, 11]\nsquare_mm = 15.0\n'
PART = '[part]\nnominal = "part.stl"\nprogram = "part.toml"\n'
AXES = ("hand_eye", "guide", "axis")


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    """A recording of a whole rig with images of 256 × 40 px: six views of the board, two of the part."""
    folder = tmp_path / "recording"
    lines = ["schema_version = 1", 'rig = "rig.toml"', BOARD]
    text = resource("rigs/paper.toml").read_text(encoding="utf-8").replace('"virtual_rig"', '"recorded"')
    without_upper = text.split("[[cameras]]")
    without_upper[3] = without_upper[3][without_upper[3].index("[projector]") :]
    text = "[[cameras]]".join(without_upper[:3]) + without_upper[3]
    for number in range(6):
        lines.append("[[board_view]]")
        lines.append(f'images = {{ left = "b/{number}_left.png", right = "b/{number}_right.png" }}\n{POSE}table_deg = {10.0 * number}')
        for camera in ("left", "right"):
            _write(folder / f"b/{number}_{camera}.png", np.full((40, 256), 100 + number, np.uint8))
    for number in (1, 2):
        write_paper_set(folder / f"view{number:02d}", ("left", "right"))
        lines.append(
            f'[[viewpoint]]\nid = "view{number:02d}"\nmanifest = "view{number:02d}/MANIFEST.toml"\n{POSE}table_deg = {40.0 * number}'
        )
    (folder / "rig.toml").write_text(text.replace("= 2592", "= 256").replace("= 1944", "= 40"), encoding="utf-8")
    (folder / "part.stl").write_bytes(resource("parts/gypsum/nominal.stl").read_bytes())
    (folder / "part.toml").write_bytes(resource("parts/gypsum/program.toml").read_bytes())
    path = folder / "RECORDING.toml"
    path.write_text("\n".join([*lines, PART]), encoding="utf-8")
    return path


@pytest.fixture
def minimal(tmp_path: Path) -> Path:
    """Known cameras and one set of fringes: no rig, no board."""
    folder = tmp_path / "minimal"
    write_paper_set(folder, ("left", "right"))
    write_cameras(folder / "cameras.json", flat_cameras())
    path = folder / "RECORDING.toml"
    path.write_text('cameras = "cameras.json"\n[[viewpoint]]\nid = "only"\nmanifest = "MANIFEST.toml"\n', encoding="utf-8")
    return path


def _write(path: Path, pixels: np.ndarray) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    assert cv2.imwrite(str(path), pixels)


def answer(capsys: pytest.CaptureFixture[str], *arguments: object) -> dict:
    assert main([*map(str, arguments), "--json"]) == 0
    return json.loads(capsys.readouterr().out)


def test_it_answers_what_there_is_and_what_is_missing(recording: Path, minimal: Path, tmp_path: Path, capsys) -> None:
    whole = answer(capsys, "import", recording, "--into", tmp_path / "whole")
    assert (whole["board_views"], whole["viewpoints"]) == (6, 2)
    assert set(whole["missing"]) == {"hand_eye", "guide"}  # the robot stands still, and so does the guide
    part = answer(capsys, "import", minimal, "--into", tmp_path / "part")
    assert (part["board_views"], part["viewpoints"]) == (0, 1)
    assert set(part["missing"]) == {*AXES, "dimensions"}
    assert main(["import", str(minimal), "--into", str(tmp_path / "again")]) == 0
    said = capsys.readouterr().out
    assert "0 board views and 1 viewpoint imported" in said and "There are no robot poses" in said and "measureapp process" in said


def test_the_same_recording_again_changes_nothing_and_another_one_is_refused(
    recording: Path, minimal: Path, tmp_path: Path, capsys
) -> None:
    into = tmp_path / "project"
    answer(capsys, "import", recording, "--into", into)
    before = {path: path.stat().st_mtime_ns for path in into.rglob("*")}
    assert answer(capsys, "import", recording, "--into", into)["already_there"]
    assert {path: path.stat().st_mtime_ns for path in into.rglob("*")} == before
    assert "contains another recording" in refused(capsys, ["import", str(minimal), "--into", str(into)])
    assert "is not an empty folder" in refused(capsys, ["import", str(minimal), "--into", str(minimal.parent)])


def test_a_damaged_image_or_a_cancellation_leaves_nothing(recording: Path, tmp_path: Path, capsys) -> None:
    def stop(done: float, total: float, note: str) -> None:
        if note == "view02":
            raise Cancelled

    into = tmp_path / "project"
    with pytest.raises(Cancelled):
        import_recording(recording, into, CallbackProgress(stop))
    cut_in_half(recording.parent / "view02" / "left" / "500_7.png")
    assert "viewpoint 'view02'" in refused(capsys, ["import", str(recording), "--into", str(into)])
    assert [path.name for path in tmp_path.iterdir()] == ["recording"]


def test_ctrl_c_is_answered_in_words_and_leaves_nothing(recording: Path, tmp_path: Path, capsys, monkeypatch) -> None:
    def interrupt(*_: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("measureapp.pipeline.recording.store.read_manifest", interrupt)
    command = ["import", str(recording), "--into", str(tmp_path / "project")]
    assert main(command) == 130
    assert capsys.readouterr().err == "measureapp: Cancelled. Nothing more was written.\n"
    assert main([*command, "--json"]) == 130
    assert json.loads(capsys.readouterr().out)["error"]["type"] == "Cancelled"
    assert [path.name for path in tmp_path.iterdir()] == ["recording"]


def test_what_a_killed_import_left_is_replaced(minimal: Path, tmp_path: Path, capsys) -> None:
    left = tmp_path / ".project.importing" / "project"
    left.mkdir(parents=True)
    (left / "project.json").write_text("half", encoding="utf-8")
    answer(capsys, "import", minimal, "--into", tmp_path / "project")
    assert not left.parent.exists()
    ProjectFolder.open(tmp_path / "project")


def test_the_rig_of_a_recording_is_never_connected(recording: Path, shelf: Path, tmp_path: Path, capsys) -> None:
    rig = str(recording.parent / "rig.toml")
    for command in (["rig", "check", rig], ["scan", str(shelf / "plan.json"), "--rig", rig, "--project", str(tmp_path / "scan")]):
        assert "is a recording: it has no devices" in refused(capsys, command)
    assert not (tmp_path / "scan").exists()


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("table_deg = 80.0", "tabel_deg = 80.0", "[[viewpoint]] 2, tabel_deg: is not a known field"),
        ("quaternion_wxyz = [0, 1, 0, 0]", "quaternion_wxyz = [0, 2, 0, 0]", "must have length 1"),
        ('id = "view02"', 'id = "View01"', "several viewpoints have the id 'view01'"),
        ('id = "view02"', 'id = ".."', "'..' is no name of a folder"),
        ('id = "view02"', 'id = "a/../../b"', "is no name of a folder"),
        ('"view02/MANIFEST.toml"', '"view01/MANIFEST.toml"', "is used twice"),
        ('"b/5_left.png"', '"b/4_left.png"', "is used twice"),
        ('"b/5_left.png"', '"b/7_left.png"', "b/7_left.png does not exist"),
        ('"b/5_left.png"', '"/b/5_left.png"', "is no path relative to this file"),
        ('"b/5_left.png"', '"C:/b/5_left.png"', "is no path relative to this file"),
        ('left = "b/5_left.png"', 'middle = "b/5_left.png"', "[[board_view]] 6: the rig has no camera 'middle'"),
        ("guide_mm = 0.0\ntable_deg = 80.0", "table_deg = 80.0", "viewpoint 'view02' has no guide position (guide_mm)"),
        ("table_deg = 50.0", "", "[[board_view]] 6 has no table angle (table_deg)"),
        ("table_deg = 50.0", "table_deg = nan", "[[board_view]] 6, table_deg"),
        (BOARD, "", "there are board views, but no [board]"),
        ("inner_corners = [14, 11]", "", "needs inner_corners = [columns, rows]"),
        ("inner_corners = [14, 11]", "inner_corners = [1, 11]", "columns"),
        ("square_mm = 15.0", "square_mm = 15.0\nmarker_mm = 3.0", "has no marker_mm"),
        ('rig = "rig.toml"', "", "neither rig nor cameras"),
        ('rig = "rig.toml"', 'rig = "b"', "rig: "),
        ('"part.toml"', '"part.stl"', "part.stl is not a text file"),
        ("schema_version = 1", "schema_version = 2", "schema_version"),
        ("schema_version = 1", "schema_version 1", "is not valid TOML"),
    ],
)
def test_a_wrong_recording_is_refused_by_its_place(recording: Path, old: str, new: str, said: str, tmp_path: Path, capsys) -> None:
    text = recording.read_text(encoding="utf-8")
    assert old in text
    head, _, tail = text.rpartition(old) if "quaternion" in old else text.partition(old)
    recording.write_text(head + new + tail, encoding="utf-8")
    assert said in refused(capsys, ["import", str(recording), "--into", str(tmp_path / "project")])
    assert not (tmp_path / "project").exists()


def _replace(name: str, old: str, new: str) -> Callable[[Path], None]:
    def change(folder: Path) -> None:
        text = (folder / name).read_text(encoding="utf-8")
        assert old in text
        (folder / name).write_text(text.replace(old, new, 1), encoding="utf-8")

    return change


def _image(name: str, pixels: np.ndarray) -> Callable[[Path], None]:
    return lambda folder: _write(folder / name, pixels)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (_replace("rig.toml", '"recorded"', '"virtual_rig"'), "driver = 'virtual_rig'"),
        (_replace("rig.toml", "bit_depth = 8", "bit_depth = 12"), "12 bit"),
        (_replace("rig.toml", 'name = "right"', 'name = "middle"'), "has the cameras left, right, the rig has left, middle"),
        (_replace("rig.toml", 'name = "right"', 'name = "middle"'), "[[board_view]] 1 and 5 more: the rig has no camera 'right'"),
        (_replace("rig.toml", "width_px = 1024", "width_px = 912"), "projector_px = 1024"),
        (_replace("view01/MANIFEST.toml", "saturation = 255", "saturation = 1023"), "saturation = 1023"),
        (_replace("view01/MANIFEST.toml", "shift_sign", "shift_sine"), "shift_sine"),
        (_replace("view01/MANIFEST.toml", "1000_0.png", "1000_9.png"), "1000_9.png"),
        (_image("view02/right/1000_0.png", np.zeros((41, 256), np.uint8)), "is 256 × 41 px, the rig's camera 'right' has 256 × 40 px"),
        (_image("view02/right/1000_0.png", np.zeros((40, 256), np.uint16)), "has 16 bit, the rig's camera 'right' has 8 bit"),
        (_image("b/3_left.png", np.zeros((40, 250), np.uint8)), "[[board_view]] 4"),
        (lambda folder: (folder / "b/3_left.png").write_bytes(b"no image"), "3_left.png is not a readable image"),
        (lambda folder: (folder / "part.stl").write_bytes(b"no mesh"), "part.stl"),
    ],
)
def test_files_that_contradict_the_rig_are_refused(
    recording: Path, change: Callable[[Path], None], said: str, tmp_path: Path, capsys
) -> None:
    change(recording.parent)
    assert said in refused(capsys, ["import", str(recording), "--into", str(tmp_path / "project")])
    assert sorted(path.name for path in tmp_path.iterdir()) == ["recording"]


def test_the_example_of_the_help_page_is_a_recording() -> None:
    text = resource("help/scan.md").read_text(encoding="utf-8")
    example = Recording.model_validate(tomllib.loads(text.partition("```toml\n")[2].partition("```")[0]))
    assert len(example.board_view) == len(example.viewpoint) == 1 and example.board is not None


def test_several_problems_are_reported_at_once(recording: Path, tmp_path: Path, capsys) -> None:
    (recording.parent / "b/1_left.png").unlink()
    (recording.parent / "part.stl").unlink()
    _replace("view02/MANIFEST.toml", "shift_sign", "shift_sine")(recording.parent)
    said = refused(capsys, ["import", str(recording), "--into", str(tmp_path / "project")])
    assert "has 3 problems" in said and "1_left.png" in said and "part.stl" in said and "shift_sine" in said


def test_a_certificate_moves_the_marks_and_one_of_another_board_is_refused(tmp_path: Path) -> None:
    """It may be given in any frame; only the shape of the grid counts."""
    rng = np.random.default_rng(3)
    printed = DEFAULT_BOARD.nominal_corners_mm + rng.normal(0, 0.01, (DEFAULT_BOARD.count, 3))
    turned = printed @ np.array([[0.0, -1, 0], [1, 0, 0], [0, 0, 1]]).T + [100, 20, -5]
    path = tmp_path / "corners.csv"
    _certificate(path, turned)
    certified = certify(DEFAULT_BOARD, path)
    np.testing.assert_allclose(certified.corners_mm, printed, atol=0.01)
    np.testing.assert_allclose(
        np.linalg.norm(np.diff(certified.corners_mm, axis=0), axis=1), np.linalg.norm(np.diff(printed, axis=0), axis=1)
    )
    for wrong, said in ((turned * 1.1, "is not a certificate"), (turned[:-1], "153 marks"), (turned / 1000, "is not a certificate")):
        _certificate(path, wrong)
        with pytest.raises(InputError, match=said):
            certify(DEFAULT_BOARD, path)


def test_the_certificate_of_a_recording_becomes_the_board_of_its_project(recording: Path, tmp_path: Path, capsys) -> None:
    printed = DEFAULT_BOARD.nominal_corners_mm * 1.0002
    _certificate(recording.parent / "corners.csv", printed)
    _replace("RECORDING.toml", "square_mm = 15.0", 'square_mm = 15.0\ncertificate = "corners.csv"')(recording.parent)
    answer(capsys, "import", recording, "--into", tmp_path / "project")
    board = ProjectFolder.open(tmp_path / "project").settings.board
    assert np.linalg.norm(board.corners_mm[13] - board.corners_mm[0]) == pytest.approx(13 * 15.0 * 1.0002)


def _certificate(path: Path, marks_mm: np.ndarray) -> None:
    rows = [f"0,{number},{x!r},{y!r},{z!r}" for number, (x, y, z) in enumerate(marks_mm.tolist())]
    path.write_text("\n".join(["position,corner,x_mm,y_mm,z_mm", *rows]) + "\n", encoding="utf-8")
