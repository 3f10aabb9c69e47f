"""Mean and temporal variance of pixels of equal brightness: the points a noise model is fitted to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from scipy.special import chdtri, ndtr

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.errors import CalibrationError

BINS = 24  # of brightness between black and saturation
LEAST_PIXELS = 1000
MOST_CLIPPED = 5e-4  # share of a bin's pixels that may be black or saturated
MOST_DRIFT = 0.02  # of the brightness within a level that is removed by scaling
OUTLIER = 6.0  # standard deviations
LEAST_SPREAD = 3.0  # grey levels that the means of a bin must cover for rounding to be even, where noise is low
LOW_NOISE = 0.45  # grey levels; above it rounding is even anyway


@dataclass(frozen=True, slots=True)
class TransferPoint:
    """Pixels of one brightness."""

    mean: float  # grey levels
    variance: float  # temporal, grey levels²
    variance_sd: float
    pixels: int


def points_of_flats(levels: Sequence[ImageArray], saturation: float, camera: str, step_grey: float) -> list[TransferPoint]:
    """Return the points of levels of repeated images, (n ≥ 2, H, W) each; bins with black or saturated pixels give none.

    Raises
    ------
    CalibrationError
        A level has a single image, or images whose brightness differs by more than 2 %.
    """
    points: list[TransferPoint] = []
    for number, images in enumerate(levels):
        if len(images) < 2:
            raise CalibrationError(
                f"Brightness level {number + 1}{_of(camera)} has a single image.", "Take at least two images of every brightness."
            )
        mean, variance, usable = _temporal(images, saturation, number, camera)
        points += bin_pixels(mean, variance, len(images) - 1, usable, _bin_numbers(images, saturation, step_grey))
    return points


def _of(camera: str) -> str:
    return f" of camera {camera!r}" if camera else ""


def _temporal(images: ImageArray, saturation: float, number: int, camera: str) -> tuple[FloatArray, FloatArray, BoolArray]:
    """Return mean and temporal variance of every pixel, and whether it is neither black nor saturated, each (H·W,).

    Brightness is equalised first: for the scale s of an image its noise is scaled too, which at 2 % is left alone.
    """
    usable = np.asarray((images.max(axis=0) < saturation) & (images.min(axis=0) > 0)).ravel()
    count = len(images)
    total = np.zeros(usable.shape)
    square = np.zeros(usable.shape)
    reference = images[0].ravel().astype(np.float64)
    for other in images:
        grey = other.ravel().astype(np.float64)
        grey = grey / _scale(grey, reference, usable, number, camera)
        total += grey - reference
        square += (grey - reference) ** 2
    variance = np.maximum(square - total**2 / count, 0.0) / (count - 1)
    return reference + total / count, variance, usable


def _scale(grey: FloatArray, reference: FloatArray, usable: BoolArray, number: int, camera: str) -> float:
    own, first = float(grey[usable].sum()), float(reference[usable].sum())
    if first <= 0:
        return 1.0
    drift = own / first - 1
    step = first / max(1, usable.sum())
    if abs(drift) * step > MOST_DRIFT * step + 0.5:
        raise CalibrationError(
            f"The images of brightness level {number + 1}{_of(camera)} differ by {abs(drift):.1%} in brightness.",
            "Use a steady lamp (exposures of whole mains periods) and group images of one exposure.",
        )
    return 1.0 + drift if abs(drift) < MOST_DRIFT else 1.0


def bin_pixels(mean: FloatArray, variance: FloatArray, freedom: int, usable: BoolArray, number: IntArray) -> list[TransferPoint]:
    """Gather pixels by bin ``number``; bins with too few or too many clipped pixels give no point. All arrays (pixels,)."""
    points = []
    for chosen in _bins(number):
        kept = chosen[usable[chosen]]
        if len(kept) < LEAST_PIXELS or len(kept) < (1 - MOST_CLIPPED) * len(chosen):
            continue
        point = point_of(mean[kept], variance[kept], freedom)
        narrow = np.ptp(np.percentile(mean[kept], [5, 95])) < LEAST_SPREAD
        if not (narrow and point.variance < LOW_NOISE**2):
            points.append(point)
    return points


def _bin_numbers(images: ImageArray, saturation: float, step_grey: float) -> IntArray:
    """Return the bin of every pixel by its mean, with edges midway between two grey levels.

    A pair that differs by one level has its mean there. All of them on one side would give that bin more than its
    share of unequal pairs, so they go by turns: to the side of the first image.
    """
    mean = images.mean(axis=0, dtype=np.float64).ravel()
    edges = np.unique((np.floor(np.linspace(0, saturation, BINS + 1)[1:-1] / step_grey) + 0.5) * step_grey)
    return np.searchsorted(edges, mean + np.where(images[0].ravel() > mean, 1e-6, -1e-6))


def _bins(number: IntArray) -> Iterator[IntArray]:
    order = np.argsort(number, kind="stable")
    edges = np.searchsorted(number[order], np.arange(number.max() + 2))
    for start, stop in pairwise(edges):
        if stop > start:
            yield order[start:stop]


def point_of(mean: FloatArray, variance: FloatArray, freedom: int) -> TransferPoint:
    """Gather pixels of similar mean; single pixels far from all others (defects, something that moved) are rejected.

    Parameters
    ----------
    variance : (n,) estimates of the variance of each pixel
    freedom : degrees of freedom of each estimate
    """
    kept = np.ones(len(variance), bool)
    for _ in range(3):
        level = float(variance[kept].mean())
        kept = variance <= level * _largest_share(freedom)
    chosen = variance[kept]
    count = len(chosen)
    return TransferPoint(float(mean[kept].mean()), float(chosen.mean()), float(chosen.std(ddof=1)) / count**0.5 + 1e-12, count)


def _largest_share(freedom: int) -> float:
    """Return how many times its expectation a variance of ``freedom`` degrees may be: 6 standard deviations for a difference."""
    return float(chdtri(freedom, 2 * ndtr(-OUTLIER)) / freedom)
