"""How sure a dimension is: from the scatter of its points, and from what the scatter does not show.

Standard uncertainties are combined in quadrature (JCGM 100), by shares:

- noise: standard deviations of the fit from the points' residuals, widened by a factor when neighbouring points
  err together (see `shared_error_factor`);
- stitching: where the views lie, by the joint covariance of their poses; what moves features alike drops out;
- calibration: how the cameras' calibration bends all clouds alike, while poses follow;
- form: smooth errors that each cloud has by itself;
- common: what all clouds may have alike beside the calibration.

Where a cloud does not know of its views or of the calibration, the settings stand in and every result says so: each view stands off
by `placement_mm` on its own, and lengths by `systematic_mm` and `systematic_relative` of the length.

The expanded uncertainty is twice the result (k = 2).
"""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.inspection.settings import UncertaintySettings

COVERAGE_FACTOR = 2.0
CELL_SIZES, LEAST_CELLS = (1.0, 2.0), 8  # of the correlation length; so many cells make a size count
SMALL_CELL_SIZES, LEAST_SMALL_CELLS = (0.125, 0.25, 0.5), 24
CHANCE = 2.0  # standard deviations of the square of a factor, which independent errors have by chance in small cells
FITTED = 3  # unknowns of the fit that flatten the sums: a plane's


def shared_error_factor(points_mm: FloatArray, residuals_mm: FloatArray, correlation_mm: float) -> float:
    """Return by how much errors shared among neighbours widen the standard deviation of a mean; at least 1.

    With residuals r of the points in each cell c of a grid this is the square root of Σ_c (Σ r)² / Σ r²: 1 for
    independent errors, √(points per cell) for errors that are the same throughout a cell (the design effect of
    cluster sampling, as in the sandwich covariance of K.-Y. Liang and S. L. Zeger, Biometrika 73(1), 1986). Cells
    must be larger than the errors reach, yet many: the largest factor of several cell sizes is taken, each
    corrected for what the fit has taken out of the sums. Patches too small for those are divided into smaller cells, which show at
    least what next neighbours share.
    """
    total = float(residuals_mm @ residuals_mm)
    if len(points_mm) < 2 or total <= 0:
        return 1.0

    def factors(places_mm: FloatArray, sizes: tuple[float, ...], least: int, chance: float) -> list[float]:
        found = []
        for size in sizes:
            cells, cell = np.unique(np.floor((places_mm - places_mm.min(axis=0)) / (correlation_mm * size)), axis=0, return_inverse=True)
            if len(cells) >= least:
                sums = np.bincount(cell.ravel(), weights=residuals_mm)
                square = len(cells) / (len(cells) - FITTED) * float(sums @ sums) / total
                found.append(float(np.sqrt(square)) if square > 1 + chance * np.sqrt(2 / len(cells)) else 1.0)
        return found

    known = factors(points_mm, CELL_SIZES, LEAST_CELLS, 0.0)
    if not known:  # in space the border of a small cell sorts points by their own errors
        middle = points_mm - points_mm.mean(axis=0)
        flat = middle @ np.linalg.svd(middle, full_matrices=False)[2][:2].T
        known = factors(flat, SMALL_CELL_SIZES, LEAST_SMALL_CELLS, CHANCE)
    return max([1.0, *known])


def effective_views(view: IntArray | None) -> float:
    """Return over how many views the points spread: 1 / Σ share²; 1 where unknown."""
    if view is None or len(view) == 0:
        return 1.0
    shares = np.bincount(np.asarray(view) - int(np.min(view))) / len(view)
    return float(1.0 / np.sum(shares**2))


def expanded(random_mm: float, length_mm: float, settings: UncertaintySettings) -> float:
    """Return the expanded uncertainty (k = 2) of a length from its random part and what is assumed of the calibration."""
    return float(COVERAGE_FACTOR * np.hypot(random_mm, assumed_calibration(length_mm, settings)))


def assumed_calibration(length_mm: float, settings: UncertaintySettings) -> float:
    """Return the standard uncertainty of a length by the settings, where nothing is known of the calibration."""
    return float(np.hypot(settings.systematic_mm, settings.systematic_relative * abs(length_mm)))
