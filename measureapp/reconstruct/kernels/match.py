"""Matching of two cameras: Newton's method for the place of equal phase on the epipolar line, with SIMD vectors.

A group of LANES pixels of a row stays in registers from the table lookup to the end of its first Newton step. Pixels that need further
steps are collected over a strip of the row, so that their vectors are full again. `reference.matching` states the same in NumPy.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.prefetch import prefetch
from measureapp.compiled.simd.elements import any_lane, bitmask, broadcast, convert, count_trailing_zeros, maximum, minimum, select
from measureapp.compiled.simd.memory import gather, gather_records, load, store
from measureapp.reconstruct.kernels.stack import stack_float32, stack_int32
from measureapp.reconstruct.kernels.structures import AMBIGUOUS, CONTINUOUS, LANES, MATCHED, PARTIAL, RECORD, Candidates, Partner, cubic
from measureapp.reconstruct.kernels.table import COLUMN_MASK, LINES_PER_CELL, REPEATED, ROW_SHIFT

STRIP = 256  # columns; what its pixels read of the other camera stays in the second-level cache from row to row
MAX_STEPS = 6  # of Newton's method
MAX_MOVE_PX = np.float32(12.0)  # of one step, along the epipolar line
QUAD_MARGIN_PX = np.float32(0.1)  # a solution may lie so far outside the four pixels whose phases are interpolated
MIN_SLOPE = np.float32(1e-6)  # rad/px along the epipolar line
MIN_SLOPE_SIGMAS = np.float32(4.0 / (3 * np.sqrt(2.0)))  # below four of its standard deviations, a slope over ±3 px locates no point
MIN_LOCAL_SLOPE = np.float32(0.25)  # of four pixels, relative to the slope over several; below, it is mostly noise
BORDER_PX = np.float32(1.001)  # behind a place four pixels are read
PREFETCH_ROWS = 6
SAME_SURFACE_PX = np.int32(8)  # a start in the row above is preferred to the table's pixel if they are so near to each other
NOWHERE, PER_ROW = np.int32(-1000 << 16), np.int32(1 << 16)
ZERO, HALF, ONE = np.float32(0), np.float32(0.5), np.float32(1)  # of the vectors' type
LANE_NUMBERS = np.arange(LANES, dtype=np.float32)
UNMATCHED_CODE, MATCHED_CODE, AMBIGUOUS_CODE = ZERO, np.float32(MATCHED), np.float32(AMBIGUOUS)


class Pixels(NamedTuple):
    """Pixels of a strip that are to be matched."""

    phase: Any
    x: Any  # rectified
    y: Any
    depth_scale: Any  # rectified depth at depth 1
    u: Any  # place in the other camera
    v: Any
    column: Any  # int32, in the strip
    above: Any  # int32, pixel of the other camera where the pixel of the row above started, packed as in the table


class Step(NamedTuple):
    """Result of a Newton step of a group."""

    depth: Any
    gain: Any
    variance: Any
    nearest: Any  # index of the other camera's nearest pixel
    start: Any  # the same pixel packed as in the table, NOWHERE where the step has failed
    matched: Any  # mask
    ambiguous: Any  # mask
    pending: Any  # mask of those that need another step
    u: Any  # from where
    v: Any


@njit(**INLINE)
def stack_pixels() -> Pixels:
    """Return scratch memory for the pixels of a strip."""
    a, b, c, d = stack_float32(STRIP), stack_float32(STRIP), stack_float32(STRIP), stack_float32(STRIP)
    return Pixels(a, b, c, d, stack_float32(STRIP), stack_float32(STRIP), stack_int32(STRIP), stack_int32(STRIP))


@njit(**INLINE)
def clamp(value: Any, low: Any, high: Any) -> Any:
    """Limit values to an interval."""
    return minimum(maximum(value, low), high)


@njit(**INLINE)
def has_zero(values: Any) -> bool:
    """Whether some of the values are 0."""
    zeros = np.int32(0)
    for i in range(len(values)):
        zeros += values[i] == 0
    return bool(zeros > 0)


@njit(**INLINE)
def load_strip(pixels: Pixels, skipped: Any, phase: Any, rectified: Any, rays: Any, axis: Any, skip: Any) -> None:
    """Load the pixels of a row, and mark the lanes behind them in their group to be skipped."""
    n = len(phase)
    for i in range(n):
        pixels.phase[i], skipped[i] = phase[i], skip[i]
    for i in range(n):
        pixels.x[i], pixels.y[i] = rectified[2 * i], rectified[2 * i + 1]
    for i in range(n):
        pixels.depth_scale[i] = axis[0] * rays[2 * i] + axis[1] * rays[2 * i + 1] + axis[2]
    for i in range(n, min(n + LANES, STRIP)):
        skipped[i], pixels.phase[i], pixels.x[i], pixels.y[i], pixels.depth_scale[i] = 1, ZERO, ZERO, ZERO, ZERO


@njit(**INLINE)
def place_limits(partner: Partner) -> Any:
    """Return the largest u and v at which four pixels can be read."""
    return np.float32(partner.shape[1]) - BORDER_PX, np.float32(partner.shape[0]) - BORDER_PX


@njit(**INLINE)
def look_up(phase: Any, y: Any, partner: Partner) -> Any:
    """Look up pixels of nearly the same phase on nearly the same epipolar line; negative for none."""
    rows, bins = partner.table_shape
    row = clamp(y * np.float32(1 / LINES_PER_CELL) + ONE, ZERO, np.float32(rows - 1))
    column = clamp((phase - partner.table.lowest) * partner.table.per_rad + ONE, ZERO, np.float32(bins - 1))
    cell = convert(row, np.int32) * np.int32(bins) + convert(column, np.int32)
    return gather(partner.table.cells, cell), cell


@njit(**INLINE)
def start(phase: Any, y: Any, u: Any, v: Any, index: Any, partner: Partner) -> Any:
    """Return where Newton's method starts: a step from the looked-up pixel in both coordinates, by its slopes."""
    u0, per_u, v0, per_v = partner.unit
    s, t = (u - u0) * per_u, (v - v0) * per_v
    y_u, y_v = cubic(partner.jacobian[2], s, t), cubic(partner.jacobian[3], s, t)
    near, gx, gy, _sigma = gather_records(partner.records, RECORD, index, 0, LANES, RECORD)
    _near_x, near_y = gather_records(partner.rectified, 2, index, 0, LANES, 2)
    dy, dphase = y - near_y, phase - near
    determinant = gx * y_v - gy * y_u
    du, dv = y_v * dphase - gy * dy, gx * dy - y_u * dphase
    solvable = maximum(abs(du), abs(dv)) < MAX_MOVE_PX * abs(determinant)
    scale = ONE / determinant
    max_u, max_v = place_limits(partner)
    return clamp(u + select(solvable, du * scale, ZERO), ZERO, max_u), clamp(v + select(solvable, dv * scale, ZERO), ZERO, max_v)


