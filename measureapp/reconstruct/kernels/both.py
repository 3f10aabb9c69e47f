"""Compiled loop that fuses what two other cameras matched of the same pixels, the most part of a view, in SIMD instructions."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.options import LOOP
from measureapp.reconstruct.kernels.scratch import stack_float32

CHUNK = 256
(Z0, G0, V0, Z1, G1, V1, STEP, OWN, FUSED, SPREAD) = (k * CHUNK for k in range(10))
SCRATCH = 10 * CHUNK
ZERO, ONE, TINY = np.float32(0), np.float32(1), np.float32(1e-20)


@njit(**LOOP)
def fuse_both(
    rays: Any,  # (H, 2 W) float32
    sigma: Any,
    depth: Any,  # (2, rows, W) float32, candidates, one per other camera
    gain: Any,  # (2, rows, W) float32, change of the phase with z
    variance: Any,  # (2, rows, W) float32, of the phase
    step: Any,  # (c0, c1, c2) float32: (c0 · nx + c1 · ny + c2) · z is the share of z that shifts a point by a pixel in the second camera
    limits: Any,  # (standard deviations, px along the epipolar line) float32 that both may differ
    row_start: int,
    row_stop: int,
    z: Any,  # out (H, W) float32, 0 where they differ or one is missing
    z_sigma: Any,  # out (H, W) float32
) -> None:
    """Solve for z and the projector's true phase, with one equation per camera, by least squares."""
    c0, c1, c2 = step
    sigmas2, tolerance = limits[0] * limits[0], limits[1]
    width = sigma.shape[1]
    s = stack_float32(SCRATCH)
    for y in range(row_start, row_stop):
        for first in range(0, width, CHUNK):
            n = min(CHUNK, width - first)
            ray, own_row = rays[y, 2 * first : 2 * (first + n)], sigma[y, first : first + n]
            for i in range(n):
                s[STEP + i] = c0 * ray[2 * i] + c1 * ray[2 * i + 1] + c2
            for i in range(n):
                s[OWN + i] = own_row[i]
            for k in range(2):
                row = y - row_start
                z_row, g_row, v_row = depth[k, row, first : first + n], gain[k, row, first : first + n], variance[k, row, first : first + n]
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
                ratio = g1 / g0
                spread = v1 + own * (ratio - ONE) * (ratio - ONE) + v0 * ratio * ratio
                limit = np.sqrt(sigmas2 * spread) + tolerance * abs(g1) * z1 * z1 * s[STEP + i]
                w0, w1, w = ONE / (v0 + TINY), ONE / (v1 + TINY), ONE / (own + TINY)
                dd = w + w0 + w1
                zz = w0 * g0 * g0 + w1 * g1 * g1
                zd = w0 * g0 + w1 * g1
                per = ONE / (zz * dd - zd * zd)
                agree = (z0 > ZERO) & (z1 > ZERO) & (abs(excess) <= limit) & (per > ZERO)
                s[FUSED + i] = z0 - w1 * excess * (g1 * dd - zd) * per if agree else ZERO
                s[SPREAD + i] = np.sqrt(dd * per) if agree else ZERO
            z_out, sigma_out = z[y, first : first + n], z_sigma[y, first : first + n]
            for i in range(n):
                z_out[i] = s[FUSED + i]
            for i in range(n):
                sigma_out[i] = s[SPREAD + i]
