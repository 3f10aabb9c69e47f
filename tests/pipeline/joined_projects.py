"""Projects of a part that was scanned upright and turned over, as far as `join` reads them: results without images."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from measureapp.data.calibration import (
    CameraArrayCalibration,
    CameraCalibration,
    HandEye,
    LinearGuide,
    Provenance,
    RigCalibration,
    RotationAxis,
)
from measureapp.data.cloud import CloudQuality
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import Measurement, ViewResult
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.project.folder import ProjectFolder, ProjectSettings
from measureapp.project.rig_file import read_rig
from measureapp.register.setups.setup_cloud import SetUpCloud

PROGRAM = """
schema_version = 1
name = "bracket"
alignment = "best-fit"

[[features]]
name = "foot"
shape = "plane"
point_mm = [0, 0, 0]
direction = [0, 0, -1]
cut = { edge_mm = 4 }

[[features]]
name = "wall top"
shape = "plane"
point_mm = [48, 12, 70]
direction = [0, 0, 1]
cut = { edge_mm = 3, x_mm = [43, 53], y_mm = [-5, 29] }

[[features]]
name = "block top"
shape = "plane"
point_mm = [52, -30, 30]
direction = [0, 0, 1]
cut = { edge_mm = 3, x_mm = [38, 57], y_mm = [-38, -14] }

[[dimensions]]
name = "height"
kind = "distance"
features = ["foot", "wall top"]
nominal = 70.0

[[dimensions]]
name = "wall"
kind = "distance"
features = ["block top", "wall top"]
nominal = 40.0
"""


def calibration(created: str) -> RigCalibration:
    pinhole = PinholeCamera(640, 480, np.array([[900, 0, 320], [0, 900, 240], [0, 0, 1]]), np.zeros(5))
    cameras = {
        name: CameraCalibration(
            name, pinhole, RigidTransform.from_vector([0, 0, 0], [100.0 * n, 0, 0], "camera", name), {"fx": 0.02}, rms_px=0.05
        )
        for n, name in enumerate(("left", "right", "upper"))
    }
    return RigCalibration(
        CameraArrayCalibration("left", cameras),
        HandEye(RigidTransform.identity("flange", "camera")),
        LinearGuide(np.array([0, 1, 0]), 1.0),
        RotationAxis(np.array([600, 0, 100]), np.array([0, 0, 1]), "guide"),
        Provenance(created, "joint"),
    )


def project_of(folder: Path, cloud: SetUpCloud, *, mesh: Any | None = None, part: str = "bracket", created: str = "2026-05-04") -> Path:
    """Write a project with the clouds of a set-up; with a mesh also program and nominal."""
    project = ProjectFolder.create(folder, ProjectSettings(name=folder.name, part=part, rig=read_rig("paper")))
    calibrated = calibration(f"{created}T08:00:00+00:00")
    project.save_calibration(calibrated)
    if mesh is not None:
        nominal, program = folder.parent / "bracket.stl", folder.parent / "bracket.toml"
        mesh.export(nominal)
        program.write_text(PROGRAM, encoding="utf-8")
        project.save_inspection(program, nominal)
    readback = AxisReadback(RigidTransform.identity("base", "flange"), 0.0, 0.0)
    views = tuple(
        ViewResult(
            one.viewpoint_id, one, CloudQuality(len(one), 9.0, 0.03, 0.0, 1.0, True, ""), placed.part_from_camera, {}, (), {}, readback
        )
        for one, placed in zip(cloud.clouds, cloud.stitched.placements, strict=True)
    )
    measured = Measurement(
        folder.name, part, "paper", "2026-05-04T10:20:30+00:00", calibrated, views, cloud.stitched, None, None, {"plan": "all around"}
    )
    project.save_measurement(measured)
    return folder
