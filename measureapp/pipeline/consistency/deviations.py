"""Deviations between overlapping views at a sample of points, beside what the error model expects of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.cloud import PointCloud, StitchedCloud
from measureapp.data.view_errors import ViewErrors
from measureapp.geometry.transform import RigidTransform

SAMPLE, LEAST_SAMPLE = 600, 100  # points of a view that are compared with each other view
MOST_DEVIATIONS = 20_000  # of all pairs, because each is compared with every error of the model
OVERLAPPING = 6  # views that a view usually overlaps
MOST_POINTS = 150_000  # of the other view, among which the nearest is sought
REACH = 1.5  # largest distance along the surface between the two points, in point spacings
NEIGHBOURS = 8  # that show whether a point lies at the rim of its face
RIM = 0.35  # offset of the middle of the neighbours, in their mean distance, beyond which a point lies at a rim
LEAST_COSINE = 0.95  # of the normals of the two points
OUTLIER = 5.0  # robust standard deviations of one pair of views
LEAST_OVERLAP = 40  # points
MADN = 1.4826  # median absolute deviation of a normal distribution, inverted


@dataclass(frozen=True, slots=True, eq=False)
class Deviations:
    """Distances along the normal of points of a view (own) from another view (other), in the part's frame."""

    distance_mm: FloatArray  # (N,)
    expected_mm: FloatArray  # (N, K), by independent errors of the model, one standard deviation each
    own_view: IntArray  # (N,), index into the placements
    other_view: IntArray  # (N,)
    own_point: IntArray  # (N,), index into the view's cloud
    other_point: IntArray  # (N,)

    def __len__(self) -> int:
        return len(self.distance_mm)


def compare_views(clouds: Sequence[PointCloud], stitched: StitchedCloud, errors: ViewErrors) -> Deviations | None:
    """Compare every view with every other that it overlaps; None without overlap.

    Distances are taken along the mean of both normals, so that the curvature of the surface does not enter (S. Rusinkiewicz, A symmetric
    objective function for ICP, ACM TOG 38(4), 2019). Points at the rim of a face do not take part: there a pixel mixes two surfaces.

    Parameters
    ----------
    clouds : in frame ``camera``, one per placement of ``stitched``
    """
    used = sum(placement.used for placement in stitched.placements)
    wanted = int(np.clip(MOST_DEVIATIONS / max(used * min(used - 1, OVERLAPPING), 1), LEAST_SAMPLE, SAMPLE))
    views = [
        _View.of(number, cloud, placement.part_from_camera, wanted)
        for number, (cloud, placement) in enumerate(zip(clouds, stitched.placements, strict=True))
        if placement.used and len(cloud) > NEIGHBOURS
    ]
    parts = [found for own in views for other in views if own is not other and (found := _compare(own, other, errors)) is not None]
    if not parts:
        return None
    names = ("distance_mm", "expected_mm", "own_view", "other_view", "own_point", "other_point")
    return Deviations(**{name: np.concatenate([getattr(part, name) for part in parts]) for name in names})


@dataclass(frozen=True, slots=True, eq=False)
class _View:
    """A sample of a view at its place, prepared for comparison: at most `MOST_POINTS`, however large its cloud is."""

    number: int
    points_mm: FloatArray  # (M, 3), among which the nearest is sought
    normals: FloatArray  # (M, 3)
    in_cloud: IntArray  # (M,), which points of the view's cloud they are
    tree: cKDTree
    spacing_mm: float
    sample: IntArray  # which of the M are compared with others

    @classmethod
    def of(cls, number: int, cloud: PointCloud, part_from_camera: RigidTransform, wanted: int) -> _View:
        in_cloud = np.arange(0, len(cloud), max(1, -(-len(cloud) // MOST_POINTS)))
        placed = cloud.where(in_cloud).seen_from(part_from_camera)
        cloud.give_up_pages()
        points = np.asarray(placed.points_mm)
        tree = cKDTree(points)
        rng = np.random.default_rng(number)  # the same sample every time
        sample = rng.choice(len(points), min(2 * wanted, len(points)), replace=False)
        distances, nearest = tree.query(points[sample], k=NEIGHBOURS + 1)
        spacing = float(np.median(distances[:, 1]))
        inside = _is_inside(points[sample], points[nearest[:, 1:]], distances[:, 1:])
        return cls(number, points, np.asarray(placed.normals), in_cloud, tree, spacing, sample[inside][:wanted])


def _is_inside(points_mm: FloatArray, neighbours_mm: FloatArray, distances_mm: FloatArray) -> BoolArray:
    """Whether points (N, 3) lie amid their neighbours (N, K, 3), and not at the rim of a face."""
    offset = np.linalg.norm(neighbours_mm.mean(axis=1) - points_mm, axis=1)
    return np.asarray(offset < RIM * np.maximum(distances_mm.mean(axis=1), 1e-9))


def _compare(own: _View, other: _View, errors: ViewErrors) -> Deviations | None:
    points = own.points_mm[own.sample]
    reach = REACH * max(own.spacing_mm, other.spacing_mm)
    distances, found = other.tree.query(points, k=1, distance_upper_bound=2 * reach)
    near = np.flatnonzero(np.isfinite(distances))
    if len(near) < LEAST_OVERLAP:
        return None
    mine, theirs = own.sample[near], found[near]
    normals = np.asarray(own.normals[mine], float), np.asarray(other.normals[theirs], float)
    between = normals[0] + normals[1]
    between /= np.maximum(np.linalg.norm(between, axis=1, keepdims=True), 1e-9)
    away = own.points_mm[mine] - other.points_mm[theirs]
    distance = np.einsum("nd,nd->n", away, between)
    beside = np.linalg.norm(away - distance[:, None] * between, axis=1)
    kept = (np.einsum("nd,nd->n", *normals) > LEAST_COSINE) & (beside < reach)
    if kept.sum() < LEAST_OVERLAP:
        return None
    middle = float(np.median(distance[kept]))
    kept &= np.abs(distance - middle) < OUTLIER * MADN * np.median(np.abs(distance[kept] - middle)) + 1e-9
    at = other.points_mm[theirs[kept]]
    around, neighbours = other.tree.query(at, k=NEIGHBOURS + 1)
    amid = _is_inside(at, other.points_mm[neighbours[:, 1:]], around[:, 1:])
    rows = np.flatnonzero(kept)[amid]
    if len(rows) < LEAST_OVERLAP:
        return None
    sides = [
        np.hstack(list(errors.along(points[near][rows], between[rows], np.full(len(rows), view.number)).values())) for view in (own, other)
    ]
    own_view, other_view = (np.full(len(rows), view.number) for view in (own, other))
    return Deviations(distance[rows], sides[0] - sides[1], own_view, other_view, own.in_cloud[mine[rows]], other.in_cloud[theirs[rows]])
