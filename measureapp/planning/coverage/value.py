"""The value of a set of viewpoints: what it sees and how well; monotone and submodular."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.sparse import csc_matrix

from measureapp.arrays import BoolArray, FloatArray, IntArray

COVER_SHARE = 0.85  # of the value of a sample that one sufficient view of it has; the rest grows with the information


@dataclass(frozen=True, slots=True, eq=False)
class Problem:
    """V candidates, N samples, and how much is required.

    Without a required standard deviation, a sample is covered when it is seen; its value is 0.85 for that and up to 0.15 for its information
    ``Σ 1/σ²``, relative to that of the median view. With a requirement, coverage and value are both ``min(1, Σ 1/σ² · σ_required²)``, so
    that further views pay until it is reached. Where places are to be seen ``views`` times, coverage and value are both the number of views over
    that, at most 1.
    """

    weights: FloatArray  # (V, N) float32, 1/σ² relative to the wanted information; 0: not seen
    areas: FloatArray  # (N,), sum 1
    station: IntArray  # (V,)
    cover_share: float  # 0 if a σ is required
    rows: tuple[IntArray, ...] = field(repr=False)  # of each candidate, the samples it sees
    _sparse: Any = field(repr=False)  # the weights, in compressed columns

    @classmethod
    def of(cls, sigma_mm: FloatArray, areas_mm2: FloatArray, station: IntArray, required_mm: float | None) -> Problem:
        """Build from the standard deviations (V, N), NaN where not seen; without a requirement, the median σ is wanted."""
        wanted = required_mm if required_mm is not None else _median(sigma_mm)
        weights = np.where(np.isnan(sigma_mm), 0.0, np.square(wanted / sigma_mm))
        return cls._of_weights(weights, areas_mm2, station, COVER_SHARE if required_mm is None else 0.0)

    @classmethod
    def of_views(cls, sigma_mm: FloatArray, areas_mm2: FloatArray, station: IntArray, views: int) -> Problem:
        """Build for places that are to be seen by several viewpoints, from the standard deviations (V, N), NaN where not seen."""
        return cls._of_weights(np.isfinite(sigma_mm) / views, areas_mm2, station, 0.0)

    @classmethod
    def _of_weights(cls, weights: FloatArray, areas_mm2: FloatArray, station: IntArray, share: float) -> Problem:
        weights = weights.astype(np.float32)
        rows = tuple(np.flatnonzero(row) for row in weights)
        areas = areas_mm2 / max(float(areas_mm2.sum()), 1e-300)
        return cls(weights, areas, station, share, rows, csc_matrix(weights, dtype=np.float64))

    def total(self, chosen: IntArray | list[int]) -> float:
        """Return the value of a set of candidates."""
        return float(self.areas @ self._of(self.weights[chosen].sum(axis=0)))

    def gain(self, candidate: int, information: FloatArray) -> float:
        """Return what a candidate adds to samples that have ``information`` (N,) already."""
        rows = self.rows[candidate]
        before = information[rows]
        return float(self.areas[rows] @ (self._of(before + self.weights[candidate, rows]) - self._of(before)))

    def covered(self, information: FloatArray) -> FloatArray:
        """Return how far each sample is covered, 0…1."""
        return (information > 0.0).astype(float) if self.cover_share else np.minimum(information, 1.0)

    def covered_area(self, information: FloatArray) -> float:
        """Return the covered share of all areas."""
        return float(self.areas @ self.covered(information))

    def covered_with(self, information: FloatArray) -> FloatArray:
        """Return the covered share of all areas with each candidate added, (V,)."""
        missing = 1.0 - self.covered(information)
        rows = np.flatnonzero(missing > 0.0)
        added = self._sparse[:, rows]
        most = np.repeat(missing[rows], np.diff(added.indptr))
        added.data = most if self.cover_share else np.minimum(added.data, most)
        return np.asarray(self.covered_area(information) + added @ self.areas[rows])

    def information(self, chosen: IntArray | list[int]) -> FloatArray:
        """Return the information (N,) of a set of candidates."""
        return np.asarray(self.weights[chosen].sum(axis=0, dtype=np.float64))

    def overlap(self, candidate: int, seen: BoolArray) -> float:
        """Return the share of the area seen by a candidate that is in ``seen`` (N,), too."""
        rows = self.rows[candidate]
        area = self.areas[rows]
        return float(area[seen[rows]].sum() / max(float(area.sum()), 1e-300))

    def _of(self, information: FloatArray) -> FloatArray:
        quality = (1.0 - self.cover_share) * np.minimum(information, 1.0)
        return quality + self.cover_share * (information > 0.0) if self.cover_share else quality


def _median(sigma_mm: FloatArray) -> float:
    seen = sigma_mm[np.isfinite(sigma_mm)]
    return float(np.median(seen)) if len(seen) else 1.0
