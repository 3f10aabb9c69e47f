from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest
from recorded import recorded

from measureapp.cli.main import main
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.camera_file import write_cameras
from measureapp.project.geometry.files import read_point_cloud
from tests.cli.fringe_sets import write_paper_set, write_recorded_manifest


def render_cameras(folder: Path, width: int = 1280, names: tuple[str, str] = ("left", "right")) -> CameraArrayCalibration:
    """The calibration that came with the rendered stereo set."""
    file = cv2.FileStorage(str(folder / "caliInfo.yml"), cv2.FILE_STORAGE_READ)
    node = {name: file.getNode(name).mat() for name in ("M1", "D1", "M2", "D2", "Rlr", "Tlr")}
    file.release()
    right_from_left = RigidTransform.from_parts(node["Rlr"], node["Tlr"].ravel(), names[1], "camera")
    cameras = {
        names[0]: CameraCalibration(
            names[0], PinholeCamera(width, 1024, node["M1"], node["D1"]), RigidTransform.identity("camera", names[0])
        ),
        names[1]: CameraCalibration(names[1], PinholeCamera(width, 1024, node["M2"], node["D2"]), right_from_left.inverse()),
    }
    return CameraArrayCalibration(names[0], cameras)


def flat_cameras(width: int = 256) -> CameraArrayCalibration:
    """Two cameras side by side that see the flat set with one and the same phase, so nothing lies at a finite depth."""
    matrix = np.array([[300.0, 0, width / 2], [0, 300, 20], [0, 0, 1]])
    places = {"left": 0.0, "right": 100.0}
    return CameraArrayCalibration(
        "left",
        {
            name: CameraCalibration(
                name, PinholeCamera(width, 40, matrix, np.zeros(5)), RigidTransform.from_parts(np.eye(3), [x, 0, 0], "camera", name)
            )
            for name, x in places.items()
        },
    )


def test_the_rendered_stereo_set_gives_the_recorded_figures(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = recorded("slmaster_render_stereo")
    manifest = write_recorded_manifest(tmp_path, folder, {"left": "L", "right": "R"}, [0, 3, 6, 9], list(range(12, 19)), 64)
    write_cameras(tmp_path / "cameras.json", render_cameras(folder))
    out = tmp_path / "cloud.ply"
    assert main(["reconstruct", str(manifest), "--cameras", str(tmp_path / "cameras.json"), "--out", str(out), "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["points"] == pytest.approx(401_000, rel=0.03)
    assert answer["depth_mm"] == pytest.approx({"p1": 515.96, "p50": 563.51, "p99": 641.05}, abs=0.3)
    assert answer["pairs"][0]["matched"] >= answer["points"]
    assert answer["pairs"][0]["epipolar_rms_px"] is None
    cloud = read_point_cloud(out)
    assert len(cloud) == answer["points"]
    assert _neighbour_noise_mm(cloud.pixel, cloud.points_mm[:, 2]) < 0.026


def _neighbour_noise_mm(pixel: np.ndarray, depth: np.ndarray) -> float:
    grid = np.full((1024, 1280), np.nan)
    grid[pixel[:, 0], pixel[:, 1]] = depth
    second = grid[:, 2:] - 2 * grid[:, 1:-1] + grid[:, :-2]
    return float(1.4826 * np.median(np.abs(second[np.isfinite(second)])) / np.sqrt(6))


def test_a_calibration_of_other_cameras_is_refused_before_decoding(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = write_paper_set(tmp_path, ("left", "right"))
    cameras, out = tmp_path / "cameras.json", tmp_path / "cloud.ply"
    for calibration, expected in ((flat_cameras(128), "128 × 40 px"), (None, "cannot be read")):
        if calibration is None:
            cameras.unlink()
        else:
            write_cameras(cameras, calibration)
        assert main(["reconstruct", str(manifest), "--cameras", str(cameras), "--out", str(out), "--json"]) == 2
        assert expected in json.loads(capsys.readouterr().out)["error"]["message"]
    assert not out.exists()


@pytest.mark.parametrize(("grey", "reason", "remedy"), [(255, "saturated", "shorter exposure"), (0, "shadow", "longer exposure")])
def test_images_that_are_all_white_or_all_black_are_distinguished_from_a_wrong_calibration(
    grey: int, reason: str, remedy: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    manifest = write_paper_set(tmp_path, ("left", "right"))
    for file in tmp_path.glob("left/*.png"):
        cv2.imwrite(str(file), np.full((40, 256), grey, np.uint8))
    write_cameras(tmp_path / "cameras.json", flat_cameras())
    assert main(["decode", str(manifest), "--out", str(tmp_path / "maps")]) == 0
    assert f"no pixel has a phase: {reason} in 100%" in capsys.readouterr().out
    said = ["reconstruct", str(manifest), "--cameras", str(tmp_path / "cameras.json"), "--out", str(tmp_path / "cloud.ply"), "--json"]
    assert main(said) == 2
    error = json.loads(capsys.readouterr().out)["error"]
    assert f"camera 'left' has no phase, {reason} in 100% of the image" in error["message"]
    assert remedy in error["hint"]


def test_no_points_are_a_refusal_and_leave_no_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    manifest = write_paper_set(tmp_path, ("left", "right"))
    write_cameras(tmp_path / "cameras.json", flat_cameras())
    out = tmp_path / "cloud.ply"
    assert main(["reconstruct", str(manifest), "--cameras", str(tmp_path / "cameras.json"), "--out", str(out), "--json"]) == 2
    assert "gives no points" in json.loads(capsys.readouterr().out)["error"]["message"]
    assert [path.name for path in tmp_path.iterdir() if "cloud" in path.name] == []


def test_missing_cameras_name_the_command_that_makes_them(tmp_path: Path, capsys) -> None:
    assert main(["reconstruct", "manifest.toml", "--cameras", str(tmp_path / "cameras.json"), "--out", str(tmp_path / "c.ply")]) == 2
    assert "`measureapp calibrate cameras --out` writes it" in capsys.readouterr().err
