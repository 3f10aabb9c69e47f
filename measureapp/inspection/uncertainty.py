"""How sure a dimension is: from the scatter of its points, and from what the scatter does not show.

Standard uncertainties are combined in quadrature (JCGM 100), by shares:

- noise: standard deviations of the fit from the points' residuals, widened by a factor when neighbouring points
  err together (see `correlation_factor`);
- stitching: where the views lie, by the joint covariance of their poses; what moves features alike drops out;
- calibration: how the cameras' calibration bends all clouds alike, while poses follow;
- form: smooth errors that each cloud has by itself;
- common: what all clouds may have alike beside the calibration;
- scale: what all lengths are measured by, as far as it was stated: the calibration board's lengths, the temperature of the part.

Where a cloud does not know of its views or of the calibration, the settings stand in and every result says so: each view stands off
by `placement_mm` on its own, and lengths by `systematic_mm` and `systematic_relative` of the length.

The expanded uncertainty is twice the result (k = 2).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.inspection.settings import UncertaintySettings

COVERAGE_FACTOR = 2.0
CELL_SIZES, LEAST_CELLS = (1.0, 2.0), 8  # of the correlation length; so many cells make a size count
SMALL_CELL_SIZES, LEAST_SMALL_CELLS = (0.125, 0.25, 0.5), 24
CHANCE = 2.0  # standard deviations of the square of a factor, which independent errors have by chance
VARIANCE, BEYOND_VARIANCE = 2.0, 6.5  # of it, times the number of cells: of a square, and of twice that less the one of cells half as large
PLANE = 3  # unknowns of a plane's fit
LEAST_PER_UNKNOWN = 2.5  # cells: of fewer the fit takes off too much to correct for


def correlation_factor(points_mm: FloatArray, residuals_mm: FloatArray, correlation_mm: float, unknowns: int = PLANE) -> float:
    """Return by how much errors shared among neighbours widen the standard deviation of a mean; at least 1.

    With residuals r of the points in each cell c of a grid this is the square root of Σ_c (Σ r)² / Σ r²: 1 for
    independent errors, √(points per cell) for errors that are the same throughout a cell (the design effect of
    cluster sampling, as in the sandwich covariance of K.-Y. Liang and S. L. Zeger, Biometrika 73(1), 1986). Cells
    must be larger than the errors reach, yet many: the largest factor of several cell sizes is taken, each
    corrected for what the fit with so many ``unknowns`` has taken out of the sums. What cells miss is what lies across their borders, in
    inverse proportion to their size, so that cells half as large tell the rest (D. N. Politis, J. P. Romano, Journal of Time Series
    Analysis 16(1), 67-103, 1995). Patches too small for those are divided into smaller cells, which show at least what next neighbours share.
    """
    if len(points_mm) < 2 or not np.any(residuals_mm):
        return 1.0

    known = _factors(points_mm, residuals_mm, [correlation_mm * size for size in CELL_SIZES], LEAST_CELLS, unknowns, 0.0)
    if not known:  # in space the border of a small cell sorts points by their own errors
        middle = points_mm - points_mm.mean(axis=0)
        flat = middle @ np.linalg.svd(middle, full_matrices=False)[2][:2].T
        known = _factors(flat, residuals_mm, [correlation_mm * size for size in SMALL_CELL_SIZES], LEAST_SMALL_CELLS, unknowns, CHANCE)
    return max([1.0, *known])


def _factors(
    places_mm: FloatArray, residuals_mm: FloatArray, sizes_mm: Sequence[float], least: int, unknowns: int, chance: float
) -> list[float]:
    """Return the factors that cells of each size show, where at least so many are filled; 1 where independent errors may show as much."""
    found: list[float] = []
    smaller = np.inf  # the first size has none half as large
    for size in sizes_mm:
        cells, cell = np.unique(np.floor((places_mm - places_mm.min(axis=0)) / size), axis=0, return_inverse=True)
        count = len(cells)
        if count >= max(least, LEAST_PER_UNKNOWN * unknowns):
            sums = np.bincount(cell.ravel(), weights=residuals_mm)
            square = count / (count - unknowns) * float(sums @ sums) / float(residuals_mm @ residuals_mm)
            found.append(_significant_factor(square, chance * np.sqrt(VARIANCE / count)))
            found.append(_significant_factor(2 * square - smaller, CHANCE * np.sqrt(BEYOND_VARIANCE / count)))
            smaller = square
    return found


def _significant_factor(square: float, by_chance: float) -> float:
    return float(np.sqrt(square)) if square > 1 + by_chance else 1.0


def effective_views(view: IntArray | None) -> float:
    """Return over how many views the points spread: 1 / Σ share²; 1 where unknown."""
    if view is None or len(view) == 0:
        return 1.0
    shares = np.bincount(np.asarray(view) - int(np.min(view))) / len(view)
    return float(1.0 / np.sum(shares**2))


def expand_uncertainty(random_mm: float, length_mm: float, settings: UncertaintySettings) -> float:
    """Return the expanded uncertainty (k = 2) of a length from its random part and what is assumed of the calibration."""
    return float(COVERAGE_FACTOR * np.hypot(random_mm, assumed_calibration(length_mm, settings)))


def assumed_calibration(length_mm: float, settings: UncertaintySettings) -> float:
    """Return the standard uncertainty of a length by the settings, where nothing is known of the calibration."""
    return float(np.hypot(settings.systematic_mm, settings.systematic_relative * abs(length_mm)))
