"""Colours of points: by view, by predicted σ, by residual, by grey."""

from __future__ import annotations

import numpy as np

# Blue – pale – red (diverging) and dark blue – teal – yellow (sequential), as nodes of a linear interpolation.
GROWING = np.array([[38, 24, 95], [33, 96, 140], [31, 150, 139], [104, 198, 96], [240, 228, 66]], float)
DIVERGING = np.array([[33, 82, 165], [110, 160, 215], [244, 244, 244], [230, 130, 110], [178, 24, 43]], float)
UNKNOWN = np.array([140, 147, 151], np.uint8)  # not measured; the 3-D view draws it hatched
HATCH_SHADE = 0.62  # of the dark stripes


def along(scale: np.ndarray, values: np.ndarray, low: float, high: float) -> np.ndarray:
    """Map values to colours (N, 3) uint8 of a scale; non-finite values are grey."""
    span = high - low if high > low else 1.0
    place = np.clip((np.nan_to_num(np.asarray(values, float)) - low) / span, 0.0, 1.0) * (len(scale) - 1)
    supports = np.arange(len(scale))
    colours = np.stack([np.interp(place, supports, scale[:, channel]) for channel in range(3)], axis=-1).astype(np.uint8)
    colours[~np.isfinite(values)] = UNKNOWN
    return colours


def plain(colour: tuple[int, int, int], count: int) -> np.ndarray:
    """Return one colour for all points."""
    return np.tile(np.array(colour, np.uint8), (count, 1))


def by_grey(grey: np.ndarray) -> np.ndarray:
    """Map grey levels (0…1) to colours, stretched to their range."""
    high = float(np.percentile(grey, 98)) if len(grey) else 1.0
    level = (55 + 200 * np.clip(grey / max(high, 1e-6), 0.0, 1.0)).astype(np.uint8)
    return np.repeat(level[:, None], 3, axis=1)


def upper_end(values: np.ndarray) -> float:
    """Return a round upper limit of a scale that covers 95 % of the values."""
    finite = values[np.isfinite(values)]
    if not len(finite):
        return 1.0
    wanted = max(float(np.percentile(finite, 95)), 1e-4)
    power = 10.0 ** np.floor(np.log10(wanted))
    return float(next(step * power for step in (1, 2, 5, 10) if step * power >= wanted))
