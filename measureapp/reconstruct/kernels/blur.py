"""Compiled loops that take from the phase by how far blur has shifted it."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.options import INLINE, LOOP

REACH = 2  # px to either side, over which slopes are taken: noise of the phase hardly grows by it, and the blur reaches no further
STEEPEST = np.float32(0.3)  # of the logarithm of the light per px; beyond, at edges, the first order says nothing
SPAN = np.float32(2 * REACH)
NEAR, FAR = 2, 6  # px to either side, over which bends are taken; over the far ones they cost 3 % in noise
FAR_SQUARED, RATIO = np.float32(FAR * FAR), np.float32((FAR / NEAR) ** 2)  # of an even bend over both
ALIKE, ALIKE_SIGMAS = np.float32(0.25), np.float32(41)  # two standard deviations of how far both bends are apart
ONE, TWO, HALF, ZERO = np.float32(1), np.float32(2), np.float32(0.5), np.float32(0)
VALID = 0


@njit(**INLINE)
def take_slope(phase: Any, grey: Any, state: Any, y: int, variance: Any, step: Any, made: Any) -> None:
    """Take from a row what comes of light that changes across the image: s² ∇φ · ∇ ln I."""
    width, own, valid, light = phase.shape[1], phase[y], state[y], grey[y]
    above, below, light_above, light_below = phase[y - REACH], phase[y + REACH], grey[y - REACH], grey[y + REACH]
    valid_above, valid_below = state[y - REACH], state[y + REACH]
    steepest, farthest = STEEPEST * SPAN, step * SPAN
    for x in range(REACH, width - REACH):
        across = own[x + REACH] - own[x - REACH]
        down = below[x] - above[x]
        right, left = np.float32(light[x + REACH]), np.float32(light[x - REACH])
        low, high = np.float32(light_below[x]), np.float32(light_above[x])
        rise_across = TWO * (right - left) / (right + left + ONE)
        rise_down = TWO * (low - high) / (low + high + ONE)
        whole_across = (valid[x + REACH] == VALID) & (valid[x - REACH] == VALID) & (abs(rise_across) < steepest) & (abs(across) < farthest)
        whole_down = (valid_below[x] == VALID) & (valid_above[x] == VALID) & (abs(rise_down) < steepest) & (abs(down) < farthest)
        shift = (across * rise_across if whole_across else ZERO) + (down * rise_down if whole_down else ZERO)
        made[x] -= variance * shift / (SPAN * SPAN) if valid[x] == VALID else ZERO


@njit(**INLINE)
def take_bend(own: Any, noise: Any, valid: Any, sides: Any, variance: Any, n: int, made: Any) -> None:
    """Take from n pixels what comes of a phase that bends along one direction: s² φ'' / 2, where it bends evenly.

    ``sides`` are phases and states, both far before, near before, near behind and far behind.
    """
    far_before, near_before, near_behind, far_behind = sides[0]
    no_far_before, no_near_before, no_near_behind, no_far_behind = sides[1]
    for x in range(n):
        far = far_before[x] + far_behind[x] - TWO * own[x]
        near = RATIO * (near_before[x] + near_behind[x] - TWO * own[x])
        missing = valid[x] | no_far_before[x] | no_near_before[x] | no_near_behind[x] | no_far_behind[x]
        even = (missing == VALID) & (abs(far - near) <= ALIKE * abs(far) + ALIKE_SIGMAS * noise[x])
        made[x] -= HALF * variance * far / FAR_SQUARED if even else ZERO


@njit(**INLINE)
def beside(row: Any, n: int) -> Any:
    """Return n pixels FAR and NEAR to the left, NEAR and FAR to the right of those from FAR on."""
    return row[:n], row[FAR - NEAR : FAR - NEAR + n], row[FAR + NEAR : FAR + NEAR + n], row[2 * FAR : 2 * FAR + n]


@njit(**INLINE)
def above_and_below(image: Any, y: int) -> Any:
    """Return the rows FAR and NEAR above, NEAR and FAR below."""
    return image[y - FAR], image[y - NEAR], image[y + NEAR], image[y + FAR]


@njit(**LOOP)
def take_blur(
    phase: Any,  # (H, W) float32
    sigma: Any,  # (H, W) float32
    grey: Any,  # (H, W) uint16
    state: Any,  # (H, W) uint8, 0 valid
    variance: Any,  # float32, of the blur, px²
    step: Any,  # float32, largest phase step between neighbours of one surface
    row_start: int,
    row_stop: int,
    out: Any,  # (H, W) float32
) -> None:
    """Write the phase of some rows as it were without blur; what has no neighbours on its surface stays."""
    height, width = phase.shape
    inner = width - 2 * FAR
    for y in range(row_start, row_stop):
        made, own, noise, valid = out[y], phase[y], sigma[y], state[y]
        for x in range(width):
            made[x] = own[x]
        if REACH <= y < height - REACH:
            take_slope(phase, grey, state, y, variance, step, made)
        if inner > 0:
            part = slice(FAR, FAR + inner)
            take_bend(own[part], noise[part], valid[part], (beside(own, inner), beside(valid, inner)), variance, inner, made[part])
        if FAR <= y < height - FAR:
            take_bend(own, noise, valid, (above_and_below(phase, y), above_and_below(state, y)), variance, width, made)
