"""A measurement of a small block, with every part a report speaks of."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.calibration import (
    CameraArrayCalibration,
    CameraCalibration,
    HandEye,
    LinearGuide,
    Provenance,
    RigCalibration,
    RotationAxis,
)
from measureapp.data.cloud import CloudQuality, PointCloud, StitchedCloud, ViewPlacement
from measureapp.data.dimension import Dimension, Verdict
from measureapp.data.fringe import AxisReadback
from measureapp.data.measurement import Alignment, Inspection, Measurement, ViewResult
from measureapp.data.mesh import Mesh
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.inspection.measured_points import sample_mesh

NASTY = 'part #1 "x" $a$ _b_ <i> & \\ [c] 件'


@pytest.fixture(scope="session")
def block() -> Mesh:
    import trimesh

    made = trimesh.creation.box((80, 60, 40)).subdivide_to_size(10)
    return Mesh(made.vertices, made.faces, "nominal")


def calibration() -> RigCalibration:
    pinhole = PinholeCamera(640, 480, np.array([[900, 0, 320], [0, 900, 240], [0, 0, 1]]), np.zeros(5))
    cameras = {
        name: CameraCalibration(name, pinhole, RigidTransform.identity("camera", name), {}, 0.04, "S1", blur_px=blur_px)
        for name, blur_px in (("left", 0.75), ("right", 0.0))
    }
    return RigCalibration(
        CameraArrayCalibration("left", cameras, {"left-right": 0.05}),
        HandEye(RigidTransform.identity("flange", "camera"), 2e-5, 0.012, 0.03, 1e-4, "Tsai-Lenz"),
        LinearGuide(np.array([0, 1, 0]), 1.00002, 1e-5, 2e-6, 0.004),
        RotationAxis(np.array([600, 0, 100]), np.array([0, 0, 1]), "guide", 0.006, 1e-5, 0.01),
        Provenance("2026-05-04T08:00:00+00:00", "joint"),
    )


def views(count: int) -> tuple[tuple[ViewResult, ...], tuple[ViewPlacement, ...]]:
    here = RigidTransform.identity("part", "camera")
    readback = AxisReadback(RigidTransform.identity("base", "flange"), 0.0, 0.0)
    results, placements = [], []
    for k in range(count):
        name = f"v{k:02d}"
        cloud = PointCloud(np.zeros((5, 3)), np.zeros((5, 3)), np.ones(5), np.ones(5), np.zeros((5, 2)), np.ones(5), "camera", name)
        quality = CloudQuality(5000 + k, 9.1, 0.018, 0.004, 0.93, True, "")
        results.append(ViewResult(name, cloud, quality, here, {}, (), {}, readback))
        bad = k == 1
        verdict = "correction exceeds its bound (0.9 mm > 0.6 mm)" if bad else "good"
        placements.append(ViewPlacement(name, here, here, 0.12, 0.011, 0.021, 0.62, verdict, not bad))
    return tuple(results), tuple(placements)


SHARES_OF_LENGTH = {"noise": 0.018, "stitching": 0.024, "calibration": 0.0}
DIMENSIONS = (
    Dimension("length", 80.0, 80.0123456789, 0.03, -0.1, 0.1, Verdict.PASS, traceability="800 points", budget=SHARES_OF_LENGTH),
    Dimension("width", 60.0, 59.8, 0.03, -0.1, 0.1, Verdict.FAIL),
    Dimension("height", 40.0, 40.095, 0.03, -0.1, 0.1, Verdict.NOT_PROVEN),
    Dimension("bore", 12.0, None, None, -0.1, 0.05, Verdict.NOT_MEASURED, reason=f"bore: no points; {NASTY}"),
    Dimension("tilt", 90.0, 90.01, 0.02, -0.5, 0.5, Verdict.PASS, unit="°"),
)


@pytest.fixture(scope="session")
def measured(block: Mesh) -> Callable[..., Measurement]:
    def make(dimensions: tuple[Dimension, ...] | None = DIMENSIONS, mesh: bool = True, view_count: int = 3) -> Measurement:
        points = sample_mesh(block, 20_000)
        assert points.normals is not None
        results, placements = views(view_count)
        count = len(points)
        alignment = Alignment("best fit", RigidTransform.identity("nominal", "part"), 0.02, 0.99, ("rotation about z",))
        stitched = StitchedCloud(points.points_mm, points.normals, np.full(count, 0.02), np.full(count, 0.5), np.zeros(count), placements)
        return Measurement(
            project=f"project {NASTY}",
            part=NASTY,
            rig="Paper rig",
            measured_at="2026-05-04T10:20:30+00:00",
            calibration=calibration(),
            views=results,
            stitched=stitched,
            mesh=replace(block, frame="part", measured=block.vertices_mm[:, 2] > -19) if mesh else None,
            inspection=None if dimensions is None else Inspection(f"program {NASTY}", alignment, (), dimensions),
            settings={"exposures_us": [100000, 20000], "decode": {"least_modulation": 4.0}, "note": NASTY},
        )

    return make
