"""Compiled loop that takes from the phase by how far blur has shifted it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.options import LOOP

REACH = 2  # px to either side, over which slopes are taken: noise of the phase hardly grows by it, and the blur reaches no further
STEEPEST = np.float32(0.3)  # of the logarithm of the light per px; beyond, at edges, the first order says nothing
SPAN = np.float32(2 * REACH)
ONE, TWO, ZERO = np.float32(1), np.float32(2), np.float32(0)
VALID = 0


@njit(**LOOP)
def take_blur(phase: Any, grey: Any, state: Any, variance: Any, step: Any, row_start: int, row_stop: int, out: Any) -> None:
    """Write the phase (H, W) of some rows as it were without blur of ``variance`` px²; what has no neighbours within ``step`` rad stays."""
    height, width = phase.shape
    steepest, farthest = STEEPEST * SPAN, step * SPAN
    for y in range(row_start, row_stop):
        own, made, valid = phase[y], out[y], state[y]
        for x in range(width):
            made[x] = own[x]
        if y < REACH or y >= height - REACH:
            continue
        above, below, light_above, light_below = phase[y - REACH], phase[y + REACH], grey[y - REACH], grey[y + REACH]
        valid_above, valid_below, light = state[y - REACH], state[y + REACH], grey[y]
        for x in range(REACH, width - REACH):
            across = own[x + REACH] - own[x - REACH]
            down = below[x] - above[x]
            right, left = np.float32(light[x + REACH]), np.float32(light[x - REACH])
            low, high = np.float32(light_below[x]), np.float32(light_above[x])
            rise_across = TWO * (right - left) / (right + left + ONE)
            rise_down = TWO * (low - high) / (low + high + ONE)
            whole_across = (
                (valid[x + REACH] == VALID) & (valid[x - REACH] == VALID) & (abs(rise_across) < steepest) & (abs(across) < farthest)
            )
            whole_down = (valid_below[x] == VALID) & (valid_above[x] == VALID) & (abs(rise_down) < steepest) & (abs(down) < farthest)
            shift = (across * rise_across if whole_across else ZERO) + (down * rise_down if whole_down else ZERO)
            made[x] -= variance * shift / (SPAN * SPAN) if valid[x] == VALID else ZERO
