"""Compiled loops over pixels: where a camera's ray meets the surface that one projector column or row lights."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

POINT, NO_PHASE, PARALLEL, BEHIND, OUTSIDE, UNSOLVED, CONTRADICTED = range(7)
STEPS = 3
SOLVED_PX = 2e-3  # an order below the noise of the best phase
TINY = 1e-30
COLUMN, ROW, WEIGHT_C, WEIGHT_R, A0, A1, A2, W, SINE, SEEN_C, SEEN_R, SQUARE, LEFT, MISS, ALLOWED, BUFFERS = range(16)
FAST = {"contract", "arcp", "nsz", "reassoc"}  # without nnan and ninf: what cannot be solved must stay recognisable


@njit(nogil=True, cache=True, fastmath=FAST, error_model="numpy")
def triangulate(
    rays: Any,  # (H, W, 2) float32, normalised image coordinates of the camera
    column_phase: Any,  # (H, W) float32, of vertical fringes; (1, 1) where there are none
    column_sigma: Any,
    column_state: Any,  # uint8, 0: valid
    row_phase: Any,  # the same of horizontal fringes
    row_sigma: Any,
    row_state: Any,
    scales: Any,  # (2, 2): column per rad and column at phase 0; the same for the row
    used: Any,  # (2,) whether there are vertical, horizontal fringes
    turn: Any,  # (3, 3) rotation from the camera to the projector
    step: Any,  # (3,) the camera's centre in the projector's frame, mm
    lens: Any,  # (12,) distortion k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4
    image: Any,  # (3, 3) distorted normalised coordinates to projector pixels, tilt of the imager included
    limits: Any,  # least sine between ray and surface; column from, to; row from, to; sigmas and px that both directions may differ
    row_start: int,
    row_stop: int,
    depth: Any,  # out (H, W) float32, z in the camera's frame, 0 for none
    depth_sigma: Any,  # out (H, W) float32
    residual: Any,  # out (H, W) float32, px off the epipolar line; (1, 1) unless both directions are used
    fate: Any,  # out (H, W) uint8
) -> None:
    """Take the pixels with a phase row by row: gather them, solve them in SIMD loops, judge and scatter them."""
    width = rays.shape[1]
    both = used[0] and used[1]
    b = np.empty((BUFFERS, width))
    index = np.empty(width, np.int64)
    for y in range(row_start, row_stop):
        count = 0
        for x in range(width):
            depth[y, x] = 0
            depth_sigma[y, x] = 0
            fate[y, x] = NO_PHASE
            if both:
                residual[y, x] = 0
            has_c = used[0] and column_state[y, x] == 0
            has_r = used[1] and row_state[y, x] == 0
            if not (has_c or has_r):
                continue
            b[COLUMN, count], b[WEIGHT_C, count] = 0.0, 0.0
            b[ROW, count], b[WEIGHT_R, count] = 0.0, 0.0
            if has_c:
                b[COLUMN, count], b[WEIGHT_C, count] = measured(column_phase[y, x], column_sigma[y, x], scales[0])
            if has_r:
                b[ROW, count], b[WEIGHT_R, count] = measured(row_phase[y, x], row_sigma[y, x], scales[1])
            rx, ry = np.float64(rays[y, x, 0]), np.float64(rays[y, x, 1])
            b[A0, count] = turn[0, 0] * rx + turn[0, 1] * ry + turn[0, 2]
            b[A1, count] = turn[1, 0] * rx + turn[1, 1] * ry + turn[1, 2]
            b[A2, count] = turn[2, 0] * rx + turn[2, 1] * ry + turn[2, 2]
            index[count] = x
            count += 1
        solve(b, count, step, lens, image, limits)
        for i in range(count):
            x, w = index[i], b[W, i]
            fate[y, x] = judged(b, i, step, limits)
            if b[WEIGHT_C, i] > 0.0 and b[WEIGHT_R, i] > 0.0 and (fate[y, x] == POINT or fate[y, x] == CONTRADICTED):
                residual[y, x] = b[MISS, i]
            if fate[y, x] == POINT:
                depth[y, x] = 1.0 / w
                depth_sigma[y, x] = 1.0 / (w * w * np.sqrt(b[SQUARE, i]))


@njit(nogil=True, cache=True, fastmath=FAST, error_model="numpy", forceinline=True)
def measured(phase: Any, sigma: Any, scale: Any) -> Any:
    """Return the column (or row) of a phase and its weight, one over its variance; ``scale`` is px per rad and the px at phase 0."""
    noise = sigma * scale[0]
    return phase * scale[0] + scale[1], 1.0 / (noise * noise + TINY)


@njit(nogil=True, cache=True, fastmath=FAST, error_model="numpy", forceinline=True)
def judged(b: Any, i: int, step: Any, limits: Any) -> int:
    """Return what becomes of the solved pixel ``i``: POINT, or the first reason against it. What is not a number fails every test."""
    if not b[SINE, i] >= limits[0]:
        return PARALLEL
    if not (b[W, i] > 0.0 and b[A2, i] + b[W, i] * step[2] > 0.0):
        return BEHIND
    if b[SEEN_C, i] < limits[1] or b[SEEN_C, i] > limits[2] or b[SEEN_R, i] < limits[3] or b[SEEN_R, i] > limits[4]:
        return OUTSIDE
    if not abs(b[LEFT, i]) <= SOLVED_PX:
        return UNSOLVED
    if b[WEIGHT_C, i] > 0.0 and b[WEIGHT_R, i] > 0.0 and abs(b[MISS, i]) > b[ALLOWED, i]:
        return CONTRADICTED
    return POINT


@njit(nogil=True, cache=True, fastmath=FAST, error_model="numpy")
def solve(b: Any, count: int, step: Any, lens: Any, image: Any, limits: Any) -> None:
    """Solve projected column = column (and row = row) for the inverse depth w by Gauss-Newton steps; one long loop that stays SIMD code.

    In the projector's frame the ray's point is (a + w t) / w: its undistorted image is a ratio of two linear functions of w, and
    the first guess, without distortion, is exact for a lens without.
    """
    k1, k2, p1, p2, k3, k4, k5, k6 = lens[0], lens[1], lens[2], lens[3], lens[4], lens[5], lens[6], lens[7]
    s1, s2, s3, s4 = lens[8], lens[9], lens[10], lens[11]
    m00, m01, m02 = image[0, 0], image[0, 1], image[0, 2]
    m10, m11, m12 = image[1, 0], image[1, 1], image[1, 2]
    m20, m21, m22 = image[2, 0], image[2, 1], image[2, 2]
    t0, t1, t2 = step[0], step[1], step[2]
    sigmas, tolerance = limits[5], limits[6]
    for i in range(count):
        u, v = (b[COLUMN, i] - m02) / m00, (b[ROW, i] - m12) / m11
        below_u, below_v = u * t2 - t0, v * t2 - t1
        by_column = b[WEIGHT_R, i] == 0.0 or (b[WEIGHT_C, i] > 0.0 and abs(below_u) > abs(below_v))
        b[W, i] = (b[A0, i] - u * b[A2, i]) / below_u if by_column else (b[A1, i] - v * b[A2, i]) / below_v
    for n in range(STEPS + 1):
        for i in range(count):
            w, weight_c, weight_r = b[W, i], b[WEIGHT_C, i], b[WEIGHT_R, i]
            q = 1.0 / (b[A2, i] + w * t2)
            u, v = (b[A0, i] + w * t0) * q, (b[A1, i] + w * t1) * q
            du, dv = (t0 - u * t2) * q, (t1 - v * t2) * q
            uv, r2 = u * v, u * u + v * v
            under = 1.0 / (1.0 + r2 * (k4 + r2 * (k5 + r2 * k6)))
            radial = (1.0 + r2 * (k1 + r2 * (k2 + r2 * k3))) * under
            slope = (k1 + r2 * (2.0 * k2 + r2 * 3.0 * k3)) * under - radial * under * (k4 + r2 * (2.0 * k5 + r2 * 3.0 * k6))
            dr2, duv = 2.0 * (u * du + v * dv), du * v + u * dv
            xd = u * radial + 2.0 * p1 * uv + p2 * (r2 + 2.0 * u * u) + r2 * (s1 + s2 * r2)
            yd = v * radial + p1 * (r2 + 2.0 * v * v) + 2.0 * p2 * uv + r2 * (s3 + s4 * r2)
            dxd = du * radial + u * slope * dr2 + 2.0 * p1 * duv + p2 * (dr2 + 4.0 * u * du) + dr2 * (s1 + 2.0 * s2 * r2)
            dyd = dv * radial + v * slope * dr2 + p1 * (dr2 + 4.0 * v * dv) + 2.0 * p2 * duv + dr2 * (s3 + 2.0 * s4 * r2)
            h = 1.0 / (m20 * xd + m21 * yd + m22)
            seen_c, seen_r = (m00 * xd + m01 * yd + m02) * h, (m10 * xd + m11 * yd + m12) * h
            dh = m20 * dxd + m21 * dyd
            dc, dr = (m00 * dxd + m01 * dyd - seen_c * dh) * h, (m10 * dxd + m11 * dyd - seen_r * dh) * h
            off_c, off_r = b[COLUMN, i] - seen_c, b[ROW, i] - seen_r
            square = weight_c * dc * dc + weight_r * dr * dr
            left = weight_c * dc * off_c + weight_r * dr * off_r
            if n < STEPS:
                b[W, i] = w + left / (square + TINY)
            else:
                b[SQUARE, i] = square
                b[SEEN_C, i] = seen_c
                b[SEEN_R, i] = seen_r
                b[LEFT, i] = left / np.sqrt((weight_c + weight_r) * square + TINY)
                # Sine of the angle between the ray and the lit surface (as a plane through the projector's centre).
                length = np.sqrt(b[A0, i] * b[A0, i] + b[A1, i] * b[A1, i] + b[A2, i] * b[A2, i])
                across_c = abs(du) / np.sqrt(1.0 + u * u) if weight_c > 0.0 else 0.0
                across_r = abs(dv) / np.sqrt(1.0 + v * v) if weight_r > 0.0 else 0.0
                b[SINE, i] = max(across_c, across_r) * abs(w / q) / length
                # Off the epipolar line, in pixels: what no depth explains, and its noise.
                norm = dc * dc + dr * dr + TINY
                b[MISS, i] = (off_c * dr - off_r * dc) / np.sqrt(norm)
                b[ALLOWED, i] = sigmas * np.sqrt((dr * dr / (weight_c + TINY) + dc * dc / (weight_r + TINY)) / norm) + tolerance