@njit(**INLINE)
def newton(
    phase: Any, x: Any, y: Any, depth_scale: Any, u: Any, v: Any, active: Any, last: bool, corners: Any, nearests: Any, partner: Partner
) -> Step:
    """Take a Newton step from (u, v) to where phase and epipolar line agree; a step that stays in its four pixels gives the match.

    The phase is interpolated between four pixels, so that its variance is known; beside a hole it follows the slope of the nearest pixel.
    """
    width = np.int32(partner.shape[1])
    corner_u, corner_v = convert(u, np.int32), convert(v, np.int32)
    nearest_u, nearest_v = convert(u + HALF, np.int32), convert(v + HALF, np.int32)
    corner, nearest = corner_v * width + corner_u, nearest_v * width + nearest_u
    store(corner, corners, 0)
    store(nearest, nearests, 0)
    p00, p01 = gather_records(partner.phase, 1, corners, 0, LANES, 2)
    p10, p11 = gather_records(partner.phase[width:], 1, corners, 0, LANES, 2)
    (quad,) = gather_records(partner.quads, 1, corners, 0, LANES, 1)
    near, gx, gy, sigma = gather_records(partner.records, RECORD, nearests, 0, LANES, RECORD)
    near_x, near_y = gather_records(partner.rectified, 2, nearests, 0, LANES, 2)

    u0, per_u, v0, per_v = partner.unit
    s, t = (u - u0) * per_u, (v - v0) * per_v
    x_u, x_v = cubic(partner.jacobian[0], s, t), cubic(partner.jacobian[1], s, t)
    y_u, y_v = cubic(partner.jacobian[2], s, t), cubic(partner.jacobian[3], s, t)
    per_area = ONE / (x_u * y_v - x_v * y_u)

    a, b = u - convert(corner_u, np.float32), v - convert(corner_v, np.float32)
    du, dv = u - convert(nearest_u, np.float32), v - convert(nearest_v, np.float32)
    twist = p11 - p10 - (p01 - p00)
    local_gx, local_gy = (p01 - p00) + b * twist, (p10 - p00) + a * twist
    state = convert(quad, np.float32)
    continuous = state == np.float32(CONTINUOUS)
    value = select(continuous, p00 + a * (p01 - p00) + b * local_gy, near + gx * du + gy * dv)
    slope = (gx * y_v - gy * y_u) * per_area
    local_slope = (local_gx * y_v - local_gy * y_u) * per_area
    local = continuous & (local_slope * slope > MIN_LOCAL_SLOPE * slope * slope)
    along = select(local, local_slope, slope)
    across = (select(local, local_gy, gy) * x_u - select(local, local_gx, gx) * x_v) * per_area

    dy = y - (near_y + y_u * du + y_v * dv)
    dx = clamp((phase - value - dy * across) / along, -MAX_MOVE_PX, MAX_MOVE_PX)
    step_u, step_v = (y_v * dx - x_v * dy) * per_area, (x_u * dy - y_u * dx) * per_area
    to_a, to_b = a + step_u, b + step_v
    off_centre = select(local, maximum(abs(to_a - HALF), abs(to_b - HALF)), maximum(abs(du + step_u), abs(dv + step_v)))
    settled = (off_centre <= HALF + QUAD_MARGIN_PX) | (abs(step_u) + abs(step_v) < (HALF if last else ZERO))

    to_a, to_b = clamp(to_a, ZERO, ONE), clamp(to_b, ZERO, ONE)
    inside = (to_a * to_a + (ONE - to_a) * (ONE - to_a)) * (to_b * to_b + (ONE - to_b) * (ONE - to_b))
    reach = abs(du + step_u) + abs(dv + step_v)
    variance = sigma * sigma * select(continuous, inside, (ONE + reach) * (ONE + reach) + reach * reach)
    disparity = x - near_x + partner.offset - (x_u * du + x_v * dv + dx)
    focal_baseline = partner.focal * partner.baseline
    depth = focal_baseline / (disparity * depth_scale)
    usable = active & (continuous | (state == np.float32(PARTIAL))) & (abs(slope) >= MIN_SLOPE)
    found = usable & settled & (minimum(disparity, depth) > ZERO)
    precise = slope * slope >= MIN_SLOPE_SIGMAS * MIN_SLOPE_SIGMAS * variance
    gain = slope * disparity * disparity * depth_scale * (ONE / focal_baseline)
    max_u, max_v = place_limits(partner)
    to_u, to_v = clamp(u + step_u, ZERO, max_u), clamp(v + step_v, ZERO, max_v)
    start = select(usable, nearest_v * PER_ROW + nearest_u, NOWHERE)
    return Step(depth, gain, variance, nearest, start, found & precise, found & ~precise, usable & ~settled, to_u, to_v)


