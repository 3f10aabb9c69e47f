"""Whiskers of a section: magnified deviations as lines from the nominal curve."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.errors import InspectionError
from measureapp.inspection.surface.round_numbers import round_down
from measureapp.inspection.surface.section import Section

PERCENTILE, LONGEST = 95, 0.06  # of the whiskers, and their length relative to the section
LEAST_MM = 1e-6
PER_SECTION = 400  # whiskers along the longest extent


@dataclass(frozen=True, slots=True, eq=False)
class Whiskers:
    """Mean deviations along a section, drawn from feet on the nominal to tips; in the nominal's frame."""

    feet_mm: FloatArray  # (K, 3)
    tips_mm: FloatArray  # (K, 3), magnified
    deviations_mm: FloatArray  # (K,), not magnified
    counts: FloatArray  # (K,), points of each mean
    gain: float  # to be printed: "whiskers ×50"


def section_whiskers(section: Section, gain: float | None = None, spacing_mm: float | None = None) -> Whiskers:
    """Return the whiskers of a section from the nominal curve.

    Parameters
    ----------
    gain : magnification; None: 1, 2 or 5 times a power of ten, so that the long whiskers reach 6 % of the section
    spacing_mm : length of the nominal curve over which points are averaged; None: 1/400 of the section

    Raises
    ------
    InspectionError
        Nothing was measured along the section.
    """
    if len(section.deviations_mm) == 0:
        raise InspectionError(f"Nothing was measured along the section {section.name}.", "Move the section, or widen its strip.")
    feet = section.measured_mm - section.deviations_mm[:, None] * section.nominal_normals
    extent = float(np.linalg.norm(np.ptp(feet, axis=0)))
    bins = _bins(feet, spacing_mm or max(extent / PER_SECTION, LEAST_MM))
    counts = np.bincount(bins).astype(np.float64)

    def mean(values: FloatArray) -> FloatArray:
        return np.bincount(bins, weights=values) / counts

    deviations = mean(section.deviations_mm)
    places = np.column_stack([mean(feet[:, axis]) for axis in range(3)])
    normals = np.column_stack([mean(section.nominal_normals[:, axis]) for axis in range(3)])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), LEAST_MM)
    long = max(float(np.percentile(np.abs(deviations), PERCENTILE)), LEAST_MM)
    chosen = gain if gain is not None else max(round_down(LONGEST * extent / long), 1.0)
    return Whiskers(places, places + chosen * deviations[:, None] * normals, deviations, counts, chosen)


def _bins(feet_mm: FloatArray, spacing_mm: float) -> IntArray:
    """Return the number of the bin of each point; points follow the curve, a new bin begins where the place leaves the old one."""
    bins = np.empty(len(feet_mm), np.int64)
    start, number = feet_mm[0], 0
    for k, foot in enumerate(feet_mm):
        if np.abs(foot - start).max() > spacing_mm:
            start, number = foot, number + 1
        bins[k] = number
    return bins
