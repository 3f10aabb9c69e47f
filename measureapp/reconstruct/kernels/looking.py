"""Compiled loops that look at points with another camera: the phase it sees there, and whether something nearer is in the way.

A rectified pair is described to the kernels by ``turn`` (3, 3), rectified axes from the camera's, and ``frame``
(focal, x0, y0) with x_px = focal · x − x0, y_px = focal · y − y0; a ``grid`` (rows, columns, 2) of native pixels (x, y) at every
``stride``-th rectified pixel leads back to the image. Rows of both images of a pair are the same epipolar lines.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.reconstruct.kernels.binning import PLACE, REPEATED
from measureapp.reconstruct.kernels.seen import BLANK, PARTLY, SEEN
from measureapp.reconstruct.kernels.slopes import BESIDE, OWN_SIGMA, PHASE, SLOPE_X, SLOPE_Y, TORN, WHOLE

OCCLUDES_PX = 16.0  # nearer by so much disparity, a surface seen instead of a point hides it


@njit(**INLINE)
def native_pixel(grid: Any, stride: Any, x: Any, y: Any) -> Any:
    """Return the image point (u, v) of a rectified one and its change with x, bilinear between the grid's nodes; (-1, -1) outside."""
    per_stride = 1.0 / stride
    gx = x * per_stride
    gy = y * per_stride
    if not (gx >= 0.0 and gy >= 0.0 and gy < grid.shape[0] - 1 and gx < grid.shape[1] - 1):
        return -1.0, -1.0, 0.0, 0.0
    i = int(gy)
    j = int(gx)
    a = gx - j
    b = gy - i
    u0 = (1 - b) * grid[i, j, 0] + b * grid[i + 1, j, 0]
    v0 = (1 - b) * grid[i, j, 1] + b * grid[i + 1, j, 1]
    du = (1 - b) * grid[i, j + 1, 0] + b * grid[i + 1, j + 1, 0] - u0
    dv = (1 - b) * grid[i, j + 1, 1] + b * grid[i + 1, j + 1, 1] - v0
    return u0 + a * du, v0 + a * dv, du * per_stride, dv * per_stride


@njit(**INLINE)
def look(state: Any, pixels: Any, quad: Any, u: Any, v: Any) -> Any:
    """Return (BLANK | SEEN | PARTLY, phase, its variance): bilinear between four pixels of one surface; beside a hole, in the half of
    a border pixel, along the slope of that pixel.
    """
    if not (u >= 0.0 and v >= 0.0 and v < quad.shape[0] - 1 and u < quad.shape[1] - 1):
        return BLANK, 0.0, 0.0
    i = int(v)
    j = int(u)
    a = u - j
    b = v - i
    if quad[i, j] == WHOLE:
        above = pixels[i, j, PHASE] + a * (pixels[i, j + 1, PHASE] - pixels[i, j, PHASE])
        below = pixels[i + 1, j, PHASE] + a * (pixels[i + 1, j + 1, PHASE] - pixels[i + 1, j, PHASE])
        p, q, r, s = (1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b
        noise = (p * pixels[i, j, OWN_SIGMA]) ** 2 + (q * pixels[i, j + 1, OWN_SIGMA]) ** 2
        noise += (r * pixels[i + 1, j, OWN_SIGMA]) ** 2 + (s * pixels[i + 1, j + 1, OWN_SIGMA]) ** 2
        return SEEN, above + b * (below - above), noise
    if quad[i, j] == TORN:
        return PARTLY, 0.0, 0.0
    y = int(v + 0.5)
    x = int(u + 0.5)
    if quad[i, j] == BESIDE and state[y, x] == 0 and (pixels[y, x, SLOPE_X] != 0 or pixels[y, x, SLOPE_Y] != 0):
        reach = abs(u - x) + abs(v - y)
        value = pixels[y, x, PHASE] + (u - x) * pixels[y, x, SLOPE_X] + (v - y) * pixels[y, x, SLOPE_Y]
        return SEEN, value, pixels[y, x, OWN_SIGMA] ** 2 * ((1 + reach) ** 2 + reach**2)
    if state[i, j] != 0 and state[i, j + 1] != 0 and state[i + 1, j] != 0 and state[i + 1, j + 1] != 0:
        return BLANK, 0.0, 0.0
    return PARTLY, 0.0, 0.0


@njit(**INLINE)
def see(own: Any, nx: Any, ny: Any, z: Any, other: Any) -> Any:
    """Look with another camera at the point at depth ``z`` of the ray (nx, ny) whose phase is ``own``.

    Returns (BLANK | SEEN | PARTLY, excess of the phase seen, its slope per rectified pixel along the epipolar line, change of the phase
    with z, variance, rectified x here + x0, rectified x there, rectified y).
    """
    state, pixels, quad, turn, frame, there_frame, grid, stride, baseline = other
    rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
    per_rz, per_z = 1.0 / rz, 1.0 / z
    here = (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) * per_rz
    row = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) * per_rz - frame[2]
    shift = baseline * per_rz * per_z
    there = there_frame[0] * (here - shift) - there_frame[1]
    u, v, to_u, to_v = native_pixel(grid, stride, there, row)
    sight, value, noise = look(state, pixels, quad, u, v)
    along = 0.0
    if sight == SEEN:
        j, k = int(u + 0.5), int(v + 0.5)
        along = pixels[k, j, SLOPE_X] * to_u + pixels[k, j, SLOPE_Y] * to_v
        if abs(along) < 1e-6:
            sight = PARTLY
    gain = along * there_frame[0] * shift * per_z
    return sight, value - own, along, gain, noise, here * frame[0], there, row


@njit(**INLINE)
def hidden(wanted: Any, here: Any, row: Any, repeats: Any, lines: Any, frame: Any, lowest: Any, per_rad: Any) -> bool:
    """Whether the phase ``wanted``, seen by another camera instead of a point, belongs to a surface that this camera sees before it."""
    r = int(row * 0.5) + 1
    k = int((wanted - lowest) * per_rad) + 1
    if r < 1 or k < 1 or r >= repeats.shape[0] - 1 or k >= repeats.shape[1] - 1:
        return False
    held = repeats[r, k]
    if held < 0 or (held & REPEATED) != 0:
        return False
    nearer = lines[(held & PLACE) >> 16, held & 0xFFFF, 0] + frame[1] - here
    return bool(nearer > OCCLUDES_PX)


@njit(**LOOP)
def resample(
    state: Any,
    pixels: Any,
    quad: Any,
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
            seen, value, noise = look(state, pixels, quad, u, v)
            new_phase[y, x] = value
            new_sigma[y, x] = np.sqrt(noise)
            new_state[y, x] = 0
            if seen != SEEN:  # the reason of the nearest pixel
                i = int(np.floor(v + 0.5))
                j = int(np.floor(u + 0.5))
                inside = 0 <= i < state.shape[0] and 0 <= j < state.shape[1]
                new_state[y, x] = state[i, j] if inside and state[i, j] != 0 else hole
