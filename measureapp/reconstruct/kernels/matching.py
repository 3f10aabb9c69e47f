"""Compiled loop that finds the pixels of one camera in another: same epipolar line, same phase.

``lines`` (H, W, 2) are the rectified coordinates (x, y) of every pixel of a pair; equal y is the same epipolar line; ``pixels``
(H, W, 4) are the records of `kernels.slopes`. The loop works on chunks of pixels in lanes of scratch arrays: ``s`` for numbers of the
pixel that is matched, ``at`` for indices, ``r`` for records as they are fetched from the other camera, ``g`` for these in lanes. What
arithmetic reads and what it writes are different arrays or lanes of one stride: only then does the compiler use SIMD instructions.
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
    PLACES,
    QUAD,
    SCRATCH,
    SOME,
    TWO,
    ZERO,
    U,
    V,
    X,
    Y,
    Z,
    ask_for,
    count_matched,
    count_wanted,
    forget,
    in_groups,
    keep_nearest,
    keep_unsettled,
    list_marked,
    list_wanted,
    load,
    load_listed,
    store_all,
    store_some,
)
from measureapp.reconstruct.kernels.options import INLINE, LOOP
from measureapp.reconstruct.kernels.scratch import GROUP, copy_1, copy_2, copy_4, split_2, split_4, stack_float32, stack_int32
from measureapp.reconstruct.kernels.seen import REPEATS, WITHOUT_PARTNER
from measureapp.reconstruct.kernels.slopes import BESIDE, REACH

STEEP = np.float32(4.0 / (REACH * np.sqrt(2.0)))  # a slope below four of its standard deviations does not tell where the point is
FLAT = np.float32(1e-6)
FARTHEST_PX = np.float32(12.0)  # from a cell's pixel to the match
ITERATIONS = 6
ON_EDGE = np.float32(BESIDE)  # there a pixel speaks for the square of half a pixel around it that it is the mean of, and for no more
QUARTER = np.float32(0.25)
BEYOND = np.float32(0.1)  # so far out of its four pixels a place may lie, in px
EDGE = np.float32(1.001)
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


@njit(**LOOP)
def match(
    rays: Any,  # (H, 2 W) float32, normalised image coordinates of the camera
    phase: Any,
    skip: Any,  # (H, W) uint8, 0 for pixels to match
    partner: Any,  # what is needed of the other camera:
    #     (H, 2 W) float32, where the pixels of the camera that is matched lie in the rectified image
    #     (3,) float32, third row of the turn to it: the rectified depth of a ray
    #     (H, W) of the other camera's image, and flat: its phases, quads, records of pixels and rectified coordinates
    #     four cubic polynomials: ∂x/∂u, ∂x/∂v, ∂y/∂u, ∂y/∂v of the latter
    #     (u0, per u, v0, per v): their variables are (u − u0) · per u, (v − v0) · per v
    #     shape of the other camera's table; the table with what is repeated in this one's, flat; lowest phase; bins per radian
    #     (focal, x0 here − x0 there, baseline), float32
    row_start: int,
    row_stop: int,
    column_start: int,
    column_stop: int,
    depth: Any,  # out (rows, columns) float32, z in the camera's frame, 0 for none
    gain: Any,  # out (rows, columns) float32, change of the other camera's phase with z, rad/mm
    variance: Any,  # out (rows, columns) float32, of the other camera's phase
    there: Any,  # out (rows, columns) int32, index of the other camera's pixel
    reason: Any,  # out (rows, columns) uint8, MATCHED | WITHOUT_PARTNER | REPEATS
) -> int:
    """Match pixels by their phase along the epipolar line; returns how many.

    From a pixel with nearly that phase on nearly that line a step of Newton's method in both leads to the place where phase and line
    are right; the phase is read there between four pixels, so that its variance is known, and the small rest follows the slope over
    several pixels. Pixels whose phase occurs at more than one place of the epipolar line, in either camera, are not matched.
    """
    lines, turn, shape, other_phase, other_quad, other_pixels, other_lines = partner[:7]
    cubics, to_unit, table_shape, table, lowest, per_rad, numbers = partner[7:]
    columns, width = phase.shape[1], np.int32(shape[1])
    limits = (np.float32(shape[1]) - EDGE, np.float32(shape[0]) - EDGE)
    s, at = stack_float32(SCRATCH), stack_int32(PLACES)
    r, g, later = stack_float32(GATHERED), stack_float32(GATHERED), stack_float32(GATHERED)
    g[:] = ZERO
    matched = 0
    depth[:] = ZERO
    reason[:] = WITHOUT_PARTNER
    # Down the columns: what a row takes from the other camera is near at hand for the next.
    for first in range(column_start, column_stop, CHUNK):
        forget(s)
        for y in range(row_start, row_stop):
            out = y - row_start
            n = min(CHUNK, column_stop - first)
            part, pairs = slice(first, first + n), slice(2 * first, 2 * (first + n))
            into = slice(first - column_start, first - column_start + n)
            wanted = count_wanted(skip[y, part], n)
            ask_for(phase, lines, rays, skip, (y + 1) * columns + first, n)
            if wanted == 0:
                continue
            mostly = 2 * wanted > n
            if mostly:
                load(s, n, phase[y, part], lines[y, pairs], rays[y, pairs], turn, skip[y, part])
            else:
                n = list_wanted(at, n, skip[y, part])
                load_listed(s, at, n, phase[y, part], lines[y, pairs], rays[y, pairs], turn)
                forget(s)
            look_up(s, at, n, table, table_shape, lowest, per_rad, width)
            fetch_start(s, g, at, n, other_pixels, other_lines)
            jump(s, g, n, cubics, to_unit, limits[0], limits[1])
            fetch(s, g, r, at, n, width, other_phase, other_quad, other_pixels, other_lines)
            newton(s, g, n, cubics, to_unit, limits, numbers, False)
            if mostly:
                store_all(s, at, n, depth[out, into], gain[out, into], variance[out, into], there[out, into], reason[out, into])
                keep_nearest(s, n)
            else:
                store_some(s, at, n, depth[out, into], gain[out, into], variance[out, into], there[out, into], reason[out, into])
            for step in range(1, ITERATIONS):
                n = keep_unsettled(s, at, n)
                if n == 0:
                    break
                fetch(s, later, r, at, n, width, other_phase, other_quad, other_pixels, other_lines)
                newton(s, later, n, cubics, to_unit, limits, numbers, step == ITERATIONS - 1)
                store_some(s, at, n, depth[out, into], gain[out, into], variance[out, into], there[out, into], reason[out, into])
    for row in range(row_stop - row_start):
        matched += count_matched(reason[row])
    return matched
