"""Documents of a measurement: what is written comes back the same."""

from __future__ import annotations

import json
import shutil
from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from measureapp.data.calibration import (
    CameraArrayCalibration,
    CameraCalibration,
    HandEye,
    LinearGuide,
    Provenance,
    RigCalibration,
    RobotStation,
    RotationAxis,
)
from measureapp.data.cloud import CloudQuality, LoopClosure, PointCloud, StitchedCloud, ViewPlacement
from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.feature import Feature
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import Alignment, Inspection, Measurement, ViewResult
from measureapp.data.mesh import Mesh
from measureapp.errors import StorageError
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.documents import (
    inspection_document,
    inspection_from,
    placement_document,
    placement_from,
    readback_document,
    readback_from,
    rig_calibration_document,
    rig_calibration_from,
)
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.results import load, save
from measureapp.project.rig_file import read_rig


def same(one: Any, other: Any, path: str = "") -> None:
    """Compare two nouns field by field, arrays included; directions are scaled to unit length once more when they come back."""
    if isinstance(one, RigidTransform):
        assert (one.to_frame, one.from_frame) == (other.to_frame, other.from_frame), path
        assert np.allclose(one.matrix, other.matrix, rtol=1e-14, atol=1e-12), path
    elif is_dataclass(one):
        assert type(one) is type(other), path
        for entry in fields(one):
            same(getattr(one, entry.name), getattr(other, entry.name), f"{path}.{entry.name}")
    elif isinstance(one, np.ndarray):
        assert one.dtype == other.dtype and one.shape == other.shape, path
        assert np.allclose(one, other, rtol=1e-15, atol=1e-16), path
    elif isinstance(one, Mapping) and one and is_dataclass(next(iter(one.values()))):
        assert list(one) == list(other), path
        for name in one:
            same(one[name], other[name], f"{path}.{name}")
    elif isinstance(one, tuple):
        assert len(one) == len(other), path
        for index, (first, second) in enumerate(zip(one, other, strict=True)):
            same(first, second, f"{path}[{index}]")
    elif isinstance(one, PinholeCamera):
        assert (one.width_px, one.height_px) == (other.width_px, other.height_px), path
        assert np.array_equal(one.matrix, other.matrix) and np.array_equal(one.distortion, other.distortion), path
    else:
        assert one == other, path


def through_json(document: dict[str, Any]) -> dict[str, Any]:
    return json.loads(json.dumps(document, allow_nan=False))


def pose(seed: int, to_frame: str, from_frame: str) -> RigidTransform:
    rng = np.random.default_rng(seed)
    return RigidTransform.from_vector(rng.normal(0, 1, 3), rng.normal(0, 300, 3), to_frame, from_frame)


READBACK = AxisReadback(pose(1, "base", "flange"), 12.345678901234567, 0.1 + 0.2)


@pytest.fixture
def calibration() -> RigCalibration:
    cameras = {}
    for number, name in enumerate(("left", "right")):
        matrix = np.array([[1000.1 + number, 0, 320.3], [0, 1001.7, 239.9], [0, 0, 1]])
        place = pose(number, "camera", name) if number else RigidTransform.identity("camera", name)
        lens = PinholeCamera(640, 480, matrix, np.array([-0.1, 0.05, 1e-4, 2e-4, 1 / 3]))
        cameras[name] = CameraCalibration(name, lens, place, {"fx": 0.1, "cx": 1 / 7}, 0.04, f"SN-{number}")
    return RigCalibration(
        cameras=CameraArrayCalibration("left", cameras, {"left-right": 0.05}, Provenance("2026-01-01", "joint", {"a.png": "00ff"})),
        hand_eye=HandEye(pose(2, "flange", "camera"), 1e-4, 0.1, 0.2, 3e-4, "Tsai-Lenz"),
        guide=LinearGuide(np.array([0.001, 0.9999, -0.002]), 0.9998, 1e-4, 2e-5, 0.01),
        axis=RotationAxis(np.array([850.1, -0.3, 100.7]), np.array([0.001, 0.002, 0.99]), "guide", 0.1, 1e-4, 0.02),
        provenance=Provenance("2026-01-02T03:04:05+00:00", "joint calibration", {"left": "SN-0"}),
        stations=(RobotStation(pose(3, "base", "flange"), pose(4, "base", "flange")),),
    )


