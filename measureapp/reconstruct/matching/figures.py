"""How well the cameras of a pair fit together, from what other cameras measure of their points."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray

TRIMMED_PX = 3.0
MIN_SAMPLES = 30  # below, the median's error is a fifth of the scatter and more, and a few wrong points decide it
MEDIAN_OF_CHI2 = 0.4549364  # of one degree of freedom
MEDIAN_ERROR = 1.2533141  # standard error of the median of normal values, in standard deviations over √N
CHI2_MEDIAN_ERROR = 1.0611  # standard error of the median of χ² of one degree of freedom, times √N
SIGNIFICANT = 2.0  # standard errors
MAX_PX = 10.0


@dataclass(frozen=True, slots=True)
class PairFigures:
    """How well two cameras matched.

    Other cameras observe the points of this pair: the distance, along the epipolar line, between the point's image and the place with the
    point's phase shows how well the calibration fits the present position of the cameras. With two cameras, fringes of one direction do not
    show it: the match absorbs any error along the epipolar line, and nothing is measured across it. With fringes of both directions each pair is
    tested by itself, across its epipolar lines, and for two cameras `epipolar_px` and `epipolar_rms_px` are of that.
    """

    names: tuple[str, str]
    matched: int
    epipolar_rms_px: float | None  # rms of the distances below 3 px, phase noise included; None without enough samples
    epipolar_px: float | None = None  # robust size of what the phase noise does not explain: errors of the calibration
    across_px: float | None = None  # the same across the epipolar lines, from orthogonal fringes; None without them
    skipped: str = ""  # reason why the pair was not matched


def evaluate_pair(names: tuple[str, str], matched: int, shifts: Sequence[FloatArray], across: FloatArray | None = None) -> PairFigures:
    """Evaluate samples (…, 2) of the distance in px and its variance, along and across the epipolar lines; (0, 0) for none.

    With fewer samples than MIN_SAMPLES the figures of that direction are None.
    """
    off, variance = _samples(shifts)
    off_across, variance_across = _samples([] if across is None else [across])
    across_px = unexplained_px(off_across, variance_across) if len(off_across) else None
    if not len(off):  # no third camera: the distance of the images from each other's epipolar lines remains
        off, variance = off_across, variance_across
    near = np.abs(off) < TRIMMED_PX
    if not near.any():
        return PairFigures(names, matched, None, across_px=across_px)
    return PairFigures(names, matched, float(np.sqrt(np.mean(off[near] ** 2))), unexplained_px(off, variance), across_px)


def _samples(shifts: Sequence[FloatArray]) -> tuple[FloatArray, FloatArray]:
    joined = np.concatenate([np.zeros((0, 2)), *(each.reshape(-1, 2) for each in shifts)]).astype(np.float64)
    known = joined[joined[:, 1] > 0]
    off, variance = (known if len(known) >= MIN_SAMPLES else known[:0]).T
    return off, variance


def unexplained_px(off_px: FloatArray, variance_px2: FloatArray) -> float:
    """Return the size of the distances beyond their noise: of their median and of their scatter, each 0 where noise explains it.

    The scatter is the s for which half of the squares off² / (variance + s²) lie below the median m of χ². A square lies below where
    off² / m − variance lies below s²: s² is the median of these.
    """
    middle_off, count = float(np.median(off_px)), len(off_px)
    if abs(middle_off) <= SIGNIFICANT * MEDIAN_ERROR * float(np.sqrt(np.median(variance_px2) / count)):
        middle_off = 0.0
    squares = (off_px - middle_off) ** 2
    if np.median(squares / variance_px2) <= MEDIAN_OF_CHI2 + SIGNIFICANT * CHI2_MEDIAN_ERROR / np.sqrt(count):
        return abs(middle_off)
    scatter2 = float(np.clip(np.median(squares / MEDIAN_OF_CHI2 - variance_px2), 0.0, MAX_PX**2))
    return float(np.hypot(middle_off, np.sqrt(scatter2)))
