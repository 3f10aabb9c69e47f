"""What is prepared for a cloud after its first picture: a locator for picks, and subsamples for a moving picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ui.viewport.shuffled_cloud import ShuffledCloud
from ui.viewport.voxel_grid import Level, VoxelGrid

LEVEL_POINTS = 600_000  # of the random order; enough for even subsamples


@dataclass(frozen=True, eq=False)
class PointIndex:
    """Locator and subsamples of one shuffled cloud."""

    cloud: ShuffledCloud
    grid: VoxelGrid
    levels: tuple[Level, ...]


def index_points(cloud: ShuffledCloud, check: Callable[[], None] = lambda: None) -> PointIndex:
    """Prepare a cloud; slow for millions of points, so it belongs on a thread. ``check`` raises to cancel."""
    few = VoxelGrid.of(cloud.points_mm[:LEVEL_POINTS])
    check()
    levels = few.levels(cloud.colours[:LEVEL_POINTS])
    check()
    return PointIndex(cloud, few if len(cloud) <= LEVEL_POINTS else VoxelGrid.of(cloud.points_mm), levels)


def nearest_point(
    cloud: ShuffledCloud, index: PointIndex | None, place_mm: np.ndarray, keep: np.ndarray | None
) -> tuple[int, float] | None:
    """Return position in the cloud and distance of the point nearest to a place (3,); without an index all points are searched."""
    if index is not None and index.cloud is cloud:
        return index.grid.nearest(place_mm, keep)
    best: tuple[int, float] | None = None
    for start in range(0, len(cloud), LEVEL_POINTS):
        points = cloud.points_mm[start : start + LEVEL_POINTS]
        gap = points - np.asarray(place_mm, np.float32)
        squares = np.einsum("nd,nd->n", gap, gap)
        if keep is not None:
            squares = np.where(((points >= keep[0]) & (points <= keep[1])).all(axis=1), squares, np.inf)
        chosen = int(np.argmin(squares))
        distance = float(np.sqrt(squares[chosen]))
        if np.isfinite(distance) and (best is None or distance < best[1]):
            best = start + chosen, distance
    return best
