"""Uncertainty budget of a dimension.

Standard uncertainties are combined in quadrature (JCGM 100). Contributions:

- noise: standard deviation of the fit from the residuals, multiplied by a factor for correlated neighbouring points
  (see `correlation_factor`);
- stitching: joint covariance of the poses of the views; a common motion of features cancels;
- calibration: distortion of all clouds by errors of the camera calibration, with the poses adapted to it;
- form: smooth form errors of single clouds;
- edges: what the blur of sharp edges does to narrow faces (`features/edge_effects.py`);
- common: systematic errors shared by all clouds, beyond the calibration;
- certificate: of the certified lengths that correct the value (`certified_lengths.py`);
- unexplained: what checks of the data find beyond all these;
- temperature: correction of lengths to 20 °C, by the uncertainty of the part's temperature and of its expansion;
- scale: length scale, by the class or certificate of the calibration board.

For a cloud without an error model, the settings are used and stated with every result: an independent displacement `placement_mm` of each
view, and `systematic_mm` plus `systematic_relative` of a length for the calibration.

The expanded uncertainty is twice the result (k = 2).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.inspection.settings import UncertaintySettings

COVERAGE_FACTOR = 2.0
CELL_SIZES, LEAST_CELLS = (1.0, 2.0), 8  # of the correlation length; least number of cells per size
SMALL_CELL_SIZES, LEAST_SMALL_CELLS = (0.125, 0.25, 0.5), 24
CHANCE = 2.0  # standard deviations of the squared factor below which independent errors explain it
VARIANCE, BEYOND_VARIANCE = 2.0, 6.5  # of the squared factor times the number of cells: of one size, and extrapolated from two sizes
PLANE = 3  # unknowns of a plane's fit
LEAST_PER_UNKNOWN = 2.5  # least number of cells per fitted parameter


def correlation_factor(points_mm: FloatArray, residuals_mm: FloatArray, correlation_mm: float, unknowns: int = PLANE) -> float:
    """Square root of the design effect: factor by which correlated errors increase the standard deviation of a mean; at least 1.

    With residuals r of the points in each cell c of a grid this is the square root of Σ_c (Σ r)² / Σ r²: 1 for independent errors,
    √(points per cell) for errors constant within a cell (cluster sampling, as in the sandwich covariance of K.-Y. Liang and S. L. Zeger,
    Biometrika 73(1), 1986). Cells must be larger than the correlation length, yet many: the largest factor of several cell sizes is used,
    each corrected for the degrees of freedom of a fit with ``unknowns`` parameters. Cells miss the correlation across their borders, a
    bias inversely proportional to their size, which is extrapolated from cells of half the size (D. N. Politis, J. P. Romano, Journal of
    Time Series Analysis 16(1), 67-103, 1995). Patches too small for this are divided into smaller cells, which show at least the
    correlation of adjacent points.
    """
    if len(points_mm) < 2 or not float(residuals_mm @ residuals_mm):  # also where squares are too small for a number
        return 1.0

    known = _factors(points_mm, residuals_mm, [correlation_mm * size for size in CELL_SIZES], LEAST_CELLS, unknowns, 0.0)
    if not known:  # in 3-D, the border of a small cell would sort points by their own errors
        middle = points_mm - points_mm.mean(axis=0)
        flat = middle @ np.linalg.svd(middle, full_matrices=False)[2][:2].T
        known = _factors(flat, residuals_mm, [correlation_mm * size for size in SMALL_CELL_SIZES], LEAST_SMALL_CELLS, unknowns, CHANCE)
    return max([1.0, *known])


def _factors(
    places_mm: FloatArray, residuals_mm: FloatArray, sizes_mm: Sequence[float], least: int, unknowns: int, chance: float
) -> list[float]:
    """Return the factors of each cell size with at least ``least`` filled cells; 1 where independent errors explain them."""
    found: list[float] = []
    smaller = np.inf  # the first size has no smaller one
    for size in sizes_mm:
        cell = _cells_of(places_mm, size)
        count = int(cell.max()) + 1
        if count >= max(least, LEAST_PER_UNKNOWN * unknowns):
            sums = np.bincount(cell, weights=residuals_mm)
            square = count / (count - unknowns) * float(sums @ sums) / float(residuals_mm @ residuals_mm)
            found.append(_significant_factor(square, chance * np.sqrt(VARIANCE / count)))
            found.append(_significant_factor(2 * square - smaller, CHANCE * np.sqrt(BEYOND_VARIANCE / count)))
            smaller = square
    return found


def _cells_of(places_mm: FloatArray, size_mm: float) -> IntArray:
    """Return the number (N,) of each place's cell among the filled ones: axis by axis, in a tenth of the time of sorting whole rows."""
    first, *others = np.floor((places_mm - places_mm.min(axis=0)) / size_mm).astype(np.int64).T
    cell = np.unique(first, return_inverse=True)[1]
    for steps in others:
        cell = np.unique(cell * (steps.max() + 1) + steps, return_inverse=True)[1]
    return np.asarray(cell)


def _significant_factor(square: float, by_chance: float) -> float:
    return float(np.sqrt(square)) if square > 1 + by_chance else 1.0


def effective_views(view: IntArray | None) -> float:
    """Return the effective number of views of the points: 1 / Σ share²; 1 where unknown."""
    if view is None or len(view) == 0:
        return 1.0
    shares = np.bincount(np.asarray(view) - int(np.min(view))) / len(view)
    return float(1.0 / np.sum(shares**2))


def expand_uncertainty(random_mm: float, length_mm: float, settings: UncertaintySettings) -> float:
    """Return the expanded uncertainty (k = 2) of a length from its random part and the assumed calibration uncertainty."""
    return float(COVERAGE_FACTOR * np.hypot(random_mm, assumed_calibration(length_mm, settings)))


def assumed_calibration(length_mm: float, settings: UncertaintySettings) -> float:
    """Return the standard uncertainty of a length from the settings, for clouds without a calibration error model."""
    return float(np.hypot(settings.systematic_mm, settings.systematic_relative * abs(length_mm)))
