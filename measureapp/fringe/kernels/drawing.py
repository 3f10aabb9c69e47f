"""Compiled steps that write pixels into the maps, and count what became of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.options import HALF, INLINE
from measureapp.fringe.kernels.records import CHUNK, RESIDUAL_SCALE
from measureapp.simd.elements import converted, count_of, filled, smaller, where
from measureapp.simd.memory import load, store, store_past_caches

BYTES = 64  # of a line of the cache


@njit(**INLINE)
def whole(values: Any, like: Any) -> Any:
    """Return numbers above zero rounded, as the type of an array and not beyond what it holds."""
    most = np.float32(255 if like.itemsize == 1 else 65535)
    return converted(converted(smaller(values + HALF, most), np.int32), like.dtype)


@njit(**INLINE)
def draw(place: int, solved: Any, residual: Any, model: Any, maps: Any) -> None:
    """Write what `judge` returned of the pixels from ``place`` on into their maps."""
    phase, sigma, modulation, grey, reason = solved
    store_past_caches(phase, maps.phase, place)
    store_past_caches(sigma, maps.sigma, place)
    store(whole(modulation, maps.modulation), maps.modulation, place)
    store(whole(grey, maps.grey), maps.grey, place)
    store(converted(converted(reason, np.int32), np.uint8), maps.state, place)
    if model.undecided:
        store(converted(converted(residual * np.float32(RESIDUAL_SCALE), np.int32), np.int8), maps.residual, place)


@njit(**INLINE)
def draw_exposure(sums: Any, off: int, begin: int, alike: int, model: Any, maps: Any) -> None:
    """Write the longest exposure that any group of a pixel took into its map."""
    exposure = maps.exposure[begin : begin + CHUNK]
    if alike >= 0:
        for j in range(0, CHUNK, BYTES):
            store(filled(model.first[alike], BYTES), exposure, j)
        return
    for j in range(0, CHUNK, BYTES):
        taken = load(sums.taken[0], off + j, BYTES)
        for m in range(1, sums.taken.shape[0]):
            taken = taken | load(sums.taken[m], off + j, BYTES)
        longest = filled(np.int8(-1), BYTES)
        for e in range(model.exposures - 1, -1, -1):
            longest = where((taken & np.uint16(1 << e)) != 0, np.int8(e), longest)
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
            number += count_of(load(state, j, BYTES) == np.uint8(reason))
        counts[reason] += number
    counts[state[last]] -= more
    if alike >= 0:
        counts[-1] += n if alike > 0 else 0
        return
    for j in range(0, CHUNK, BYTES):
        lit = load(sums.zero, off + j, BYTES) == 0
        for m in range(sums.taken.shape[0]):
            lit = lit & (load(sums.taken[m], off + j, BYTES) != 0)
        counts[-1] += count_of(lit)
    lit_last = sums.zero[off + last] == 0
    for m in range(sums.taken.shape[0]):
        lit_last &= sums.taken[m, off + last] != 0
    counts[-1] -= more if lit_last else 0