@pytest.fixture
def inspection() -> Inspection:
    shapes = (
        Feature(
            "top", "plane", np.array([0.1, 0.2, 0.3]), np.array([0.0, 0.0, 1.0]), points=7, left_out=1, rms_mm=0.01, form_error_mm=0.05
        ),
        Feature("bore", "cylinder", np.zeros(3), np.array([0.0, 1.0, 0.0]), 12.5, standard_deviations={"radius_mm": 1e-3}),
        Feature("tip", "point", np.ones(3), boundary_mm=np.arange(12.0).reshape(4, 3)),
        Feature("lip", "torus", np.ones(3), np.array([1.0, 0.0, 0.0]), 30.0, 0.25, 2.0),
    )
    dimensions = (
        Dimension("a", 180.0, 180.02, 0.04, -0.1, 0.1, Verdict.PASS, features=("top", "bore")),
        Dimension("w", 90.0, 90.2, None, -0.1, 0.1, Verdict.FAIL, unit="°"),
        Dimension("d", 40.0, None, None, -0.1, 0.1, Verdict.NOT_MEASURED, reason="no points"),
    )
    return Inspection("cross", Alignment("best fit", pose(5, "nominal", "part"), 0.05, 0.98, ("rotation about z",)), shapes, dimensions)


def placement(name: str, seed: int) -> ViewPlacement:
    return ViewPlacement(name, pose(seed, "part", "camera"), pose(seed + 50, "part", "camera"), 0.1, 0.01, 0.02, 0.5, "good", True)


def cloud(name: str, count: int = 30) -> PointCloud:
    rng = np.random.default_rng(count)
    points = rng.normal(0, 100, (count, 3)).astype(np.float32)  # as a PLY file keeps them
    normals = np.tile(np.array([0, 0, -1], np.float32), (count, 1))
    numbers = rng.random((2, count)).astype(np.float32) + np.float32(0.001)
    pixel = rng.integers(0, 400, (count, 2)).astype(np.int32)
    return PointCloud(points, normals, numbers[0], np.clip(numbers[1], 0, 1), pixel, np.full(count, 3, np.uint8), "camera", name)


@pytest.fixture
def measurement(calibration: RigCalibration, inspection: Inspection) -> Measurement:
    views = tuple(
        ViewResult(
            viewpoint_id=name,
            cloud=cloud(name, 30 + index),
            quality=CloudQuality(30 + index, 1.5, 0.01, 0.02, 0.9, True, ""),
            part_from_camera=pose(20 + index, "part", "camera"),
            decode={"left": {"valid_ratio": {"exposures": [0.5, 0.6], "composite": 0.55}, "order_conflicts": 3}},
            pairs=({"names": ["left", "right"], "matched": 25, "epipolar_rms_px": None},),
            rejected={"unmatched": 5},
            readback=READBACK,
        )
        for index, name in enumerate(("view01", "view02"))
    )
    seen = cloud("", 50)
    stitched = StitchedCloud(
        seen.points_mm,
        seen.normals,
        seen.sigma_mm,
        seen.grey,
        np.arange(50) % 2,
        (placement("view01", 6), placement("view02", 7)),
        notes={"spacing_mm": 0.6},
        loop_closure=LoopClosure(("view01", "view02", "view03"), 0.012, 0.004, 0.02),
    )
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32)
    mesh = Mesh(corners, np.array([[0, 1, 2], [0, 2, 3]]), "part", np.array([True, True, False, True]))
    settings, timings = {"patterns": "paper", "exposures_us": [100_000, 20_000]}, {"stitching": 1.25}
    return Measurement(
        "order 7", "gypsum", "paper", "2026-05-04T10:20:30+00:00", calibration, views, stitched, mesh, inspection, settings, timings
    )


def test_a_read_back_comes_back() -> None:
    same(readback_from(through_json(readback_document(READBACK))), READBACK)


def test_a_rig_calibration_comes_back(calibration: RigCalibration) -> None:
    same(rig_calibration_from(through_json(rig_calibration_document(calibration)), calibration.cameras), calibration)


def test_a_calibration_comes_back_from_a_project_and_places_views_the_same(calibration: RigCalibration, tmp_path: Path) -> None:
    project = ProjectFolder.create(tmp_path / "p", ProjectSettings(name="n", part="gypsum", rig=read_rig("paper")))
    assert project.calibration() is None
    project.save_calibration(calibration)
    found = ProjectFolder.open(project.path).calibration()
    assert found is not None
    same(found, calibration)
    same(found.part_from_camera(READBACK), calibration.part_from_camera(READBACK))
    at_station = replace(READBACK, base_from_flange=calibration.stations[0].read)
    same(found.part_from_camera(at_station), calibration.part_from_camera(at_station))


