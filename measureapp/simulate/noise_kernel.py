"""Compiled loop that adds noise to an image; see `kernels` for how such loops are run."""

from __future__ import annotations

import numpy as np
from numba import njit

from measureapp.arrays import FloatArray, ImageArray


@njit(cache=True)
def _splitmix(x):  # type: ignore[no-untyped-def]
    """64 random bits from a counter (splitmix64: G. L. Steele et al., OOPSLA 2014)."""
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return x ^ (x >> np.uint64(31))


@njit(cache=True, nogil=True)
def quantise(
    start: int, stop: int, mean: FloatArray, full_scale: int, variance: FloatArray, key: int, normal: FloatArray, out: ImageArray
) -> None:
    """Add noise to a mean image (n,) and quantise it, in blocks of four pixels.

    ``variance`` = (of a dark pixel, increase per grey level); ``normal`` contains 65536 quantiles of the standard normal
    distribution, indexed by a counter-based generator so that the image depends on ``key`` alone, not on threads.
    """
    golden = np.uint64(0x9E3779B97F4A7C15)
    origin = _splitmix(np.uint64(key) * golden)
    for block in range(start, stop):
        bits = _splitmix(origin + np.uint64(block + 1) * golden)
        first = 4 * block
        for i in range(first, min(first + 4, out.shape[0])):
            level = mean[i] * full_scale
            draw = normal[np.int64(bits & np.uint64(0xFFFF))]
            bits >>= np.uint64(16)
            level += draw * np.sqrt(variance[0] + variance[1] * level)
            out[i] = int(min(max(level + np.float32(0.5), np.float32(0.0)), np.float32(full_scale)))
