"""`why` explains holes that were painted into recorded images, and refuses what it cannot answer in words."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from demo_fixture import Demo

from measureapp.cli.main import main
from measureapp.project.calibration.camera_file import write_cameras
from tests.cli.fringe_sets import write_paper_set
from tests.cli.test_reconstruct import flat_cameras

DISPARITY = 60  # px between the cameras: the flat surface lies at 300 px · 100 mm / 60 px = 500 mm
SATURATED, SHADOW, WEAK = (4, 60, 14, 80), (18, 60, 28, 80), (4, 120, 14, 140)  # row, column, row, column


@pytest.fixture(scope="module")
def holes(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """Two cameras see a plane; in the left one a box is saturated, one is without light, one without contrast."""
    folder = tmp_path_factory.mktemp("holes")
    manifest = write_paper_set(folder, ("left", "right"))
    for path in sorted(folder.glob("right/*.png")):
        cv2.imwrite(str(path), np.roll(cv2.imread(str(path), cv2.IMREAD_UNCHANGED), -DISPARITY, axis=1))
    for path in sorted(folder.glob("left/*.png")):
        image = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
        image[_box(SATURATED)], image[_box(SHADOW)] = 255, 3
        image[_box(WEAK)] = np.rint(60 + 0.02 * (image[_box(WEAK)].astype(float) - 60))
        cv2.imwrite(str(path), image)
    write_cameras(folder / "cameras.json", flat_cameras())
    return ["why", str(manifest), "--cameras", str(folder / "cameras.json")]


def _box(corners: tuple[int, int, int, int]) -> tuple[slice, slice]:
    return slice(corners[0], corners[2]), slice(corners[1], corners[3])


def _told(arguments: list[str], capsys: pytest.CaptureFixture[str], code: int = 0) -> dict[str, Any]:
    assert main([*arguments, "--json"]) == code
    document: dict[str, Any] = json.loads(capsys.readouterr().out)
    return document


@pytest.mark.parametrize(
    ("place", "reason", "words"),
    [
        ((8, 70), "saturated", "shorter exposure"),
        ((22, 70), "shadow", "projector's light"),
        ((8, 130), "weak modulation", "longer exposure"),
    ],
)
def test_a_painted_hole_is_explained_with_its_remedy(
    holes: list[str], capsys: pytest.CaptureFixture[str], place: tuple[int, int], reason: str, words: str
) -> None:
    told = _told([*holes, "--pixel", f"{place[0]},{place[1]}"], capsys)["pixel"]
    assert (told["camera"], told["stage"], told["reason"]) == ("left", "decode", reason)
    assert words in told["sentence"]
    assert main([*holes, "--pixel", f"{place[0]},{place[1]}"]) == 0
    said = capsys.readouterr().out
    assert f"lost in decoding, {reason}" in said and "at least 3 grey levels" in said


def test_a_pixel_with_a_point_says_so(holes: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert _told([*holes, "--pixel", "20,100"], capsys)["pixel"]["stage"] == "point"


def test_the_shares_of_a_region_are_those_that_were_painted(holes: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    told = _told([*holes, "--region", "4,50,14,90"], capsys)["region"]
    assert told["shares"]["saturated"] == pytest.approx(200 / 400, abs=0.01)
    assert sum(told["shares"].values()) == pytest.approx(1.0)
    assert told["example"]["reason"] == "saturated"
    top, left, bottom, right = SATURATED
    assert top <= told["example"]["row"] < bottom and left <= told["example"]["column"] < right


def test_the_shares_of_a_view_sum_to_one_for_every_camera(holes: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    cameras = _told(holes, capsys)["cameras"]
    assert list(cameras) == ["left", "right"]
    for camera in cameras.values():
        assert sum(camera["shares"].values()) == pytest.approx(1.0)
    assert cameras["left"]["shares"]["shadow"] == pytest.approx(200 / (256 * 40), abs=1e-3)
    assert list(_told([*holes, "--camera", "right"], capsys)["cameras"]) == ["right"]


def test_maps_are_written_with_the_colours_of_their_legend(holes: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    files = {kind: tmp_path / f"{kind}.png" for kind in ("reasons", "exposure", "snr")}
    options = ["--map", str(files["reasons"]), *[f"--map={kind}={files[kind]}" for kind in ("exposure", "snr")]]
    told = _told([*holes, "--camera", "left", *options], capsys)["maps"]
    for kind, file in files.items():
        assert told[kind]["file"] == str(file)
        assert cv2.imread(str(file)).shape[0] > 40
    drawn = cv2.imread(str(files["reasons"]))[..., ::-1]
    legend = {entry["words"]: tuple(entry["colour"]) for entry in told["reasons"]["legend"]["left"]}
    assert tuple(drawn[8, 70]) == legend["saturated"]
    assert tuple(drawn[22, 70]) == legend["shadow"]
    assert tuple(drawn[8, 130]) == legend["weak modulation"]


@pytest.mark.parametrize(
    ("options", "words"),
    [
        (["--pixel", "40,0"], "no pixel in row 40"),
        (["--pixel", "3"], "--pixel 3 is not a pixel"),
        (["--region", "1,2,3,x"], "--region 1,2,3,x is not a region"),
        (["--region", "0,0,99,9"], "is not inside the images"),
        (["--pixel", "1,2", "--region", "1,2,3,4"], "exclude each other"),
        (["--camera", "front"], "no camera 'front'"),
        (["--view", "view01"], "is not a project"),
        (["--map", "reasons.jpg"], "cannot be drawn"),
        (["--map", "colours=a.png"], "cannot be drawn"),
        (["--rule", "brightest"], "--rule brightest is unknown"),
    ],
)
def test_what_cannot_be_answered_is_refused_in_words(
    holes: list[str], capsys: pytest.CaptureFixture[str], options: list[str], words: str
) -> None:
    error = _told([*holes, *options], capsys, 2)["error"]
    assert words in error["message"]
    assert error["hint"]


def test_recorded_images_need_their_calibration(holes: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert "--cameras" in _told(holes[:2], capsys, 2)["error"]["hint"]


def test_a_calibration_of_other_cameras_is_refused_before_decoding(
    holes: list[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    write_cameras(tmp_path / "other.json", flat_cameras(128))
    error = _told([*holes[:2], "--cameras", str(tmp_path / "other.json")], capsys, 2)["error"]
    assert "128 × 40 px" in error["message"]


def test_a_view_of_a_project_is_explained_and_an_unclear_question_refused(demo: Demo, capsys: pytest.CaptureFixture[str]) -> None:
    told = _told(["why", str(demo.folder), "--view", "view01", "--camera", "left"], capsys)
    assert sum(told["cameras"]["left"]["shares"].values()) == pytest.approx(1.0)
    assert "view01" in _told(["why", str(demo.folder)], capsys, 2)["error"]["hint"]
    assert "view99" in _told(["why", str(demo.folder), "--view", "view99"], capsys, 2)["error"]["message"]
    with_cameras = ["why", str(demo.folder), "--view", "view01", "--cameras", "cameras.json"]
    assert "--cameras" in _told(with_cameras, capsys, 2)["error"]["hint"]


def test_images_of_a_single_camera_need_no_calibration(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    alone = ["why", str(write_paper_set(tmp_path))]
    shares = _told(alone, capsys)["cameras"]["left"]["shares"]
    assert set(shares) <= {"unmatched", "edge", "order conflict", "out of range"} and shares["unmatched"] > 0.9
    told = _told([*alone, "--pixel", "20,100"], capsys)["pixel"]
    assert told["stage"] == "match" and "Only one camera sees the projector column" in told["sentence"]
