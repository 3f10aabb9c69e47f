"""Compiled loop over candidates: which one the cameras agree on, and the depth they give together."""
# One loop over pixels cannot be cut into functions without leaving SIMD code.
# ruff: noqa: PLR0912, PLR0915

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.seen import SEEN


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def fuse(
    sigma: Any,  # (rows, W) float32, of this camera's phase
    depth: Any,  # (M, rows, W) float32, candidates, one per other camera
    gain: Any,  # (M, M, rows, W) float32, [candidate, camera]
    variance: Any,  # (M, M, rows, W)
    excess: Any,  # (M, M, rows, W)
    shift: Any,  # (M, M, rows, W)
    seen: Any,  # (M, M, rows, W) uint8
    sigmas: Any,
    tolerance_px: Any,
    z: Any,  # out (rows, W) float32
    z_sigma: Any,  # out (rows, W) float32
    bits: Any,  # out (rows, W) uint8, bit i: camera i of the others takes part
) -> int:
    """Choose the candidate no camera contradicts and most agree with; the depth is the least-squares solution of all that agree.

    Unknowns are z and the projector's true phase; one equation per camera. Returns how many pixels were contradicted.
    """
    count, rows, width = depth.shape
    contradicted = 0
    for y in range(rows):
        for x in range(width):
            z[y, x] = 0
            z_sigma[y, x] = 0
            bits[y, x] = 0
            best = -1
            best_support = 0
            tried = False
            own = sigma[y, x] * sigma[y, x]
            for k in range(count):
                if depth[k, y, x] <= 0:
                    continue
                tried = True
                support = 1
                for c in range(count):
                    if c == k or seen[k, c, y, x] != SEEN:
                        continue
                    slope = abs(excess[k, c, y, x] / shift[k, c, y, x]) if shift[k, c, y, x] != 0 else 0.0
                    ratio = gain[k, c, y, x] / gain[k, k, y, x]
                    noise = variance[k, c, y, x] + own * (ratio - 1) ** 2 + variance[k, k, y, x] * ratio**2
                    limit = sigmas * np.sqrt(noise) + tolerance_px * slope
                    if abs(excess[k, c, y, x]) > limit:
                        support = -100
                    else:
                        support += 1
                if support > best_support:
                    best_support = support
                    best = k
            if best < 0:
                contradicted += tried
                continue
            zz = 0.0
            zd = 0.0
            dd = 1.0 / (own + 1e-20)
            rz = 0.0
            rd = 0.0
            for c in range(count):
                if c != best and seen[best, c, y, x] != SEEN:
                    continue
                weight = 1.0 / (variance[best, c, y, x] + 1e-20)
                g = gain[best, c, y, x]
                e = excess[best, c, y, x]
                zz += weight * g * g
                zd -= weight * g
                dd += weight
                rz -= weight * g * e
                rd += weight * e
                bits[y, x] |= np.uint8(1 << c)
            determinant = zz * dd - zd * zd
            if determinant <= 0:
                continue
            z[y, x] = depth[best, y, x] + (rz * dd - zd * rd) / determinant
            z_sigma[y, x] = np.sqrt(dd / determinant)
    return contradicted
