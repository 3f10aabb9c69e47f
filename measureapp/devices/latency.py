"""Latency of a projector that cannot report when an image is lit: measured with a camera on black and white."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.errors import DeviceError, InputError

FEWEST_FLIPS = 10
USUAL_FLIPS = 50
SETTLED = 0.05  # of the contrast: an image this close to its level is the new one
LEAST_CONTRAST = 10.0  # of the scatter of settled images
HINT_SETTLE = "Hold every level longer, and check that the camera sees the projector only."


@dataclass(frozen=True, slots=True)
class ProjectorLatency:
    """Times from the request of an image to the first exposure that sees nothing else, over all flips."""

    wait_s: float  # what to wait after each request: the largest latency and one frame
    smallest_s: float
    median_s: float
    largest_s: float
    flips: int

    @property
    def jitter_s(self) -> float:
        """Spread of the latencies; more than two frames point to a compositor or a frame interpolation."""
        return self.largest_s - self.smallest_s


def measure_latency(
    flip_times_s: FloatArray, flips_white: BoolArray, image_times_s: FloatArray, greys: FloatArray, *, exposure_s: float, frame_s: float
) -> ProjectorLatency:
    """Determine the latency of a projector from flips between black and white seen by a camera.

    The latency of a flip is the time from its request to the start of the first exposure from which on all images show the new level.
    It is never smaller than the true one, and larger by at most the time between two images.

    Parameters
    ----------
    flip_times_s : (M,) when each flip was requested, ascending; 50 are usual
    flips_white : (M,) whether a flip is to white, else to black
    image_times_s : (N,) start of each exposure by the same clock, ascending
    greys : (N,) mean grey level of each image, or of the part that the projector lights
    exposure_s : exposure of all images
    frame_s : one frame of the projector, added to the largest latency

    Raises
    ------
    InputError
        Too few flips, or times that are not ascending.
    DeviceError
        The levels do not differ, or a flip did not settle before the next.
    """
    flips, white = np.asarray(flip_times_s, float), np.asarray(flips_white, bool)
    starts, levels = np.asarray(image_times_s, float), np.asarray(greys, float)
    _check_input(flips, white, starts, levels)
    ends = np.append(flips[1:], np.inf)
    held = [np.flatnonzero((starts >= begin) & (starts + exposure_s <= end)) for begin, end in zip(flips, ends, strict=True)]
    if any(len(images) < 2 for images in held):
        raise DeviceError("Fewer than two images were taken between two flips.", "Hold every level longer, or take images more often.")
    dark, bright = _levels(held, white, levels)
    tolerance = SETTLED * (bright - dark)
    goals = np.where(white, bright, dark)
    settled = [_first_settled(levels[images], goal, tolerance) for images, goal in zip(held, goals, strict=True)]
    missed = sum(place is None for place in settled)
    if missed:
        raise DeviceError(f"{missed} of {len(flips)} flips did not settle before the next one.", HINT_SETTLE)
    first = np.array([starts[images[place]] for images, place in zip(held, settled, strict=True)])
    latencies = first - flips
    return ProjectorLatency(
        wait_s=float(latencies.max() + frame_s),
        smallest_s=float(latencies.min()),
        median_s=float(np.median(latencies)),
        largest_s=float(latencies.max()),
        flips=len(flips),
    )


def _check_input(flips: FloatArray, white: BoolArray, starts: FloatArray, levels: FloatArray) -> None:
    if flips.shape != white.shape or starts.shape != levels.shape or flips.ndim != 1 or starts.ndim != 1:
        raise InputError(
            f"There are {flips.size} times and {white.size} levels of flips, {starts.size} times and {levels.size} grey levels of images.",
            "Give one level for each time.",
        )
    if len(flips) < FEWEST_FLIPS:
        raise InputError(f"{len(flips)} flips are too few to find the largest latency.", f"Take {USUAL_FLIPS}.")
    if np.any(np.diff(flips) <= 0) or np.any(np.diff(starts) <= 0):
        raise InputError("The times of flips or images are not ascending.", "Use a monotonic clock, the same for both.")


def _levels(held: Sequence[IntArray], white: BoolArray, levels: FloatArray) -> tuple[float, float]:
    """Return the settled grey levels of black and white, from the last image of every flip. Raises DeviceError."""
    last = np.array([levels[images[-1]] for images in held])
    if white.all() or not white.any():
        raise InputError("All flips are to the same level.", "Flip between black and white.")
    dark, bright = float(np.median(last[~white])), float(np.median(last[white]))
    scatter = 1.4826 * float(np.median(np.abs(last - np.where(white, bright, dark))))
    if bright - dark <= LEAST_CONTRAST * scatter or bright <= dark:
        raise DeviceError(
            f"Black and white of the projector differ by {bright - dark:.1f} grey levels, and images of the same one scatter by {scatter:.1f}.",
            "Point the camera at what the projector lights, and shut out ambient light that flickers.",
        )
    return dark, bright


def _first_settled(levels: FloatArray, goal: float, tolerance: float) -> int | None:
    """Return the place of the first image from which on all are close to the goal; None if the last is not."""
    off = np.flatnonzero(np.abs(levels - goal) > tolerance)
    first = int(off[-1]) + 1 if len(off) else 0
    return first if first < len(levels) else None
