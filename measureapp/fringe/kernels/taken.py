"""Compiled loops over the exposures that pixels took: the noise, the light and the reasons that belong to them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE
from measureapp.compiled.simd.elements import any_lane, broadcast, convert, select
from measureapp.compiled.simd.memory import gather, load, store
from measureapp.fringe.kernels.constants import BLOOMING, SATURATED, VALID, WEAK
from measureapp.fringe.kernels.records import BLACK, CHUNK, FLOOR, GAIN, LOST, PIXELS, TO_BRIGHTEST, TO_LONGEST


@njit(**INLINE)
def common(sums: Any, off: int) -> Any:
    """Return the exposures that all pixels of a chunk took, as bits; -1 where they differ or some have a reason of their own."""
    zero, bloomed = sums.zero[off : off + CHUNK], sums.bloomed[off : off + CHUNK]
    first = sums.taken[0, off]
    differs = broadcast(np.uint8(0), PIXELS) != 0
    for j in range(0, CHUNK, PIXELS):
        differs = differs | ((load(zero, j, PIXELS) | load(bloomed, j, PIXELS)) != 0)
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + CHUNK]
        for j in range(0, CHUNK, PIXELS):
            differs = differs | (load(taken, j, PIXELS) != first)
    return np.int64(-1) if any_lane(differs) else np.int64(first)


@njit(**INLINE)
def set_alike(taken: int, j: int, model: Any, work: Any) -> None:
    """Put what belongs to the exposures ``taken`` into the rows of the noise and the light, from ``j`` on."""
    store(broadcast(model.black[taken], PIXELS), work.rows, BLACK + j)
    store(broadcast(model.gain[taken], PIXELS), work.rows, GAIN + j)
    store(broadcast(model.floor[taken], PIXELS), work.rows, FLOOR + j)
    store(broadcast(model.to_brightest[taken], PIXELS), work.rows, TO_BRIGHTEST + j)
    store(broadcast(model.to_longest[taken], PIXELS), work.rows, TO_LONGEST + j)


@njit(**INLINE)
def set_together(alike: int, model: Any, work: Any) -> None:
    """Put what belongs to the exposures ``alike`` into the rows of the noise, the light and the reasons, for all pixels of a chunk."""
    for j in range(0, CHUNK, PIXELS):
        set_alike(alike, j, model, work)
        store(broadcast(np.float32(SATURATED if alike == 0 else VALID), PIXELS), work.rows, LOST + j)


@njit(**INLINE)
def set_apart(sums: Any, off: int, model: Any, work: Any) -> None:
    """Put what belongs to the exposures of every pixel into the same rows; where groups decide apart, those of the finest count.

    Neighbours mostly took the same, and looking up one set is faster than one for each.
    """
    rows, zero, bloomed = work.rows, sums.zero[off : off + CHUNK], sums.bloomed[off : off + CHUNK]
    own = sums.taken[0 if sums.taken.shape[0] == 1 else model.finest, off : off + CHUNK]
    unlit = np.float32(WEAK if model.zero_is_dark else VALID)
    for j in range(0, CHUNK, PIXELS):
        taken = load(own, j, PIXELS)
        if any_lane(taken != own[j]):
            which = convert(taken, np.int32)
            store(gather(model.black, which), rows, BLACK + j)
            store(gather(model.gain, which), rows, GAIN + j)
            store(gather(model.floor, which), rows, FLOOR + j)
            store(gather(model.to_brightest, which), rows, TO_BRIGHTEST + j)
            store(gather(model.to_longest, which), rows, TO_LONGEST + j)
        else:
            set_alike(own[j], j, model, work)
        lost = select(load(zero, j, PIXELS) != 0, broadcast(unlit, PIXELS), np.float32(VALID))
        reason = select(load(bloomed, j, PIXELS) != 0, broadcast(np.float32(BLOOMING), PIXELS), np.float32(SATURATED))
        for m in range(sums.taken.shape[0]):
            lost = select(load(sums.taken[m], off + j, PIXELS) == 0, reason, lost)
        store(lost, rows, LOST + j)
