"""Gradients of a phase map: the record of every pixel, and the state of four neighbouring pixels."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.simd.elements import broadcast, maximum, minimum, select
from measureapp.compiled.simd.memory import load, store, store_records
from measureapp.reconstruct.kernels.structures import (
    CONTINUOUS,
    DISCONTINUOUS,
    LANES,
    NO_QUAD,
    PARTIAL,
    PHASE,
    RECORD,
    SIGMA,
    SLOPE_X,
    SLOPE_Y,
    VALID,
)

REACH_PX = 3  # to either side, over which a slope is taken where the surface is smooth
PER_PX = np.float32(1 / (2 * REACH_PX))
# Second difference over the reach, relative to the first one and in standard deviations of the phase, beyond which it is not smooth.
MAX_CURVATURE, CURVATURE_SIGMAS = np.float32(0.2), np.float32(4.0)
ZERO, HALF, ONE, TWO = np.float32(0), np.float32(0.5), np.float32(1), np.float32(2)


@njit(**INLINE)
def narrow_slopes(phase: Any, state: Any, at: int, apart: int, max_step: Any) -> Any:
    """Return the mean differences to the two neighbours on the same surface, or to the only one; 0 without both. ``apart``: 1 or a row."""
    own = load(phase, at, LANES)
    before, after = own - load(phase, at - apart, LANES), load(phase, at + apart, LANES) - own
    use_before = (load(state, at - apart, LANES) == VALID) & (abs(before) < max_step)
    use_after = (load(state, at + apart, LANES) == VALID) & (abs(after) < max_step)
    total = select(use_before, before, ZERO) + select(use_after, after, ZERO)
    return total * select(use_before & use_after, HALF, broadcast(ONE, LANES))


@njit(**INLINE)
def inner_slopes(phase: Any, state: Any, at: int, width: int, sigma: Any, max_step: Any) -> Any:
    """Return the slopes along x and y of LANES pixels that are at least REACH_PX from the border."""
    own, down = load(phase, at, LANES), REACH_PX * width
    left, right = load(phase, at - REACH_PX, LANES), load(phase, at + REACH_PX, LANES)
    above, below = load(phase, at - down, LANES), load(phase, at + down, LANES)
    holes = load(state, at, LANES) | load(state, at - REACH_PX, LANES) | load(state, at + REACH_PX, LANES)
    holes = holes | load(state, at - down, LANES) | load(state, at + down, LANES)
    rise_x, rise_y = right - left, below - above
    curvature = maximum(abs(right + left - TWO * own), abs(below + above - TWO * own))
    smooth = (holes == VALID) & (curvature <= MAX_CURVATURE * (abs(rise_x) + abs(rise_y)) + CURVATURE_SIGMAS * sigma)
    slope_x = select(smooth, PER_PX * rise_x, narrow_slopes(phase, state, at, 1, max_step))
    slope_y = select(smooth, PER_PX * rise_y, narrow_slopes(phase, state, at, width, max_step))
    valid = load(state, at, LANES) == VALID
    return select(valid, slope_x, ZERO), select(valid, slope_y, ZERO)


@njit(**INLINE)
def quad_states(phase: Any, state: Any, at: int, width: int, max_step: Any) -> Any:
    """Return the states of LANES pixels with their right, lower and lower right neighbours."""
    a, b = load(phase, at, LANES), load(phase, at + 1, LANES)
    c, d = load(phase, at + width, LANES), load(phase, at + width + 1, LANES)
    spread = maximum(maximum(a, b), maximum(c, d)) - minimum(minimum(a, b), minimum(c, d))
    first, second = load(state, at, LANES) == VALID, load(state, at + 1, LANES) == VALID
    third, fourth = load(state, at + width, LANES) == VALID, load(state, at + width + 1, LANES) == VALID
    upper, lower = first & second, third & fourth
    partial = select(upper | lower | ((first | second) & (third | fourth)), PARTIAL, broadcast(NO_QUAD, LANES))
    return select(upper & lower, select(spread <= max_step, CONTINUOUS, broadcast(DISCONTINUOUS, LANES)), partial)


@njit(**INLINE)
def border_slope(phase: Any, state: Any, y: int, x: int, dy: int, dx: int, max_step: Any) -> Any:
    """Return the slope of a pixel near the border along one direction, as `narrow_slopes` does."""
    total, count = ZERO, 0
    for sign in (-1, 1):
        v, u = y + sign * dy, x + sign * dx
        if 0 <= v < phase.shape[0] and 0 <= u < phase.shape[1] and state[v, u] == VALID:
            difference = np.float32(sign) * (phase[v, u] - phase[y, x])
            if abs(difference) < max_step:
                total, count = total + difference, count + 1
    return total / np.float32(max(count, 1)) if state[y, x] == VALID else ZERO


@njit(**INLINE)
def border_quad(phase: Any, state: Any, y: int, x: int, max_step: Any) -> Any:
    """Return the state of a pixel and its neighbours as `quad_states` does; beyond the border there is no phase."""
    valid, low, high = 0, np.float32(np.inf), np.float32(-np.inf)
    for v in range(y, min(y + 2, phase.shape[0])):
        for u in range(x, min(x + 2, phase.shape[1])):
            if state[v, u] == VALID:
                valid |= 1 << (2 * (v - y) + u - x)
                low, high = min(low, phase[v, u]), max(high, phase[v, u])
    if valid == 0b1111:
        return CONTINUOUS if high - low <= max_step else DISCONTINUOUS
    return PARTIAL if (valid & 0b0011 and valid & 0b1100) or valid in (0b0011, 0b1100) else NO_QUAD


@njit(**LOOP)
def measure_gradients(
    phase: Any,  # (H, W) float32
    sigma: Any,  # (H, W) float32
    state: Any,  # (H, W) uint8, 0 valid
    max_step: Any,  # float32, largest phase step between neighbours of one surface
    every: int,  # distance of the samples in pixels
    row_start: int,
    row_stop: int,
    records: Any,  # out (H, W, 4) float32
    quads: Any,  # out (H, W) uint8
    samples: Any,  # out (3, H / every, W / every), rounded up: phase and slopes of every so many pixels in both directions
) -> None:
    """Take slopes as central differences over the widest reach that is one smooth surface: three pixels, one, one to one side.

    A wide reach lowers the noise of a slope; near discontinuities and bends a narrow one keeps it unbiased.
    """
    height, width = phase.shape
    for y in range(row_start, row_stop):
        inner = REACH_PX <= y < height - REACH_PX and width >= LANES + 2 * REACH_PX
        last = width - REACH_PX - LANES
        for first in range(REACH_PX, width - REACH_PX if inner else 0, LANES):
            at = y * width + min(first, last)  # some pixels twice
            noise = load(sigma, at, LANES)
            slope_x, slope_y = inner_slopes(phase, state, at, width, noise, max_step)
            store_records((load(phase, at, LANES), slope_x, slope_y, noise), records, RECORD * at)
            store(quad_states(phase, state, at, width, max_step), quads, at)
        for k in range(2 * REACH_PX if inner else width):
            x = k if k < REACH_PX or not inner else width - 2 * REACH_PX + k
            records[y, x, PHASE], records[y, x, SIGMA] = phase[y, x], sigma[y, x]
            records[y, x, SLOPE_X] = border_slope(phase, state, y, x, 0, 1, max_step)
            records[y, x, SLOPE_Y] = border_slope(phase, state, y, x, 1, 0, max_step)
            quads[y, x] = border_quad(phase, state, y, x, max_step)
        if y % every == 0:
            for field in range(3):
                sampled = samples[field, y // every]
                for i in range(len(sampled)):
                    sampled[i] = records[y, every * i, field]