@njit(**INLINE)
def prefetch_table(cell: Any, cells: Any, partner: Partner) -> None:
    """Prefetch the cells that the pixels of the next row look up."""
    store(cell, cells, 0)
    for k in range(0, LANES, 8):
        prefetch(partner.table.cells, np.uint32(cells[k] + partner.table_shape[1]))


@njit(**INLINE)
def prefetch_below(nearests: Any, partner: Partner) -> None:
    """Prefetch the other camera's pixels some rows below a group: hardware prefetchers do not follow a walk down the columns."""
    ahead = np.int32(partner.shape[1]) * PREFETCH_ROWS
    for k in range(0, LANES, 2):
        prefetch(partner.records, np.uint32(nearests[k] + ahead) * np.uint32(RECORD))
    for k in range(0, LANES, 4):
        prefetch(partner.rectified, np.uint32(nearests[k] + ahead) * np.uint32(2))
    for k in range(0, LANES, 8):
        prefetch(partner.phase, np.uint32(nearests[k] + ahead))
    prefetch(partner.quads, np.uint32(nearests[0] + ahead))


class Scratch(NamedTuple):
    """Values of a group in memory, where single lanes can be read."""

    index: Any  # int32
    nearest: Any
    code: Any  # float32
    depth: Any
    gain: Any
    variance: Any
    u: Any
    v: Any


