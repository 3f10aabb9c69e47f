"""Extraction of a measured surface: the means of its points over cells, so that noise does not grow with the number of points."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from scipy.special import ndtri

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.feature import Feature
from measureapp.errors import InspectionError
from measureapp.geometry.shapes import tangents
from measureapp.inspection.features.errors import Source
from measureapp.inspection.features.found import Found
from measureapp.inspection.features.shapes import along_and_off, outward_normals, signed_distances

LEAST_CELLS = 12
LEAST_IN_CELL = 5
WELL_FILLED = 0.25  # of the median count: cells at the rim hold fewer points, whose mean is noisier
LEAST_AROUND = 24  # cells about an axis, whatever the radius
COVERAGE = 0.95


@dataclass(frozen=True, slots=True, eq=False)
class Cells:
    """Mean points of the well-filled cells of a surface."""

    points_mm: FloatArray  # (K, 3)
    deviations_mm: FloatArray  # (K,), from the feature
    keys: IntArray  # (K, D), which cell
    noise_mm: float  # typical standard deviation of a mean, from the scatter within the cells
    noises_mm: FloatArray  # (K,), of each mean: cells at the rim hold fewer points
    normals: FloatArray  # (K, 3), of the shape
    by_views: Mapping[Source, FloatArray] = field(
        default_factory=dict
    )  # (K, M), errors of the means along the normals because of their views

    def __len__(self) -> int:
        return len(self.points_mm)

    def raised(self, heights_mm: FloatArray) -> FloatArray:
        """Return the means (K, 3) displaced along their normals."""
        return np.asarray(self.points_mm + heights_mm[:, None] * self.normals)

    @property
    def form_sigma_mm(self) -> float:
        """Half the range that noise alone spans over all means in 95 of 100 cases.

        The range of the sum of form and noise differs from that of the form by no more than the range of the noise, so
        that twice this is an expanded uncertainty whatever the form is.
        """
        return noise_reach(len(self)) * self.noise_mm


def noise_reach(count: int) -> float:
    """Return the multiple of σ that the greatest of ``count`` normal errors does not exceed in 95 of 100 cases."""
    return float(ndtri((1 + COVERAGE ** (1 / max(count, 1))) / 2))


def cell_means(found: Found, feature: Feature, keys: IntArray, chosen: BoolArray | None = None) -> Cells:
    """Return the means over all cells that hold enough points.

    Parameters
    ----------
    found : whose points are extracted
    feature : on whose surface they lie
    keys : (N, D), the cell of each point
    chosen : mask of the points of ``found`` that are meant; None: all

    Raises
    ------
    InspectionError
        Fewer than twelve cells are filled.
    """
    points_mm = found.points_mm if chosen is None else found.points_mm[chosen]
    view = found.view if chosen is None or found.view is None else found.view[chosen]
    deviations = signed_distances(feature, points_mm)
    cells, cell = np.unique(keys, axis=0, return_inverse=True)
    cell = cell.ravel()
    counts = np.bincount(cell)
    full = counts >= max(LEAST_IN_CELL, WELL_FILLED * float(np.median(counts)))
    if np.count_nonzero(full) < LEAST_CELLS:
        raise InspectionError(f"{found.name}: its points fill only {np.count_nonzero(full)} cells, {LEAST_CELLS} are needed")
    mean = np.bincount(cell, weights=deviations) / counts
    places = np.column_stack([np.bincount(cell, weights=points_mm[:, k]) / counts for k in range(3)])[full]
    scatter = np.bincount(cell, weights=(deviations - mean[cell]) ** 2)[full] / (counts[full] - 1)
    # the mean of points on a curved surface lies inside it; their mean deviation does not
    places = places + (mean[full] - signed_distances(feature, places))[:, None] * outward_normals(feature, places)
    freedoms = float(np.median(counts[full])) - 1
    variance = float(np.median(scatter)) / (1 - 2 / (9 * freedoms)) ** 3  # of χ² the median lies below the mean (Wilson and Hilferty)
    noise = float(np.sqrt(variance / np.median(counts[full])))
    normals = outward_normals(feature, places)
    number = np.where(full, np.cumsum(full) - 1, -1)[cell]
    return Cells(
        places, mean[full], cells[full], noise, np.sqrt(variance / counts[full]), normals, _by_views(found, places, normals, number, view)
    )


def _by_views(
    found: Found, places_mm: FloatArray, normals: FloatArray, number: IntArray, view: IntArray | None
) -> dict[Source, FloatArray]:
    """Return the errors of means at ``places_mm`` whose points, ``number`` (N,) saying which mean each is part of, were measured in ``view``."""
    if found.view_errors is None or view is None:
        return {}
    inside = number >= 0
    pairs, counts = np.unique(np.column_stack([number[inside], view[inside]]), axis=0, return_counts=True)
    place = pairs[:, 0]
    share = counts / np.bincount(place, counts)[place]
    begins = np.flatnonzero(np.diff(place, prepend=-1))
    moved = found.view_errors.along(places_mm[place], normals[place], pairs[:, 1])
    return {Source(name): np.add.reduceat(share[:, None] * columns, begins) for name, columns in moved.items()}


def surface_keys(points_mm: FloatArray, feature: Feature, cell_mm: float) -> IntArray:
    """Return cells (N, D) of about ``cell_mm`` that follow the surface of ``feature``."""
    if feature.shape in ("cylinder", "cone") and feature.direction is not None:
        return round_keys(points_mm, feature.point_mm, feature.direction, cell_mm, feature.radius_mm or cell_mm)
    foot = points_mm - signed_distances(feature, points_mm)[:, None] * outward_normals(feature, points_mm)
    if feature.shape == "plane" and feature.direction is not None:
        offset = foot - feature.point_mm
        foot = offset @ tangents(feature.direction).T
    return np.floor((foot - foot.min(axis=0)) / cell_mm + 0.5).astype(np.int64)


def round_keys(points_mm: FloatArray, point_mm: FloatArray, direction: FloatArray, cell_mm: float, radius_mm: float) -> IntArray:
    """Return cells (N, 2) about an axis: which section along it, and where around it."""
    along, _, _ = along_and_off(points_mm, point_mm, direction)
    around = around_count(radius_mm, cell_mm)
    section = np.floor((along - along.min()) / cell_mm).astype(np.int64)
    return np.column_stack([section, np.floor(angles(points_mm, point_mm, direction) / (2 * np.pi) * around).astype(np.int64) % around])


def around_count(radius_mm: float, cell_mm: float) -> int:
    """Return into how many cells a turn is divided."""
    return max(LEAST_AROUND, round(2 * np.pi * radius_mm / cell_mm))


def angles(points_mm: FloatArray, point_mm: FloatArray, direction: FloatArray) -> FloatArray:
    """Return the angles (N,) of points about an axis, from 0 to 2π."""
    first, second = tangents(direction)
    offset = points_mm - point_mm
    return np.asarray(np.arctan2(offset @ second, offset @ first) % (2 * np.pi))
