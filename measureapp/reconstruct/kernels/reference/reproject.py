"""NumPy statements of projecting points into another camera and interpolating its phase there; all for (N,) points at once."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.reconstruct.kernels.reproject import Observation, Projection
from measureapp.reconstruct.kernels.structures import (
    ABSENT,
    CONTINUOUS,
    INCOMPLETE,
    INTERPOLATED,
    MIN_SLOPE,
    PARTIAL,
    PHASE,
    SIGMA,
    SLOPE_X,
    SLOPE_Y,
    Observer,
    Pair,
    PhaseImage,
)

CORNERS = ((0, 0), (0, 1), (1, 0), (1, 1))


def native_pixel(grid: FloatArray, stride: float, x: FloatArray, y: FloatArray) -> tuple[FloatArray, ...]:
    """Return the image points (u, v) of rectified ones and their change with x, bilinear between the grid's nodes; (-1, -1) outside."""
    gx, gy = x / stride, y / stride
    inside = (gx >= 0) & (gy >= 0) & (gy < grid.shape[0] - 1) & (gx < grid.shape[1] - 1)
    gx, gy = np.where(inside, gx, 0), np.where(inside, gy, 0)
    i, j = gy.astype(int), gx.astype(int)
    a, b = (gx - j)[:, None], (gy - i)[:, None]
    left, right = ((1 - b) * grid[i, j + k] + b * grid[i + 1, j + k] for k in (0, 1))
    place, slope = np.where(inside[:, None], left + a * (right - left), -1), np.where(inside[:, None], (right - left) / stride, 0)
    return place[:, 0], place[:, 1], slope[:, 0], slope[:, 1]


def project(rays: FloatArray, depth: FloatArray, pair: Pair) -> Projection:
    """Project the points at some depth of rays (N, 2) into the other camera of a pair."""
    x, y, z = np.asarray(pair.rotation) @ np.column_stack([rays, np.ones(len(rays))]).astype(np.float64).T
    disparity = pair.baseline / (z * depth)
    place, line = pair.other_frame[0] * (x / z - disparity) - pair.other_frame[1], pair.frame[0] * y / z - pair.frame[2]
    return Projection(place, line, x / z * pair.frame[0], disparity, *native_pixel(pair.other_grid, pair.stride, place, line))


def interpolate_phase(image: PhaseImage, u: FloatArray, v: FloatArray) -> tuple[IntArray, FloatArray, FloatArray]:
    """Return (ABSENT | INTERPOLATED | INCOMPLETE, phase, its variance) at places of an image."""
    inside = (u >= 0) & (v >= 0) & (v < image.quads.shape[0] - 1) & (u < image.quads.shape[1] - 1)
    u, v = np.where(inside, u, 0.0), np.where(inside, v, 0.0)
    i, j = v.astype(int), u.astype(int)
    a, b = u - j, v - i
    weights = ((1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b)
    corners = [image.records[i + dy, j + dx].astype(np.float64) for dy, dx in CORNERS]
    value = sum(weight * corner[:, PHASE] for weight, corner in zip(weights, corners, strict=True))
    variance = sum((weight * corner[:, SIGMA]) ** 2 for weight, corner in zip(weights, corners, strict=True))

    y, x = (v + 0.5).astype(int), (u + 0.5).astype(int)
    nearest = image.records[y, x].astype(np.float64)
    reach = np.abs(u - x) + np.abs(v - y)
    beside = nearest[:, PHASE] + (u - x) * nearest[:, SLOPE_X] + (v - y) * nearest[:, SLOPE_Y]
    beside_variance = nearest[:, SIGMA] ** 2 * ((1 + reach) ** 2 + reach**2)

    quad = image.quads[i, j]
    has_slope = (image.state[y, x] == 0) & ((nearest[:, SLOPE_X] != 0) | (nearest[:, SLOPE_Y] != 0))
    continuous, partial = inside & (quad == CONTINUOUS), inside & (quad == PARTIAL) & has_slope
    empty = ~inside | np.all([image.state[i + dy, j + dx] != 0 for dy, dx in CORNERS], axis=0)
    sight = np.where(continuous | partial, INTERPOLATED, np.where(empty, ABSENT, INCOMPLETE))
    return (
        sight,
        np.where(continuous, value, np.where(partial, beside, 0.0)),
        np.where(continuous, variance, np.where(partial, beside_variance, 0.0)),
    )


def slopes_at(image: PhaseImage, u: FloatArray, v: FloatArray) -> FloatArray:
    """Return the slopes (N, 2) of the nearest pixels, anything outside."""
    height, width = image.quads.shape
    y, x = np.clip((v + 0.5).astype(int), 0, height - 1), np.clip((u + 0.5).astype(int), 0, width - 1)
    return np.asarray(image.records[y, x][:, [SLOPE_X, SLOPE_Y]].astype(np.float64))


def observe(phase: FloatArray, rays: FloatArray, depth: FloatArray, observer: Observer) -> Observation:
    """Compare the phases of points at some depth of rays with what another camera measures at their images."""
    at = project(rays, depth, observer.pair)
    sight, value, variance = interpolate_phase(observer.image, at.u, at.v)
    slope_x, slope_y = slopes_at(observer.image, at.u, at.v).T
    slope = np.where(sight == INTERPOLATED, slope_x * at.u_x + slope_y * at.v_x, 0.0)
    sight = np.where((sight == INTERPOLATED) & (np.abs(slope) < MIN_SLOPE), INCOMPLETE, sight)
    gain = slope * observer.pair.other_frame[0] * at.disparity / depth
    return Observation(sight, value - phase, slope, gain, variance, at.own_x, at.y)


def resample_phase(
    image: PhaseImage, native: FloatArray, row_start: int, row_stop: int, phase: FloatArray, sigma: FloatArray, state: IntArray, hole: int
) -> None:
    """Resample a phase map at the nodes of another grid."""
    rows = slice(row_start, row_stop)
    u, v = native[rows].reshape(-1, 2).astype(np.float64).T
    sight, value, variance = interpolate_phase(image, u, v)
    y, x = np.floor(v + 0.5).astype(int), np.floor(u + 0.5).astype(int)
    height, width = image.state.shape
    inside = (y >= 0) & (x >= 0) & (y < height) & (x < width)
    nearest = np.where(inside, image.state[np.clip(y, 0, height - 1), np.clip(x, 0, width - 1)], 0)
    shape = native[rows].shape[:2]
    phase[rows], sigma[rows] = value.reshape(shape), np.sqrt(variance).reshape(shape)
    state[rows] = np.where(sight == INTERPOLATED, 0, np.where(nearest != 0, nearest, hole)).reshape(shape)
