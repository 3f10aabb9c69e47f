"""How sure a dimension is: from the scatter of its points, and from what the scatter does not show.

Standard uncertainties are combined in quadrature (JCGM 100):

- fit: standard deviations of the fit from the points' residuals, widened by a factor when neighbouring points
  err together (see `shared_error_factor`);
- placement: each view stands off by `placement_mm`; a feature seen by n views averages over n;
- calibration: `systematic_mm` for every length and `systematic_relative` of the length.

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
    """Return the expanded uncertainty (k = 2) of a length from its random part and the calibration."""
    systematic = np.hypot(settings.systematic_mm, settings.systematic_relative * abs(length_mm))
    return float(COVERAGE_FACTOR * np.hypot(random_mm, systematic))
