"""Histogram of deviations over the bands of a tolerance."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.errors import InspectionError

BANDS_IN_TOLERANCE = 10


@dataclass(frozen=True, slots=True, eq=False)
class Histogram:
    """Counts of deviations in equal bands; the first and the last are unbounded."""

    edges_mm: FloatArray  # (B + 1,); the outermost are finite, for display
    counts: IntArray  # (B,)
    below: float  # share of the points below the lower tolerance
    within: float
    above: float


def bin_deviations(distances_mm: FloatArray, lower_mm: float, upper_mm: float) -> Histogram:
    """Count deviations in ten bands within the tolerance and five on each side, the outermost unbounded.

    Raises
    ------
    InspectionError
        The lower tolerance is not below the upper one, or there are no deviations.

    >>> found = bin_deviations(np.array([-0.3, 0.0, 0.05, 0.2]), -0.1, 0.1)
    >>> found.below, found.within, found.above
    (0.25, 0.5, 0.25)
    """
    if not lower_mm < upper_mm:
        raise InspectionError(f"The tolerance from {lower_mm:g} to {upper_mm:g} mm is empty.", "Give the lower limit first.")
    if len(distances_mm) == 0:
        raise InspectionError("There are no deviations.", "Compare a cloud that has points.")
    half = (upper_mm - lower_mm) / 2
    edges = np.linspace(lower_mm - half, upper_mm + half, 2 * BANDS_IN_TOLERANCE + 1)
    counts = np.histogram(np.clip(distances_mm, edges[0], edges[-1]), edges)[0]
    below, above = float(np.mean(distances_mm < lower_mm)), float(np.mean(distances_mm > upper_mm))
    return Histogram(edges, counts, below, float(np.mean((distances_mm >= lower_mm) & (distances_mm <= upper_mm))), above)
