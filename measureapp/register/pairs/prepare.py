"""A cloud made ready for registration: thinned to one mean point per voxel, sorted into cells."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import PointCloud
from measureapp.register.grid.cells import CellIndex
from measureapp.register.grid.voxels import VoxelSums

LEAST_COHERENCE = 0.985  # length of the mean normal below which a voxel straddles an edge or a thin wall
LEAST_COSINE = 0.26  # viewing angles beyond 75° are too noisy to register by
LEAST_COUNT = 2  # points per voxel
GICP_NEIGHBOURS = 15
CELL_VOXELS = 2.0  # edge of the cells in which neighbours are searched
RIM_VOXELS = 2.5  # neighbours within this tell a rim: about 20 on a closed surface
RIM_LEAST = 6  # of them at least
RIM_OFFSET = 0.3  # distance of the neighbours' centre over their mean distance; about 0.6 at a straight border
SAME_FACE_COSINE = 0.9


@dataclass(frozen=True, slots=True, eq=False)
class PreparedCloud:
    """Thinned points of one view in its camera's frame, sorted by the cells of `index`."""

    points_mm: FloatArray  # (M, 3)
    normals: FloatArray  # (M, 3)
    variance_mm2: FloatArray  # (M,), of the mean point along its ray
    index: CellIndex
    voxel_mm: float

    def __len__(self) -> int:
        return len(self.points_mm)

    @property
    def centroid_mm(self) -> FloatArray:
        """The mean of the thinned points, (3,); the origin when there are none."""
        return self.points_mm.mean(axis=0) if len(self) else np.zeros(3)

    @property
    def radius_mm(self) -> float:
        """The rms distance of the thinned points from their centroid, at least 1."""
        return max(1.0, float(np.sqrt(np.mean(np.sum((self.points_mm - self.centroid_mm) ** 2, axis=1))))) if len(self) else 1.0


def prepare(cloud: PointCloud, voxel_mm: float) -> PreparedCloud:
    """Thin a cloud in its camera's frame; voxels over edges, with single points or seen at a grazing angle are left out."""
    from measureapp.register.grid.kernels import facing_rows

    sums = VoxelSums(8)
    sums.add(*facing_rows(cloud.points_mm, cloud.normals, cloud.sigma_mm, voxel_mm, LEAST_COSINE))
    _, rows = sums.sorted()
    count = rows[:, 0]
    mean_normal = rows[:, 4:7] / np.maximum(count, 1)[:, None]
    length = np.linalg.norm(mean_normal, axis=1)
    good = (count >= LEAST_COUNT) & (length > LEAST_COHERENCE)
    means = rows[good, 1:4] / count[good, None]
    unit = mean_normal[good] / length[good, None]
    variances = rows[good, 7] / count[good] ** 2
    inner = _without_rims(means, unit, voxel_mm)
    index, order = CellIndex.sorting(means[inner], CELL_VOXELS * voxel_mm)
    chosen = inner[order]
    return PreparedCloud(means[chosen], unit[chosen], variances[chosen], index, voxel_mm)


def _without_rims(points_mm: FloatArray, normals: FloatArray, voxel_mm: float) -> IntArray:
    """Return the points that have neighbours of their own face on all sides.

    At the border of a face pixels mix it with what lies behind, so that its rim is displaced, and in one direction.
    """
    from measureapp.register.pairs.kernels import surrounded

    cells, order = CellIndex.sorting(points_mm, RIM_VOXELS * voxel_mm)
    inner = surrounded(
        points_mm[order], normals[order], cells.edge_mm, cells.keys, cells.starts, cells.table, RIM_LEAST, SAME_FACE_COSINE, RIM_OFFSET
    )
    return np.asarray(order[inner])


def occupied_cells(prepared: PreparedCloud, points_mm: FloatArray, normals: FloatArray, cell_mm: float) -> IntArray:
    """Return the sorted keys of the cells (with the way the surface faces) that placed points lie in."""
    from measureapp.register.grid.kernels import dominant_faces, voxel_keys

    if len(prepared) == 0:
        return np.empty(0, np.int64)
    return np.unique(voxel_keys(np.ascontiguousarray(points_mm), dominant_faces(np.ascontiguousarray(normals)), cell_mm))
