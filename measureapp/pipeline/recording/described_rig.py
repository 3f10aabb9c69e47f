"""Nominal description of a recorded rig of which only the calibrated cameras are known."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from pydantic import ValidationError
from scipy.spatial.transform import Rotation

from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.model import first_problem
from measureapp.data.rig import RECORDED, RigDescription
from measureapp.errors import InputError
from measureapp.geometry.transform import RigidTransform
from measureapp.project.rig_file import ABSENT_AXES, AT_ORIGIN

FARTHEST_MM = 5000.0


def rig_of_cameras(
    name: str, cameras: CameraArrayCalibration, bit_depth: int, projector_px: tuple[int, int], exposures_us: Sequence[int]
) -> RigDescription:
    """Describe a rig by its calibrated cameras: no robot, no guide, no table; frame ``head`` is that of the reference camera.

    Raises
    ------
    InputError
        A camera's name cannot be used.
    """
    described = []
    for camera, found in cameras.cameras.items():
        pinhole, pose = found.pinhole, found.reference_from_camera
        turned = Rotation.from_matrix(np.array(pose.rotation)).as_euler("XYZ", degrees=True)
        described.append(
            {
                "name": camera,
                "model": "recorded",
                "serial": found.serial,
                "width_px": pinhole.width_px,
                "height_px": pinhole.height_px,
                "pixel_um": 1.0,
                "focal_mm": float(pinhole.matrix[0, 0]) / 1000.0,
                "bit_depth": bit_depth,
                "head_from_camera": {"position_mm": tuple(pose.translation_mm.tolist()), "rotation_deg": tuple(turned.tolist())},
            }
        )
    width, height = projector_px
    projector = {"name": "projector", "model": "recorded", "width_px": width, "height_px": height, "focal_px": float(width)}
    document = {
        **ABSENT_AXES,
        "name": name,
        "driver": RECORDED,
        "cameras": described,
        "reference": cameras.reference,
        "projector": {**projector, "head_from_projector": AT_ORIGIN},
        "standoff_mm": _crossing_mm([found.reference_from_camera for found in cameras.cameras.values()]),
        "exposures_us": tuple(exposures_us),
    }
    try:
        return RigDescription.model_validate(document)
    except ValidationError as error:
        raise InputError(f"The cameras do not make a rig: {first_problem(error, 'the rig')}.", "Correct cameras.json.") from error


def _crossing_mm(poses: Sequence[RigidTransform]) -> float:
    """Return how far in front of the reference camera the lines of sight pass nearest to each other; 1 m where they hardly converge."""
    directions = np.array([pose.rotation[:, 2] for pose in poses])
    across = np.eye(3) - directions[:, :, None] * directions[:, None, :]
    if np.linalg.eigvalsh(across.sum(axis=0))[0] < 1e-4:
        return 1000.0
    centres = np.array([pose.translation_mm for pose in poses])
    nearest = np.linalg.solve(across.sum(axis=0), np.einsum("nij,nj->i", across, centres))
    return float(np.clip(nearest[2], 1.0, FARTHEST_MM))
