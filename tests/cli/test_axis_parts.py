"""`measureapp calibrate axis`: an image in which only a part of the board is left is told by the table's angles."""

from __future__ import annotations

import json

import cv2
import numpy as np
import pytest

from measureapp.cli import main
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, RotationAxis
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.camera_file import write_cameras
from tests.calibrate.virtual_board import CHECKER, middle_of, photographed, shot

AXIS = RotationAxis(np.array([12.0, 25.0, 590.0]), np.array([0.1, -0.8, 0.6]), "camera")
ANGLES_DEG = (0.0, 24.0, 12.0, -12.0, -24.0)
PART = 1  # the position at which the middle of the board is seen


@pytest.fixture(scope="module")
def table(tmp_path_factory):
    folder = tmp_path_factory.mktemp("table")
    start = shot(CHECKER, 25, 100, 5)
    cameras = {"left": CameraCalibration("left", start.camera, RigidTransform.identity("camera", "left"))}
    write_cameras(folder / "cameras.json", CameraArrayCalibration("left", cameras))
    for number, angle in enumerate(ANGLES_DEG):
        pose = AXIS.turned(np.deg2rad(angle)) @ start.camera_from_board
        image = photographed(CHECKER, start.camera, pose, number)
        marks = start.camera.project(pose.apply(CHECKER.corners_mm))
        cv2.imwrite(str(folder / f"view{number}.png"), middle_of(image, marks) if number == PART else image)
    lines = ["position,angle_deg", *(f"{number},{angle}" for number, angle in enumerate(ANGLES_DEG))]
    (folder / "angles.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")
    return folder


def run(capsys, table, *more):
    options = ["--images", f"left={table}/view*.png", "--cameras", str(table / "cameras.json"), "--board", "14x11", "--square-mm", "15"]
    code = main(["calibrate", "axis", *options, *more, "--json"])
    return code, json.loads(capsys.readouterr().out)


def test_a_part_is_determined_by_the_angles_of_the_table_and_not_without_them(capsys, table):
    code, answer = run(capsys, table, "--angles", str(table / "angles.csv"))
    assert code == 0, answer
    assert answer["rejected"] == []
    assert answer["positions"] == len(ANGLES_DEG)
    best = answer["maximum_likelihood"]
    assert (
        np.rad2deg(np.arccos(min(1.0, abs(float(np.dot(best["direction"], AXIS.direction)))))) < 0.1
    )  # off by squares it would be degrees
    code, answer = run(capsys, table)
    assert code == 0, answer
    assert [(one["position"], "may be any of" in one["reason"]) for one in answer["rejected"]] == [(PART, True)]
    assert answer["positions"] == len(ANGLES_DEG) - 1


def test_angles_for_another_number_of_images_are_refused(capsys, table, tmp_path):
    (tmp_path / "angles.csv").write_text("position,angle_deg\n0,0\n1,20\n", encoding="utf-8")
    code, answer = run(capsys, table, "--angles", str(tmp_path / "angles.csv"))
    assert code == 2
    assert "5 images per camera do not belong to 2 read-backs" in answer["error"]["message"]
