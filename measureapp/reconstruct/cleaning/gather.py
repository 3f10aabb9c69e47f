"""Points of a clean depth map, written into the arrays of a cloud."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.reconstruct import kernels
from measureapp.reconstruct.cleaning.depth_grid import DepthGrid
from measureapp.reconstruct.kernels.gather import CloudArrays


@dataclass(frozen=True, slots=True, eq=False)
class Grey:
    """Grey levels of a camera."""

    levels: FloatArray | IntArray  # (H, W)
    saturation: float  # the level that becomes 1


def make_cloud_arrays(count: int, memory: BufferPool) -> CloudArrays:
    """Allocate the arrays of a cloud."""
    return CloudArrays(
        memory.empty((count, 3), np.float64),
        memory.empty((count, 3), np.float32),
        memory.empty(count, np.float32),
        memory.empty(count, np.float32),
        memory.empty((count, 2), np.int32),
        memory.empty(count, np.uint8),
    )


def gather(grid: DepthGrid, first: int, grey: Grey, bits: tuple[int, ...], reference_from_camera: FloatArray, cloud: CloudArrays) -> None:
    """Write the points of a depth map into a cloud, from index ``first`` on.

    Parameters
    ----------
    bits : of this camera and of the others, for `PointCloud.cameras`
    reference_from_camera : (4, 4)
    """
    starts = first + np.cumsum(grid.per_row) - grid.per_row
    pose = np.ascontiguousarray(reference_from_camera[:3], np.float64)
    masks = np.array(
        [bits[0] + sum(bit for place, bit in enumerate(bits[1:]) if k >> place & 1) for k in range(2 ** len(bits[1:]))], np.uint8
    )
    maps = (grid.inverse, grid.depth_mm, grid.sigma_mm, grid.lens.flat_rays, grid.normals)
    levels, per_level = read_only(grey.levels, np.uint16), np.float32(1 / grey.saturation)
    in_bands(
        lambda start, stop: kernels.gather_points(*maps, levels, per_level, grid.others, masks, pose, starts, start, stop, cloud),
        len(starts),
    )


def gather_normals(grid: DepthGrid, partners: int) -> tuple[IntArray, FloatArray]:
    """Return the pixels (N, 2) and normals (N, 3) of the points left of a depth map with this many other cameras."""
    cloud = make_cloud_arrays(int(grid.per_row.sum()), BufferPool())
    gather(grid, 0, Grey(grid.depth_mm, 1.0), (1,) * (1 + partners), np.eye(4), cloud)  # which cameras see a point is not asked here
    return cloud.pixel, cloud.normals