def test_a_placement_comes_back() -> None:
    refused = replace(placement("view03", 8), verdict="too little overlap", used=False)
    for one in (placement("view01", 6), refused):
        same(placement_from(through_json(placement_document(one))), one)


def test_an_inspection_comes_back_with_features_of_every_kind(inspection: Inspection) -> None:
    same(inspection_from(through_json(inspection_document(inspection))), inspection)


def test_results_of_a_version_that_did_not_state_itself_are_read_as_such(inspection: Inspection) -> None:
    stated = replace(inspection, dimensions=tuple(replace(one, version="0.1.0") for one in inspection.dimensions))
    document = through_json(inspection_document(stated))
    assert [one.pop("version") for one in document["dimensions"]] == ["0.1.0"] * len(stated.dimensions)
    assert {one.version for one in inspection_from(document).dimensions} == {""}


def test_a_measurement_comes_back(measurement: Measurement, tmp_path: Path) -> None:
    save(tmp_path, measurement)
    found = load(tmp_path, measurement.calibration)
    assert found is not None
    same(found, measurement)


def test_without_the_clouds_of_its_views_the_rest_comes_back_and_their_files_stay_unread(measurement: Measurement, tmp_path: Path) -> None:
    save(tmp_path, measurement)
    shutil.rmtree(tmp_path / "clouds")
    found = load(tmp_path, measurement.calibration, clouds=False)
    assert found is not None and all(len(view.cloud) == 0 for view in found.views)
    whole = replace(found, views=tuple(replace(view, cloud=own.cloud) for view, own in zip(found.views, measurement.views, strict=True)))
    same(whole, measurement)


def test_a_measurement_without_mesh_and_inspection_comes_back_and_the_old_mesh_is_gone(measurement: Measurement, tmp_path: Path) -> None:
    save(tmp_path, measurement)
    bare = replace(measurement, mesh=None, inspection=None)
    save(tmp_path, bare)
    found = load(tmp_path, measurement.calibration)
    assert found is not None
    same(found, bare)
    assert not (tmp_path / "mesh.ply").exists()


def test_where_nothing_was_measured_there_is_nothing(calibration: RigCalibration, tmp_path: Path) -> None:
    assert load(tmp_path, calibration) is None


def test_a_save_that_breaks_off_leaves_the_earlier_measurement_as_it_was(measurement: Measurement, tmp_path: Path, monkeypatch) -> None:
    save(tmp_path, measurement)

    def full(*_: object) -> None:
        raise StorageError("The disk is full.", "Free some space.")

    monkeypatch.setattr("measureapp.project.results.write_mesh", full)
    with pytest.raises(StorageError):
        save(tmp_path, replace(measurement, project="order 8"))
    same(load(tmp_path, measurement.calibration), measurement)
    assert sorted(path.name for path in tmp_path.rglob("*") if ".part" in path.name) == []


@pytest.mark.parametrize("damaged", ["measurement.json", "stitched_cloud.ply", "mesh.ply", "clouds/view02.ply"])
def test_damaged_results_are_refused_with_the_remedy(damaged: str, measurement: Measurement, tmp_path: Path) -> None:
    save(tmp_path, measurement)
    path = tmp_path / damaged
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    with pytest.raises(StorageError, match="cannot be read") as refusal:
        load(tmp_path, measurement.calibration)
    assert "measureapp process" in refusal.value.hint


@pytest.mark.parametrize("missing", ["placements", "views", "inspection", "notes", "measured_at"])
def test_a_document_that_lacks_an_entry_is_refused(missing: str, measurement: Measurement, tmp_path: Path) -> None:
    save(tmp_path, measurement)
    document = json.loads((tmp_path / "measurement.json").read_text())
    del document[missing]
    (tmp_path / "measurement.json").write_text(json.dumps(document))
    with pytest.raises(StorageError, match=missing):
        load(tmp_path, measurement.calibration)


def test_an_inspection_comes_back_with_its_further_alignments_and_dimensions_without_tolerance(inspection: Inspection) -> None:
    weak = replace(inspection.alignment, method="datums", fixed=5, weakest_mm=0.02, weakest_direction=(0.0, 0.6, 0.8))
    free = replace(inspection.dimensions[0], lower_tolerance=None, upper_tolerance=None, tolerance_source="", alignment="A", group="fit")
    slot = replace(inspection.features[0], shape="slot", length_mm=30.0, normal=np.array([0.0, 0.0, 1.0]))
    whole = replace(inspection, further={"A": weak}, dimensions=(free,), features=(slot,))
    same(inspection_from(through_json(inspection_document(whole))), whole)
