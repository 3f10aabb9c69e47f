"""Gradients of a phase map: the record of every pixel, and the state of four neighbouring pixels."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.reconstruct.kernels.structures import (
    CONTINUOUS,
    DISCONTINUOUS,
    NO_QUAD,
    PARTIAL,
    PHASE,
    RECORD,
    SIGMA,
    SLOPE_X,
    SLOPE_Y,
    VALID,
    read,
    write,
)

REACH_PX = 3  # to either side, over which a slope is taken where the surface is smooth
PER_PX = np.float32(1 / (2 * REACH_PX))
# Second difference over the reach, relative to the first one and in standard deviations of the phase, beyond which it is not smooth.
MAX_CURVATURE, CURVATURE_SIGMAS = np.float32(0.2), np.float32(4.0)
ZERO, HALF, ONE, TWO = np.float32(0), np.float32(0.5), np.float32(1), np.float32(2)


@njit(**INLINE)
def narrow_slope(phase: Any, state: Any, at: int, apart: int, max_step: Any) -> Any:
    """Return the mean difference to the two neighbours on the same surface, or to the only one; 0 without both. ``apart``: 1 or a row."""
    own = read(phase, at)
    before, after = own - read(phase, at - apart), read(phase, at + apart) - own
    use_before = (read(state, at - apart) == VALID) & (abs(before) < max_step)
    use_after = (read(state, at + apart) == VALID) & (abs(after) < max_step)
    total = (before if use_before else ZERO) + (after if use_after else ZERO)
    return total * (HALF if use_before & use_after else ONE)


@njit(**INLINE)
def inner_slopes(phase: Any, state: Any, at: int, width: int, sigma: Any, max_step: Any) -> Any:
    """Return the slopes along x and y of a pixel that is at least REACH_PX from the border."""
    own, down = read(phase, at), REACH_PX * width
    left, right, above, below = read(phase, at - REACH_PX), read(phase, at + REACH_PX), read(phase, at - down), read(phase, at + down)
    holes = read(state, at) | read(state, at - REACH_PX) | read(state, at + REACH_PX) | read(state, at - down) | read(state, at + down)
    rise_x, rise_y = right - left, below - above
    curvature = max(abs(right + left - TWO * own), abs(below + above - TWO * own))
    smooth = (holes == VALID) & (curvature <= MAX_CURVATURE * (abs(rise_x) + abs(rise_y)) + CURVATURE_SIGMAS * sigma)
    narrow_x, narrow_y = narrow_slope(phase, state, at, 1, max_step), narrow_slope(phase, state, at, width, max_step)
    valid = read(state, at) == VALID
    slope_x, slope_y = PER_PX * rise_x if smooth else narrow_x, PER_PX * rise_y if smooth else narrow_y
    return slope_x if valid else ZERO, slope_y if valid else ZERO


@njit(**INLINE)
def quad_state(phase: Any, state: Any, at: int, width: int, max_step: Any) -> Any:
    """Return the state of a pixel with its right, lower and lower right neighbours."""
    a, b, c, d = read(phase, at), read(phase, at + 1), read(phase, at + width), read(phase, at + width + 1)
    spread = max(a, b, c, d) - min(a, b, c, d)
    first, second = read(state, at) == VALID, read(state, at + 1) == VALID
    third, fourth = read(state, at + width) == VALID, read(state, at + width + 1) == VALID
    upper, lower = first & second, third & fourth
    partial = PARTIAL if upper | lower | ((first | second) & (third | fourth)) else NO_QUAD
    whole = CONTINUOUS if spread <= max_step else DISCONTINUOUS
    return whole if upper & lower else partial


@njit(**INLINE)
def border_slope(phase: Any, state: Any, shape: Any, y: int, x: int, dy: int, dx: int, max_step: Any) -> Any:
    """Return the slope of a pixel near the border along one direction, as `narrow_slope` does."""
    height, width = shape
    own, total, count = phase[y * width + x], ZERO, 0
    for sign in (-1, 1):
        v, u = y + sign * dy, x + sign * dx
        if 0 <= v < height and 0 <= u < width and state[v * width + u] == VALID:
            difference = np.float32(sign) * (phase[v * width + u] - own)
            if abs(difference) < max_step:
                total, count = total + difference, count + 1
    return total / np.float32(max(count, 1)) if state[y * width + x] == VALID else ZERO


@njit(**INLINE)
def border_quad(phase: Any, state: Any, shape: Any, y: int, x: int, max_step: Any) -> Any:
    """Return the state of a pixel and its neighbours as `quad_state` does; beyond the border there is no phase."""
    height, width = shape
    valid, low, high = 0, np.float32(np.inf), np.float32(-np.inf)
    for v in range(y, min(y + 2, height)):
        for u in range(x, min(x + 2, width)):
            if state[v * width + u] == VALID:
                valid |= 1 << (2 * (v - y) + u - x)
                low, high = min(low, phase[v * width + u]), max(high, phase[v * width + u])
    if valid == 0b1111:
        return CONTINUOUS if high - low <= max_step else DISCONTINUOUS
    return PARTIAL if (valid & 0b0011 and valid & 0b1100) or valid in (0b0011, 0b1100) else NO_QUAD


@njit(**LOOP)
def measure_gradients(
    phase: Any,  # (H · W,) float32
    sigma: Any,  # (H · W,) float32
    state: Any,  # (H · W,) uint8, 0 valid
    shape: Any,  # (H, W)
    max_step: Any,  # float32, largest phase step between neighbours of one surface
    every: int,  # distance of the samples in pixels
    row_start: int,
    row_stop: int,
    records: Any,  # out (4 H · W,) float32
    quads: Any,  # out (H · W,) uint8
    samples: Any,  # out (3, H / every, W / every), rounded up: phase and slopes of every so many pixels in both directions
) -> None:
    """Take slopes as central differences over the widest reach that is one smooth surface: three pixels, one, one to one side.

    A wide reach lowers the noise of a slope; near discontinuities and bends a narrow one keeps it unbiased.
    """
    height, width = shape
    for y in range(row_start, row_stop):
        row, inner = y * width, REACH_PX <= y < height - REACH_PX and width > 2 * REACH_PX
        for at in range(row + REACH_PX, row + width - REACH_PX if inner else 0):
            slope_x, slope_y = inner_slopes(phase, state, at, width, read(sigma, at), max_step)
            write(records, RECORD * at + PHASE, read(phase, at))
            write(records, RECORD * at + SLOPE_X, slope_x)
            write(records, RECORD * at + SLOPE_Y, slope_y)
            write(records, RECORD * at + SIGMA, read(sigma, at))
            write(quads, at, quad_state(phase, state, at, width, max_step))
        for k in range(2 * REACH_PX if inner else width):
            x = k if k < REACH_PX or not inner else width - 2 * REACH_PX + k
            records[RECORD * (row + x) + PHASE], records[RECORD * (row + x) + SIGMA] = phase[row + x], sigma[row + x]
            records[RECORD * (row + x) + SLOPE_X] = border_slope(phase, state, shape, y, x, 0, 1, max_step)
            records[RECORD * (row + x) + SLOPE_Y] = border_slope(phase, state, shape, y, x, 1, 0, max_step)
            quads[row + x] = border_quad(phase, state, shape, y, x, max_step)
        if y % every == 0:
            for field in range(3):
                sampled = samples[field, y // every]
                for i in range(len(sampled)):
                    sampled[i] = records[RECORD * (row + every * i) + field]
