"""Projection of points into another camera, and the phase that it measures there."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.reconstruct.kernels.structures import (
    ABSENT,
    CONTINUOUS,
    DISCONTINUOUS,
    INCOMPLETE,
    INTERPOLATED,
    MIN_SLOPE,
    PARTIAL,
    PHASE,
    SIGMA,
    SLOPE_X,
    SLOPE_Y,
    VALID,
    Observer,
    Pair,
    PhaseImage,
)


class Projection(NamedTuple):
    """Image of a point in the rectified other camera."""

    x: Any  # px
    y: Any
    own_x: Any  # rectified x in the own camera + its x0
    disparity: Any  # baseline over rectified depth
    u: Any  # native pixel, (-1, -1) outside the image
    v: Any
    u_x: Any  # its change with x
    v_x: Any


class Observation(NamedTuple):
    """What another camera measures of a point."""

    sight: Any  # ABSENT | INTERPOLATED | INCOMPLETE
    excess: Any  # of its phase over the point's, rad
    slope: Any  # of its phase along the epipolar line, rad/px
    gain: Any  # change of its phase with the point's depth, rad/mm
    variance: Any  # of its phase
    own_x: Any  # see `Projection`
    y: Any


@njit(**INLINE)
def native_pixel(grid: Any, stride: Any, x: Any, y: Any) -> Any:
    """Return the image point (u, v) of a rectified one and its change with x, bilinear between the grid's nodes; (-1, -1) outside."""
    per_stride = 1.0 / stride
    gx, gy = x * per_stride, y * per_stride
    if not (gx >= 0.0 and gy >= 0.0 and gy < grid.shape[0] - 1 and gx < grid.shape[1] - 1):
        return -1.0, -1.0, 0.0, 0.0
    i, j = int(gy), int(gx)
    a, b = gx - j, gy - i
    u = (1 - b) * grid[i, j, 0] + b * grid[i + 1, j, 0]
    v = (1 - b) * grid[i, j, 1] + b * grid[i + 1, j, 1]
    du = (1 - b) * grid[i, j + 1, 0] + b * grid[i + 1, j + 1, 0] - u
    dv = (1 - b) * grid[i, j + 1, 1] + b * grid[i + 1, j + 1, 1] - v
    return u + a * du, v + a * dv, du * per_stride, dv * per_stride


@njit(**INLINE)
def project(ray_x: Any, ray_y: Any, depth: Any, pair: Pair) -> Projection:
    """Project the point at a depth of a ray into the other camera of a pair."""
    rotation = pair.rotation
    per_z, per_depth = 1.0 / (rotation[2, 0] * ray_x + rotation[2, 1] * ray_y + rotation[2, 2]), 1.0 / depth
    own_x = (rotation[0, 0] * ray_x + rotation[0, 1] * ray_y + rotation[0, 2]) * per_z
    y = pair.frame[0] * (rotation[1, 0] * ray_x + rotation[1, 1] * ray_y + rotation[1, 2]) * per_z - pair.frame[2]
    disparity = pair.baseline * per_z * per_depth
    x = pair.other_frame[0] * (own_x - disparity) - pair.other_frame[1]
    u, v, u_x, v_x = native_pixel(pair.other_grid, pair.stride, x, y)
    return Projection(x, y, own_x * pair.frame[0], disparity, u, v, u_x, v_x)


@njit(**INLINE)
def interpolate_phase(image: PhaseImage, u: Any, v: Any) -> Any:
    """Return (ABSENT | INTERPOLATED | INCOMPLETE, phase, its variance) at a place of an image.

    Bilinear between four pixels of one surface; beside a hole, within half a pixel of a valid one, along the slope of that.
    """
    state, records, quads = image.state, image.records, image.quads
    if not (u >= 0.0 and v >= 0.0 and v < quads.shape[0] - 1 and u < quads.shape[1] - 1):
        return ABSENT, 0.0, 0.0
    i, j = int(v), int(u)
    a, b = u - j, v - i
    if quads[i, j] == CONTINUOUS:
        upper = records[i, j, PHASE] + a * (records[i, j + 1, PHASE] - records[i, j, PHASE])
        lower = records[i + 1, j, PHASE] + a * (records[i + 1, j + 1, PHASE] - records[i + 1, j, PHASE])
        variance = ((1 - a) * (1 - b) * records[i, j, SIGMA]) ** 2 + (a * (1 - b) * records[i, j + 1, SIGMA]) ** 2
        variance += ((1 - a) * b * records[i + 1, j, SIGMA]) ** 2 + (a * b * records[i + 1, j + 1, SIGMA]) ** 2
        return INTERPOLATED, upper + b * (lower - upper), variance
    if quads[i, j] == DISCONTINUOUS:
        return INCOMPLETE, 0.0, 0.0
    y, x = int(v + 0.5), int(u + 0.5)
    slope_x, slope_y = records[y, x, SLOPE_X], records[y, x, SLOPE_Y]
    if quads[i, j] == PARTIAL and state[y, x] == VALID and (slope_x != 0 or slope_y != 0):
        reach = abs(u - x) + abs(v - y)
        value = records[y, x, PHASE] + (u - x) * slope_x + (v - y) * slope_y
        return INTERPOLATED, value, records[y, x, SIGMA] ** 2 * ((1 + reach) ** 2 + reach**2)
    empty = state[i, j] != VALID and state[i, j + 1] != VALID and state[i + 1, j] != VALID and state[i + 1, j + 1] != VALID
    return ABSENT if empty else INCOMPLETE, 0.0, 0.0


@njit(**INLINE)
def observe(phase: Any, ray_x: Any, ray_y: Any, depth: Any, observer: Observer) -> Observation:
    """Compare the phase of a point at a depth of a ray with what another camera measures at its image."""
    at = project(ray_x, ray_y, depth, observer.pair)
    sight, value, variance = interpolate_phase(observer.image, at.u, at.v)
    slope = 0.0
    if sight == INTERPOLATED:
        j, i = int(at.u + 0.5), int(at.v + 0.5)
        slope = observer.image.records[i, j, SLOPE_X] * at.u_x + observer.image.records[i, j, SLOPE_Y] * at.v_x
        if abs(slope) < MIN_SLOPE:
            sight = INCOMPLETE
    gain = slope * observer.pair.other_frame[0] * at.disparity * (1.0 / depth)
    return Observation(sight, value - phase, slope, gain, variance, at.own_x, at.y)


@njit(**LOOP)
def resample_phase(
    image: PhaseImage,
    native: Any,  # (rows, columns, 2) float32, places (x, y)
    row_start: int,
    row_stop: int,
    phase: Any,  # out (rows, columns) float32
    sigma: Any,  # out (rows, columns) float32
    state: Any,  # out (rows, columns) uint8, that of the nearest pixel, or `hole`
    hole: int,
) -> None:
    """Resample a phase map at the nodes of another grid."""
    for y in range(row_start, row_stop):
        for x in range(phase.shape[1]):
            u, v = native[y, x, 0], native[y, x, 1]
            sight, value, variance = interpolate_phase(image, u, v)
            phase[y, x], sigma[y, x], state[y, x] = value, np.sqrt(variance), VALID
            if sight != INTERPOLATED:
                i, j = int(np.floor(v + 0.5)), int(np.floor(u + 0.5))
                inside = 0 <= i < image.state.shape[0] and 0 <= j < image.state.shape[1]
                state[y, x] = image.state[i, j] if inside and image.state[i, j] != VALID else hole
