"""A small calibrated rig and simple parts for predictions, without images and without the virtual rig."""

from __future__ import annotations

import numpy as np

from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration, HandEye, LinearGuide, RigCalibration, RotationAxis
from measureapp.data.mesh import Mesh
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.geometry.transform import RigidTransform
from measureapp.pipeline.prediction.rig_model import RigModel
from measureapp.pipeline.prediction.typical_rig import nominal_pinhole
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.rig_file import read_rig

BLUR_PX = 0.75
COARSER = 8  # than the reference rig: 324 x 243 px


def small_rig() -> RigDescription:
    """The reference rig with coarse pixels."""
    rig = read_rig("paper")
    cameras = tuple(
        camera.model_copy(
            update={
                "width_px": camera.width_px // COARSER,
                "height_px": camera.height_px // COARSER,
                "pixel_um": camera.pixel_um * COARSER,
            }
        )
        for camera in rig.cameras
    )
    return rig.model_copy(update={"cameras": cameras})


def nominal_rig(description: RigDescription | None = None) -> RigModel:
    """A rig that is exactly as described, its calibration without uncertainty."""
    rig = description or small_rig()
    head_from_camera = {camera.name: camera.head_from_camera.transform("head", camera.name) for camera in rig.cameras}
    reference = RigidTransform(head_from_camera[rig.reference].matrix, "head", "camera")
    cameras = {
        camera.name: CameraCalibration(
            camera.name,
            nominal_pinhole(camera),
            reference.inverse() @ head_from_camera[camera.name],
            blur_px=BLUR_PX,
        )
        for camera in rig.cameras
    }
    calibration = RigCalibration(
        CameraArrayCalibration(rig.reference, cameras),
        HandEye(rig.flange_from_head.transform("flange", "head") @ reference),
        LinearGuide(np.array([0.0, 1.0, 0.0]), 1.0),
        RotationAxis(np.array(rig.table.centre_in_guide_mm), np.array([0.0, 0.0, 1.0]), "guide"),
    )
    return RigModel(rig, calibration, None, "as described")


def plan_for(rig: RigDescription, count: int) -> ScanPlan:
    """Viewpoints around a part of 60 mm."""
    return plan_around_part(rig, "test", radius_mm=60.0, height_mm=60.0, count=count)


def box(size_mm: tuple[float, float, float], origin_mm: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> Mesh:
    """A box whose bottom is centred on ``origin_mm``, its faces counter-clockwise from outside."""
    half = np.array(size_mm) / 2
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]) * half + [0, 0, half[2]] + np.array(origin_mm)
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    triangles = np.array([(a, b, c) for a, b, c, _ in faces] + [(a, c, d) for a, _, c, d in faces])
    return Mesh(corners, triangles, "nominal")


def joined(*meshes: Mesh) -> Mesh:
    """Several meshes as one."""
    ends = np.cumsum([0, *(len(mesh.vertices_mm) for mesh in meshes)])
    triangles = np.vstack([mesh.triangles + first for mesh, first in zip(meshes, ends, strict=False)])
    return Mesh(np.vstack([mesh.vertices_mm for mesh in meshes]), triangles, "nominal")
