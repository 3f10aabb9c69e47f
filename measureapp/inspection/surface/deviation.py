"""Deviation of a cloud from its nominal surface."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray, IntArray, read_only
from measureapp.data.measurement import Alignment
from measureapp.data.mesh import Mesh
from measureapp.inspection.measured_points import HasPoints, MeasuredPoints, sample_mesh
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.surface.ray_distances import distances_along_normals
from measureapp.inspection.surface.units import NEAR_SHARE, check_unit_against
from measureapp.progress import NoProgress, Progress

CHUNK = 200_000
LEAF = 16  # points of a leaf
COVERAGE_SAMPLES = 40_000
NEAR_MM = 2.0  # the nominal counts as measured where a point lies closer than this


@dataclass(frozen=True, slots=True, eq=False)
class Deviation:
    """Signed distances of measured points from the nominal surface; positive outside."""

    points_mm: FloatArray  # (N, 3), in the nominal's frame
    distances_mm: FloatArray  # (N,)
    nominal_normals: FloatArray  # (N, 3), of the nominal at each point
    mean_mm: float
    rms_mm: float
    p95_mm: float  # of the absolute distances
    min_mm: float
    max_mm: float
    unmeasured_share: float  # of the nominal's area without a measured point nearby
    alignment: Alignment
    tree: cKDTree = field(repr=False)  # search tree of the points

    @classmethod
    def of(
        cls,
        points_mm: FloatArray,
        distances_mm: FloatArray,
        nominal_normals: FloatArray,
        unmeasured_share: float,
        alignment: Alignment,
        tree: cKDTree | None = None,
    ) -> Deviation:
        """Return the deviation with these distances; ``tree``: of the points, if it is built already."""
        return cls(
            points_mm,
            distances_mm,
            nominal_normals,
            float(distances_mm.mean()),
            float(np.sqrt(np.mean(distances_mm**2))),
            float(np.percentile(np.abs(distances_mm), 95)),
            float(distances_mm.min()),
            float(distances_mm.max()),
            unmeasured_share,
            alignment,
            search_tree(points_mm) if tree is None else tree,
        )

    def __post_init__(self) -> None:
        object.__setattr__(self, "points_mm", read_only(self.points_mm, np.float64, (None, 3)))
        object.__setattr__(self, "nominal_normals", read_only(self.nominal_normals, np.float32, (len(self.points_mm), 3)))
        object.__setattr__(self, "distances_mm", read_only(self.distances_mm, np.float64, (len(self.points_mm),)))


def compute_deviation(
    measured: MeasuredPoints | HasPoints | Mesh,
    nominal: Mesh,
    alignment: Alignment,
    *,
    near_mm: float = NEAR_MM,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> Deviation:
    """Compare measured points with a nominal mesh that may be open.

    Parameters
    ----------
    near_mm : the nominal counts as measured where a point lies closer than this

    Raises
    ------
    InspectionError
        There are no points, the nominal has no surface, or the points match it in another unit only.
    """
    points = MeasuredPoints.of(measured).seen_from(alignment.nominal_from_part)
    surface = NominalSurface(nominal)
    distances, normals = np.empty(len(points)), np.empty((len(points), 3), np.float32)
    for start in range(0, len(points), CHUNK):
        progress.report(start, len(points), "distances from the nominal")
        chunk = slice(start, start + CHUNK)
        own = None if points.normals is None else points.normals[chunk]
        distances[chunk], normals[chunk] = distances_and_normals(points.points_mm[chunk], own, surface)
    tree = search_tree(points.points_mm)
    unmeasured = unmeasured_share(tree, nominal, near_mm)
    if unmeasured > 0.5 or np.median(np.abs(distances)) > NEAR_SHARE * surface.diagonal_mm:
        check_unit_against(points, surface)  # a cloud that covers its nominal is in the right unit
    progress.report(1, 1, "distances from the nominal")
    return Deviation.of(points.points_mm, distances, normals, unmeasured, alignment, tree)


def search_tree(points_mm: FloatArray) -> cKDTree:
    """Return a search tree of points (N, 3); unbalanced, which is three times faster to build, with leaves in which millions are found soonest."""
    return cKDTree(points_mm, LEAF, balanced_tree=False, compact_nodes=False)


def signed_distances(points_mm: FloatArray, surface: NominalSurface) -> FloatArray:
    """Return distances (N,) to the nearest surface point, positive on the side its normal points to."""
    return distances_and_normals(points_mm, None, surface)[0]


def distances_and_normals(points_mm: FloatArray, normals: FloatArray | None, surface: NominalSurface) -> tuple[FloatArray, FloatArray]:
    """Return signed distances (N,) from the surface and its normals there (N, 3).

    For points with normals the distance is taken along them near a face of matching normal; otherwise from the closest surface point.
    """
    if normals is None:
        return _from_closest(points_mm, surface)
    distances, triangles, sure = distances_along_normals(points_mm, normals, surface)
    facing = surface.normals[triangles]
    rest = np.flatnonzero(~sure)
    if len(rest):
        distances[rest], facing[rest] = _from_closest(points_mm[rest], surface, triangles[rest])
    return distances, facing


def _from_closest(points_mm: FloatArray, surface: NominalSurface, near: IntArray | None = None) -> tuple[FloatArray, FloatArray]:
    closest = surface.closest(points_mm, near)
    offset = points_mm - closest.points_mm
    side = np.where(np.einsum("nd,nd->n", offset, closest.normals) < 0, -1.0, 1.0)
    return side * np.linalg.norm(offset, axis=1), closest.normals


def unmeasured_share(tree: cKDTree, nominal: Mesh, near_mm: float) -> float:
    """Return the share of the nominal's area without a point of the tree nearby."""
    places = sample_mesh(nominal, COVERAGE_SAMPLES).points_mm
    distance, _ = tree.query(places, distance_upper_bound=near_mm, workers=-1)
    return float(np.mean(~np.isfinite(distance)))
