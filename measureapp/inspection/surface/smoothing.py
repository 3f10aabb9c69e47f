"""Smoothing of deviations for the eye: colours only; values, extremes and histograms always use the raw deviations."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.inspection.surface.deviation_index import DeviationIndex

DEFAULT_SPACINGS = 2.0
MOST = 24  # neighbours; more would not be seen
CHUNK = 100_000


@dataclass(frozen=True, slots=True, eq=False)
class Smoothed:
    """Mean deviations around every point."""

    distances_mm: FloatArray  # (N,)
    radius_mm: float  # of the mean, to be stated in the legend


def smooth_for_eye(index: DeviationIndex, radius_mm: float | None = None) -> Smoothed:
    """Average the deviations within ``radius_mm`` on the same side of the part; None: twice the point spacing."""
    radius = DEFAULT_SPACINGS * index.spacing_mm if radius_mm is None else radius_mm
    found = index.found
    made = np.empty(len(found.distances_mm))
    for start in range(0, len(made), CHUNK):
        part = slice(start, start + CHUNK)
        near, weights = index.neighbours(found.points_mm[part], found.nominal_normals[part], MOST, radius)
        made[part] = (weights * found.distances_mm[near]).sum(axis=1) / np.maximum(weights.sum(axis=1), 1.0)
    return Smoothed(made, radius)
