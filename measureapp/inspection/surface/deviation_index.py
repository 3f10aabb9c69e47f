"""Neighbours of the points of a deviation, prepared once for probes, extremes and smoothing."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import FloatArray, IntArray
from measureapp.inspection.surface.deviation import Deviation

SAMPLES, NEAREST = 2_000, 6
SAME_SIDE = 0.5  # least cosine between nominal normals: not the opposite face of a thin wall
MAD_TO_SIGMA = 1.4826


@dataclass(frozen=True, eq=False)
class DeviationIndex:
    """Search structure over the compared points of one deviation."""

    found: Deviation

    @property
    def tree(self) -> cKDTree:
        """Search tree of the points."""
        return self.found.tree

    @cached_property
    def spacing_mm(self) -> float:
        """Typical distance of neighbouring points on the surface."""
        return float(np.median(self._sample[0][:, -1]) * np.sqrt(np.pi / NEAREST))

    @cached_property
    def noise_mm(self) -> float:
        """Standard deviation of single deviations from those beside them, robust."""
        _, near, own = self._sample
        off = self.found.distances_mm[own] - np.median(self.found.distances_mm[near], axis=1)
        return MAD_TO_SIGMA * float(np.median(np.abs(off)))

    @cached_property
    def _sample(self) -> tuple[FloatArray, IntArray, IntArray]:
        """Distances and indices (S, K) of the neighbours of some points, and the indices of these (S,)."""
        count = len(self.found.points_mm)
        own = np.arange(0, count, -(-count // SAMPLES))
        nearest = min(NEAREST + 1, count)
        away, near = self.tree.query(self.found.points_mm[own], k=nearest)
        return away.reshape(len(own), -1)[:, 1:] if nearest > 1 else np.zeros((len(own), 1)), near.reshape(len(own), -1), own

    def neighbours(self, places_mm: FloatArray, normals: FloatArray, most: int, radius_mm: float) -> tuple[IntArray, FloatArray]:
        """Return indices and weights (N, K) of the points near places: 1 within the radius on the same side, otherwise 0."""
        count = min(most, len(self.found.points_mm))
        away, near = self.tree.query(places_mm, k=count, distance_upper_bound=radius_mm, workers=-1)
        away, near = away.reshape(len(places_mm), -1), near.reshape(len(places_mm), -1)
        within = np.isfinite(away)
        near = np.where(within, near, 0)
        within &= np.einsum("nkd,nd->nk", self.found.nominal_normals[near], normals) > SAME_SIDE
        return near, within.astype(np.float64)