@njit(**INLINE)
def stack_scratch() -> Scratch:
    """Return scratch memory for a group."""
    a, b, c, d = stack_float32(LANES), stack_float32(LANES), stack_float32(LANES), stack_float32(LANES)
    return Scratch(stack_int32(LANES), stack_int32(LANES), a, b, c, d, stack_float32(LANES), stack_float32(LANES))


@njit(**INLINE)
def append_pending(pending: Pixels, count: int, step: Step, pixels: Pixels, i: int, scratch: Scratch) -> int:
    """Append the pixels of the i-th group that need another step to a list, which may be the one they are from; returns its length."""
    bits = bitmask(step.pending)
    store(step.u, scratch.u, 0)
    store(step.v, scratch.v, 0)
    while bits != np.uint32(0):
        lane = count_trailing_zeros(bits)
        k, m = np.uint32(i) + lane, np.uint32(count)
        pending.phase[m], pending.x[m], pending.y[m] = pixels.phase[k], pixels.x[k], pixels.y[k]
        pending.depth_scale[m], pending.column[m] = pixels.depth_scale[k], pixels.column[k]
        pending.u[m], pending.v[m] = scratch.u[lane], scratch.v[lane]
        count += 1
        bits &= bits - np.uint32(1)
    return count


@njit(**INLINE)
def result_code(step: Step, otherwise: Any) -> Any:
    """Return the result of matching as a number, ``otherwise`` for pixels that were not matched."""
    unmatched = select(step.ambiguous, broadcast(AMBIGUOUS_CODE, LANES), otherwise)
    return select(step.matched, broadcast(MATCHED_CODE, LANES), unmatched)


@njit(**INLINE)
def take_first_step(
    i: int, pixels: Pixels, skipped: Any, pending: Pixels, count: int, scratch: Scratch, partner: Partner, out: Candidates
) -> int:
    """Look up and step once with the i-th group of a strip; returns how many pixels are pending then."""
    wanted = load(skipped, i, LANES) == np.int32(0)
    if not any_lane(wanted):
        for k in range(i, i + LANES):
            out.depth[k], out.reason[k], pixels.above[k] = ZERO, np.uint8(UNMATCHED_CODE), NOWHERE
        return count
    phase, x, y = load(pixels.phase, i, LANES), load(pixels.x, i, LANES), load(pixels.y, i, LANES)
    held, cell = look_up(phase, y, partner)
    prefetch_table(cell, scratch.index, partner)
    known, repeated = wanted & (held >= np.int32(0)), (held & REPEATED) != np.int32(0)
    active = known & ~repeated
    held = select(active, held, np.int32(0))
    above = load(pixels.above, i, LANES)
    apart = maximum(abs((held >> ROW_SHIFT) - (above >> ROW_SHIFT)), abs((held & COLUMN_MASK) - (above & COLUMN_MASK)))
    held = select(apart <= SAME_SURFACE_PX, above, held)
    row, column = held >> ROW_SHIFT, held & COLUMN_MASK
    store(row * np.int32(partner.shape[1]) + column, scratch.index, 0)
    u, v = start(phase, y, convert(column, np.float32), convert(row, np.float32), scratch.index, partner)
    step = newton(phase, x, y, load(pixels.depth_scale, i, LANES), u, v, active, False, scratch.index, scratch.nearest, partner)
    prefetch_below(scratch.nearest, partner)
    store(select(step.matched, step.depth, ZERO), out.depth, i)
    store(step.gain, out.gain, i)
    store(step.variance, out.variance, i)
    store(step.nearest, out.pixel, i)
    store(step.start, pixels.above, i)
    store(convert(result_code(step, AMBIGUOUS_CODE * convert(known & repeated, np.float32)), np.uint8), out.reason, i)
    return append_pending(pending, count, step, pixels, i, scratch)


