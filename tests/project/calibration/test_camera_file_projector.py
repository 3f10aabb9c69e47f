"""The projector in `cameras.json`."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, ProjectorCalibration, Provenance
from measureapp.errors import InputError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration.camera_file import cameras_document, read_cameras, write_cameras

MATRIX = np.array([[2045.5, 0, 650], [0, 2044.25, 480], [0, 0, 1]])


def calibration(projector: ProjectorCalibration | None) -> CameraArrayCalibration:
    camera = CameraCalibration("one", PinholeCamera(1296, 972, MATRIX, np.zeros(5)), RigidTransform.identity("camera", "one"))
    return CameraArrayCalibration("one", {"one": camera}, projector=projector)


def projector() -> ProjectorCalibration:
    pose = RigidTransform.from_vector([0.02, -0.3, 0.01], [120.5, 0.25, 5.125], "camera", "projector")
    pinhole = PinholeCamera(1024, 768, MATRIX, np.array([-0.1, 0.05, 0.001, -0.002, 0.01]))
    return ProjectorCalibration(pinhole, pose, "projector", {"fx": 0.5}, Provenance("2030-01-02T03:04:05+00:00", "bundle", {"a.png": "1"}))


def test_a_written_projector_reads_back_as_it_was(tmp_path: Path) -> None:
    written = calibration(projector())
    write_cameras(tmp_path / "cameras.json", written)
    again = read_cameras(tmp_path / "cameras.json")
    assert cameras_document(again) == cameras_document(written)
    assert again.projector is not None
    assert again.projector.pinhole.width_px == 1024
    assert again.projector.reference_from_projector.from_frame == "projector"


def test_a_file_without_a_projector_is_read_and_written_without_one(tmp_path: Path) -> None:
    write_cameras(tmp_path / "cameras.json", calibration(None))
    assert "projector" not in json.loads((tmp_path / "cameras.json").read_text())
    assert read_cameras(tmp_path / "cameras.json").projector is None


def test_a_foreign_projector_with_the_needed_fields_only_is_read(tmp_path: Path) -> None:
    document = cameras_document(calibration(projector()))
    for name in ("name", "standard_deviations", "provenance"):
        del document["projector"][name]
    (tmp_path / "cameras.json").write_text(json.dumps(document))
    read = read_cameras(tmp_path / "cameras.json").projector
    assert read is not None
    assert read.name == "projector"
    np.testing.assert_array_equal(read.pinhole.matrix, MATRIX)


@pytest.mark.parametrize(
    ("field", "value", "said"),
    [
        ("gamma", 2.2, "projector has the unknown field 'gamma'"),
        ("matrix", None, "projector.matrix is missing"),
        ("width", 0, "projector.width and height must be whole numbers"),
        ("distortion", [1, 2, 3], "projector.distortion has 3 coefficients"),
        ("reference_from_projector", None, "projector.reference_from_projector is missing"),
        ("reference_from_projector", np.diag([1.0, 1, -1, 1]).tolist(), "projector.reference_from_projector is not a rigid transform"),
        ("reference_from_projector", np.ones((4, 4)).tolist(), "projector.reference_from_projector is not a rigid"),
        ("name", "one", "the name of a camera"),
    ],
)
def test_what_is_wrong_in_a_projector_is_named(tmp_path: Path, field: str, value: Any, said: str) -> None:
    document = cameras_document(calibration(projector()))
    document["projector"] |= {field: value}
    if value is None:
        del document["projector"][field]
    (tmp_path / "cameras.json").write_text(json.dumps(document))
    with pytest.raises(InputError, match=said) as caught:
        read_cameras(tmp_path / "cameras.json")
    assert "cameras.json" in caught.value.message


def test_a_projector_that_is_no_object_is_refused(tmp_path: Path) -> None:
    document = cameras_document(calibration(projector())) | {"projector": [1, 2]}
    (tmp_path / "cameras.json").write_text(json.dumps(document))
    with pytest.raises(InputError, match="projector is not a JSON object"):
        read_cameras(tmp_path / "cameras.json")
