"""Compiled steps of the search for a pixel in another camera: where to begin, and Newton's method on line and phase.

See `matching` for the lanes and records.
"""
# A step of Newton's method is one function: its parts would hand dozens of vectors to each other.

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.cache_hints import prefetch
from measureapp.compiled.options import INLINE
from measureapp.compiled.simd.elements import bitmask, convert, count_trailing_zeros, maximum, minimum, select
from measureapp.compiled.simd.memory import gather_records, load, store
from measureapp.reconstruct.kernels.binning import REPEATED
from measureapp.reconstruct.kernels.constants import PIXELS
from measureapp.reconstruct.kernels.cubic import cubic
from measureapp.reconstruct.kernels.lanes import (
    CODE,
    DEPTH_SCALE,
    HALF,
    HELD,
    KEPT_C,
    KEPT_D,
    KEPT_GX,
    KEPT_GY,
    KEPT_PHASE,
    KEPT_U,
    KEPT_V,
    KEPT_Y,
    NEAR_GX,
    NEAR_GY,
    NEAR_PHASE,
    NEAR_SIGMA,
    NEAR_X,
    NEAR_Y,
    NEAREST,
    NONE,
    NOWHERE,
    ONE,
    P00,
    P01,
    P10,
    P11,
    PER_AREA,
    PHASE,
    PLACE,
    QUAD,
    ROWS_AHEAD,
    TWICE,
    TWO,
    WANTED,
    ZERO,
    A,
    B,
    C,
    D,
    U,
    V,
    X,
    Y,
)
from measureapp.reconstruct.kernels.slopes import BESIDE, REACH, WHOLE

STEEP = np.float32(4.0 / (REACH * np.sqrt(2.0)))  # a slope below four of its standard deviations does not tell where the point is
FLAT = np.float32(1e-6)
FARTHEST_PX = np.float32(12.0)  # from a cell's pixel to the match
ALL_WHOLE, ON_EDGE = np.float32(WHOLE), np.float32(BESIDE)  # what four pixels are together
QUARTER = np.float32(0.25)
BEYOND = np.float32(0.1)  # so far out of its four pixels a place may lie, in px
KEEPS_PX = np.float32(8.0)  # so near to a cell's pixel the match of the row above lies on the same surface
CELLS_APART, RECORDS_APART, PAIRS_APART, PHASES_APART = 8, 2, 4, 8  # pixels whose cells, records, … lie in one cache line
HALVES, LOW_HALF, EMPTY = np.int32(16), np.int32(0xFFFF), np.int32(0)  # of what a cell holds
FOUR = np.uint32(2)  # as a shift


@njit(**INLINE)
def within(value: Any, most: Any) -> Any:
    """Return numbers between zero and ``most``."""
    return minimum(maximum(value, ZERO), most)


@njit(**INLINE)
def look_up(s: Any, at: Any, n: int, table: Any, shape: Any, lowest: Any, per_rad: Any) -> None:
    """Leave in NEAREST what the table holds of nearly the phase on nearly the line of n pixels."""
    bins = np.int32(shape[1])
    last_row, last_bin = np.float32(shape[0] - 1), np.float32(shape[1] - 1)
    for i in range(0, n, PIXELS):
        row = within(load(s, Y + i, PIXELS) * HALF + ONE, last_row)
        cell = within((load(s, PHASE + i, PIXELS) - lowest) * per_rad + ONE, last_bin)
        store(convert(row, np.int32) * bins + convert(cell, np.int32), at, PLACE + i)
    for i in range(0, n, CELLS_APART):
        prefetch(table, np.uint32(at[PLACE + i]) + np.uint32(bins))
    for i in range(0, n, PIXELS):
        (held,) = gather_records(table, 1, at, PLACE + i, PIXELS, 1)
        store(held, at, NEAREST + i)


