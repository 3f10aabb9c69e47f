"""How sure a dimension is: from the scatter of its points, and from what the scatter does not show.

Standard uncertainties are combined in quadrature (JCGM 100), by shares:

- noise: standard deviations of the fit from the points' residuals, widened by a factor when neighbouring points
  err together (see `shared_error_factor`);
- stitching: where the views lie, by the joint covariance of their poses; what moves features alike drops out;
- calibration: how the cameras' calibration bends all clouds alike, while poses follow.

Where a cloud does not know of its views or of the calibration, the settings stand in and every result says so: each view stands off
by `placement_mm` on its own, and lengths by `systematic_mm` and `systematic_relative` of the length.

The expanded uncertainty is twice the result (k = 2).
"""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.inspection.settings import UncertaintySettings

COVERAGE_FACTOR = 2.0
CELL_SIZES = (1.0, 2.0)
LEAST_CELLS = 8
FITTED = 3  # unknowns of the fit that flatten the sums: a plane's


def shared_error_factor(points_mm: FloatArray, residuals_mm: FloatArray, correlation_mm: float) -> float:
    """Return by how much errors shared among neighbours widen the standard deviation of a mean; at least 1.

    With residuals r of the points in each cell c of a grid this is the square root of Σ_c (Σ r)² / Σ r²: 1 for
    independent errors, √(points per cell) for errors that are the same throughout a cell (the design effect of
    cluster sampling, as in the sandwich covariance of K.-Y. Liang and S. L. Zeger, Biometrika 73(1), 1986). Cells
    must be larger than the errors reach, yet many: the largest factor of several cell sizes is taken, each
    corrected for what the fit has taken out of the sums.
    """
    total = float(residuals_mm @ residuals_mm)
    if len(points_mm) < 2 or total <= 0:
        return 1.0
    offset = points_mm - points_mm.min(axis=0)
    factors = [1.0]
    for cell_mm in (correlation_mm * size for size in CELL_SIZES):
        index = np.floor(offset / cell_mm).astype(np.int64)
        key = (index[:, 0] << 42) + (index[:, 1] << 21) + index[:, 2]
        cells, cell = np.unique(key, return_inverse=True)
        if len(cells) < LEAST_CELLS:
            break
        sums = np.bincount(cell.ravel(), weights=residuals_mm)
        correction = len(cells) / (len(cells) - FITTED)
        factors.append(float(np.sqrt(correction * (sums @ sums) / total)))
    return max(factors)


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
