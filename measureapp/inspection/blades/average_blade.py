"""The average blade of a part, how far each blade is turned against it, and what then remains."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.inspection.blades.profile import Profile, fit_profile
from measureapp.inspection.blades.section_frame import SectionFrame

ROUNDS = 3
STEPS = 4
POOLED = 12_000
STRAY = 10.0  # median absolute deviations


@dataclass(frozen=True, slots=True, eq=False)
class AverageComparison:
    """One blade against the average of all."""

    turn_rad: float  # by which it stands ahead of its even place, about the axis
    turn_sigma_rad: float  # from the scatter of its points, as if they erred independently
    lengths_mm: FloatArray  # (K,), of its side points, along the mean line
    upper: BoolArray  # (K,), on which side
    deviations_mm: FloatArray  # (K,), outside the average blade is positive, once turned onto it
    on_side: IntArray  # (K,), indices of the points


def compare_with_average(blades: list[FloatArray], frame: SectionFrame) -> list[AverageComparison]:
    """Compare blades with their average.

    The points of all blades are turned onto each other about the axis, and one profile is laid through them; then each
    blade is turned onto that anew.

    Parameters
    ----------
    blades : points (N, 3) of each blade, turned back to the first
    """
    turns = np.zeros(len(blades))
    found: list[AverageComparison] = []
    for _ in range(ROUNDS):
        turned = [frame.rotate(points, -turn) for points, turn in zip(blades, turns, strict=True)]
        flat = np.vstack([frame.flatten(points) for points in turned])
        average = fit_profile(flat[:: max(1, len(flat) // POOLED)], frame.shape)
        found = [_compare(points, frame, average) for points in blades]
        turns = np.array([one.turn_rad for one in found])
        turns -= turns.mean()
    return found


def _compare(points_mm: FloatArray, frame: SectionFrame, average: Profile) -> AverageComparison:
    turn = 0.0
    for _ in range(STEPS):
        moved = frame.rotate(points_mm, -turn)
        on_side, lengths, upper, off, normals = _offsets(frame.flatten(moved), average)
        effect = np.einsum("nd,nd->n", frame.effect_of_turn(moved[on_side]), normals)
        sure = _not_stray(off)
        turn += float(effect[sure] @ off[sure] / (effect[sure] @ effect[sure]))
    moved = frame.rotate(points_mm, -turn)
    on_side, lengths, upper, off, _ = _offsets(frame.flatten(moved), average)
    sigma = float(np.std(off[sure]) / np.linalg.norm(effect[sure]))
    return AverageComparison(turn, sigma, lengths, upper, np.where(upper, off, -off), on_side)


def _not_stray(off_mm: FloatArray) -> BoolArray:
    """Which points may say how far a blade is turned; what they show of its form stays."""
    apart = np.abs(off_mm - np.median(off_mm))
    return np.asarray(apart <= STRAY * np.median(apart))


def _offsets(flat_mm: FloatArray, average: Profile) -> tuple[IntArray, FloatArray, BoolArray, FloatArray, FloatArray]:
    """Which points lie on the sides, where, and how far along the mean line's normals from the average's side."""
    x, heights = average.line.feet(flat_mm)
    on_side = np.flatnonzero((x > average.line.first_mm) & (x < average.line.last_mm))
    lengths = average.line.lengths(x)[on_side]
    above, below = average.sides.heights(lengths)
    upper = heights[on_side] > 0
    off = heights[on_side] - np.where(upper, above, below)
    return on_side, lengths, upper, off, average.line.normals(x[on_side])
