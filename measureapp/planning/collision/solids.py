"""Solids whose distance can be calculated: boxes, cylinders, capsules and convex hulls, each with a margin."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
import numpy.typing as npt

from measureapp.arrays import FloatArray

HULL_DIRECTIONS = 400  # of the support points of a hull: enough for a part, and each distance still takes 10 µs
BLOCK = 20_000
GOLDEN_RAD = float(np.pi) * (3.0 - 5.0**0.5)


@dataclass(frozen=True, slots=True, eq=False)
class Solid:
    """A convex solid: the hull of points, widened to discs about z or to balls; everything within ``margin_mm`` of it counts as well."""

    geometry: Any  # the same for python-fcl, which has its middle at the origin
    from_geometry: FloatArray  # (4, 4), that origin in the frame of the solid
    points_mm: FloatArray  # (N, 3)
    disc_mm: float  # radius of the discs
    ball_mm: float  # radius of the balls
    low_mm: FloatArray  # (3,) bounds in the frame of the solid, without the margin
    high_mm: FloatArray
    margin_mm: float

    def support_mm(self, direction: FloatArray) -> float:
        """Return how far the solid reaches along a unit vector (3,) of its frame, without the margin."""
        along = float((self.points_mm @ direction).max())
        return along + self.disc_mm * float(np.hypot(direction[0], direction[1])) + self.ball_mm

    @property
    def corners_mm(self) -> FloatArray:
        """The corners of its bounds, (8, 3)."""
        picks = np.array(np.meshgrid([0, 1], [0, 1], [0, 1])).reshape(3, 8).T
        return np.where(picks, self.high_mm, self.low_mm)


def box(low_mm: npt.ArrayLike, high_mm: npt.ArrayLike, margin_mm: float = 0.0) -> Solid:
    """Return a box between two corners (3,)."""
    import fcl

    low, high = np.asarray(low_mm, float), np.asarray(high_mm, float)
    corners = np.array(np.meshgrid(*zip(low, high, strict=True))).reshape(3, 8).T
    return Solid(fcl.Box(*(high - low)), _moved((low + high) / 2.0), corners, 0.0, 0.0, low, high, margin_mm)


def cylinder(foot_mm: npt.ArrayLike, radius_mm: float, height_mm: float, margin_mm: float = 0.0) -> Solid:
    """Return an upright cylinder; ``foot_mm`` (3,) is the centre of its lower end."""
    import fcl

    foot, reach = np.asarray(foot_mm, float), np.array([radius_mm, radius_mm, 0.0])
    top = foot + np.array([0.0, 0.0, height_mm])
    geometry = fcl.Cylinder(radius_mm, height_mm)
    return Solid(geometry, _moved((foot + top) / 2.0), np.array([foot, top]), radius_mm, 0.0, foot - reach, top + reach, margin_mm)


def capsule(start_mm: npt.ArrayLike, end_mm: npt.ArrayLike, radius_mm: float, margin_mm: float = 0.0) -> Solid:
    """Return all within ``radius_mm`` of a straight line between two points (3,)."""
    import fcl

    start, end = np.asarray(start_mm, float), np.asarray(end_mm, float)
    length = float(np.linalg.norm(end - start))
    from_geometry = _moved((start + end) / 2.0)
    if length > 0.0:
        along = (end - start) / length
        across = np.cross(along, np.eye(3)[np.abs(along).argmin()])
        across /= np.linalg.norm(across)
        from_geometry[:3, :3] = np.column_stack([across, np.cross(along, across), along])
    low, high = np.minimum(start, end) - radius_mm, np.maximum(start, end) + radius_mm
    return Solid(fcl.Capsule(radius_mm, length), from_geometry, np.array([start, end]), 0.0, radius_mm, low, high, margin_mm)


def hull(points_mm: FloatArray, margin_mm: float = 0.0) -> Solid:
    """Return the convex hull of points (N, 3).

    Of many points those that lie furthest in `HULL_DIRECTIONS` are taken; by how much the others are outside of their hull is added to the
    margin, so that none is lost.
    """
    import fcl
    from scipy.spatial import ConvexHull

    kept = ConvexHull(_support(points_mm)) if len(points_mm) > HULL_DIRECTIONS else ConvexHull(points_mm)
    normals, offsets = kept.equations[:, :3].T, kept.equations[:, 3]
    outside_mm = max(0.0, *(float((block @ normals + offsets).max()) for block in _blocks(points_mm)))
    vertices = kept.points[kept.vertices]
    number = np.full(len(kept.points), -1)
    number[kept.vertices] = np.arange(len(vertices))
    faces = np.column_stack([np.full(len(kept.simplices), 3), number[_outward(kept)]]).ravel()
    geometry = fcl.Convex(vertices, len(kept.simplices), faces.astype(np.int32))
    low, high = vertices.min(axis=0), vertices.max(axis=0)
    return Solid(geometry, np.eye(4), vertices, 0.0, 0.0, low, high, margin_mm + outside_mm)


def _support(points_mm: FloatArray) -> FloatArray:
    """Return the points that lie furthest in evenly spread directions and along the axes, each once."""
    step = np.arange(HULL_DIRECTIONS)
    height = 1.0 - (2.0 * step + 1.0) / HULL_DIRECTIONS
    radius, turn = np.sqrt(1.0 - height**2), GOLDEN_RAD * step
    spiral = np.column_stack([radius * np.cos(turn), radius * np.sin(turn), height])
    directions = np.vstack([spiral, np.eye(3), -np.eye(3)])
    best, reach_mm = np.zeros(len(directions), int), np.full(len(directions), -np.inf)
    for number, block in enumerate(_blocks(points_mm)):
        along = block @ directions.T
        further = along.max(axis=0) > reach_mm
        best = np.where(further, number * BLOCK + along.argmax(axis=0), best)
        reach_mm = np.maximum(reach_mm, along.max(axis=0))
    return points_mm[np.unique(best)]


def _blocks(points_mm: FloatArray) -> Iterator[FloatArray]:
    """Yield points in blocks, so that large nominals need no large memory."""
    for start in range(0, len(points_mm), BLOCK):
        yield points_mm[start : start + BLOCK]


def _outward(found: Any) -> npt.NDArray[np.int64]:
    """Return the triangles of a hull with their corners counter-clockwise seen from outside."""
    triangles: npt.NDArray[np.int64] = found.simplices.astype(np.int64)
    a, b, c = (found.points[triangles[:, corner]] for corner in range(3))
    inward = np.einsum("ij,ij->i", np.cross(b - a, c - a), found.equations[:, :3]) < 0.0
    triangles[inward] = triangles[inward][:, [0, 2, 1]]
    return triangles


def _moved(translation_mm: FloatArray) -> FloatArray:
    matrix = np.eye(4)
    matrix[:3, 3] = translation_mm
    return matrix
