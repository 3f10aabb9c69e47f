"""Extracted surface: means of the points over cells, so that form values do not grow with the number of points."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np
from scipy.optimize import brentq
from scipy.special import ndtr, ndtri

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.feature import Feature
from measureapp.errors import InspectionError
from measureapp.geometry.shapes import tangents
from measureapp.inspection.features.feature_errors import ErrorSource
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.features.shapes import along_and_off, outward_normals, signed_distances

LEAST_CELLS = 12
LEAST_IN_CELL = 5
FITTED = 3  # mean and slopes of a cell
RANK = 1e-6  # tolerance for the extent along the normal
WELL_FILLED = 0.25  # of the median count: border cells with fewer points have noisier means
LEAST_AROUND = 24  # cells about an axis, whatever the radius
COVERAGE = 0.95
EQUAL_NOISE = 1e-9

SurfaceDistance = Callable[
    [FloatArray], tuple[FloatArray, FloatArray]
]  # points (N, 3) -> signed distances (N,) from a surface, and its unit normals (N, 3)


@dataclass(frozen=True, slots=True, eq=False)
class Cells:
    """Mean points of the well-filled cells of a surface."""

    points_mm: FloatArray  # (K, 3)
    deviations_mm: FloatArray  # (K,), from the feature
    keys: IntArray  # (K, D), index of the cell
    noise_mm: float  # typical standard deviation of a mean, from the scatter within the cells
    noises_mm: FloatArray  # (K,), of each mean
    normals: FloatArray  # (K, 3), of the surface
    view_contributions: Mapping[ErrorSource, FloatArray] = field(
        default_factory=dict
    )  # (K, M), errors of the means along the normals by their views

    def __len__(self) -> int:
        return len(self.points_mm)

    def displace(self, heights_mm: FloatArray) -> FloatArray:
        """Return the means (K, 3) displaced along their normals."""
        return np.asarray(self.points_mm + heights_mm[:, None] * self.normals)

    @property
    def form_sigma_mm(self) -> float:
        """Half the range of the noise of all means, 95 % quantile.

        The range of form plus noise differs from that of the form by at most the range of the noise, so that twice this value is an
        expanded uncertainty for any form.
        """
        return greatest_noise(self.noises_mm)


def greatest_noise_factor(count: int) -> float:
    """Return the 95 % quantile of the greatest of ``count`` normal errors, in standard deviations."""
    return float(ndtri((1 + COVERAGE ** (1 / max(count, 1))) / 2))


def greatest_noise(noises_mm: FloatArray) -> float:
    """Return the 95 % quantile of the greatest of independent normal errors with these standard deviations."""
    least, most = (greatest_noise_factor(len(noises_mm)) * float(noise) for noise in (noises_mm.min(), noises_mm.max()))
    if most - least <= EQUAL_NOISE * most:
        return most
    return float(brentq(lambda reach: np.log(2 * ndtr(reach / noises_mm) - 1).sum() - np.log(COVERAGE), least, most))


def cell_means(found: FoundFeature, feature: Feature, keys: IntArray, chosen: BoolArray | None = None) -> Cells:
    """Return the means over all cells with enough points.

    Parameters
    ----------
    found : feature with the points
    feature : fitted surface
    keys : (N, D), the cell of each point
    chosen : mask of the points to use; None: all

    Raises
    ------
    InspectionError
        Fewer than twelve cells are filled.
    """
    return surface_means(found, lambda points: (signed_distances(feature, points), outward_normals(feature, points)), keys, chosen)


def surface_means(found: FoundFeature, beside: SurfaceDistance, keys: IntArray, chosen: BoolArray | None = None) -> Cells:
    """Return the means relative to any surface; see `cell_means`."""
    points_mm = found.points_mm if chosen is None else found.points_mm[chosen]
    deviations, _ = beside(points_mm)
    kinds, cell = np.unique(keys, axis=0, return_inverse=True)
    cell = cell.ravel()
    counts = np.bincount(cell)
    full = counts >= max(LEAST_IN_CELL, WELL_FILLED * float(np.median(counts)))
    if np.count_nonzero(full) < LEAST_CELLS:
        raise InspectionError(f"{found.name}: only {np.count_nonzero(full)} cells have enough points, {LEAST_CELLS} are needed")
    mean = np.bincount(cell, weights=deviations) / counts
    places = np.column_stack([np.bincount(cell, weights=points_mm[:, k]) / counts for k in range(3)])
    away, normals = beside(places)
    scatter = _scatter(cell, points_mm - places[cell], deviations - mean[cell], normals)
    # the mean of points on a curved surface lies inside it, their mean deviation is unbiased
    places = places + (mean - away)[:, None] * normals
    freedoms = float(np.median(counts[full])) - FITTED
    variance = float(np.median(scatter[full])) / (1 - 2 / (9 * freedoms)) ** 3  # median to mean of χ² (Wilson and Hilferty)
    noise = float(np.sqrt(variance / np.median(counts[full])))
    number = np.where(full, np.cumsum(full) - 1, -1)[cell]
    by_views = _by_views(found, places[full], normals[full], number, chosen)
    return Cells(places[full], mean[full], kinds[full], noise, np.sqrt(variance / counts[full]), normals[full], by_views)


def _by_views(
    found: FoundFeature, places_mm: FloatArray, normals: FloatArray, number: IntArray, chosen: BoolArray | None
) -> dict[ErrorSource, FloatArray]:
    """Return the errors of means at ``places_mm`` by the views of their points; ``number`` (N,) is the mean of each point, -1 for none."""
    if found.view_errors is None or found.view is None:
        return {}
    view = found.view if chosen is None else found.view[chosen]
    inside = number >= 0
    pairs, counts = np.unique(np.column_stack([number[inside], view[inside]]), axis=0, return_counts=True)
    place = pairs[:, 0]
    share = counts / np.bincount(place, counts)[place]
    begins = np.flatnonzero(np.diff(place, prepend=-1))
    moved = found.view_errors.along(places_mm[place], normals[place], pairs[:, 1])
    return {ErrorSource(name): np.add.reduceat(share[:, None] * columns, begins) for name, columns in moved.items()}


def _scatter(cell: IntArray, offsets_mm: FloatArray, deviations_mm: FloatArray, normals: FloatArray) -> FloatArray:
    """Return the variance (C,) of the points of each cell about their fitted plane.

    Scatter about the mean would count the inclination of the surface as noise.

    Parameters
    ----------
    cell : (N,), cell of each point
    offsets_mm, deviations_mm : (N, 3) and (N,), from the cell's mean
    normals : (C, 3), unit normals of the cells
    """
    counts = np.bincount(cell)
    normal = normals[cell]
    across = offsets_mm - np.einsum("nd,nd->n", offsets_mm, normal)[:, None] * normal
    products = across[:, :, None] * np.concatenate([across, deviations_mm[:, None]], axis=1)[:, None, :]
    sums = np.stack([np.bincount(cell, weights=one) for one in products.reshape(len(cell), -1).T], axis=1).reshape(-1, 3, 4)
    slopes = np.einsum("cij,cj->ci", np.linalg.pinv(sums[:, :, :3], rcond=RANK, hermitian=True), sums[:, :, 3])
    rest = deviations_mm - np.einsum("nd,nd->n", across, slopes[cell])
    return np.bincount(cell, weights=rest**2) / np.maximum(counts - FITTED, 1)


def surface_keys(points_mm: FloatArray, feature: Feature, cell_mm: float) -> IntArray:
    """Return cells (N, D) of about ``cell_mm`` that follow the surface of ``feature``."""
    if feature.shape in ("cylinder", "cone", "circle") and feature.direction is not None:
        return round_keys(points_mm, feature.point_mm, feature.direction, cell_mm, feature.radius_mm or cell_mm)
    foot = points_mm - signed_distances(feature, points_mm)[:, None] * outward_normals(feature, points_mm)
    if feature.shape == "plane" and feature.direction is not None:
        offset = foot - feature.point_mm
        foot = offset @ tangents(feature.direction).T
    return grid_keys(foot, cell_mm)


def grid_keys(places_mm: FloatArray, cell_mm: float) -> IntArray:
    """Return cells (N, D) of a 2-D or 3-D grid, starting at the smallest coordinates."""
    return np.floor((places_mm - places_mm.min(axis=0)) / cell_mm + 0.5).astype(np.int64)


def round_keys(points_mm: FloatArray, point_mm: FloatArray, direction: FloatArray, cell_mm: float, radius_mm: float) -> IntArray:
    """Return cells (N, 2) about an axis: section along it, and sector around it."""
    along, _, _ = along_and_off(points_mm, point_mm, direction)
    around = around_count(radius_mm, cell_mm)
    section = np.floor((along - along.min()) / cell_mm).astype(np.int64)
    return np.column_stack([section, np.floor(angles(points_mm, point_mm, direction) / (2 * np.pi) * around).astype(np.int64) % around])


def around_count(radius_mm: float, cell_mm: float) -> int:
    """Return the number of cells per turn."""
    return max(LEAST_AROUND, round(2 * np.pi * radius_mm / cell_mm))


def angles(points_mm: FloatArray, point_mm: FloatArray, direction: FloatArray) -> FloatArray:
    """Return the angles (N,) of points about an axis, from 0 to 2π."""
    first, second = tangents(direction)
    offset = points_mm - point_mm
    return np.asarray(np.arctan2(offset @ second, offset @ first) % (2 * np.pi))
