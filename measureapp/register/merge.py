"""Merging of overlapping views: weighted means of points that lie together and face the same way."""

from __future__ import annotations

import os
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.cloud import PointCloud
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import NoProgress, Progress
from measureapp.register.clouds.filters import in_large_components
from measureapp.register.grid.voxels import CHUNK, VoxelSums

# columns of the sums of one voxel
WEIGHT, POSITION, NORMAL, GREY, NOISE, ALONG = 0, slice(1, 4), slice(4, 7), 7, 8, 9
WIDTH = 10
GRAZING = 0.15  # lower limit of the cosine in a point's weight
LEAST_SIGMA_MM = 0.005
LAYER_GAP = 1.5  # in voxels: layers of one face closer than this along its axis are one surface
SPARSE_FACTOR = 3.0
MOST_AT_ONCE = 4  # clouds
QUERIED_AT_ONCE = 200_000  # points whose neighbours are in memory
GOLDEN = (5**0.5 - 1) / 2


@dataclass(frozen=True, slots=True, eq=False)
class MergedPoints:
    """Result of merging; the arrays are those of a StitchedCloud."""

    points_mm: FloatArray
    normals: FloatArray
    sigma_mm: FloatArray
    grey: FloatArray
    view: IntArray
    sampled_view: IntArray

    def where(self, keep: BoolArray) -> MergedPoints:
        """Return the points chosen by a mask."""
        return MergedPoints(
            self.points_mm[keep], self.normals[keep], self.sigma_mm[keep], self.grey[keep], self.view[keep], self.sampled_view[keep]
        )


def merge(
    clouds: Sequence[PointCloud],
    origins_mm: Sequence[FloatArray],
    voxel_mm: float,
    *,
    poses: Sequence[RigidTransform] | None = None,
    views: Sequence[int] | None = None,
    island_mm2: float = 0.0,
    progress: Progress | None = None,
) -> MergedPoints:
    """Merge clouds in one frame on a voxel grid; points of surfaces facing different ways are never averaged.

    Points are collected in columns of the grid along the largest component of their normals, so that noise normal to the surface is
    averaged over the whole layer and not cut by the grid. The weight of a point is cos²(viewing angle)/σ². Sparse points and isolated
    patches are removed.

    Parameters
    ----------
    origins_mm : camera position of each cloud, in the frame in which they are merged
    voxel_mm : grid step; about the point spacing, far below the thinnest wall
    poses : of clouds that are in frames of their own: they are placed when it is their turn, which saves the memory of all of them
    views : number of each cloud in ``view``; None: 0, 1, 2 …
    island_mm2 : isolated patches smaller than this are removed
    """
    progress = progress or NoProgress()
    numbers = list(views) if views is not None else list(range(len(clouds)))
    places: Sequence[RigidTransform | None] = poses or [None] * len(clouds)
    summed = _sum_clouds(list(zip(clouds, places, origins_mm, strict=True)), voxel_mm, progress)
    progress.check()
    merged = _merge_layers(summed, numbers, voxel_mm)
    progress.check()
    merged = merged.where(_not_sparse(merged.points_mm, progress)) if len(merged.points_mm) > 10 else merged
    progress.check()
    merged = merged.where(in_large_components(merged.points_mm, voxel_mm, island_mm2)) if island_mm2 > 0 else merged
    progress.report(1, 1, "merged")
    return merged


@dataclass(slots=True, eq=False)
class _Summed:
    """All clouds in voxels; its arrays are given up one by one, as soon as they are no longer needed."""

    keys: IntArray  # (V,), ascending
    rows: FloatArray  # (V, WIDTH)
    parts: list[tuple[IntArray, FloatArray]]  # of every cloud, its keys and the weight of each


def _sum_clouds(placed: Sequence[tuple[PointCloud, RigidTransform | None, FloatArray]], voxel_mm: float, progress: Progress) -> _Summed:
    sums = VoxelSums(WIDTH)
    parts: list[tuple[IntArray, FloatArray]] = []
    at_once = min(os.cpu_count() or 1, MOST_AT_ONCE)  # limits the memory for sums waiting to be added
    with ThreadPoolExecutor(at_once) as pool:
        for start in range(0, len(placed), at_once):
            progress.report(start, len(placed), "merging")
            for keys, rows in pool.map(lambda one: _sum_cloud(one[0], one[1], one[2], voxel_mm), placed[start : start + at_once]):
                sums.add(keys, rows)
                parts.append((keys, rows[:, WEIGHT].astype(np.float32)))
    return _Summed(*sums.pop_sorted(), parts)


def _sum_cloud(cloud: PointCloud, pose: RigidTransform | None, origin_mm: FloatArray, voxel_mm: float) -> tuple[IntArray, FloatArray]:
    """Return the sorted voxel keys of one cloud, at its place, and the sums of their rows."""
    single = VoxelSums(WIDTH)
    for start in range(0, len(cloud), CHUNK):  # a row is larger than a point
        part = cloud.where(slice(start, start + CHUNK))
        single.add(*_weight_points(part if pose is None else part.seen_from(pose), np.asarray(origin_mm), voxel_mm))
    cloud.give_up_pages()
    return single.pop_sorted()


