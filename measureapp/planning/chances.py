"""Chance that a surface point predicted to be visible is measured, learnt from a scan."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, read_only

INCIDENCE_DEG = (30.0, 45.0, 60.0)  # borders of the classes of incidence
GREY = (0.15, 0.7)  # borders of the classes of grey level over saturation: dark, usual, bright
PRIOR_POINTS = 20.0  # how many points the mean over all classes counts as in each
LEAST_TRIED = 2  # views that a point must have been visible from to tell whether it can be measured at all


@dataclass(frozen=True, slots=True, eq=False)
class Chances:
    """Chance of a measurement by classes of incidence and grey level, and the share of points that nothing measures."""

    table: FloatArray  # (I, G), of points that can be measured
    hopeless: float  # share of visible points that no view measures, whatever its direction

    def __post_init__(self) -> None:
        object.__setattr__(self, "table", read_only(self.table, np.float64, (len(INCIDENCE_DEG) + 1, len(GREY) + 1)))

    @classmethod
    def learn(cls, visible: BoolArray, measured: BoolArray, incidence_deg: FloatArray, grey: FloatArray) -> Chances:
        """Learn from V views of N points.

        Parameters
        ----------
        visible, measured : (V, N), predicted to be visible; measured by this view
        incidence_deg : (V, N), between the normal and the direction to the head
        grey : (N,), over saturation, of the point or its measured surroundings
        """
        tried = visible.sum(axis=0)
        often = tried >= LEAST_TRIED
        never = often & ~(visible & measured).any(axis=0)
        hopeless = (float(never.sum()) + 1.0) / (float(often.sum()) + PRIOR_POINTS)
        counted = visible & ~never
        rows, columns = _incidence_class(incidence_deg), np.broadcast_to(grey_class(grey), visible.shape)
        shape = (len(INCIDENCE_DEG) + 1, len(GREY) + 1)
        seen, good = np.zeros(shape), np.zeros(shape)
        np.add.at(seen, (rows[counted], columns[counted]), 1.0)
        np.add.at(good, (rows[counted], columns[counted]), measured[counted])
        usual = (good.sum() + 1.0) / (seen.sum() + 2.0)
        return cls((good + PRIOR_POINTS * usual) / (seen + PRIOR_POINTS), min(hopeless, 1.0))

    def of(self, incidence_deg: FloatArray, grey: FloatArray, failures: FloatArray) -> FloatArray:
        """Return the chance (V, N) that views measure points which ``failures`` (N,) views did not although they were visible.

        Each failure makes it more likely that a point is one of those that nothing measures (Bayes' rule).
        """
        fits = self.table[_incidence_class(incidence_deg), np.broadcast_to(grey_class(grey), incidence_deg.shape)]
        usual = self.table[:, grey_class(grey)].mean(axis=0)
        alive = (1.0 - self.hopeless) * (1.0 - usual) ** failures
        return np.asarray(fits * (alive / np.maximum(alive + self.hopeless, 1e-12)))


def grey_class(grey: FloatArray) -> IntArray:
    """Return the class of each grey level: 0 dark, 1 usual, 2 bright."""
    return np.searchsorted(GREY, grey).astype(np.intp)


def _incidence_class(incidence_deg: FloatArray) -> IntArray:
    return np.searchsorted(INCIDENCE_DEG, incidence_deg).astype(np.intp)
