"""Triangulation of a camera and the projector: where a ray meets the surface that one projector column or row illuminates."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

POINT, NO_PHASE, PARALLEL, BEHIND, OUTSIDE, UNSOLVED, CONTRADICTED = range(7)
STEPS = 3  # of Gauss-Newton's method
SOLVED_PX = 2e-3  # an order below the noise of the best phase
TINY = 1e-30
# Rows of the buffer of a row of pixels.
COLUMN, ROW, WEIGHT_C, WEIGHT_R, A0, A1, A2, W, SINE, SEEN_C, SEEN_R, SQUARE, LEFT, MISS, ALLOWED, BUFFERS = range(16)
FAST = {"contract", "arcp", "nsz", "reassoc"}  # without nnan and ninf: pixels without a solution must stay recognisable
OPTIONS: dict[str, Any] = {"nogil": True, "cache": True, "fastmath": FAST, "error_model": "numpy"}


class Fringes(NamedTuple):
    """Phase map of fringes of one direction; (1, 1) where there are none."""

    phase: Any  # (H, W) float32
    sigma: Any  # (H, W) float32
    state: Any  # (H, W) uint8, 0 valid
    scale: Any  # (2,) projector pixels per rad, and the pixel at phase 0
    present: bool


class Projector(NamedTuple):
    """Projector in the camera's frame, and the limits of its points."""

    rotation: Any  # (3, 3) from the camera
    centre: Any  # (3,) of the camera in the projector's frame, mm
    distortion: Any  # (12,) k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4
    image: Any  # (3, 3) distorted normalised coordinates to pixels, tilt of the imager included
    min_sine: float  # of the angle between ray and illuminated surface
    bounds: Any  # (4,) column from, to; row from, to
    sigmas: float  # by which column and row may differ,
    px: float  # plus so many pixels


class Output(NamedTuple):
    """Triangulated points."""

    depth: Any  # (H, W) float32, z in the camera's frame, 0 for none
    sigma: Any  # (H, W) float32
    residual: Any  # (H, W) float32, px off the epipolar line; (1, 1) unless both directions are used
    state: Any  # (H, W) uint8


@njit(**OPTIONS)
def triangulate(
    rays: Any,  # (H, W, 2) float32, normalised image coordinates of the camera
    columns: Fringes,  # vertical fringes
    rows: Fringes,  # horizontal fringes
    projector: Projector,
    row_start: int,
    row_stop: int,
    out: Output,
) -> None:
    """Collect the pixels of a row that have a phase, solve them in SIMD loops, evaluate and scatter them."""
    width, turn = rays.shape[1], projector.rotation
    b = np.empty((BUFFERS, width))
    index = np.empty(width, np.int64)
    for y in range(row_start, row_stop):
        count = 0
        for x in range(width):
            out.depth[y, x], out.sigma[y, x], out.state[y, x] = 0, 0, NO_PHASE
            if columns.present and rows.present:
                out.residual[y, x] = 0
            has_column, has_row = columns.present and columns.state[y, x] == 0, rows.present and rows.state[y, x] == 0
            if not (has_column or has_row):
                continue
            b[COLUMN, count], b[WEIGHT_C, count], b[ROW, count], b[WEIGHT_R, count] = 0.0, 0.0, 0.0, 0.0
            if has_column:
                b[COLUMN, count], b[WEIGHT_C, count] = pixel_and_weight(columns.phase[y, x], columns.sigma[y, x], columns.scale)
            if has_row:
                b[ROW, count], b[WEIGHT_R, count] = pixel_and_weight(rows.phase[y, x], rows.sigma[y, x], rows.scale)
            ray_x, ray_y = np.float64(rays[y, x, 0]), np.float64(rays[y, x, 1])
            b[A0, count] = turn[0, 0] * ray_x + turn[0, 1] * ray_y + turn[0, 2]
            b[A1, count] = turn[1, 0] * ray_x + turn[1, 1] * ray_y + turn[1, 2]
            b[A2, count] = turn[2, 0] * ray_x + turn[2, 1] * ray_y + turn[2, 2]
            index[count] = x
            count += 1
        solve(b, count, projector)
        for i in range(count):
            x, w = index[i], b[W, i]
            state = evaluate(b, i, projector)
            out.state[y, x] = state
            if b[WEIGHT_C, i] > 0.0 and b[WEIGHT_R, i] > 0.0 and state in (POINT, CONTRADICTED):
                out.residual[y, x] = b[MISS, i]
            if state == POINT:
                out.depth[y, x], out.sigma[y, x] = 1.0 / w, 1.0 / (w * w * np.sqrt(b[SQUARE, i]))


