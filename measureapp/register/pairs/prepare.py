"""Preparation of a cloud for registration: voxel thinning to mean points, border removal, cell index."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cloud import PointCloud
from measureapp.register.grid.cells import CellIndex
from measureapp.register.grid.voxels import VoxelSums

if TYPE_CHECKING:
    from measureapp.register.pairs.kernels import SortedPoints

LEAST_COHERENCE = 0.985  # a shorter mean normal means that the voxel straddles an edge or a thin wall
LEAST_COSINE = 0.26  # viewing angles beyond 75° are too noisy to register by
LEAST_COUNT = 2  # points per voxel
GICP_NEIGHBOURS = 15
CELL_VOXELS = 2.0  # edge of the cells of the neighbour search
BORDER_VOXELS = 2.5  # radius of the neighbourhood for border detection: about 20 neighbours inside a surface
BORDER_LEAST_NEIGHBOURS = 6
BORDER_OFFSET = 0.3  # distance of the neighbours' centroid over their mean distance; about 0.6 at a straight border
SAME_FACE_COSINE = 0.9


@dataclass(frozen=True, slots=True, eq=False)
class PreparedCloud:
    """Thinned points of one view in its camera's frame, sorted by the cells of `index`."""

    points_mm: FloatArray  # (M, 3)
    normals: FloatArray  # (M, 3)
    variance_mm2: FloatArray  # (M,), of the mean point along its viewing ray
    index: CellIndex
    voxel_mm: float

    def __len__(self) -> int:
        return len(self.points_mm)

    @property
    def sorted_points(self) -> SortedPoints:
        """The points with their index, for kernels."""
        return _sorted_points(self.points_mm, self.normals, self.index)

    @property
    def centroid_mm(self) -> FloatArray:
        """The mean of the thinned points, (3,); the origin when there are none."""
        return self.points_mm.mean(axis=0) if len(self) else np.zeros(3)

    @property
    def radius_mm(self) -> float:
        """The rms distance of the thinned points from their centroid, at least 1."""
        return max(1.0, float(np.sqrt(np.mean(np.sum((self.points_mm - self.centroid_mm) ** 2, axis=1))))) if len(self) else 1.0


def prepare(cloud: PointCloud, voxel_mm: float, least_cosine: float = LEAST_COSINE) -> PreparedCloud:
    """Voxel thinning in the camera's frame, without voxels on edges or borders, with single points, or viewed at a grazing angle.

    Parameters
    ----------
    least_cosine : of the viewing angle; -1 keeps all points, as of a cloud that no single camera measured
    """
    from measureapp.register.grid.kernels import facing_rows

    sums = VoxelSums(8)
    sums.add(*facing_rows(cloud.points_mm, cloud.normals, cloud.sigma_mm, voxel_mm, least_cosine))
    _, rows = sums.pop_sorted()
    count = rows[:, 0]
    mean_normal = rows[:, 4:7] / np.maximum(count, 1)[:, None]
    length = np.linalg.norm(mean_normal, axis=1)
    good = (count >= LEAST_COUNT) & (length > LEAST_COHERENCE)
    means = rows[good, 1:4] / count[good, None]
    unit = mean_normal[good] / length[good, None]
    variances = rows[good, 7] / count[good] ** 2
    inner = _find_interior_points(means, unit, voxel_mm)
    index, order = CellIndex.build(means[inner], CELL_VOXELS * voxel_mm)
    chosen = inner[order]
    return PreparedCloud(means[chosen], unit[chosen], variances[chosen], index, voxel_mm)


def _find_interior_points(points_mm: FloatArray, normals: FloatArray, voxel_mm: float) -> IntArray:
    """Return the indices of points with neighbours of their own face on all sides.

    At occlusion edges a pixel mixes foreground and background, which displaces the border of a face in one direction.
    """
    from measureapp.register.pairs.kernels import find_interior

    cells, order = CellIndex.build(points_mm, BORDER_VOXELS * voxel_mm)
    sorted_points = _sorted_points(points_mm[order], normals[order], cells)
    inner = find_interior(sorted_points, BORDER_LEAST_NEIGHBOURS, SAME_FACE_COSINE, BORDER_OFFSET)
    return np.asarray(order[inner])


def _sorted_points(points_mm: FloatArray, normals: FloatArray, index: CellIndex) -> SortedPoints:
    from measureapp.register.pairs.kernels import SortedPoints

    return SortedPoints(points_mm, normals, index.edge_mm, index.keys, index.starts, index.table)


def occupied_cells(prepared: PreparedCloud, points_mm: FloatArray, normals: FloatArray, cell_mm: float) -> IntArray:
    """Return the sorted keys (face and cell) of the cells that contain placed points."""
    from measureapp.register.grid.kernels import dominant_faces, voxel_keys

    if len(prepared) == 0:
        return np.empty(0, np.int64)
    return np.unique(voxel_keys(np.ascontiguousarray(points_mm), dominant_faces(np.ascontiguousarray(normals)), cell_mm))
