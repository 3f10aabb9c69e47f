"""Day, temperature and validity of a camera calibration survive its file."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, Provenance
from measureapp.errors import InputError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.camera_file import read_cameras, write_cameras


@pytest.fixture
def calibration() -> CameraArrayCalibration:
    lens = PinholeCamera(640, 480, np.array([[800.0, 0, 320], [0, 800, 240], [0, 0, 1]]), np.zeros(5))
    camera = CameraCalibration("left", lens, RigidTransform.identity("camera", "left"), serial="SN-1")
    return CameraArrayCalibration(
        "left", {"left": camera}, provenance=Provenance("2031-05-01T08:00:00+00:00", "m", {"a.png": "00"}, 21.5, 30.0)
    )


def test_temperature_and_validity_are_written_and_read(tmp_path, calibration):
    write_cameras(tmp_path / "cameras.json", calibration)
    assert read_cameras(tmp_path / "cameras.json").provenance == calibration.provenance


def test_files_without_them_can_still_be_read(tmp_path, calibration):
    plain = replace(calibration, provenance=Provenance("2031-05-01T08:00:00+00:00", "m"))
    write_cameras(tmp_path / "cameras.json", plain)
    document = json.loads((tmp_path / "cameras.json").read_text())
    assert "temperature_c" not in document["provenance"]
    assert read_cameras(tmp_path / "cameras.json").provenance.valid_days is None


def test_a_validity_that_is_no_number_is_refused(tmp_path, calibration):
    write_cameras(tmp_path / "cameras.json", calibration)
    document = json.loads((tmp_path / "cameras.json").read_text())
    document["provenance"]["valid_days"] = "a month"
    (tmp_path / "cameras.json").write_text(json.dumps(document))
    with pytest.raises(InputError, match=r"provenance\.valid_days is not a number"):
        read_cameras(tmp_path / "cameras.json")
