"""How far a table or a guide was moved, and where positions are missing."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

WIDE_GAP = 0.4  # of the whole span; a wider gap between two positions is worth one more between them


def widest_gap(positions: Sequence[float]) -> tuple[float, float] | None:
    """Return the ends of a gap between neighbouring positions that is too wide; None where there is none or fewer than four."""
    ordered = sorted(positions)
    if len(ordered) < 4:
        return None
    start, end = max(pairwise(ordered), key=lambda pair: pair[1] - pair[0])
    return (start, end) if end - start > WIDE_GAP * (ordered[-1] - ordered[0]) else None


def next_position(positions: Sequence[float], span: float) -> float:
    """Return where the next position adds most: within a gap, otherwise beyond the end that is nearer to zero."""
    gap = widest_gap(positions)
    if gap is not None:
        return (gap[0] + gap[1]) / 2
    low, high = min(positions), max(positions)
    step = max((span - (high - low)) / 2, span / 8)
    return high + step if abs(high) <= abs(low) else low - step


def span_of(positions: Sequence[float]) -> float:
    """Return largest less smallest; 0 without any."""
    return float(np.ptp(positions)) if len(positions) else 0.0