@njit(**INLINE)
def take_start(s: Any, at: Any, i: int, started: Any, images: Any, cubics: Any, to_unit: Any, width: Any) -> None:
    """Fetch the records of those pixels of a group, one bit each, that were looked up for want of one kept from the row above."""
    pixels, lines = images[2], images[3]
    u0, per_u, v0, per_v = to_unit
    bits = started
    while bits != NONE:
        k = np.uint32(i + count_trailing_zeros(bits))
        place = np.uint32(at[PLACE + k])
        record = place << FOUR
        row = np.int32(at[PLACE + k] // width)
        us, vs = (np.float32(at[PLACE + k] - row * width) - u0) * per_u, (np.float32(row) - v0) * per_v
        s[KEPT_PHASE + k], s[KEPT_GX + k], s[KEPT_GY + k] = pixels[record], pixels[record + np.uint32(1)], pixels[record + np.uint32(2)]
        s[KEPT_Y + k] = lines[(place << TWO) + np.uint32(1)]
        s[KEPT_C + k], s[KEPT_D + k] = cubic(cubics[2], us, vs), cubic(cubics[3], us, vs)
        bits &= bits - np.uint32(1)


@njit(**INLINE)
def jump(s: Any, at: Any, n: int, width: Any, images: Any, cubics: Any, to_unit: Any, limits: Any) -> None:
    """Step from the pixels kept or looked up to where their slopes let phase and line be right; what the table says in CODE."""
    for i in range(0, n, PIXELS):
        held = load(at, NEAREST + i, PIXELS)
        told, repeated = held >= EMPTY, (held & REPEATED) != EMPTY
        usable = (load(s, CODE + i, PIXELS) == WANTED) & told & ~repeated
        held = select(usable, held, EMPTY)
        row, column = held >> HALVES, held & LOW_HALF
        u, v = convert(column, np.float32), convert(row, np.float32)
        kept_u, kept_v = load(s, KEPT_U + i, PIXELS), load(s, KEPT_V + i, PIXELS)
        keeps = maximum(abs(u - kept_u), abs(v - kept_v)) <= KEEPS_PX
        started = bitmask(usable & ~keeps)
        if started != NONE:
            store(row * width + column, at, PLACE + i)
            take_start(s, at, i, started, images, cubics, to_unit, width)
        u, v = select(keeps, kept_u, u), select(keeps, kept_v, v)
        c, d = load(s, KEPT_C + i, PIXELS), load(s, KEPT_D + i, PIXELS)
        gx, gy = load(s, KEPT_GX + i, PIXELS), load(s, KEPT_GY + i, PIXELS)
        down = load(s, Y + i, PIXELS) - load(s, KEPT_Y + i, PIXELS)
        rise = load(s, PHASE + i, PIXELS) - load(s, KEPT_PHASE + i, PIXELS)
        area = gx * d - gy * c
        du, dv = d * rise - gy * down, gx * down - c * rise
        farthest = FARTHEST_PX * abs(area)
        near = maximum(abs(du), abs(dv)) < farthest
        scale = ONE / area
        store(within(u + select(near, du * scale, ZERO), limits[0]), s, U + i)
        store(within(v + select(near, dv * scale, ZERO), limits[1]), s, V + i)
        store(select(usable, HELD, TWICE * convert(told & repeated, np.float32)), s, CODE + i)


@njit(**INLINE)
def aim(s: Any, at: Any, n: int, width: Any, cubics: Any, to_unit: Any) -> None:
    """Leave in PLACE and NEAREST the index of the first of the four pixels around the places U, V, and of the nearest one.

    In A to D goes by how much x and y change with u and v there.
    """
    x_u, x_v, y_u, y_v = cubics
    u0, per_u, v0, per_v = to_unit
    for i in range(0, n, PIXELS):
        u, v = load(s, U + i, PIXELS), load(s, V + i, PIXELS)
        store(convert(v, np.int32) * width + convert(u, np.int32), at, PLACE + i)
        store(convert(v + HALF, np.int32) * width + convert(u + HALF, np.int32), at, NEAREST + i)
        us, vs = (u - u0) * per_u, (v - v0) * per_v
        a, b, c, d = cubic(x_u, us, vs), cubic(x_v, us, vs), cubic(y_u, us, vs), cubic(y_v, us, vs)
        store(a, s, A + i)
        store(b, s, B + i)
        store(c, s, C + i)
        store(d, s, D + i)
        store(ONE / (a * d - b * c), s, PER_AREA + i)


@njit(**INLINE)
def prefetch_below(at: Any, i: int, ahead: Any, phase: Any, quad: Any, pixels: Any, lines: Any) -> None:
    """Prefetch what the pixels some rows below a group need."""
    for k in range(i, i + PIXELS, RECORDS_APART):
        prefetch(pixels, np.uint32(at[NEAREST + k] + ahead) << FOUR)
    for k in range(i, i + PIXELS, PAIRS_APART):
        prefetch(lines, np.uint32(at[NEAREST + k] + ahead) << TWO)
    for k in range(i, i + PIXELS, PHASES_APART):
        prefetch(phase, np.uint32(at[NEAREST + k] + ahead))
    prefetch(quad, np.uint32(at[NEAREST + i] + ahead))


@njit(**INLINE)
def fetch(s: Any, at: Any, n: int, width: Any, images: Any) -> None:
    """Fetch what is at the places in PLACE and NEAREST."""
    phase, quad, pixels, lines = images
    below = phase[width:]
    for i in range(0, n, PIXELS):
        prefetch_below(at, i, width * ROWS_AHEAD, *images)
        p00, p01 = gather_records(phase, 1, at, PLACE + i, PIXELS, 2)
        p10, p11 = gather_records(below, 1, at, PLACE + i, PIXELS, 2)
        (surface,) = gather_records(quad, 1, at, PLACE + i, PIXELS, 1)
        near, gx, gy, sigma = gather_records(pixels, 4, at, NEAREST + i, PIXELS, 4)
        x, y = gather_records(lines, 2, at, NEAREST + i, PIXELS, 2)
        store(p00, s, P00 + i)
        store(p01, s, P01 + i)
        store(p10, s, P10 + i)
        store(p11, s, P11 + i)
        store(convert(surface, np.float32), s, QUAD + i)
        store(near, s, NEAR_PHASE + i)
        store(gx, s, NEAR_GX + i)
        store(gy, s, NEAR_GY + i)
        store(sigma, s, NEAR_SIGMA + i)
        store(x, s, NEAR_X + i)
        store(y, s, NEAR_Y + i)


class Step(NamedTuple):
    """What a step finds of a group of pixels."""

    depth: Any
    gain: Any
    variance: Any
    code: Any  # HELD of those that are matched
    unsettled: Any  # mask of those that need another step
    next_u: Any
    next_v: Any


@njit(**INLINE)
def keep_nearest(s: Any, i: int, u: Any, v: Any) -> None:
    """Keep the nearest pixels of a group, and what was fetched of them: the matches of the next row lie beside them."""
    store(u, s, KEPT_U + i)
    store(v, s, KEPT_V + i)
    store(load(s, NEAR_PHASE + i, PIXELS), s, KEPT_PHASE + i)
    store(load(s, NEAR_GX + i, PIXELS), s, KEPT_GX + i)
    store(load(s, NEAR_GY + i, PIXELS), s, KEPT_GY + i)
    store(load(s, NEAR_Y + i, PIXELS), s, KEPT_Y + i)
    store(load(s, C + i, PIXELS), s, KEPT_C + i)
    store(load(s, D + i, PIXELS), s, KEPT_D + i)


@njit(**INLINE)
def newton(s: Any, i: int, limits: Any, numbers: Any, last: bool, keep: bool) -> Step:
    """Step from U, V to where the phase between the four pixels, or beside a hole along the slope, is right on the line."""
    focal, offset, baseline = numbers
    focal_baseline = focal * baseline
    p00, p01, p10, p11 = load(s, P00 + i, PIXELS), load(s, P01 + i, PIXELS), load(s, P10 + i, PIXELS), load(s, P11 + i, PIXELS)
    near, gx, gy = load(s, NEAR_PHASE + i, PIXELS), load(s, NEAR_GX + i, PIXELS), load(s, NEAR_GY + i, PIXELS)
    near_x, near_y, sigma = load(s, NEAR_X + i, PIXELS), load(s, NEAR_Y + i, PIXELS), load(s, NEAR_SIGMA + i, PIXELS)
    surface = load(s, QUAD + i, PIXELS)
    u, v = load(s, U + i, PIXELS), load(s, V + i, PIXELS)
    fu, fv = convert(convert(u, np.int32), np.float32), convert(convert(v, np.int32), np.float32)
    nu, nv = convert(convert(u + HALF, np.int32), np.float32), convert(convert(v + HALF, np.int32), np.float32)
    a, b, c, d = load(s, A + i, PIXELS), load(s, B + i, PIXELS), load(s, C + i, PIXELS), load(s, D + i, PIXELS)
    per_area = load(s, PER_AREA + i, PIXELS)
    p, q = u - fu, v - fv
    du, dv = u - nu, v - nv
    right, under = p01 - p00, p10 - p00
    twist = p11 - p10 - right
    lx, ly = right + q * twist, under + p * twist
    whole = surface == ALL_WHOLE
    value = select(whole, p00 + p * right + q * ly, near + gx * du + gy * dv)
    slope = (gx * d - gy * c) * per_area
    local = (lx * d - ly * c) * per_area
    inner = whole & (local * slope > QUARTER * slope * slope)
    along = select(inner, local, slope)
    across = (select(inner, ly, gy) * a - select(inner, lx, gx) * b) * per_area
    down = load(s, Y + i, PIXELS) - (near_y + c * du + d * dv)
    move = (load(s, PHASE + i, PIXELS) - value - down * across) / along
    move = minimum(maximum(move, -FARTHEST_PX), FARTHEST_PX)
    to_u, to_v = (d * move - b * down) * per_area, (a * down - c * move) * per_area
    pn, qn = p + to_u, q + to_v
    away = select(inner, maximum(abs(pn - HALF), abs(qn - HALF)), maximum(abs(du + to_u), abs(dv + to_v)))
    settles = (away <= HALF + BEYOND) | (abs(to_u) + abs(to_v) < (HALF if last else ZERO))
    pn, qn = within(pn, ONE), within(qn, ONE)
    reach = abs(du + to_u) + abs(dv + to_v)
    outward = (ONE + reach) * (ONE + reach) + reach * reach
    share = select(whole, (pn * pn + (ONE - pn) * (ONE - pn)) * (qn * qn + (ONE - qn) * (ONE - qn)), outward)
    held = load(s, CODE + i, PIXELS) == HELD
    taken = held & (whole | (surface == ON_EDGE)) & (abs(slope) >= FLAT)  # on an edge a pixel speaks for half a pixel around it
    parallax = load(s, X + i, PIXELS) - near_x + offset - (a * du + b * dv + move)
    scale = load(s, DEPTH_SCALE + i, PIXELS)
    depth = focal_baseline / (parallax * scale)
    variance = sigma * sigma * share
    steep = slope * slope >= STEEP * STEEP * variance
    found = taken & settles & (minimum(parallax, depth) > ZERO)
    if keep:
        keep_nearest(s, i, select(taken, nu, NOWHERE), nv)
    code = load(s, CODE + i, PIXELS)
    return Step(
        select(found & steep, depth, ZERO),
        slope * parallax * parallax * scale * (ONE / focal_baseline),
        variance,
        select(found, select(steep, code, TWICE), select(held, ZERO, code)),
        taken & ~settles,
        within(u + to_u, limits[0]),
        within(v + to_v, limits[1]),
    )
