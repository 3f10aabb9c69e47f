"""Compiled steps of the search for a pixel in another camera: where to begin, and Newton's method on line and phase.

See `matching` for the lanes and records.
"""
# A step of Newton's method is one loop: cut into two it would write and read all between them.
# ruff: noqa: PLR0915

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.machine_memory import will_read
from measureapp.reconstruct.kernels.binning import REPEATED
from measureapp.reconstruct.kernels.cubic import cubic
from measureapp.reconstruct.kernels.lanes import (
    CHUNK,
    CODE,
    DEPTH_SCALE,
    GAIN,
    HALF,
    HELD,
    KEPT_U,
    KEPT_V,
    LEFT,
    LOST,
    NEAREST,
    NEXT_U,
    NEXT_V,
    NOISE,
    ONE,
    PHASE,
    PLACE,
    QUAD,
    SOME,
    TWO,
    ZERO,
    U,
    V,
    X,
    Y,
    Z,
    in_groups,
    list_marked,
)
from measureapp.reconstruct.kernels.options import INLINE
from measureapp.reconstruct.kernels.scratch import GROUP, copy_1, copy_2, copy_4, split_2, split_4
from measureapp.reconstruct.kernels.seen import REPEATS
from measureapp.reconstruct.kernels.slopes import BESIDE, REACH

STEEP = np.float32(4.0 / (REACH * np.sqrt(2.0)))  # a slope below four of its standard deviations does not tell where the point is
FLAT = np.float32(1e-6)
FARTHEST_PX = np.float32(12.0)  # from a cell's pixel to the match
ON_EDGE = np.float32(BESIDE)  # there a pixel speaks for the square of half a pixel around it that it is the mean of, and for no more
QUARTER = np.float32(0.25)
BEYOND = np.float32(0.1)  # so far out of its four pixels a place may lie, in px
KEEPS_PX = np.float32(8.0)  # so near to a cell's pixel the match of the row above lies on the same surface
TWICE = np.float32(REPEATS)
ROWS_AHEAD = np.uint32(4)  # so far below is asked for what rows soon need: 2 is enough where epipolar lines are level, 4 where tilted
CELLS_APART = 8  # of so many pixels the cells lie in one line of the cache
FOUR = np.uint32(2)  # as a shift

(P00, P01, P10, P11, NEAR_X, NEAR_Y, NEAR, NEAR_GX, NEAR_GY, NEAR_SIGMA) = (k * CHUNK for k in range(10))
GATHERED = 10 * CHUNK
ABOVE, BELOW, LINE, RECORD = P00, P10, NEAR_X, NEAR  # where the records of two and four numbers begin
LANE = np.uint32(CHUNK)


@njit(**INLINE)
def look_up(s: Any, at: Any, n: int, table: Any, shape: Any, lowest: Any, per_rad: Any, width: Any) -> None:
    """Look up the pixels of the other camera with nearly the phase on nearly the line; places in U and V, what the table says in CODE."""
    bins = np.int32(shape[1])
    last_row, last_bin = np.float32(shape[0] - 1), np.float32(shape[1] - 1)
    for i in range(n):
        line = np.int32(min(max(s[Y + i] * HALF + ONE, ZERO), last_row))
        at[PLACE + i] = line * bins + np.int32(min(max((s[PHASE + i] - lowest) * per_rad + ONE, ZERO), last_bin))
    for i in range(n):
        cell = np.uint32(at[PLACE + i])
        copy_1(at, np.uint32(NEAREST + i), table, cell)
    for i in range(0, n, CELLS_APART):
        will_read(table, np.uint32(at[PLACE + i]) + np.uint32(bins))
    for i in range(n):
        held = at[NEAREST + i]
        repeated = (held & REPEATED) != 0
        usable = (s[CODE + i] == ONE) & (held >= 0) & (not repeated)
        s[CODE + i] = HELD if usable else (TWICE if (held >= 0) & repeated else ZERO)
        held = held if usable else np.int32(0)
        v = held >> 16
        u = held & 0xFFFF
        at[PLACE + i] = v * width + u
        kept_u, kept_v = s[KEPT_U + i], s[KEPT_V + i]
        keeps = (abs(u - kept_u) <= KEEPS_PX) & (abs(v - kept_v) <= KEEPS_PX)
        s[U + i] = kept_u if keeps else u
        s[V + i] = kept_v if keeps else v
        s[LEFT + i] = ONE if usable & (not keeps) else ZERO


