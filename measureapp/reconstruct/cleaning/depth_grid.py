"""Depth map of a camera during cleaning, and the viewing rays of its pixels."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, read_only
from measureapp.reconstruct.kernels.structures import Surface
from measureapp.reconstruct.rectification.jacobian import PixelJacobian


@dataclass(frozen=True, slots=True, eq=False)
class Lens:
    """Viewing rays of a camera."""

    rays: FloatArray  # (H, W, 2) float32, normalised image coordinates
    jacobian: PixelJacobian
    spacing: float  # distance of neighbouring pixels in normalised coordinates

    @property
    def flat_rays(self) -> FloatArray:
        """The rays as rows of numbers (H, 2 W), read-only."""
        return np.asarray(read_only(self.rays.reshape(len(self.rays), -1)))


@dataclass(frozen=True, slots=True, eq=False)
class DepthGrid:
    """A depth map with the points that were not rejected, and the other cameras that take part in each."""

    depth_mm: FloatArray  # (H, W) float32
    sigma_mm: FloatArray  # (H, W) float32
    others: IntArray  # (H, W) uint8
    state: IntArray  # (H, W) uint8 of PointState
    lens: Lens
    inverse: FloatArray  # (H + 2r, W + 2r) float32, inverse depth of the points left, with a border of zeros
    radius_px: int  # r
    step_per_px: np.float32  # largest depth step between neighbours of one surface, relative to the depth
    normals: FloatArray  # (3, H, W) float32, in the camera's frame, towards it
    per_row: IntArray  # (H,) int64, how many points are left in every row

    @property
    def surface(self) -> Surface:
        """The arrays that kernels read."""
        jacobian = self.lens.jacobian
        rays, step = self.lens.flat_rays, self.step_per_px
        return Surface(self.inverse, self.sigma_mm, rays, jacobian.cubics, jacobian.unit, step, self.radius_px)
