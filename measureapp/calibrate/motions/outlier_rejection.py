"""Outlier rejection by leave-one-out tests: views of an axis, a hand-eye transform or a guide in which the board had moved."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TypeVar

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.sightings import rms
from measureapp.errors import CalibrationError

OUTLIER_FACTOR = 6.0  # of the median misfit, as in the joint calibration of the rig
LEAST_OUTLIER_MM = 0.05  # a misfit below is never called one
SUSPECTS = 3  # the views that fit worst, each left out once as a test
RELIEF = 1 / 3  # of the rms misfit that is left without a view which contradicts the others; noise alone leaves four fifths
MOST_REJECTED = 0.25  # of the views
MOVED = "the board pose is {misfit:.2f} mm from the joint solution: the board moved or was detected wrongly; repeat the view"
REPRESENTATIVE_MARKS_MM = 100.0 * np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]])  # marks of a board of which only poses are known

Name = TypeVar("Name")
Solution = TypeVar("Solution")
Solve = Callable[[Sequence[Name]], tuple[Solution, Mapping[Name, FloatArray]]]


def reject_outliers(
    names: Sequence[Name], solve: Solve[Name, Solution], seen_mm: Mapping[Name, FloatArray], least: int
) -> tuple[Solution, dict[Name, str]]:
    """Solve repeatedly, rejecting the view with the largest misfit each time while it is an outlier.

    Parameters
    ----------
    solve : solves from the views of these names; returns the solution and its prediction of the board's marks (M, 3) in each of them
    seen_mm : name -> observed marks (M, 3)
    least : views that a solution needs

    Returns
    -------
    the last solution, and the reason of every rejected view

    Raises
    ------
    CalibrationError
        As ``solve``.
    """
    kept, rejected = list(names), dict[Name, str]()
    while True:
        solution, placed = solve(kept)
        if len(kept) <= least or len(rejected) + 1 > MOST_REJECTED * len(names):
            return solution, rejected
        misfits = _misfits(placed, seen_mm)
        outlier = _find_outlier(kept, solve, seen_mm, misfits)
        if outlier is None:
            return solution, rejected
        rejected[outlier] = MOVED.format(misfit=misfits[outlier])
        kept.remove(outlier)


def _find_outlier(
    kept: Sequence[Name], solve: Solve[Name, Solution], seen_mm: Mapping[Name, FloatArray], misfits: Mapping[Name, float]
) -> Name | None:
    """Return the outlier: a misfit far beyond the median, or a view without which all others fit far better.

    The second test finds one at the end of an arc or a travel, which has so much leverage that its own residual is small.
    """
    ordered = sorted(misfits, key=lambda name: -misfits[name])
    median = float(np.median(list(misfits.values())))
    if misfits[ordered[0]] <= LEAST_OUTLIER_MM:
        return None
    if misfits[ordered[0]] > OUTLIER_FACTOR * median:
        return ordered[0]
    left = {}
    for name in ordered[:SUSPECTS]:
        try:
            _, placed = solve([one for one in kept if one != name])
        except CalibrationError:  # the rest does not determine the answer: no evidence against this view
            continue
        left[name] = _rms_of(_misfits(placed, seen_mm))
    best = min(left, key=lambda name: left[name], default=None)
    return best if best is not None and left[best] < RELIEF * _rms_of(misfits) else None


def _misfits(placed_mm: Mapping[Name, FloatArray], seen_mm: Mapping[Name, FloatArray]) -> dict[Name, float]:
    return {name: rms(points - seen_mm[name]) for name, points in placed_mm.items()}


def _rms_of(misfits: Mapping[Name, float]) -> float:
    return float(np.sqrt(np.mean(np.square(list(misfits.values())))))
