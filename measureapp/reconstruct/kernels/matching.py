"""Compiled loop that finds the pixels of one camera in another: same epipolar line, same phase.

``lines`` (H, W, 2) are the rectified coordinates (x, y) of every pixel of a pair; equal y is the same epipolar line. The loop works on
chunks of pixels: places are looked up one by one, arithmetic runs on a scratch array at constant offsets in SIMD instructions.
"""
# One loop over pixels cannot be cut into functions without leaving SIMD code.
# ruff: noqa: PLR0912, PLR0915

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.binning import REPEATED
from measureapp.reconstruct.kernels.options import INLINE
from measureapp.reconstruct.kernels.seen import MATCHED, REPEATS, WITHOUT_PARTNER
from measureapp.reconstruct.kernels.slopes import BESIDE, REACH

CHUNK = 512
ZERO, ONE, HALF = np.float32(0), np.float32(1), np.float32(0.5)
STEEP = np.float32(4.0 / (REACH * np.sqrt(2.0)))  # a slope below four of its standard deviations does not tell where the point is
FLAT = np.float32(1e-6)
FARTHEST_PX = np.float32(12.0)  # from a cell's pixel to the match
ITERATIONS = 6
ON_EDGE = np.float32(BESIDE)  # there a pixel speaks for the square of half a pixel around it that it is the mean of, and for no more
QUARTER = np.float32(0.25)
BEYOND = np.float32(0.1)  # so far out of its four pixels a place may lie, in px
EDGE = np.float32(1.001)
LOST = np.float32(100.0)
HELD, TWICE = np.float32(MATCHED), np.float32(REPEATS)

(PHASE, X, Y, DEPTH_SCALE, START_PHASE, START_X, START_Y, START_GX, START_GY, START_U, START_V) = (k * CHUNK for k in range(11))
(U, V, P00, P01, P10, P11, NEAR, NEAR_SIGMA, NEAR_GX, NEAR_GY, NEAR_X, NEAR_Y, TEAR) = (k * CHUNK for k in range(11, 24))
(LEFT, SLOPE, NOISE, Z, GAIN, NEXT_U, NEXT_V, CODE) = (k * CHUNK for k in range(24, 32))
SCRATCH = 32 * CHUNK