@njit(**INLINE)
def take_further_step(
    i: int, listed: int, last: bool, pending: Pixels, count: int, scratch: Scratch, partner: Partner, out: Candidates
) -> int:
    """Step once more with the i-th group of the pending pixels; returns how many are pending then."""
    active = load(LANE_NUMBERS, 0, LANES) < np.float32(listed - i)
    phase, x, y = load(pending.phase, i, LANES), load(pending.x, i, LANES), load(pending.y, i, LANES)
    u, v, depth_scale = load(pending.u, i, LANES), load(pending.v, i, LANES), load(pending.depth_scale, i, LANES)
    step = newton(phase, x, y, depth_scale, u, v, active, last, scratch.index, scratch.nearest, partner)
    store(result_code(step, broadcast(UNMATCHED_CODE, LANES)), scratch.code, 0)
    store(select(step.matched, step.depth, ZERO), scratch.depth, 0)
    store(step.gain, scratch.gain, 0)
    store(step.variance, scratch.variance, 0)
    for lane in range(min(LANES, listed - i)):
        k = np.uint32(pending.column[np.uint32(i + lane)])
        out.depth[k], out.gain[k], out.variance[k] = scratch.depth[lane], scratch.gain[lane], scratch.variance[lane]
        out.pixel[k], out.reason[k] = scratch.nearest[lane], np.uint8(np.int32(scratch.code[lane]))
    return append_pending(pending, count, step, pending, i, scratch)


@njit(**INLINE)
def row_of(found: Candidates, row: int, begin: int) -> Candidates:
    """Return a row of the candidates from a column on."""
    part = slice(begin, None)
    return Candidates(
        found.depth[row, part], found.gain[row, part], found.variance[row, part], found.pixel[row, part], found.reason[row, part]
    )


@njit(**LOOP)
def match(
    rays: Any,  # (H, 2 W) float32, normalised image coordinates of the camera
    phase: Any,  # (H, W) float32
    skip: Any,  # (H, W) uint8, 0 for pixels to match
    partner: Partner,
    row_start: int,
    row_stop: int,
    column_start: int,
    column_stop: int,
    found: Candidates,  # out (rows, columns rounded up to whole groups)
) -> int:
    """Match pixels with another camera where phase and epipolar line are equal; returns how many.

    Pixels whose phase occurs at more than one place of the epipolar line, in either camera, are not matched.
    """
    pixels, pending, skipped, scratch = stack_pixels(), stack_pixels(), stack_int32(STRIP), stack_scratch()
    for k in range(STRIP):  # lanes behind the last pixel read the first pixel of the other camera
        pixels.column[k], pending.u[k], pending.v[k] = k, ZERO, ZERO
    matched = 0
    for first in range(column_start, column_stop, STRIP):
        n = min(STRIP, column_stop - first)
        pixels.above[:] = NOWHERE
        part, pairs = slice(first, first + n), slice(2 * first, 2 * (first + n))
        for y in range(row_start, row_stop):
            out = row_of(found, y - row_start, first - column_start)
            if not has_zero(skip[y, part]):
                out.depth[:n], out.reason[:n], pixels.above[:] = ZERO, np.uint8(UNMATCHED_CODE), NOWHERE
                continue
            rectified, ray = partner.own_rectified[y, pairs], rays[y, pairs]
            load_strip(pixels, skipped, phase[y, part], rectified, ray, partner.depth_axis, skip[y, part])
            count = 0
            for i in range(0, n, LANES):
                count = take_first_step(i, pixels, skipped, pending, count, scratch, partner, out)
            for number in range(1, MAX_STEPS):
                listed, count = count, 0
                for i in range(0, listed, LANES):
                    count = take_further_step(i, listed, number == MAX_STEPS - 1, pending, count, scratch, partner, out)
            for i in range(n):
                matched += out.reason[i] == MATCHED
    return matched
