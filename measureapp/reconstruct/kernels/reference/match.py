"""NumPy statement of matching: Newton's method row by row, all columns at once."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.reconstruct.kernels.match import (
    BORDER_PX,
    MAX_MOVE_PX,
    MAX_STEPS,
    MIN_LOCAL_SLOPE,
    MIN_SLOPE,
    MIN_SLOPE_SIGMAS,
    QUAD_MARGIN_PX,
    SAME_SURFACE_PX,
)
from measureapp.reconstruct.kernels.reference.table import unpack
from measureapp.reconstruct.kernels.structures import AMBIGUOUS, CONTINUOUS, MATCHED, PARTIAL, RECORD, UNMATCHED, Candidates, Partner, cubic
from measureapp.reconstruct.kernels.table import LINES_PER_CELL, REPEATED

NOWHERE = -1000


class Step(NamedTuple):
    """Result of a Newton step, (N,) each."""

    depth: FloatArray
    gain: FloatArray
    variance: FloatArray
    nearest: IntArray  # (2, N) row and column
    usable: BoolArray
    settled: BoolArray
    ambiguous: BoolArray
    positive: BoolArray  # disparity and depth
    u: FloatArray
    v: FloatArray


def jacobian_at(partner: Partner, u: FloatArray, v: FloatArray) -> list[FloatArray]:
    """Return ∂x/∂u, ∂x/∂v, ∂y/∂u, ∂y/∂v at places of the other camera."""
    u0, per_u, v0, per_v = partner.unit
    return [np.asarray(cubic.py_func(coefficients, (u - u0) * per_u, (v - v0) * per_v)) for coefficients in partner.jacobian]


def clip_places(partner: Partner, u: FloatArray, v: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Limit places to where four pixels can be read."""
    height, width = partner.shape
    return np.clip(u, 0, np.float32(width) - BORDER_PX), np.clip(v, 0, np.float32(height) - BORDER_PX)


def match(
    rays: FloatArray, phase: FloatArray, skip: IntArray, partner: Partner, row_start: int, row_stop: int, column_start: int,
    column_stop: int, found: Candidates,
) -> int:  # fmt: skip
    """Match pixels with another camera where phase and epipolar line are equal; returns how many."""
    part, pairs = slice(column_start, column_stop), slice(2 * column_start, 2 * column_stop)
    above = np.full((2, column_stop - column_start), NOWHERE)
    matched = 0
    for y in range(row_start, row_stop):
        xy, ray = partner.own_rectified[y, pairs].reshape(-1, 2), rays[y, pairs].reshape(-1, 2)
        scale = (ray @ np.array(partner.depth_axis[:2], np.float32)) + partner.depth_axis[2]
        pixels = np.column_stack([phase[y, part], xy, scale]).T
        results = _match_row(pixels, skip[y, part] == 0, partner, above)
        for out, values in zip(found, results, strict=True):
            out[y - row_start, : column_stop - column_start] = values
        matched += int(np.count_nonzero(results[-1] == MATCHED))
    return matched


def _match_row(pixels: FloatArray, wanted: BoolArray, partner: Partner, above: IntArray) -> tuple[FloatArray | IntArray, ...]:
    """Match the pixels (4, N) of a row: phase, rectified x and y, rectified depth at depth 1; ``above`` (2, N): see `_starts`."""
    count = pixels.shape[1]
    depth, gain, variance = np.zeros((3, count), np.float32)
    pixel, reason = np.zeros(count, np.int32), np.full(count, UNMATCHED)
    held = _look_up(pixels, partner)
    repeated = wanted & (held >= 0) & (held & REPEATED != 0)
    reason[repeated] = AMBIGUOUS
    active = np.flatnonzero(wanted & (held >= 0) & ~repeated)
    u, v = _starts(pixels[:, active], np.stack(unpack(held[active])), above[:, active], partner)
    above[:] = NOWHERE
    for number in range(MAX_STEPS):
        if not len(active):
            break
        step = _newton(pixels[:, active], u, v, number == MAX_STEPS - 1, partner)
        if number == 0:
            above[:, active] = np.where(step.usable, step.nearest, NOWHERE)
        found = step.usable & step.settled & step.positive
        done = active[found & ~step.ambiguous]
        for out, values in zip((depth, gain, variance), step[:3], strict=True):
            out[done] = values[found & ~step.ambiguous]
        pixel[active] = step.nearest[0] * partner.shape[1] + step.nearest[1]
        reason[done], reason[active[found & step.ambiguous]] = MATCHED, AMBIGUOUS
        pending = step.usable & ~step.settled
        active, u, v = active[pending], step.u[pending], step.v[pending]
    return depth, gain, variance, pixel, reason


def _look_up(pixels: FloatArray, partner: Partner) -> IntArray:
    """Return what the table holds for the phase and the epipolar line of pixels."""
    rows, bins = partner.table_shape
    row = np.clip(pixels[2] * np.float32(1 / LINES_PER_CELL) + 1, 0, rows - 1).astype(np.int64)
    column = np.clip((pixels[0] - partner.table.lowest) * partner.table.per_rad + 1, 0, bins - 1).astype(np.int64)
    return np.asarray(partner.table.cells[row * bins + column])


