"""Compiled loops that look phases up in another image: sampling, tables of rectified rows, matching, checking, resampling.

A rectified pair is described to the kernels by ``turn`` (3, 3), rectified axes from the camera's, and ``frame``
(focal, x0, y0) with x_px = focal · x − x0, y_px = focal · y − y0; a ``grid`` (rows, columns, 2) of native pixels (x, y) at every
``stride``-th rectified pixel leads back to the image. Rows of both images of a pair are the same epipolar lines.
"""
# One loop over pixels cannot be cut into functions without leaving SIMD code.
# ruff: noqa: PLR0912, PLR0915, PLR1714, PLW3301

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.seen import BLANK, BORROWED, PARTLY, SEEN

ITERATIONS = 8
SLOPE_REACH = 3.0  # rectified pixels to either side over which the phase slope is taken
SLOPE_SIGMAS = 4.0  # a slope below this many of its standard deviations is no slope: the phase does not tell where the point is
CONVERGED_PX = 0.02


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def native_pixel(grid: Any, stride: Any, x: Any, y: Any) -> Any:
    """Return the image point (x, y) of a rectified one, bilinear between the grid's nodes; (-1, -1) outside."""
    gx = x / stride
    gy = y / stride
    i = int(np.floor(gy))
    j = int(np.floor(gx))
    if i < 0 or j < 0 or i + 1 >= grid.shape[0] or j + 1 >= grid.shape[1]:
        return -1.0, -1.0
    a = gx - j
    b = gy - i
    u = (1 - b) * ((1 - a) * grid[i, j, 0] + a * grid[i, j + 1, 0]) + b * ((1 - a) * grid[i + 1, j, 0] + a * grid[i + 1, j + 1, 0])
    v = (1 - b) * ((1 - a) * grid[i, j, 1] + a * grid[i, j + 1, 1]) + b * ((1 - a) * grid[i + 1, j, 1] + a * grid[i + 1, j + 1, 1])
    return u, v


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def look(phase: Any, state: Any, step: Any, u: Any, v: Any) -> Any:
    """Return (BLANK | SEEN | PARTLY, phase), bilinear between four pixels within ``step`` of each other.

    The nearest pixel must be valid, the others at least borrowed.
    """
    if u < 0.0 or v < 0.0 or v >= phase.shape[0] - 1 or u >= phase.shape[1] - 1:
        return BLANK, 0.0
    i = int(v)
    j = int(u)
    if (state[i, j] | state[i, j + 1]) | (state[i + 1, j] | state[i + 1, j + 1]) != 0:
        holes = 0
        blanks = 0
        for k in range(4):
            here = state[i + k // 2, j + k % 2]
            blanks += here != 0
            holes += here != 0 and here != BORROWED
        if holes or state[int(v + 0.5), int(u + 0.5)] != 0:
            return (BLANK if blanks == 4 else PARTLY), 0.0
    p, q, r, s = phase[i, j], phase[i, j + 1], phase[i + 1, j], phase[i + 1, j + 1]
    if max(max(p, q), max(r, s)) - min(min(p, q), min(r, s)) > step:
        return PARTLY, 0.0
    a = u - j
    b = v - i
    above = p + a * (q - p)
    return SEEN, above + b * (r + a * (s - r) - above)


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def variance_at(sigma: Any, u: Any, v: Any) -> Any:
    """Return the variance of a phase that `look` has SEEN."""
    i = int(v)
    j = int(u)
    a = u - j
    b = v - i
    wp, wq, wr, ws = (1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b
    return (wp * sigma[i, j]) ** 2 + (wq * sigma[i, j + 1]) ** 2 + (wr * sigma[i + 1, j]) ** 2 + (ws * sigma[i + 1, j + 1]) ** 2


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def fill_table(
    grid: Any,
    stride: Any,
    width: int,
    phase: Any,
    state: Any,
    step: Any,  # largest phase step between neighbours
    lowest: Any,  # phase of bin 0
    per_rad: Any,  # bins per radian
    row_start: int,
    row_stop: int,
    first: Any,  # out (rows, bins) int16, first rectified column whose segment holds the bin's phase, -1 for none
    last: Any,  # out (rows, bins) int16, last one
) -> None:
    """Sort the segments between neighbours of every rectified row into bins of the phase; linear in the width."""
    bins = first.shape[1]
    for row in range(row_start, row_stop):
        for k in range(bins):
            first[row, k] = -1
            last[row, k] = -1
        before = 0.0
        known = False
        for x in range(width):
            u, v = native_pixel(grid, stride, float(x), float(row))
            seen, value = look(phase, state, step, u, v)
            if seen == SEEN and known and abs(value - before) < step:
                low = max(0, int((min(value, before) - lowest) * per_rad))
                high = min(bins - 1, int((max(value, before) - lowest) * per_rad))
                for k in range(low, high + 1):
                    if first[row, k] < 0:
                        first[row, k] = x
                    last[row, k] = x
            known = seen == SEEN
            before = value


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def direction_at(grid: Any, stride: Any, x: Any, y: Any) -> Any:
    """Return the image point of a rectified one and how it moves per rectified pixel along the row: (u, v, du, dv)."""
    u, v = native_pixel(grid, stride, x, y)
    right, below = native_pixel(grid, stride, x + 1.0, y)
    return u, v, right - u, below - v


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def slope_along(phase: Any, state: Any, step: Any, u: Any, v: Any, du: Any, dv: Any, here: Any, middle: Any) -> Any:
    """Return (known, radians per rectified pixel) along the row: the central difference over the widest reach that is one surface.

    A wide one is less noisy; near a border it is taken over single pixels, at the border one-sided. ``here`` and ``middle`` are
    what `look` says of (u, v).
    """
    wide_right, high = look(phase, state, step, u + SLOPE_REACH * du, v + SLOPE_REACH * dv)
    wide_left, low = look(phase, state, step, u - SLOPE_REACH * du, v - SLOPE_REACH * dv)
    if wide_right == SEEN and wide_left == SEEN and here == SEEN and abs(high + low - 2.0 * middle) < 0.2 * abs(high - low):
        return True, (high - low) / (2.0 * SLOPE_REACH)
    right, high = look(phase, state, step, u + du, v + dv)
    left, low = look(phase, state, step, u - du, v - dv)
    if right == SEEN and left == SEEN:
        return True, (high - low) / 2.0
    if here == SEEN and right == SEEN:
        return True, high - middle
    if here == SEEN and left == SEEN:
        return True, middle - low
    return False, 0.0


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def solve_row(grid: Any, stride: Any, phase: Any, sigma: Any, state: Any, step: Any, wanted: Any, x: Any, y: Any) -> Any:
    """Find where the row has the phase ``wanted``, from ``x`` on; returns (found, x, slope, variance)."""
    u, v, du, dv = direction_at(grid, stride, x, y)
    if u < 0:
        return False, x, 0.0, 0.0
    seen, value = look(phase, state, step, u, v)
    known, slope = slope_along(phase, state, step, u, v, du, dv, seen, value)
    if not known or abs(slope) < 1e-6:
        return False, x, 0.0, 0.0
    gone = 0.0
    for _ in range(ITERATIONS):
        if seen != SEEN:
            return False, x, 0.0, 0.0
        move = (wanted - value) / slope
        if abs(move) < CONVERGED_PX:
            return True, x + gone + move, slope, variance_at(sigma, u + gone * du, v + gone * dv)
        gone += min(2.0, max(-2.0, move))
        seen, value = look(phase, state, step, u + gone * du, v + gone * dv)
    return False, x, 0.0, 0.0


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def match(
    rays: Any,  # (H, W, 2) float32, normalised image coordinates of the camera
    phase: Any,
    state: Any,
    turn: Any,
    frame: Any,  # of this camera
    first_here: Any,
    last_here: Any,
    other_frame: Any,
    grid: Any,  # of the other camera
    stride: Any,
    other_phase: Any,
    other_sigma: Any,
    other_state: Any,
    first: Any,
    last: Any,
    lowest: Any,
    per_rad: Any,
    step: Any,
    baseline: Any,
    row_start: int,
    row_stop: int,
    depth: Any,  # out (rows, W) float32, z in the camera's frame, 0 for none
    gain: Any,  # out (rows, W) float32, change of the other camera's phase with z, rad/mm
    variance: Any,  # out (rows, W) float32, of the other camera's phase
) -> Any:
    """Match pixels by their phase along the epipolar line; returns how many were matched, unmatched and ambiguous.

    Ambiguous: the phase occurs at more than one place of the epipolar line, in either camera.
    """
    matched = 0
    unmatched = 0
    ambiguous = 0
    bins = first.shape[1]
    for y in range(row_start, row_stop):
        for x in range(phase.shape[1]):
            out = y - row_start
            depth[out, x] = 0
            gain[out, x] = 0
            variance[out, x] = 0
            if state[y, x] != 0:
                continue
            nx = rays[y, x, 0]
            ny = rays[y, x, 1]
            rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
            here = (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) / rz
            row = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) / rz - frame[2]
            k = int((phase[y, x] - lowest) * per_rad)
            r = int(np.floor(row + 0.5))
            if r < 0 or r >= first.shape[0] or k < 0 or k >= bins:
                unmatched += 1
                continue
            if first[r, k] < 0:
                if k + 1 < bins and first[r, k + 1] >= 0:
                    k += 1
                elif k > 0 and first[r, k - 1] >= 0:
                    k -= 1
                else:
                    unmatched += 1
                    continue
            a = first[r, k]
            b = last[r, k]
            start = (a + b) / 2.0 - 0.5 if b - a <= 2 else a - 0.5
            found, there, slope, noise = solve_row(grid, stride, other_phase, other_sigma, other_state, step, phase[y, x], start, row)
            if not found:
                unmatched += 1
                continue
            if abs(slope) * SLOPE_REACH * np.sqrt(2.0) < SLOPE_SIGMAS * np.sqrt(noise):
                ambiguous += 1
                continue
            slack = 4.0 + 2.0 / (per_rad * abs(slope))
            own = frame[0] * here - frame[1]
            repeated = b - a > slack
            if first_here[r, k] >= 0:
                repeated |= abs(first_here[r, k] - own) > slack or abs(last_here[r, k] - own) > slack
            if repeated:
                ambiguous += 1
                continue
            parallax = here - (there + other_frame[1]) / other_frame[0]
            if parallax <= 0:
                unmatched += 1
                continue
            z = baseline / parallax / rz
            depth[out, x] = z
            gain[out, x] = slope * other_frame[0] * baseline / (rz * z * z)
            variance[out, x] = noise
            matched += 1
    return matched, unmatched, ambiguous


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def observe(
    rays: Any,
    phase: Any,
    turn: Any,
    frame: Any,
    other_frame: Any,
    grid: Any,
    stride: Any,
    other_phase: Any,
    other_sigma: Any,
    other_state: Any,
    step: Any,
    baseline: Any,
    depth: Any,  # (rows, W) float32
    row_start: int,
    row_stop: int,
    seen: Any,  # out (rows, W) uint8
    excess: Any,  # out (rows, W) float32, phase of the other camera at the point minus the pixel's own
    shift: Any,  # out (rows, W) float32, the same as a shift along the epipolar line in rectified pixels
    gain: Any,  # out (rows, W) float32
    variance: Any,  # out (rows, W) float32
) -> None:
    """Look at points of this camera with another one."""
    for y in range(row_start, row_stop):
        for x in range(phase.shape[1]):
            out = y - row_start
            seen[out, x] = BLANK
            excess[out, x] = 0
            shift[out, x] = 0
            gain[out, x] = 0
            variance[out, x] = 0
            z = depth[out, x]
            if z <= 0:
                continue
            nx = rays[y, x, 0]
            ny = rays[y, x, 1]
            rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
            here = (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) / rz
            row = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) / rz - frame[2]
            there = other_frame[0] * (here - baseline / (rz * z)) - other_frame[1]
            u, v, du, dv = direction_at(grid, stride, there, row)
            sight, value = look(other_phase, other_state, step, u, v)
            if sight == SEEN:
                known, slope = slope_along(other_phase, other_state, step, u, v, du, dv, sight, value)
                if not known or abs(slope) < 1e-6:
                    sight = PARTLY
                else:
                    excess[out, x] = value - phase[y, x]
                    shift[out, x] = excess[out, x] / slope
                    gain[out, x] = slope * other_frame[0] * baseline / (rz * z * z)
                    variance[out, x] = variance_at(other_sigma, u, v)
            seen[out, x] = sight


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def resample(
    phase: Any,
    sigma: Any,
    state: Any,
    step: Any,
    native: Any,  # (rows, columns, 2) float32, where to take the pixels from, (x, y)
    row_start: int,
    row_stop: int,
    new_phase: Any,  # out (rows, columns) float32
    new_sigma: Any,  # out (rows, columns) float32
    new_state: Any,  # out (rows, columns) uint8, that of the nearest pixel, or `hole`
    hole: int,
) -> None:
    """Take a phase map to another grid, bilinear where all four pixels are valid and of one surface."""
    for y in range(row_start, row_stop):
        for x in range(new_phase.shape[1]):
            u = native[y, x, 0]
            v = native[y, x, 1]
            seen, value = look(phase, state, step, u, v)
            new_phase[y, x] = value
            new_sigma[y, x] = np.sqrt(variance_at(sigma, u, v)) if seen == SEEN else 0.0
            new_state[y, x] = 0
            if seen != SEEN:  # the reason of the nearest pixel
                i = int(np.floor(v + 0.5))
                j = int(np.floor(u + 0.5))
                inside = 0 <= i < state.shape[0] and 0 <= j < state.shape[1]
                new_state[y, x] = state[i, j] if inside and state[i, j] != 0 and state[i, j] != BORROWED else hole
