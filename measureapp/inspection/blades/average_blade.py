"""Average blade of a part, and the rotation and form deviation of each blade against it."""

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
    """Deviation of one blade from the average of all."""

    turn_rad: float  # rotation about the axis from its equally spaced position
    turn_sigma_rad: float  # from the scatter of its points, without correlation
    lengths_mm: FloatArray  # (K,), of its side points, along the mean line
    upper: BoolArray  # (K,), on the upper side
    deviations_mm: FloatArray  # (K,), positive outside the average blade, after rotation onto it
    on_side: IntArray  # (K,), indices of the points


def compare_with_average(blades: list[FloatArray], frame: SectionFrame) -> list[AverageComparison]:
    """Compare blades with their average.

    The points of all blades are rotated onto each other about the axis, and one profile is fitted; then each blade is rotated onto it,
    iteratively.

    Parameters
    ----------
    blades : points (N, 3) of each blade, rotated to the first
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
    """Return the points used for the rotation of a blade; for its form all points count."""
    apart = np.abs(off_mm - np.median(off_mm))
    return np.asarray(apart <= STRAY * np.median(apart))


def _offsets(flat_mm: FloatArray, average: Profile) -> tuple[IntArray, FloatArray, BoolArray, FloatArray, FloatArray]:
    """Return side points: indices, arc lengths, side, offsets from the average's side along the mean line's normals, and these normals."""
    x, heights = average.line.feet(flat_mm)
    on_side = np.flatnonzero((x > average.line.first_mm) & (x < average.line.last_mm))
    lengths = average.line.lengths(x)[on_side]
    above, below = average.sides.heights(lengths)
    upper = heights[on_side] > 0
    off = heights[on_side] - np.where(upper, above, below)
    return on_side, lengths, upper, off, average.line.normals(x[on_side])
