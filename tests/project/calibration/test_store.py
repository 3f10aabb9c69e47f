"""A calibration is never changed: another takes its place, and what was said of each stays."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from measureapp.data.axis_motions import AxisMotions
from measureapp.data.calibration import (
    CameraArrayCalibration,
    CameraCalibration,
    HandEye,
    LinearGuide,
    Provenance,
    RigCalibration,
    RotationAxis,
)
from measureapp.data.conditions import LensSetting
from measureapp.data.fringe import AxisReadback
from measureapp.data.validity import CheckRecord
from measureapp.errors import StorageError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.calibration import store
from measureapp.project.documents import calibration_id

LINE = CheckRecord("2031-05-02T08:00:00+00:00", "scan", "abc", "watch", "Camera left has turned.", 0.1, 0.04, 0.2, ("left",), 34.5)


@pytest.fixture
def calibration() -> RigCalibration:
    pinhole = PinholeCamera(64, 48, np.array([[100.1, 0, 31.7], [0, 100.3, 23.2], [0, 0, 1]]), np.full(5, 0.01))
    camera = CameraCalibration("left", pinhole, RigidTransform.identity("camera", "left"), serial="A", lens=LensSetting(550.0, 8.0))
    return RigCalibration(
        CameraArrayCalibration("left", {"left": camera}),
        HandEye(RigidTransform.from_vector([0.1, 0.2, 0.3], [1, 2, 3], "flange", "camera")),
        LinearGuide(np.array([0.001, 1.0, 0.002]), 1.0001),
        RotationAxis(np.array([850.0, 0.0, 0.0]), np.array([0.001, 0.0, 1.0]), "guide"),
        Provenance("2031-05-01T08:00:00+00:00", "joint", {"pose01/left": "00ff"}, 35.0, 90.0),
    )


def test_a_calibration_reads_back_as_it_was_stored(tmp_path: Path, calibration: RigCalibration) -> None:
    store.save(tmp_path, calibration)
    found = store.load(tmp_path)
    assert found is not None
    assert found.provenance == calibration.provenance
    assert found.cameras.cameras["left"].lens == LensSetting(550.0, 8.0)
    assert calibration_id(found) == calibration_id(calibration)


def test_a_calibration_of_other_images_sets_the_former_aside(tmp_path: Path, calibration: RigCalibration) -> None:
    store.save(tmp_path, calibration)
    newer = replace(calibration, provenance=replace(calibration.provenance, inputs={"pose01/left": "0100"}))
    store.save(tmp_path, newer)
    (place,) = (tmp_path / "former").iterdir()
    assert place.name == f"2031-05-01-{calibration_id(calibration)}"
    former = store.load(place)
    assert former is not None and former.provenance == calibration.provenance
    store.save(tmp_path, newer)  # solved again from the same images
    assert len([*(tmp_path / "former").iterdir()]) == 1


@pytest.mark.parametrize(("name", "old", "new"), [("rig.json", "850.0", "851.0"), ("cameras.json", "100.1", "100.2")])
def test_a_file_that_was_changed_is_refused(tmp_path: Path, calibration: RigCalibration, name: str, old: str, new: str) -> None:
    store.save(tmp_path, calibration)
    text = (tmp_path / name).read_text(encoding="utf-8")
    assert old in text
    (tmp_path / name).write_text(text.replace(old, new), encoding="utf-8")
    with pytest.raises(StorageError, match="modified after it was stored"):
        store.load(tmp_path)


def test_the_history_only_grows_and_says_nothing_twice(tmp_path: Path) -> None:
    store.record(tmp_path, LINE)
    store.record(tmp_path, LINE)
    later = replace(LINE, at="2031-05-03T08:00:00+00:00", status="good", shift_px=None, cameras=())
    store.record(tmp_path, later)
    assert store.history(tmp_path) == (LINE, later)


def test_a_line_that_a_power_cut_left_does_no_harm(tmp_path: Path) -> None:
    store.record(tmp_path, LINE)
    path = tmp_path / "history.jsonl"
    path.write_text(path.read_text(encoding="utf-8") + '{"at": "2031', encoding="utf-8")
    later = replace(LINE, at="2031-05-03T08:00:00+00:00")
    store.record(tmp_path, later)
    assert store.history(tmp_path) == (LINE, later)


def test_error_motions_of_the_axes_make_version_2_and_a_file_of_version_1_still_reads(tmp_path: Path, calibration: RigCalibration) -> None:
    rng = np.random.default_rng(3)
    motions = AxisMotions(
        np.array([850.0, 0, 190]),
        np.eye(3),
        np.array([-650.0, 650.0]),
        rng.normal(size=(5, 12)) * 1e-5,
        rng.normal(size=(6, 10)) * 1e-5,
        np.full(5, 1e-5),
        np.full(6, 1e-5),
        explained_mm=0.004,
    )
    store.save(tmp_path / "old", calibration)
    store.save(tmp_path / "new", replace(calibration, motions=motions))
    versions = {name: json.loads((tmp_path / name / "rig.json").read_text(encoding="utf-8"))["schema_version"] for name in ("old", "new")}
    assert versions == {"old": 1, "new": 2}
    old, found = store.load(tmp_path / "old"), store.load(tmp_path / "new")
    assert old is not None
    assert old.motions is None
    assert found is not None
    readback = AxisReadback(RigidTransform.from_vector([0.1, 2.0, 0.2], [500, 10, 300], "base", "flange"), 120.0, 1.1)
    placed = found.part_from_camera(readback).matrix
    np.testing.assert_allclose(placed, replace(calibration, motions=motions).part_from_camera(readback).matrix, atol=1e-11)
    assert np.abs(placed - calibration.part_from_camera(readback).matrix).max() > 1e-5
    (tmp_path / "new" / "rig.json").write_text('{"schema_version": 3}', encoding="utf-8")
    with pytest.raises(StorageError, match="newer version"):
        store.load(tmp_path / "new")