@njit(**INLINE)
def cubic(c: Any, s: Any, t: Any) -> Any:
    """Return the value of a cubic polynomial of two variables."""
    return c[0] + s * (c[1] + s * (c[3] + s * c[6])) + t * (c[2] + s * (c[4] + s * c[7]) + t * (c[5] + s * c[8] + t * c[9]))


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def match(
    rays: Any,  # (H, W, 2) float32, normalised image coordinates of the camera
    phase: Any,
    skip: Any,  # (H, W) uint8, 0 for pixels to match
    lines: Any,
    turn: Any,  # (3,) float32, third row: the rectified depth of the ray
    other_phase: Any,
    other_sigma: Any,
    other_slope: Any,
    other_quad: Any,
    other_lines: Any,
    to_rows: Any,  # four cubic polynomials: ∂x/∂u, ∂x/∂v, ∂y/∂u, ∂y/∂v of the other camera's `other_lines`
    to_unit: Any,  # (u0, per u, v0, per v): their variables are (u − u0) · per u, (v − v0) · per v
    table: Any,  # of the other camera, with what is repeated in this one
    lowest: Any,
    per_rad: Any,
    numbers: Any,  # (focal, x0 here − x0 there, baseline), float32
    row_start: int,
    row_stop: int,
    depth: Any,  # out (rows, W) float32, z in the camera's frame, 0 for none
    gain: Any,  # out (rows, W) float32, change of the other camera's phase with z, rad/mm
    variance: Any,  # out (rows, W) float32, of the other camera's phase
    there: Any,  # out (rows, W) int32, index of the other camera's pixel
    reason: Any,  # out (rows, W) uint8, MATCHED | WITHOUT_PARTNER | REPEATS
) -> int:
    """Match pixels by their phase along the epipolar line; returns how many.

    From a pixel with nearly that phase on nearly that line a step of Newton's method in both leads to the place where phase and line
    are right; the phase is read there between four pixels, so that its variance is known, and the small rest follows the slope over
    several pixels. Pixels whose phase occurs at more than one place of the epipolar line, in either camera, are not matched.
    """
    height, width = other_phase.shape
    u_max, v_max = np.float32(width) - EDGE, np.float32(height) - EDGE
    last_row, last_bin = np.float32(table.shape[0] - 1), np.float32(table.shape[1] - 1)
    focal, offset, baseline = numbers
    x_u, x_v, y_u, y_v = to_rows
    u0, per_u, v0, per_v = to_unit
    t0, t1, t2 = turn
    flat_phase, flat_sigma, flat_quad = other_phase.ravel(), other_sigma.ravel(), other_quad.ravel()
    flat_slope, flat_lines = other_slope.ravel(), other_lines.ravel()
    flat_table = table.ravel()
    to_right, to_below = np.uint32(1), np.uint32(width)
    row_length, bins = np.int32(width), np.int32(table.shape[1])
    s = np.zeros(SCRATCH, np.float32)
    column = np.zeros(CHUNK, np.int32)
    at = np.zeros(2 * CHUNK, np.int32)
    matched = 0
    for y in range(row_start, row_stop):
        out = y - row_start
        depth[out] = 0
        reason[out] = WITHOUT_PARTNER
        for first in range(0, phase.shape[1], CHUNK):
            n = min(CHUNK, phase.shape[1] - first)
            skip_row, phase_row = skip[y, first : first + n], phase[y, first : first + n]
            lines_row, rays_row = lines[y].ravel()[2 * first : 2 * (first + n)], rays[y].ravel()[2 * first : 2 * (first + n)]
            wanted = 0
            for i in range(n):
                wanted += skip_row[i] == 0
            if wanted == 0:
                continue
            for i in range(n):
                s[PHASE + i] = phase_row[i]
            for i in range(n):
                s[X + i] = lines_row[2 * i]
                s[Y + i] = lines_row[2 * i + 1]
            for i in range(n):
                s[DEPTH_SCALE + i] = t0 * rays_row[2 * i] + t1 * rays_row[2 * i + 1] + t2
            for i in range(n):
                line = np.int32(min(max(s[Y + i] * HALF + ONE, ZERO), last_row))
                at[i] = line * bins + np.int32(min(max((s[PHASE + i] - lowest) * per_rad + ONE, ZERO), last_bin))
            for i in range(n):
                cell = np.uint32(at[i])
                held = flat_table[cell]
                repeated = (held & REPEATED) != 0
                usable = (skip_row[i] == 0) & (held >= 0) & (not repeated)
                s[CODE + i] = HELD if usable else (TWICE if (held >= 0) & repeated else ZERO)
                held = held if usable else np.int32(0)
                v = held >> 16
                u = held & 0xFFFF
                place = np.uint32(v * row_length + u)
                s[START_U + i] = u
                s[START_V + i] = v
                s[START_PHASE + i] = flat_phase[place]
                s[START_X + i] = flat_lines[place + place]
                s[START_Y + i] = flat_lines[place + place + to_right]
                s[START_GX + i] = flat_slope[place + place]
                s[START_GY + i] = flat_slope[place + place + to_right]
            for i in range(n):
                us = (s[START_U + i] - u0) * per_u
                vs = (s[START_V + i] - v0) * per_v
                a, b, c, d = cubic(x_u, us, vs), cubic(x_v, us, vs), cubic(y_u, us, vs), cubic(y_v, us, vs)
                gx, gy = s[START_GX + i], s[START_GY + i]
                down = s[Y + i] - s[START_Y + i]
                rise = s[PHASE + i] - s[START_PHASE + i]
                scale = ONE / (gx * d - gy * c)
                du = (d * rise - gy * down) * scale
                dv = (gx * down - c * rise) * scale
                near = (abs(du) < FARTHEST_PX) & (abs(dv) < FARTHEST_PX)
                s[U + i] = min(max(s[START_U + i] + (du if near else ZERO), ZERO), u_max)
                s[V + i] = min(max(s[START_V + i] + (dv if near else ZERO), ZERO), v_max)
            for turn_number in range(ITERATIONS):
                for i in range(n):
                    u, v = s[U + i], s[V + i]
                    at[i] = np.int32(v) * row_length + np.int32(u)
                    at[CHUNK + i] = np.int32(v + HALF) * row_length + np.int32(u + HALF)
                for i in range(n):
                    corner = np.uint32(at[i])
                    s[P00 + i] = flat_phase[corner]
                    s[P01 + i] = flat_phase[corner + to_right]
                    s[P10 + i] = flat_phase[corner + to_below]
                    s[P11 + i] = flat_phase[corner + to_below + to_right]
                    s[TEAR + i] = flat_quad[corner]
                for i in range(n):
                    place = np.uint32(at[CHUNK + i])
                    s[NEAR + i] = flat_phase[place]
                    s[NEAR_SIGMA + i] = flat_sigma[place]
                    s[NEAR_GX + i] = flat_slope[place + place]
                    s[NEAR_GY + i] = flat_slope[place + place + to_right]
                    s[NEAR_X + i] = flat_lines[place + place]
                    s[NEAR_Y + i] = flat_lines[place + place + to_right]
                for i in range(n):
                    u, v = s[U + i], s[V + i]
                    fu, fv = np.float32(np.int32(u)), np.float32(np.int32(v))
                    nu, nv = np.float32(np.int32(u + HALF)), np.float32(np.int32(v + HALF))
                    us, vs = (u - u0) * per_u, (v - v0) * per_v
                    a, b, c, d = cubic(x_u, us, vs), cubic(x_v, us, vs), cubic(y_u, us, vs), cubic(y_v, us, vs)
                    gx, gy = s[NEAR_GX + i], s[NEAR_GY + i]
                    p, q = u - fu, v - fv
                    du, dv = u - nu, v - nv
                    above = s[P00 + i] + p * (s[P01 + i] - s[P00 + i])
                    below = s[P10 + i] + p * (s[P11 + i] - s[P10 + i])
                    whole = s[TEAR + i] == ONE
                    value = above + q * (below - above) if whole else s[NEAR + i] + gx * du + gy * dv
                    determinant = a * d - b * c
                    slope = (gx * d - gy * c) / determinant
                    right, under = s[P01 + i] - s[P00 + i], s[P10 + i] - s[P00 + i]
                    twist = s[P11 + i] - s[P00 + i] - right - under
                    lx, ly = right + q * twist, under + p * twist
                    local = (lx * d - ly * c) / determinant
                    inner = whole & (local * slope > QUARTER * slope * slope)
                    along = local if inner else slope
                    across = ((ly if inner else gy) * a - (lx if inner else gx) * b) / determinant
                    down = s[Y + i] - (s[NEAR_Y + i] + c * du + d * dv)
                    move = (s[PHASE + i] - value - down * across) / along
                    move = min(max(move, -FARTHEST_PX), FARTHEST_PX)
                    to_u, to_v = (d * move - b * down) / determinant, (a * down - c * move) / determinant
                    pn, qn = p + to_u, q + to_v
                    within = (pn >= -BEYOND) & (pn <= ONE + BEYOND) & (qn >= -BEYOND) & (qn <= ONE + BEYOND)
                    close = within if inner else (abs(du + to_u) <= HALF + BEYOND) & (abs(dv + to_v) <= HALF + BEYOND)
                    settles = close | ((turn_number == ITERATIONS - 1) & (abs(to_u) + abs(to_v) < HALF))
                    pn, qn = min(max(pn, ZERO), ONE), min(max(qn, ZERO), ONE)
                    reach = abs(du + to_u) + abs(dv + to_v)
                    outward = (ONE + reach) * (ONE + reach) + reach * reach
                    share = (pn * pn + (ONE - pn) * (ONE - pn)) * (qn * qn + (ONE - qn) * (ONE - qn)) if whole else outward
                    bad = ((s[TEAR + i] != ONE) & (s[TEAR + i] != ON_EDGE)) | (abs(slope) < FLAT)
                    parallax = s[X + i] - s[NEAR_X + i] + offset - (a * du + b * dv + move)
                    z = baseline * focal / (parallax * s[DEPTH_SCALE + i])
                    s[LEFT + i] = LOST if bad else (ZERO if settles else ONE)
                    s[SLOPE + i] = slope
                    s[NOISE + i] = s[NEAR_SIGMA + i] * s[NEAR_SIGMA + i] * share
                    s[Z + i] = z if parallax > ZERO else ZERO
                    s[GAIN + i] = slope * parallax / z
                    s[NEXT_U + i] = min(max(u + to_u, ZERO), u_max)
                    s[NEXT_V + i] = min(max(v + to_v, ZERO), v_max)
                for i in range(n):
                    z, slope = s[Z + i], s[SLOPE + i]
                    steep = slope * slope >= STEEP * STEEP * s[NOISE + i]
                    there_at = s[CODE + i] == HELD
                    found = there_at & (s[LEFT + i] < ONE) & (z > ZERO)
                    s[Z + i] = z if found & steep else ZERO
                    s[LEFT + i] = s[LEFT + i] if there_at else LOST
                    other = ZERO if there_at else s[CODE + i]
                    s[CODE + i] = (HELD if steep else TWICE) if found else other
                if turn_number == 0:
                    depth_out, gain_out = depth[out, first : first + n], gain[out, first : first + n]
                    noise_out, there_out = variance[out, first : first + n], there[out, first : first + n]
                    reason_out = reason[out, first : first + n]
                    for i in range(n):
                        depth_out[i] = s[Z + i]
                    for i in range(n):
                        gain_out[i] = s[GAIN + i]
                    for i in range(n):
                        noise_out[i] = s[NOISE + i]
                    for i in range(n):
                        there_out[i] = at[CHUNK + i]
                    for i in range(n):
                        reason_out[i] = np.uint8(np.int32(s[CODE + i]))
                    for i in range(n):
                        column[i] = i
                else:
                    for i in range(n):
                        x = first + column[i]
                        depth[out, x], gain[out, x], variance[out, x] = s[Z + i], s[GAIN + i], s[NOISE + i]
                        there[out, x] = at[CHUNK + i]
                        reason[out, x] = np.uint8(np.int32(s[CODE + i]))
                left = 0
                for i in range(n):
                    if s[LEFT + i] >= ONE and s[LEFT + i] < LOST:
                        column[left] = column[i]
                        s[PHASE + left], s[X + left], s[Y + left] = s[PHASE + i], s[X + i], s[Y + i]
                        s[DEPTH_SCALE + left] = s[DEPTH_SCALE + i]
                        s[U + left], s[V + left] = s[NEXT_U + i], s[NEXT_V + i]
                        s[CODE + left] = HELD
                        left += 1
                n = left
                if n == 0:
                    break
        for x in range(phase.shape[1]):
            matched += reason[out, x] == MATCHED
    return matched
