"""Compiled loops that say which pixels of a camera are still to be matched: not those near to ones that take part in points already."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.data.point_state import PointState

NO_PHASE, SEEN_BY_ANOTHER, RIM = np.uint8(PointState.NO_PHASE), np.uint8(PointState.SEEN_BY_ANOTHER), np.uint8(PointState.RIM)
RADIUS_PX = 2  # gaps between the pixels that take part in points of another camera
NOTHING = np.uint8(0)


@njit(**INLINE)
def unless_without_phase(state: Any, otherwise: Any) -> Any:
    """Return why a pixel has no phase, or ``otherwise`` where it has one."""
    without = RIM if state == RIM else NO_PHASE
    return without if state != NOTHING else otherwise


@njit(**LOOP)
def mark_without_phase(state: Any, row_start: int, row_stop: int, marked: Any) -> None:
    """Mark pixels without a phase, as `mark_covered` does where nothing is covered."""
    for y in range(row_start, row_stop):
        out, valid = marked[y], state[y]
        for x in range(len(out)):
            out[x] = unless_without_phase(valid[x], NOTHING)


@njit(**LOOP)
def mark_covered(
    state: Any,  # (H, W) uint8, 0 for pixels with a phase, RIM at rims
    covered: Any,  # (H, W) uint8, 1 for pixels that take part in points of another camera
    sample: int,  # at every so many pixels only the pixel itself counts, or nothing where `sampled` is 0
    sampled: Any,  # uint8, 1 or 0
    uncovered: Any,  # uint8, what is written for all others
    row_start: int,
    row_stop: int,
    marked: Any,  # out (H, W) uint8: NO_PHASE, SEEN_BY_ANOTHER, RIM or `uncovered`
) -> None:
    """Mark pixels without a phase, and those within RADIUS_PX of a covered one."""
    height, width = state.shape
    for y in range(row_start, row_stop):
        out, valid = marked[y], state[y]
        out[:] = NOTHING
        for v in range(max(y - RADIUS_PX, 0), min(y + RADIUS_PX + 1, height)):
            near = covered[v]
            for shift in range(-RADIUS_PX, RADIUS_PX + 1):
                low, high = max(-shift, 0), width - max(shift, 0)
                into, of = out[low:high], near[low + shift : high + shift]
                for x in range(high - low):
                    into[x] |= of[x]
        if y % sample == 0:
            for x in range(0, width, sample):
                out[x] = covered[y, x] & sampled
        for x in range(width):
            out[x] = unless_without_phase(valid[x], SEEN_BY_ANOTHER if out[x] != NOTHING else uncovered)
