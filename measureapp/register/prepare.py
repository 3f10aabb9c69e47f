"""A cloud made ready for registration: thinned to one mean point per voxel, with search trees."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.cloud import PointCloud
from measureapp.register.voxels import VoxelSums

LEAST_COHERENCE = 0.985  # length of the mean normal below which a voxel straddles an edge or a thin wall
LEAST_COSINE = 0.26  # viewing angles beyond 75° are too noisy to register by
LEAST_COUNT = 2  # points per voxel
GICP_NEIGHBOURS = 15
RIM_NEIGHBOURS = 20
RIM_OFFSET = 0.3  # distance of the neighbours' centre over their mean distance; about 0.6 at a straight border
SAME_FACE_COSINE = 0.9


@dataclass(frozen=True, slots=True, eq=False)
class PreparedCloud:
    """Thinned points of one view in its camera's frame."""

    points_mm: FloatArray  # (M, 3)
    normals: FloatArray  # (M, 3)
    variance_mm2: FloatArray  # (M,), of the mean point along its ray
    tree: Any  # scipy's cKDTree of the points
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
    from measureapp.register.kernels import voxel_keys

    points, normals = np.asarray(cloud.points_mm), np.asarray(cloud.normals)
    cosine = np.abs(np.einsum("ij,ij->i", normals, points)) / np.maximum(np.linalg.norm(points, axis=1), 1e-9)
    facing = cosine > LEAST_COSINE
    points, normals = np.ascontiguousarray(points[facing]), normals[facing]
    sums = VoxelSums(8)
    keys = voxel_keys(points, np.zeros(len(points), np.uint8), voxel_mm)
    variance = np.asarray(cloud.sigma_mm, np.float64)[facing] ** 2
    sums.add(keys, np.column_stack([np.ones(len(points)), points, normals, variance]))
    _, rows = sums.sorted()
    count = rows[:, 0]
    mean_normal = rows[:, 4:7] / np.maximum(count, 1)[:, None]
    length = np.linalg.norm(mean_normal, axis=1)
    good = (count >= LEAST_COUNT) & (length > LEAST_COHERENCE)
    means = rows[good, 1:4] / count[good, None]
    unit = mean_normal[good] / length[good, None]
    variances = rows[good, 7] / count[good] ** 2
    inner = _surrounded(means, unit)
    means, unit, variances = means[inner], unit[inner], variances[inner]
    return PreparedCloud(means, unit, variances, cKDTree(means) if len(means) else None, voxel_mm)


def _surrounded(points_mm: FloatArray, normals: FloatArray) -> BoolArray:
    """Return which points have neighbours of their own face on all sides.

    At the border of a face pixels mix it with what lies behind, so that its rim is displaced, and in one direction.
    """
    if len(points_mm) <= RIM_NEIGHBOURS:
        return np.ones(len(points_mm), np.bool_)
    distance, index = cKDTree(points_mm).query(points_mm, RIM_NEIGHBOURS + 1, workers=-1)
    same = np.einsum("ik,ijk->ij", normals, normals[index[:, 1:]]) > SAME_FACE_COSINE
    offset = np.einsum("ij,ijk->ik", same, points_mm[index[:, 1:]] - points_mm[:, None])
    reach = np.sum(distance[:, 1:], axis=1)
    return np.asarray((same.sum(axis=1) >= RIM_NEIGHBOURS / 2) & (np.linalg.norm(offset, axis=1) < RIM_OFFSET * reach))


def occupied_cells(prepared: PreparedCloud, points_mm: FloatArray, normals: FloatArray, cell_mm: float) -> IntArray:
    """Return the sorted keys of the cells (with the way the surface faces) that placed points lie in."""
    from measureapp.register.kernels import dominant_faces, voxel_keys

    if len(prepared) == 0:
        return np.empty(0, np.int64)
    return np.unique(voxel_keys(np.ascontiguousarray(points_mm), dominant_faces(np.ascontiguousarray(normals)), cell_mm))
