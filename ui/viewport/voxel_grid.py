"""Points sorted into cubes: a locator that finds the nearest point at once, and even subsamples for a moving picture."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import product

import numpy as np

FINEST_CELLS = 600.0  # along the diagonal of the points
CROWDED = 4.0  # points of a cube, on average, from which on a subsample is even
LEAST_LEVEL, LARGEST_LEVEL = 12_000, 400_000
CHUNK = 1_000_000
RINGS = 6  # cubes around that of the place asked for, until all points are searched


@dataclass(frozen=True, eq=False)
class Level:
    """One point per cube, at the mean place and in the mean colour of its points."""

    points_mm: np.ndarray  # (L, 3) float32
    colours: np.ndarray  # (L, 3) uint8
    cell_mm: float  # edge of the cubes


@dataclass(frozen=True, eq=False)
class VoxelGrid:
    """Points in the order of their cubes."""

    points_mm: np.ndarray  # (N, 3) float32
    low_mm: np.ndarray  # (3,)
    cell_mm: float
    shape: np.ndarray  # (3,) int64
    order: np.ndarray  # (N,) int32, indices of the points, cube by cube
    keys: np.ndarray  # (N,) int64, ascending: cube of each point of `order`

    @classmethod
    def of(cls, points_mm: np.ndarray, cell_mm: float | None = None) -> VoxelGrid:
        """Sort points (N, 3) into cubes; without an edge, into 600 along their diagonal. Sorting runs without the interpreter's lock."""
        points = np.asarray(points_mm, np.float32)
        low = points.min(axis=0).astype(float) if len(points) else np.zeros(3)
        high = points.max(axis=0).astype(float) if len(points) else np.ones(3)
        edge = cell_mm or max(float(np.linalg.norm(high - low)) / FINEST_CELLS, 1e-6)
        shape = np.floor((high - low) / edge).astype(np.int64) + 1
        keys = _keys(points, low, edge, shape)
        order = np.argsort(keys).astype(np.int32)
        return cls(points, low, edge, shape, order, keys[order])

    def nearest(self, place_mm: np.ndarray, keep: np.ndarray | None = None) -> tuple[int, float] | None:
        """Return index and distance of the point nearest to a place (3,); ``keep`` (2, 3): corners of a box that it must be in."""
        if not len(self.points_mm):
            return None
        cell = np.floor((np.asarray(place_mm, float) - self.low_mm) / self.cell_mm).astype(np.int64)
        found: tuple[int, float] | None = None
        for ring in range(RINGS + 1):
            if found is not None and found[1] <= (ring - 1) * self.cell_mm:  # nothing nearer can follow
                return found
            found = self._nearer(found, self._in_ring(cell, ring), place_mm, keep)
        return found if found is not None and found[1] <= RINGS * self.cell_mm else self._nearer(None, None, place_mm, keep)

    def _in_ring(self, cell: np.ndarray, ring: int) -> np.ndarray:
        """Return the indices of the points in the cubes at this distance of a cube."""
        steps = list(product(range(-ring, ring + 1), repeat=2))
        cubes = [(x, y, z) for x, y in steps for z in (range(-ring, ring + 1) if max(abs(x), abs(y)) == ring else {-ring, ring})]
        around = cell + np.array(cubes)
        around = around[((around >= 0) & (around < self.shape)).all(axis=1)]
        keys = (around[:, 0] * self.shape[1] + around[:, 1]) * self.shape[2] + around[:, 2]
        starts, ends = np.searchsorted(self.keys, keys, "left"), np.searchsorted(self.keys, keys, "right")
        parts = [self.order[start:end] for start, end in zip(starts, ends, strict=True) if end > start]
        return np.concatenate(parts) if parts else np.empty(0, np.int32)

    def _nearer(
        self, found: tuple[int, float] | None, indices: np.ndarray | None, place_mm: np.ndarray, keep: np.ndarray | None
    ) -> tuple[int, float] | None:
        points = self.points_mm if indices is None else self.points_mm[indices]
        if not len(points):
            return found
        gap = points - np.asarray(place_mm, np.float32)
        squares = np.einsum("nd,nd->n", gap, gap)
        if keep is not None:
            squares = np.where(((points >= keep[0]) & (points <= keep[1])).all(axis=1), squares, np.inf)
        best = int(np.argmin(squares))
        distance = float(np.sqrt(squares[best]))
        if not np.isfinite(distance) or (found is not None and found[1] <= distance):
            return found
        return (best if indices is None else int(indices[best])), distance

    def levels(self, colours: np.ndarray) -> tuple[Level, ...]:
        """Return even subsamples, the finest first; none where the points are too sparse for any."""
        made: list[Level] = []
        points, tints, keys, cell = self.points_mm[self.order], colours[self.order], self.keys, self.cell_mm
        weights = np.ones(len(points), np.float32)
        total = len(points)
        while len(points):
            starts = np.flatnonzero(np.concatenate([[True], keys[1:] != keys[:-1]]))
            sums = np.add.reduceat(weights, starts)
            means = np.add.reduceat(points * weights[:, None], starts, axis=0) / sums[:, None]
            shades = np.add.reduceat(tints * weights[:, None], starts, axis=0) / sums[:, None]
            if len(starts) <= LARGEST_LEVEL and total / len(starts) >= CROWDED:
                made.append(Level(means.astype(np.float32), np.rint(shades).astype(np.uint8), cell))
            if len(starts) <= LEAST_LEVEL:
                break
            cell *= 2.0
            shape = self.shape // 2 + 1
            keys = _keys(means, self.low_mm, cell, shape)
            order = np.argsort(keys)
            points, tints, weights, keys = means[order].astype(np.float32), shades[order].astype(np.float32), sums[order], keys[order]
        return tuple(made)


def _keys(points: np.ndarray, low: np.ndarray, edge: float, shape: np.ndarray) -> np.ndarray:
    """Return the number of the cube of each point."""
    keys = np.empty(len(points), np.int64)
    for start in range(0, len(points), CHUNK):
        part = slice(start, start + CHUNK)
        cells = np.floor((points[part] - low) / edge).astype(np.int64)
        cells = np.clip(cells, 0, None)
        keys[part] = (cells[:, 0] * shape[1] + cells[:, 1]) * shape[2] + cells[:, 2]
    return keys