def _starts(pixels: FloatArray, held: IntArray, above: IntArray, partner: Partner) -> tuple[FloatArray, FloatArray]:
    """Return where Newton's method starts: a step by the slopes of the pixel at which that of the row above started, or of the table's."""
    row, column = np.where(np.abs(held - above).max(axis=0) <= SAME_SURFACE_PX, above, held)
    u, v, at = column.astype(np.float32), row.astype(np.float32), row * partner.shape[1] + column
    _x_u, _x_v, y_u, y_v = jacobian_at(partner, u, v)
    near, gx, gy, _sigma = partner.records.reshape(-1, RECORD)[at].T
    dphase, dy = pixels[0] - near, pixels[2] - partner.rectified.reshape(-1, 2)[at, 1]
    with np.errstate(divide="ignore", invalid="ignore"):
        du, dv = np.array([y_v * dphase - gy * dy, gx * dy - y_u * dphase]) / (gx * y_v - gy * y_u)
    near_enough = np.maximum(np.abs(du), np.abs(dv)) < MAX_MOVE_PX
    return clip_places(partner, u + np.where(near_enough, du, 0), v + np.where(near_enough, dv, 0))


@np.errstate(divide="ignore", invalid="ignore", over="ignore")
def _newton(pixels: FloatArray, u: FloatArray, v: FloatArray, last: bool, partner: Partner) -> Step:
    """Take a Newton step from (u, v) to where phase and epipolar line agree."""
    phase, x, y, depth_scale = pixels
    corner, nearest = np.stack([v, u]).astype(np.int64), (np.stack([v, u]) + np.float32(0.5)).astype(np.int64)
    image, first, near = partner.phase.reshape(partner.shape), tuple(corner), tuple(nearest)
    near_phase, gx, gy, sigma = partner.records.reshape(*partner.shape, RECORD)[near].T
    near_x, near_y = partner.rectified.reshape(*partner.shape, 2)[near].T
    x_u, x_v, y_u, y_v = jacobian_at(partner, u, v)
    area = x_u * y_v - x_v * y_u

    b, a = np.stack([v, u]) - corner.astype(np.float32)
    dv, du = np.stack([v, u]) - nearest.astype(np.float32)
    p00, p01 = image[first], image[corner[0], corner[1] + 1]
    p10, p11 = image[corner[0] + 1, corner[1]], image[corner[0] + 1, corner[1] + 1]
    local_gx, local_gy = (1 - b) * (p01 - p00) + b * (p11 - p10), (1 - a) * (p10 - p00) + a * (p11 - p01)
    quad = partner.quads.reshape(partner.shape)[first]
    continuous = quad == CONTINUOUS
    bilinear = (1 - b) * ((1 - a) * p00 + a * p01) + b * ((1 - a) * p10 + a * p11)
    value = np.where(continuous, bilinear, near_phase + gx * du + gy * dv)
    slope, local_slope = (gx * y_v - gy * y_u) / area, (local_gx * y_v - local_gy * y_u) / area
    local = continuous & (local_slope * slope > MIN_LOCAL_SLOPE * slope**2)
    along = np.where(local, local_slope, slope)
    across = (np.where(local, local_gy, gy) * x_u - np.where(local, local_gx, gx) * x_v) / area

    dy = y - (near_y + y_u * du + y_v * dv)
    dx = np.clip((phase - value - dy * across) / along, -MAX_MOVE_PX, MAX_MOVE_PX)
    step_u, step_v = (y_v * dx - x_v * dy) / area, (x_u * dy - y_u * dx) / area
    from_quad = np.maximum(np.abs(a + step_u - 0.5), np.abs(b + step_v - 0.5))
    off_centre = np.where(local, from_quad, np.maximum(np.abs(du + step_u), np.abs(dv + step_v)))
    settled = (off_centre <= 0.5 + QUAD_MARGIN_PX) | (np.abs(step_u) + np.abs(step_v) < (0.5 if last else 0))

    a, b = np.clip(a + step_u, 0, 1), np.clip(b + step_v, 0, 1)
    reach = np.abs(du + step_u) + np.abs(dv + step_v)
    share = np.where(continuous, (a**2 + (1 - a) ** 2) * (b**2 + (1 - b) ** 2), (1 + reach) ** 2 + reach**2)
    variance = sigma**2 * share
    disparity = x - near_x + partner.offset - (x_u * du + x_v * dv + dx)
    focal_baseline = partner.focal * partner.baseline
    depth = focal_baseline / (disparity * depth_scale)
    gain = slope * disparity**2 * depth_scale / focal_baseline
    usable = (continuous | (quad == PARTIAL)) & (np.abs(slope) >= MIN_SLOPE)
    ambiguous, positive = slope**2 < MIN_SLOPE_SIGMAS**2 * variance, np.minimum(disparity, depth) > 0
    return Step(depth, gain, variance, nearest, usable, settled, ambiguous, positive, *clip_places(partner, u + step_u, v + step_v))
