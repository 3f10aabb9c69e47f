"""Compiled loop over a band of rows: matches a camera with all others and fuses what they found, strip of columns by strip.

What is found of a strip of a band stays in the second cache of a processor until it is fused.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import ALLOCATING_LOOP
from measureapp.reconstruct.kernels.both import fuse_both
from measureapp.reconstruct.kernels.fusing import fuse
from measureapp.reconstruct.kernels.lanes import CHUNK, Found
from measureapp.reconstruct.kernels.matching import match

ZERO = np.float32(0)


@njit(**ALLOCATING_LOOP)
def match_and_fuse(
    rays: Any,  # (H, W, 2) float32, normalised image coordinates of the camera that is matched
    flat_rays: Any,  # the same (H, 2 W)
    phase: Any,
    sigma: Any,
    skip: Any,  # (H, W) uint8, 0 for pixels to match, else their fate
    partners: Any,  # per other camera: what `match` needs of it
    others: Any,  # per other camera: what `see` needs of it
    tables: Any,  # per other camera, see `fuse`
    step: Any,  # of the second other camera, see `fuse_both`
    limits: Any,  # (standard deviations, px along the epipolar line) float32 that cameras may differ
    sample: int,  # every so many pixels the shifts between the cameras are noted
    row_start: int,
    row_stop: int,
    z: Any,  # out, this and what follows: see `fuse`
    z_sigma: Any,
    bits: Any,
    fate: Any,
    pair_gain: Any,
    covered: Any,
    shifts: Any,
    matched: Any,  # out (M,) int64, how many pixels were matched with each other camera
) -> None:
    """Match the rows of a band with every other camera; what two cameras found alike is fused at once, all else one by one."""
    count, rows, width = len(partners), row_stop - row_start, phase.shape[1]
    shape = (count, rows, CHUNK)
    depth, gain, variance = np.empty(shape, np.float32), np.empty(shape, np.float32), np.empty(shape, np.float32)
    there, reason = np.empty(shape, np.int32), np.empty(shape, np.uint8)
    found = Found(depth, gain, variance, there, reason)
    matched[:] = 0
    for first in range(0, width, CHUNK):
        strip = (row_start, row_stop, first, min(first + CHUNK, width))
        for k in range(count):
            of_one = Found(depth[k], gain[k], variance[k], there[k], reason[k])
            matched[k] += match(flat_rays, phase, skip, partners[k], *strip, of_one)
        if count == 2:
            fuse_both(flat_rays, sigma, depth, gain, variance, step, limits, *strip, z, z_sigma)
        else:
            z[row_start:row_stop, strip[2] : strip[3]] = ZERO
            z_sigma[row_start:row_stop, strip[2] : strip[3]] = ZERO
        fuse(rays, phase, sigma, skip, found, others, tables, limits, sample, *strip, z, z_sigma, bits, fate, pair_gain, covered, shifts)
