"""How well the cameras fit together: what other cameras see of the points of a pair."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray

TRIMMED_PX = 3.0
MEDIAN_OF_CHI2 = 0.4549364  # of one degree of freedom
LARGEST_PX = 10.0


@dataclass(frozen=True, slots=True)
class PairFigures:
    """How well two cameras matched.

    The points of this pair alone are seen by the other cameras: the distance, along the epipolar line, between the point's image and
    the place with the point's phase tells how well the calibration fits the cameras as they stand. With two cameras vertical fringes
    say nothing across the epipolar lines: then both figures are None.
    """

    names: tuple[str, str]
    matched: int
    epipolar_rms_px: float | None  # rms of the distances below 3 px, phase noise included
    epipolar_px: float | None = None  # robust standard deviation of what the phase noise does not explain: the calibration's errors
    skipped: str = ""  # why the pair was not matched


def pair_figures(names: tuple[str, str], matched: int, shifts: Sequence[FloatArray]) -> PairFigures:
    """Judge a pair by samples (…, 2) of the distance in px and its variance; (0, 0) where there is none."""
    samples = np.concatenate([np.zeros((0, 2)), *(each.reshape(-1, 2) for each in shifts)]).astype(np.float64)
    off, variance = samples[samples[:, 1] > 0].T
    near = np.abs(off) < TRIMMED_PX
    if not near.any():
        return PairFigures(names, matched, None)
    return PairFigures(names, matched, float(np.sqrt(np.mean(off[near] ** 2))), unexplained_px(off, variance))


def unexplained_px(off_px: FloatArray, variance_px2: FloatArray) -> float:
    """Return the s for which half of the squares off² / (variance + s²) lie below the median of χ²; 0 where noise alone explains them."""
    low, high = 0.0, LARGEST_PX
    if np.median(off_px**2 / variance_px2) <= MEDIAN_OF_CHI2:
        return 0.0
    while high - low > 1e-4:
        middle = (low + high) / 2
        if np.median(off_px**2 / (variance_px2 + middle**2)) > MEDIAN_OF_CHI2:
            low = middle
        else:
            high = middle
    return (low + high) / 2
