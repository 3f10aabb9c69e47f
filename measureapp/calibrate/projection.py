"""Projection of points with its derivatives."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.pinhole import PinholeCamera

FOCAL_AND_CENTRE = 4  # fx, fy, cx, cy come first among the intrinsic parameters
DISTORTION_NAMES = ("k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6", "s1", "s2", "s3", "s4", "tau_x", "tau_y")


def intrinsic_names(count: int) -> tuple[str, ...]:
    """Return the names of the intrinsic parameters of a lens with ``count`` distortion coefficients."""
    return ("fx", "fy", "cx", "cy", *DISTORTION_NAMES[:count])


def project_with_derivatives(pinhole: PinholeCamera, points_mm: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Project points (N, 3) in the camera's frame.

    Returns
    -------
    pixels : (N, 2)
    by_point : (N, 2, 3), derivative of the pixel by the point, px/mm
    by_intrinsics : (N, 2, K), derivative by the parameters of `intrinsic_names`
    """
    count = len(pinhole.distortion)
    pixels, jacobian = cv2.projectPoints(
        np.ascontiguousarray(points_mm).reshape(-1, 1, 3),
        np.zeros(3),
        np.zeros(3),
        np.asarray(pinhole.matrix),
        np.asarray(pinhole.distortion),
        jacobian=np.empty(0),
    )
    derivatives = np.asarray(jacobian, np.float64).reshape(-1, 2, jacobian.shape[1])
    return np.asarray(pixels, np.float64).reshape(-1, 2), derivatives[:, :, 3:6], derivatives[:, :, 6 : 6 + FOCAL_AND_CENTRE + count]


def apply_intrinsic_changes(pinhole: PinholeCamera, change: FloatArray) -> PinholeCamera:
    """Return the camera after a change of the parameters of `intrinsic_names`."""
    matrix = np.array(pinhole.matrix)
    matrix[[0, 1, 0, 1], [0, 1, 2, 2]] += change[:FOCAL_AND_CENTRE]
    return PinholeCamera(pinhole.width_px, pinhole.height_px, matrix, pinhole.distortion + change[FOCAL_AND_CENTRE:])


def cross_matrices(vectors: FloatArray) -> FloatArray:
    """Return the skew-symmetric matrices (N, 3, 3) with [v]× w = v × w."""
    x, y, z = np.moveaxis(vectors, -1, 0)
    crossed = np.zeros((*np.shape(vectors), 3))
    crossed[..., 0, 1], crossed[..., 1, 0] = -z, z
    crossed[..., 0, 2], crossed[..., 2, 0] = y, -y
    crossed[..., 1, 2], crossed[..., 2, 1] = -x, x
    return crossed
