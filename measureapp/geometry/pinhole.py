"""Pinhole camera with Brown-Conrady lens distortion; also the model of projectors."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from measureapp.arrays import FloatArray, read_only

UNDISTORT_ITERATIONS = 40
UNDISTORT_TOLERANCE = 1e-12
MANY = 100  # points from which on NumPy projects faster than OpenCV
RADIAL_AND_TANGENTIAL = 8  # coefficients; those after them are of thin prisms and of a tilted sensor


@dataclass(frozen=True, slots=True, eq=False)
class PinholeCamera:
    """Intrinsic parameters of a camera. Pixel (0, 0) is the centre of the top-left pixel; points are (x, y).

    The distortion coefficients are in OpenCV's order (k1 k2 p1 p2 [k3 [k4 k5 k6 [s1 s2 s3 s4 [τx τy]]]]);
    model: D. C. Brown, Photogrammetric Engineering 37(8), 1971, with OpenCV's extensions.
    """

    width_px: int
    height_px: int
    matrix: FloatArray  # (3, 3)
    distortion: FloatArray  # (4 | 5 | 8 | 12 | 14,)

    def __post_init__(self) -> None:
        object.__setattr__(self, "matrix", read_only(self.matrix, np.float64, (3, 3)))
        object.__setattr__(self, "distortion", read_only(np.ravel(self.distortion), np.float64))

    def project(self, points_mm: FloatArray) -> FloatArray:
        """Project points (N, 3) in the camera's frame to distorted pixels (N, 2)."""
        if len(points_mm) == 0:
            return np.empty((0, 2))
        points = np.ascontiguousarray(points_mm, np.float64)
        if len(points) >= MANY and len(self.distortion) <= RADIAL_AND_TANGENTIAL:
            return self._project_many(points)
        pixels, _ = cv2.projectPoints(
            points.reshape(-1, 1, 3), np.zeros(3), np.zeros(3), np.asarray(self.matrix), np.asarray(self.distortion)
        )
        return np.asarray(pixels, np.float64).reshape(-1, 2)

    def _project_many(self, points_mm: FloatArray) -> FloatArray:
        """Project as OpenCV does, which takes fifteen times as long for thousands of points; behind or beside the camera no warning is due."""
        k1, k2, p1, p2, k3, k4, k5, k6 = (*self.distortion.tolist(), 0.0, 0.0, 0.0, 0.0)[:RADIAL_AND_TANGENTIAL]
        pixels = np.empty((len(points_mm), 2))
        with np.errstate(all="ignore"):
            depth = np.where(points_mm[:, 2] == 0.0, 1.0, points_mm[:, 2])
            x, y = points_mm[:, 0] / depth, points_mm[:, 1] / depth
            xx, yy, xy = x * x, y * y, 2.0 * x * y
            r2 = xx + yy
            radial = 1.0 + r2 * (k1 + r2 * (k2 + r2 * k3))
            if len(self.distortion) == RADIAL_AND_TANGENTIAL:
                radial /= 1.0 + r2 * (k4 + r2 * (k5 + r2 * k6))
            pixels[:, 0] = self.matrix[0, 0] * (x * radial + p1 * xy + p2 * (r2 + 2.0 * xx)) + self.matrix[0, 2]
            pixels[:, 1] = self.matrix[1, 1] * (y * radial + p1 * (r2 + 2.0 * yy) + p2 * xy) + self.matrix[1, 2]
        return pixels

    def project_with_jacobian(self, points_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Project points (N, 3) in the camera's frame to pixels (N, 2), with the Jacobian (N, 2, 3) by the points, px/mm."""
        if len(points_mm) == 0:
            return np.empty((0, 2)), np.empty((0, 2, 3))
        points = np.ascontiguousarray(points_mm, np.float64).reshape(-1, 1, 3)
        matrix, distortion = np.asarray(self.matrix), np.asarray(self.distortion)
        pixels, slopes = cv2.projectPoints(points, np.zeros(3), np.zeros(3), matrix, distortion, jacobian=np.empty(0))
        by_shift = np.asarray(slopes, np.float64).reshape(-1, 2, slopes.shape[1])[:, :, 3:6]
        return np.asarray(pixels, np.float64).reshape(-1, 2), by_shift

    def normalise(self, pixels: FloatArray) -> FloatArray:
        """Undistort pixels (N, 2) to normalised image coordinates (N, 2) on the plane z = 1."""
        if len(pixels) == 0:
            return np.empty((0, 2))
        criteria = (cv2.TERM_CRITERIA_COUNT + cv2.TERM_CRITERIA_EPS, UNDISTORT_ITERATIONS, UNDISTORT_TOLERANCE)
        source = np.ascontiguousarray(pixels, np.float64).reshape(-1, 1, 2)
        undistorted = cv2.undistortPoints(source, np.asarray(self.matrix), np.asarray(self.distortion), criteria=criteria)
        return np.asarray(undistorted, np.float64).reshape(-1, 2)

    def rays(self, pixels: FloatArray) -> FloatArray:
        """Return unit directions (N, 3) in the camera's frame through pixels (N, 2)."""
        flat = self.normalise(pixels)
        rays = np.column_stack([flat, np.ones(len(flat))])
        return rays / np.linalg.norm(rays, axis=1, keepdims=True)
