"""Compiled loop that fuses what two other cameras matched of the same pixels, the most part of a view, in SIMD instructions."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import LOOP
from measureapp.reconstruct.kernels.scratch import stack_float32

CHUNK = 256
(Z0, G0, V0, Z1, G1, V1, STEP, OWN, FUSED, SPREAD) = (k * CHUNK for k in range(10))
SCRATCH = 10 * CHUNK
ZERO, ONE, TINY = np.float32(0), np.float32(1), np.float32(1e-20)


@njit(**LOOP)
def fuse_both(
    rays: Any,  # (H, 2 W) float32
    sigma: Any,
    depth: Any,  # (2, rows, columns) float32, candidates, one per other camera
    gain: Any,  # (2, rows, columns) float32, change of the phase with z
    variance: Any,  # (2, rows, columns) float32, of the phase
    step: Any,  # (c0, c1, c2) float32: (c0 · nx + c1 · ny + c2) · z is the share of z that shifts a point by a pixel in the second camera
    limits: Any,  # (standard deviations, px along the epipolar line) float32 that both may differ
    row_start: int,
    row_stop: int,
    column_start: int,
    column_stop: int,
    z: Any,  # out (H, W) float32, 0 where they differ or one is missing
    z_sigma: Any,  # out (H, W) float32
) -> None:
    """Solve for z and the projector's true phase, with one equation per camera, by least squares."""
    c0, c1, c2 = step
    sigmas2, tolerance = limits[0] * limits[0], limits[1]
    s = stack_float32(SCRATCH)
    for y in range(row_start, row_stop):
        for first in range(column_start, column_stop, CHUNK):
            n = min(CHUNK, column_stop - first)
            part = slice(first - column_start, first - column_start + n)
            ray, own_row = rays[y, 2 * first : 2 * (first + n)], sigma[y, first : first + n]
            for i in range(n):
                s[STEP + i] = c0 * ray[2 * i] + c1 * ray[2 * i + 1] + c2
            for i in range(n):
                s[OWN + i] = own_row[i]
            for k in range(2):
                row = y - row_start
                z_row, g_row, v_row = depth[k, row, part], gain[k, row, part], variance[k, row, part]
                lane = s[k * 3 * CHUNK : (k * 3 + 3) * CHUNK]
                for i in range(n):
                    lane[i] = z_row[i]
                for i in range(n):
                    lane[CHUNK + i] = g_row[i]
                for i in range(n):
                    lane[2 * CHUNK + i] = v_row[i]
            for i in range(n):
                z0, z1, g0, g1, v0, v1 = s[Z0 + i], s[Z1 + i], s[G0 + i], s[G1 + i], s[V0 + i], s[V1 + i]
                own = s[OWN + i] * s[OWN + i]
                excess = g1 * (z0 - z1)
                spread = v1 * g0 * g0 + own * (g1 - g0) * (g1 - g0) + v0 * g1 * g1  # of the excess, times g0²
                limit = np.sqrt(sigmas2 * spread) + tolerance * abs(g1 * g0) * z1 * z1 * s[STEP + i]
                share = ONE / own  # all variances as shares of the own one: then one division serves all weights
                a, b = v0 * share, v1 * share
                dd = a * b + a + b
                zz = b * g0 * g0 + a * g1 * g1
                zd = b * g0 + a * g1
                determinant = zz * dd - zd * zd
                per = ONE / determinant
                agree = (z0 > ZERO) & (z1 > ZERO) & (abs(excess * g0) <= limit) & (determinant > ZERO)
                s[FUSED + i] = z0 - a * excess * (g1 * dd - zd) * per if agree else ZERO
                s[SPREAD + i] = np.sqrt(own * a * b * dd * per) if agree else ZERO
            z_out, sigma_out = z[y, first : first + n], z_sigma[y, first : first + n]
            for i in range(n):
                z_out[i] = s[FUSED + i]
            for i in range(n):
                sigma_out[i] = s[SPREAD + i]
