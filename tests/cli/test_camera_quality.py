"""`calibrate cameras` says how far its result can be trusted."""

from __future__ import annotations

import json

import cv2
import numpy as np
import pytest
from recorded import recorded

from measureapp.cli import main
from measureapp.project.calibration.camera_file import read_cameras


def run(capsys, *arguments):
    """Return exit code and JSON document of `calibrate cameras` on the recorded pairs."""
    folder = recorded("opencv_stereo")
    images = ("--images", f"left={folder}/left[0-9]*.jpg", "--images", f"right={folder}/right[0-9]*.jpg")
    code = main(["calibrate", "cameras", *images, "--board", "9x6", "--square-mm", "25", *map(str, arguments), "--json"])
    return code, json.loads(capsys.readouterr().out)


def test_recorded_pairs_are_cross_validated_and_mapped(capsys, tmp_path):
    code, answer = run(
        capsys,
        *("--out", tmp_path / "cameras.json", "--uncertainty-map", tmp_path / "map.npz", "--corners-out", tmp_path / "corners.json"),
        *("--serial", "left=L-1", "--serial", "right=R-2", "--temperature-c", 21.5, "--valid-days", 30, "--standoff-mm", 350),
    )
    assert code == 0, answer
    validation = answer["cross_validation"]
    assert validation["observed_px"] == pytest.approx(validation["predicted_px"], rel=0.25)
    assert {half["camera"] for half in validation["halves"]} == {"left", "right"}
    assert "a length of 300 mm in this volume" in answer["uncertainty"]["sentence"]
    assert answer["uncertainty"]["projection"]["left"]["least_px"] < 0.2
    stored = np.load(tmp_path / "map.npz")
    assert stored["left_sigma_px"].shape == (18, 24)
    assert len(stored["points_mm"]) == answer["uncertainty"]["volume"]["points"]
    assert cv2.imread(str(tmp_path / "map.png")).shape[1] == 2 * 484
    calibration = read_cameras(tmp_path / "cameras.json")
    assert (calibration.cameras["left"].serial, calibration.cameras["right"].serial) == ("L-1", "R-2")
    assert (calibration.provenance.temperature_c, calibration.provenance.valid_days) == (21.5, 30.0)
    assert all(len(digest) == 64 for digest in calibration.provenance.inputs.values())
    for name, camera in calibration.cameras.items():  # a sharp lens and chip show edges of 2 to 3 px
        assert 0.5 < camera.blur_px == answer["blur_px"][name] < 1.5


def test_corners_found_once_are_solved_again_without_images(capsys, tmp_path):
    stored = ("calibrate", "cameras", "--corners", str(tmp_path / "corners.json"))
    first = run(capsys, "--corners-out", tmp_path / "corners.json", "--out", tmp_path / "first.json")[1]
    assert main([*stored, "--out", str(tmp_path / "second.json"), "--json"]) == 0
    second = json.loads(capsys.readouterr().out)
    for figure in ("joint_rms_px", "cameras", "pairs", "views", "rejected", "cross_validation"):
        assert second[figure] == first[figure]
    assert main(["calibrate", "again", str(tmp_path / "second.json"), "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["inputs"] == 1
    assert main([*stored, "--distortion", "4", "--reference", "right", "--json"]) == 0
    other = json.loads(capsys.readouterr().out)
    assert other["reference"] == "right"
    assert len(other["cameras"]["left"]["distortion"]) == 4
    assert len(other["views"]) + len(other["rejected"]) == 26
    (tmp_path / "cut.json").write_bytes((tmp_path / "corners.json").read_bytes()[:5000])
    for arguments, said in (
        ((*stored, "--board", "9x6", "--square-mm", "25"), "--corners already holds"),
        ((*stored, "--serial", "middle=7"), "'middle=7' names no camera"),
        ((*stored[:-1], str(tmp_path / "cut.json")), "does not hold the corners"),
        ((*stored[:-1], str(tmp_path / "absent.json")), "cannot be read"),
    ):
        assert main([*arguments, "--json"]) == 2
        assert said in json.loads(capsys.readouterr().out)["error"]["message"]


def test_a_serial_number_of_no_camera_is_refused(capsys):
    code, answer = run(capsys, "--serial", "middle=7")
    assert code == 2
    assert "'middle=7' names no camera" in answer["error"]["message"]


def test_a_map_that_its_picture_would_overwrite_is_refused(capsys, tmp_path):
    code, answer = run(capsys, "--uncertainty-map", tmp_path / "map.png")
    assert code == 2
    assert "--uncertainty-map" in answer["error"]["message"]
