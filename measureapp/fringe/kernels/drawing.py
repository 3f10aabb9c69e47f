"""Compiled steps that write pixels into the maps, and count what became of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES
from measureapp.compiled.options import INLINE
from measureapp.compiled.simd.elements import broadcast, convert, minimum, popcount, select
from measureapp.compiled.simd.memory import load, store, store_streaming
from measureapp.fringe.kernels.records import CHUNK, RESIDUAL_SCALE

BYTES = CACHE_LINE_BYTES  # lanes of a vector of bytes that fills a cache line


@njit(**INLINE)
def whole(values: Any, like: Any) -> Any:
    """Return numbers above zero rounded, as the type of an array and not beyond what it holds."""
    most = np.float32(255 if like.itemsize == 1 else 65535)
    return convert(convert(minimum(values + 0.5, most), np.int32), like.dtype)


@njit(**INLINE)
def draw(place: int, solved: Any, residual: Any, model: Any, maps: Any) -> None:
    """Write what `judge` returned of the pixels from ``place`` on into their maps."""
    phase, sigma, modulation, grey, reason = solved
    store_streaming(phase, maps.phase, place)
    store_streaming(sigma, maps.sigma, place)
    store(whole(modulation, maps.modulation), maps.modulation, place)
    store(whole(grey, maps.grey), maps.grey, place)
    store(convert(convert(reason, np.int32), np.uint8), maps.state, place)
    if model.undecided:
        store(convert(convert(residual * np.float32(RESIDUAL_SCALE), np.int32), np.int8), maps.residual, place)


@njit(**INLINE)
def draw_exposure(sums: Any, off: int, begin: int, alike: int, model: Any, maps: Any) -> None:
    """Write the longest exposure that any group of a pixel took into its map."""
    exposure = maps.exposure[begin : begin + CHUNK]
    if alike >= 0:
        for j in range(0, CHUNK, BYTES):
            store(broadcast(model.first[alike], BYTES), exposure, j)
        return
    for j in range(0, CHUNK, BYTES):
        taken = load(sums.taken[0], off + j, BYTES)
        for m in range(1, sums.taken.shape[0]):
            taken = taken | load(sums.taken[m], off + j, BYTES)
        longest = broadcast(np.int8(-1), BYTES)
        for e in range(model.exposures - 1, -1, -1):
            longest = select((taken & np.uint16(1 << e)) != 0, np.int8(e), longest)
        store(longest, exposure, j)


@njit(**INLINE)
def tally(sums: Any, off: int, n: int, alike: int, state: Any, counts: Any) -> None:
    """Count the first ``n`` pixels of a chunk by state, and last those with an exposure above zero in all groups.

    What fills up the chunk is like the last of them, and not counted.
    """
    last, more = n - 1, CHUNK - n
    for reason in range(counts.shape[0] - 1):
        number = np.int64(0)
        for j in range(0, CHUNK, BYTES):
            number += popcount(load(state, j, BYTES) == np.uint8(reason))
        counts[reason] += number
    counts[state[last]] -= more
    if alike >= 0:
        counts[-1] += n if alike > 0 else 0
        return
    for j in range(0, CHUNK, BYTES):
        lit = load(sums.zero, off + j, BYTES) == 0
        for m in range(sums.taken.shape[0]):
            lit = lit & (load(sums.taken[m], off + j, BYTES) != 0)
        counts[-1] += popcount(lit)
    lit_last = sums.zero[off + last] == 0
    for m in range(sums.taken.shape[0]):
        lit_last &= sums.taken[m, off + last] != 0
    counts[-1] -= more if lit_last else 0
