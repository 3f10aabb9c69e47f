"""Colours of points: by view, by predicted σ, by residual, by grey."""

from __future__ import annotations

import numpy as np

UNKNOWN = np.array([140, 147, 151], np.uint8)  # not measured; the 3-D view draws it hatched
HATCH_SHADE = 0.62  # of the dark stripes


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