def _weight_points(cloud: PointCloud, origin_mm: FloatArray, voxel_mm: float) -> tuple[IntArray, FloatArray]:
    """Return the voxel key and the row to be summed of every point."""
    from measureapp.register.grid.kernels import dominant_faces, voxel_keys

    points, normals = np.asarray(cloud.points_mm), np.asarray(cloud.normals)
    ray = points - origin_mm
    cosine = np.abs(np.einsum("ij,ij->i", normals, ray)) / np.maximum(np.linalg.norm(ray, axis=1), 1e-9)
    sigma = np.maximum(cloud.sigma_mm, LEAST_SIGMA_MM).astype(np.float64)
    weight = np.maximum(cosine, GRAZING) ** 2 / sigma**2
    rows = np.empty((len(points), WIDTH))
    rows[:, WEIGHT] = weight
    rows[:, POSITION] = points * weight[:, None]
    rows[:, NORMAL] = normals * weight[:, None]
    rows[:, GREY] = cloud.grey * weight
    rows[:, NOISE] = (weight * sigma) ** 2
    rows[:, ALONG] = np.einsum("ij,ij->i", normals, points) * weight
    return voxel_keys(points, dominant_faces(normals), voxel_mm), rows


def _dominant_views(keys: IntArray, parts: list[tuple[IntArray, FloatArray]], numbers: list[int]) -> IntArray:
    """Return the view of greatest weight for every key; for equal weights the lower number."""
    best = np.full(len(keys), -1.0, np.float32)
    view = np.zeros(len(keys), np.int16)
    for number, (own, weight) in sorted(zip(numbers, parts, strict=True), key=lambda pair: pair[0]):
        place = np.searchsorted(keys, own)
        more = weight > best[place]
        best[place[more]] = weight[more]
        view[place[more]] = number
    return view


def _sample_views(
    keys: IntArray, group: IntArray, weight: FloatArray, parts: list[tuple[IntArray, FloatArray]], numbers: list[int]
) -> IntArray:
    """Sample one view per group of keys, of ``weight`` (G,), with probability proportional to the view's weight.

    A low-discrepancy sequence (multiples of the golden ratio) replaces random numbers, so that the frequencies match already over few
    neighbouring points.
    """
    wanted, below = np.arange(len(weight)) * GOLDEN % 1.0 * weight, np.zeros(len(weight))
    view = np.full(len(weight), numbers[0], np.int16)
    for number, (own, part) in zip(numbers, parts, strict=True):
        added = np.bincount(group[np.searchsorted(keys, own)], part, len(weight))
        view[(added > 0) & (below <= wanted)] = number
        below += added
    return view


def _merge_layers(summed: _Summed, numbers: list[int], voxel_mm: float) -> MergedPoints:
    """Merge voxels of one column and face that hold the same surface; what was summed is given up on the way."""
    keys, rows = summed.keys, summed.rows
    if len(keys) == 0:
        none = np.empty(0, np.int16)
        return MergedPoints(np.empty((0, 3)), np.empty((0, 3)), np.empty(0), np.empty(0), none, none)
    axis = keys >> 61
    depth = np.take_along_axis(rows[:, POSITION], axis[:, None], axis=1)[:, 0] / rows[:, WEIGHT]
    begins = np.ones(len(keys), np.bool_)
    begins[1:] = ((keys[1:] >> 20) != (keys[:-1] >> 20)) | (np.abs(np.diff(depth)) > LAYER_GAP * voxel_mm)
    del axis, depth
    first = np.flatnonzero(begins)
    heaviest = _heaviest(rows[:, WEIGHT], first)
    total = rows[: len(first)]
    for column in range(WIDTH):  # in the place of what is added up
        total[:, column] = np.add.reduceat(rows[:, column], first)
    view = _dominant_views(keys, summed.parts, numbers)[heaviest]
    weight = total[:, WEIGHT]
    sampled = _sample_views(keys, np.cumsum(begins, dtype=np.int32) - 1, weight, summed.parts, numbers)
    del keys, begins, first, heaviest
    summed.keys, summed.rows, summed.parts = np.empty(0, np.int64), np.empty((0, WIDTH)), []
    mean = total[:, POSITION] / weight[:, None]
    normals = total[:, NORMAL]
    # the mean of points on a curved surface lies inside it, by half their mean offset from it along their own normals
    inside = 0.5 * (total[:, ALONG] - np.einsum("ij,ij->i", normals, mean)) / weight
    normals = normals / np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), 1e-30)
    return MergedPoints(
        mean + inside[:, None] * normals,
        normals.astype(np.float32),
        (np.sqrt(total[:, NOISE]) / weight).astype(np.float32),
        np.clip(total[:, GREY] / weight, 0, 1).astype(np.float32),
        view,
        sampled,
    )


def _heaviest(weight: FloatArray, first: IntArray) -> IntArray:
    """Return the row (G,) of largest weight in each group of rows, which begin at ``first`` (G,); of equal ones the last."""
    most = np.repeat(np.maximum.reduceat(weight, first), np.diff(np.append(first, len(weight))))
    rows = np.where(weight == most, np.arange(len(weight)), -1)
    return np.asarray(np.maximum.reduceat(rows, first))


def _not_sparse(points_mm: FloatArray, progress: Progress) -> BoolArray:
    """Return which points have a mean neighbour distance of at most three times the median."""
    tree, mean = cKDTree(points_mm, copy_data=False), np.empty(len(points_mm))
    for start in range(0, len(points_mm), QUERIED_AT_ONCE):
        progress.check()
        part = slice(start, start + QUERIED_AT_ONCE)
        distances, _ = tree.query(points_mm[part], 7, workers=-1)
        mean[part] = distances[:, 1:].mean(axis=1)
    return np.asarray(mean <= SPARSE_FACTOR * np.median(mean))
