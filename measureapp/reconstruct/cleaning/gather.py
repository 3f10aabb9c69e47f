"""The points of a clean depth map, written into the arrays of a cloud."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.reconstruct import kernels
from measureapp.reconstruct.cleaning.depth_grid import DepthGrid


@dataclass(frozen=True, slots=True, eq=False)
class PointArrays:
    """The arrays of a cloud, to be filled."""

    points_mm: FloatArray  # (N, 3) float64
    normals: FloatArray  # (N, 3) float32
    sigma_mm: FloatArray  # (N,) float32
    grey: FloatArray  # (N,) float32
    pixel: IntArray  # (N, 2) int32
    cameras: IntArray  # (N,) uint8

    @classmethod
    def of(cls, count: int, memory: BufferPool) -> PointArrays:
        """Make room for points."""
        return cls(
            memory.empty((count, 3), np.float64),
            memory.empty((count, 3), np.float32),
            memory.empty(count, np.float32),
            memory.empty(count, np.float32),
            memory.empty((count, 2), np.int32),
            memory.empty(count, np.uint8),
        )


def gather(
    grid: DepthGrid,
    first: int,
    grey: FloatArray | IntArray,
    saturation: float,
    bits: tuple[int, ...],
    reference_from_camera: FloatArray,
    out: PointArrays,
) -> None:
    """Write the points of a depth map into a cloud, from index ``first`` on.

    Parameters
    ----------
    grey, saturation : grey levels of the image, and the one that becomes 1
    bits : of this camera and of the others, for `PointCloud.cameras`
    reference_from_camera : (4, 4)
    """
    begins = first + np.cumsum(grid.per_row) - grid.per_row
    steps = grid.lens.steps
    pose = np.ascontiguousarray(reference_from_camera[:3], np.float64)
    masks = np.array(
        [bits[0] + sum(bit for place, bit in enumerate(bits[1:]) if k >> place & 1) for k in range(2 ** len(bits[1:]))], np.uint8
    )
    written = kernels.Points(out.points_mm.reshape(-1), out.normals.reshape(-1), out.sigma_mm, out.grey, out.pixel.reshape(-1), out.cameras)
    rays = grid.lens.flat_rays
    levels = read_only(grey, np.uint16)
    in_bands(
        lambda start, stop: kernels.gather_points(
            grid.inverse,
            grid.depth_mm,
            grid.sigma_mm,
            rays,
            steps.cubics,
            steps.unit,
            grid.per_px,
            grid.border,
            grid.normals,
            grid.removed,
            levels,
            np.float32(1 / saturation),
            grid.others,
            masks,
            pose,
            begins,
            start,
            stop,
            written,
        ),
        len(begins),
    )


def gathered_normals(grid: DepthGrid) -> tuple[IntArray, FloatArray]:
    """Return the pixels (N, 2) and normals (N, 3) of the points left."""
    out = PointArrays.of(int(grid.per_row.sum()), BufferPool())
    gather(grid, 0, grid.depth_mm, 1.0, (1,), np.eye(4), out)
    return out.pixel, out.normals
