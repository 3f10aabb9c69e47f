"""Systematic deformation of all clouds by errors of the cameras' calibration, with the correlated errors of the axes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.cameras.uncertainty import point_jacobian
from measureapp.calibrate.rig.stitch_uncertainty import RigUncertainty, pose_camera_jacobians
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.fringe import AxisReadback
from measureapp.data.view_errors import POWERS, CalibrationErrors, CloudDistortion

STEPS = 9  # of the grid along each axis
SEEN_BY = 2


def calibration_errors(rig: RigUncertainty, readbacks: Sequence[AxisReadback], corners_mm: FloatArray) -> CalibrationErrors | None:
    """Return the errors of clouds and poses of views by the calibration; None where it has no covariance between cameras and axes.

    Parameters
    ----------
    corners_mm : (2, 3), of the box that holds the points of all clouds, in the reference camera's frame
    """
    moved = pose_camera_jacobians(rig, readbacks)
    if rig.cameras is None or moved is None:
        return None
    root = rig.cameras.root
    bends = cloud_distortions(rig.calibration.cameras, rig.cameras.parameters, root, corners_mm)
    return None if bends is None else CalibrationErrors(bends, moved @ root)


def cloud_distortions(
    cameras: CameraArrayCalibration, parameters: Sequence[str], root: FloatArray, corners_mm: FloatArray
) -> CloudDistortion | None:
    """Return the displacements of triangulated points over a box by errors ``root`` (C, K) of the parameters; None where no two cameras see any of it."""
    middle, reach = corners_mm.mean(axis=0), np.maximum(np.ptp(corners_mm, axis=0) / 2, 1.0)
    nodes = np.cos(np.pi * (np.arange(STEPS) + 0.5) / STEPS)  # Chebyshev's, for the least greatest error between them
    points = middle + reach * np.stack(np.meshgrid(nodes, nodes, nodes, indexing="ij"), -1).reshape(-1, 3)
    moved, seeing = point_jacobian(cameras, points, parameters)
    seen = seeing >= SEEN_BY
    if np.count_nonzero(seen) < len(POWERS):
        return None
    empty = CloudDistortion(middle, reach, np.zeros((len(POWERS), 3, 0)))
    shifts = (moved[seen] @ root).reshape(np.count_nonzero(seen), -1)
    coefficients = np.linalg.lstsq(empty.products(points[seen]), shifts, rcond=None)[0]
    return CloudDistortion(middle, reach, coefficients.reshape(len(POWERS), 3, -1))
