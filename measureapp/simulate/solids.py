"""Closed triangle surfaces composed of walls and flat faces with shared border vertices."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise
from math import asin, ceil, sqrt

import numpy as np
from scipy.spatial import Delaunay

from measureapp.arrays import BoolArray, FloatArray, IntArray

CHORD_ERROR_MM = 0.00005  # sagitta of the chords of round walls
MEAN_SAGITTA = 2 / 3  # mean distance of a chord from its arc, relative to the sagitta
MERGE_DECIMALS = 6  # corners closer than a nanometre are one corner


def segments(radius_mm: float, angle_rad: float, chord_error_mm: float = CHORD_ERROR_MM) -> int:
    """Return the number of equal chords that keeps the sagitta of an arc within ``chord_error_mm``."""
    step = 4.0 * asin(sqrt(chord_error_mm / (2.0 * radius_mm)))
    return max(1, ceil(abs(angle_rad) / step))


def arc(radius_mm: float, start_rad: float, end_rad: float, centre: tuple[float, float] = (0.0, 0.0), count: int = 0) -> FloatArray:
    """Return the corners (n + 1, 2) of an arc of ``count`` chords (0: from the chord error), both ends included.

    The chords are on the arc on average, their corners outside, so that a circle fitted to the wall has the true radius.
    """
    angles = np.linspace(start_rad, end_rad, (count or segments(radius_mm, end_rad - start_rad)) + 1)
    sagitta_mm = radius_mm * (1.0 - np.cos((angles[1] - angles[0]) / 2.0))
    return np.column_stack([np.cos(angles), np.sin(angles)]) * (radius_mm + MEAN_SAGITTA * sagitta_mm) + centre


def circle(radius_mm: float, centre: tuple[float, float] = (0.0, 0.0)) -> FloatArray:
    """Return the corners (n, 2) of a circle of chords, counter-clockwise, the first not repeated."""
    return arc(radius_mm, 0.0, 2.0 * np.pi, centre)[:-1]


def polyline(corners: FloatArray, step_mm: float) -> FloatArray:
    """Sample the straight segments between ``corners`` (n, 2) with spacings of at most ``step_mm``."""
    pieces = [corners[:1]]
    for start, end in pairwise(corners):
        count = max(1, ceil(float(np.linalg.norm(end - start)) / step_mm))
        pieces.append(start + (end - start) * np.linspace(0.0, 1.0, count + 1)[1:, None])
    return np.concatenate(pieces)


@dataclass
class Soup:
    """Triangle soup; `merge` joins coincident vertices."""

    pieces: list[FloatArray] = field(default_factory=list)  # each (n, 3, 3)

    def add(self, triangles: FloatArray) -> None:
        """Add triangles (n, 3, 3), counter-clockwise seen from outside."""
        self.pieces.append(triangles)

    def wall(self, outline: FloatArray, low_mm: float, high_mm: float, *, closed: bool = True) -> None:
        """Add a vertical wall over ``outline`` (n, 2); outside is to the right of its direction."""
        ends = np.roll(outline, -1, axis=0) if closed else outline[1:]
        starts = outline if closed else outline[:-1]
        a, b = _at_height(starts, low_mm), _at_height(ends, low_mm)
        c, d = _at_height(ends, high_mm), _at_height(starts, high_mm)
        self.add(np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]))

    def face(self, outlines: list[FloatArray], height_mm: float, *, up: bool) -> None:
        """Add a horizontal face inside the outer outline and outside all other ``outlines``, whatever their orientation."""
        flat = triangulate(outlines)
        order = [0, 1, 2] if up else [0, 2, 1]
        self.add(_at_height(flat.reshape(-1, 2), height_mm).reshape(-1, 3, 3)[:, order])

    def merge(self) -> tuple[FloatArray, IntArray]:
        """Merge coincident corners; return vertices (V, 3) and triangles (T, 3)."""
        corners = np.concatenate(self.pieces).reshape(-1, 3)
        _, first, index = np.unique(np.round(corners, MERGE_DECIMALS) + 0.0, axis=0, return_index=True, return_inverse=True)
        return corners[first], index.reshape(-1, 3).astype(np.int32)


def triangulate(outlines: list[FloatArray]) -> FloatArray:
    """Triangulate the plane region between ``outlines``, each (n, 2): counter-clockwise triangles (T, 3, 2).

    A Delaunay triangulation contains every border edge that is short compared with its distance to other borders; the outlines of
    the sample parts are sampled accordingly, so a missing edge is a programming error.

    Raises
    ------
    ValueError
        An edge of an outline is not an edge of the triangulation.
    """
    points = np.concatenate(outlines)
    triangles = Delaunay(points, qhull_options="Qbb Qc Qz Q12 Qt").simplices
    corners = points[triangles]
    inside = _inside(corners.mean(axis=1), outlines)
    first, second = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    doubled_area = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0]
    kept = inside & (np.abs(doubled_area) > 1e-9)
    if _lost_borders(triangles[kept], outlines):
        raise ValueError("an outline is sampled too coarsely to be triangulated")
    turned = doubled_area[kept] < 0
    result = corners[kept]
    result[turned] = result[turned][:, [0, 2, 1]]
    return result


def _inside(points: FloatArray, outlines: list[FloatArray]) -> BoolArray:
    """Point-in-polygon test by the even-odd rule, along +x."""
    order = np.argsort(points[:, 1])
    across, up = points[order].T
    crossings = np.zeros(len(points), int)
    for outline in outlines:
        following = np.roll(outline, -1, axis=0)
        firsts = np.searchsorted(up, np.minimum(outline[:, 1], following[:, 1]))
        lasts = np.searchsorted(up, np.maximum(outline[:, 1], following[:, 1]))
        for start, end, first, last in zip(outline, following, firsts, lasts, strict=True):
            if first < last:  # else no point is as high as this edge
                at_x = start[0] + (up[first:last] - start[1]) * (end[0] - start[0]) / (end[1] - start[1])
                crossings[first:last] += across[first:last] < at_x
    inside = np.empty(len(points), bool)
    inside[order] = crossings % 2 == 1
    return inside


def _lost_borders(triangles: IntArray, outlines: list[FloatArray]) -> bool:
    edges = np.sort(np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]]), axis=1)
    known = {(int(a), int(b)) for a, b in edges}
    offset = 0
    for outline in outlines:
        count = len(outline)
        for index in range(count):
            a, b = offset + index, offset + (index + 1) % count
            if (min(a, b), max(a, b)) not in known:
                return True
        offset += count
    return False


def _at_height(points: FloatArray, height_mm: float) -> FloatArray:
    return np.column_stack([points, np.full(len(points), height_mm)])