@njit(**INLINE)
def fetch_start(s: Any, g: Any, at: Any, n: int, pixels: Any, lines: Any) -> None:
    """Fetch the records of those pixels that were looked up for want of one kept from the row above."""
    for i in range(list_marked(s, at, n)):
        k = np.uint32(at[SOME + i])
        place = np.uint32(at[PLACE + k])
        record = place << FOUR
        g[NEAR + k], g[NEAR_GX + k], g[NEAR_GY + k] = pixels[record], pixels[record + np.uint32(1)], pixels[record + np.uint32(2)]
        g[NEAR_Y + k] = lines[(place << TWO) + np.uint32(1)]


@njit(**INLINE)
def jump(s: Any, g: Any, n: int, cubics: Any, to_unit: Any, u_max: Any, v_max: Any) -> None:
    """Step from the pixels kept or looked up to where their slopes let phase and line be right."""
    y_u, y_v = cubics[2], cubics[3]
    u0, per_u, v0, per_v = to_unit
    for i in range(n):
        u, v = s[U + i], s[V + i]
        us, vs = (u - u0) * per_u, (v - v0) * per_v
        c, d = cubic(y_u, us, vs), cubic(y_v, us, vs)
        gx, gy = g[NEAR_GX + i], g[NEAR_GY + i]
        down = s[Y + i] - g[NEAR_Y + i]
        rise = s[PHASE + i] - g[NEAR + i]
        scale = ONE / (gx * d - gy * c)
        du = (d * rise - gy * down) * scale
        dv = (gx * down - c * rise) * scale
        near = (abs(du) < FARTHEST_PX) & (abs(dv) < FARTHEST_PX)
        s[U + i] = min(max(u + (du if near else ZERO), ZERO), u_max)
        s[V + i] = min(max(v + (dv if near else ZERO), ZERO), v_max)


@njit(**INLINE)
def fetch(s: Any, g: Any, r: Any, at: Any, n: int, width: Any, phase: Any, quad: Any, pixels: Any, lines: Any) -> None:
    """Fetch the four phases around the places U, V and the record and line of the nearest pixel; those of the next row are asked for."""
    below = np.uint32(width)
    for i in range(in_groups(n)):
        u, v = s[U + i], s[V + i]
        at[PLACE + i] = np.int32(v) * width + np.int32(u)
        at[NEAREST + i] = np.int32(v + HALF) * width + np.int32(u + HALF)
    for i in range(n):
        corner, nearest = np.uint32(at[PLACE + i]), np.uint32(at[NEAREST + i])
        copy_2(r, np.uint32(ABOVE + 2 * i), phase, corner)
        copy_2(r, np.uint32(BELOW + 2 * i), phase, corner + below)
        at[PLACE + i] = quad[corner]
        copy_4(r, np.uint32(RECORD + 4 * i), pixels, nearest << FOUR)
        copy_2(r, np.uint32(LINE + 2 * i), lines, nearest << TWO)
        ahead = nearest + below * ROWS_AHEAD
        will_read(pixels, ahead << FOUR)
        will_read(lines, ahead << TWO)
        will_read(phase, ahead)
    for i in range(in_groups(n)):
        s[QUAD + i] = at[PLACE + i]
    for i in range(0, n, GROUP):
        split_2(g, np.uint32(ABOVE + i), LANE, r, np.uint32(ABOVE + 2 * i))
        split_2(g, np.uint32(BELOW + i), LANE, r, np.uint32(BELOW + 2 * i))
        split_4(g, np.uint32(RECORD + i), LANE, r, np.uint32(RECORD + 4 * i))
        split_2(g, np.uint32(LINE + i), LANE, r, np.uint32(LINE + 2 * i))