@njit(**OPTIONS, forceinline=True)
def pixel_and_weight(phase: Any, sigma: Any, scale: Any) -> Any:
    """Return the column (or row) of a phase and its weight, one over its variance."""
    noise = sigma * scale[0]
    return phase * scale[0] + scale[1], 1.0 / (noise * noise + TINY)


@njit(**OPTIONS, forceinline=True)
def evaluate(b: Any, i: int, projector: Projector) -> int:
    """Return POINT for the i-th solved pixel, or the first reason against it; NaN fails every test."""
    bounds = projector.bounds
    if not b[SINE, i] >= projector.min_sine:
        return PARALLEL
    if not (b[W, i] > 0.0 and b[A2, i] + b[W, i] * projector.centre[2] > 0.0):
        return BEHIND
    if b[SEEN_C, i] < bounds[0] or b[SEEN_C, i] > bounds[1] or b[SEEN_R, i] < bounds[2] or b[SEEN_R, i] > bounds[3]:
        return OUTSIDE
    if not abs(b[LEFT, i]) <= SOLVED_PX:
        return UNSOLVED
    if b[WEIGHT_C, i] > 0.0 and b[WEIGHT_R, i] > 0.0 and abs(b[MISS, i]) > b[ALLOWED, i]:
        return CONTRADICTED
    return POINT


@njit(**OPTIONS)
def solve(b: Any, count: int, projector: Projector) -> None:
    """Solve projected column = column (and row = row) for the inverse depth w by Gauss-Newton steps; one long loop that stays SIMD code.

    In the projector's frame the ray's point is (a + w t) / w: its undistorted image is a ratio of two linear functions of w, and
    the first guess, without distortion, is exact for a lens without.
    """
    lens, image, step = projector.distortion, projector.image, projector.centre
    k1, k2, p1, p2, k3, k4, k5, k6 = lens[0], lens[1], lens[2], lens[3], lens[4], lens[5], lens[6], lens[7]
    s1, s2, s3, s4 = lens[8], lens[9], lens[10], lens[11]
    m00, m01, m02 = image[0, 0], image[0, 1], image[0, 2]
    m10, m11, m12 = image[1, 0], image[1, 1], image[1, 2]
    m20, m21, m22 = image[2, 0], image[2, 1], image[2, 2]
    t0, t1, t2 = step[0], step[1], step[2]
    sigmas, tolerance = projector.sigmas, projector.px
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
                # Sine of the angle between the ray and the illuminated surface (as a plane through the projector's centre).
                length = np.sqrt(b[A0, i] * b[A0, i] + b[A1, i] * b[A1, i] + b[A2, i] * b[A2, i])
                across_c = abs(du) / np.sqrt(1.0 + u * u) if weight_c > 0.0 else 0.0
                across_r = abs(dv) / np.sqrt(1.0 + v * v) if weight_r > 0.0 else 0.0
                b[SINE, i] = max(across_c, across_r) * abs(w / q) / length
                # Off the epipolar line, in pixels: what no depth explains, and its noise.
                norm = dc * dc + dr * dr + TINY
                b[MISS, i] = (off_c * dr - off_r * dc) / np.sqrt(norm)
                b[ALLOWED, i] = sigmas * np.sqrt((dr * dr / (weight_c + TINY) + dc * dc / (weight_r + TINY)) / norm) + tolerance
