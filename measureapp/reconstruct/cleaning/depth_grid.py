"""A depth map as the kernels of cleaning know it, and the viewing rays of its camera."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, read_only
from measureapp.reconstruct.rectification.cubics import PixelSteps


@dataclass(frozen=True, slots=True, eq=False)
class Lens:
    """The viewing rays of a camera as the kernels want them."""

    rays: FloatArray  # (H, W, 2) float32, normalised image coordinates
    steps: PixelSteps  # how they change from pixel to pixel
    spacing: float  # distance of neighbouring pixels in normalised coordinates

    @property
    def flat_rays(self) -> FloatArray:
        """The same rays as rows of numbers (H, 2 W), read-only, as kernels know them."""
        return np.asarray(read_only(self.rays.reshape(len(self.rays), -1)))


@dataclass(frozen=True, slots=True, eq=False)
class DepthGrid:
    """A depth map with the points that were not rejected, and the other cameras that take part in each."""

    depth_mm: FloatArray  # (H, W) float32
    sigma_mm: FloatArray  # (H, W) float32
    others: IntArray  # (H, W) uint8
    fate: IntArray  # (H, W) uint8 of PointState
    lens: Lens
    inverse: FloatArray  # (H + 2r, W + 2r) float32, inverse depth of the points left, with a border of zeros
    border: int  # r
    per_px: np.float32  # largest depth step between neighbours of one surface, as a share of the depth
    normals: FloatArray  # (3, H, W) float32, by all points that were judged
    removed: IntArray  # (H, chunks) uint8, 1 where points of a chunk of a row were removed since
    per_row: IntArray  # (H,) int64, how many points are left in every row