@njit(**INLINE)
def newton(s: Any, g: Any, n: int, cubics: Any, to_unit: Any, limits: Any, numbers: Any, last: bool) -> None:
    """Step from U, V to where the phase between the four pixels, or beside a hole along the slope, is right on the line."""
    x_u, x_v, y_u, y_v = cubics
    u0, per_u, v0, per_v = to_unit
    u_max, v_max = limits
    focal, offset, baseline = numbers
    focal_baseline = focal * baseline
    for i in range(in_groups(n)):
        u, v = s[U + i], s[V + i]
        fu, fv = np.float32(np.int32(u)), np.float32(np.int32(v))
        nu, nv = np.float32(np.int32(u + HALF)), np.float32(np.int32(v + HALF))
        us, vs = (u - u0) * per_u, (v - v0) * per_v
        a, b, c, d = cubic(x_u, us, vs), cubic(x_v, us, vs), cubic(y_u, us, vs), cubic(y_v, us, vs)
        gx, gy, sigma = g[NEAR_GX + i], g[NEAR_GY + i], g[NEAR_SIGMA + i]
        p, q = u - fu, v - fv
        du, dv = u - nu, v - nv
        right, under = g[P01 + i] - g[P00 + i], g[P10 + i] - g[P00 + i]
        twist = g[P11 + i] - g[P10 + i] - right
        lx, ly = right + q * twist, under + p * twist
        whole = s[QUAD + i] == ONE
        value = g[P00 + i] + p * right + q * ly if whole else g[NEAR + i] + gx * du + gy * dv
        per_area = ONE / (a * d - b * c)
        slope = (gx * d - gy * c) * per_area
        local = (lx * d - ly * c) * per_area
        inner = whole & (local * slope > QUARTER * slope * slope)
        along = local if inner else slope
        across = ((ly if inner else gy) * a - (lx if inner else gx) * b) * per_area
        down = s[Y + i] - (g[NEAR_Y + i] + c * du + d * dv)
        move = (s[PHASE + i] - value - down * across) / along
        move = min(max(move, -FARTHEST_PX), FARTHEST_PX)
        to_u, to_v = (d * move - b * down) * per_area, (a * down - c * move) * per_area
        pn, qn = p + to_u, q + to_v
        within = (pn >= -BEYOND) & (pn <= ONE + BEYOND) & (qn >= -BEYOND) & (qn <= ONE + BEYOND)
        close = within if inner else (abs(du + to_u) <= HALF + BEYOND) & (abs(dv + to_v) <= HALF + BEYOND)
        settles = close | (last & (abs(to_u) + abs(to_v) < HALF))
        pn, qn = min(max(pn, ZERO), ONE), min(max(qn, ZERO), ONE)
        reach = abs(du + to_u) + abs(dv + to_v)
        outward = (ONE + reach) * (ONE + reach) + reach * reach
        share = (pn * pn + (ONE - pn) * (ONE - pn)) * (qn * qn + (ONE - qn) * (ONE - qn)) if whole else outward
        bad = ((s[QUAD + i] != ONE) & (s[QUAD + i] != ON_EDGE)) | (abs(slope) < FLAT)
        parallax = s[X + i] - g[NEAR_X + i] + offset - (a * du + b * dv + move)
        z = focal_baseline / (parallax * s[DEPTH_SCALE + i])
        z = z if parallax > ZERO else ZERO
        noise = sigma * sigma * share
        steep = slope * slope >= STEEP * STEEP * noise
        left = LOST if bad else (ZERO if settles else ONE)
        held = s[CODE + i] == HELD
        found = held & (left < ONE) & (z > ZERO)
        s[LEFT + i] = left if held else LOST
        s[NOISE + i] = noise
        s[GAIN + i] = slope * parallax * parallax * s[DEPTH_SCALE + i] * (ONE / focal_baseline)
        s[Z + i] = z if found & steep else ZERO
        s[NEXT_U + i] = min(max(u + to_u, ZERO), u_max)
        s[NEXT_V + i] = min(max(v + to_v, ZERO), v_max)
        s[CODE + i] = (HELD if steep else TWICE) if found else (ZERO if held else s[CODE + i])
