"""Compiled loops over the exposures that pixels took: the noise, the light and the reasons that belong to them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.options import BLOOMING, INLINE, SATURATED, VALID, WEAK
from measureapp.fringe.kernels.records import BLACK, CHUNK, FLOOR, GAIN, LOST, TO_BRIGHTEST, TO_LONGEST


@njit(**INLINE)
def look_up(table: Any, taken: Any, n: int, out: Any) -> None:
    """Write what belongs to the exposures that each pixel took."""
    for j in range(n):
        out[j] = table[taken[j]]


@njit(**INLINE)
def common(sums: Any, off: int, n: int) -> Any:
    """Return the exposures that all pixels of a chunk took, as bits; -1 where they differ or some have a reason of their own."""
    zero, bloomed = sums.zero[off : off + n], sums.bloomed[off : off + n]
    first = sums.taken[0, off]
    marked, differs = np.uint8(0), np.uint16(0)
    for j in range(n):
        marked |= zero[j] | bloomed[j]
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            differs |= taken[j] ^ first
    return np.int64(first) if marked == 0 and differs == 0 else np.int64(-1)


@njit(**INLINE)
def set_together(alike: int, model: Any, work: Any) -> None:
    """Put what belongs to the exposures ``alike`` into the rows of the noise, the light and the reasons, for all pixels of a chunk."""
    rows = work.rows
    rows[BLACK : BLACK + CHUNK] = model.black[alike]
    rows[GAIN : GAIN + CHUNK] = model.gain[alike]
    rows[FLOOR : FLOOR + CHUNK] = model.floor[alike]
    rows[TO_BRIGHTEST : TO_BRIGHTEST + CHUNK] = model.to_brightest[alike]
    rows[TO_LONGEST : TO_LONGEST + CHUNK] = model.to_longest[alike]
    rows[LOST : LOST + CHUNK] = np.float32(SATURATED if alike == 0 else VALID)


@njit(**INLINE)
def set_apart(sums: Any, off: int, n: int, model: Any, work: Any) -> None:
    """Put what belongs to the exposures of every pixel into the same rows; where groups decide apart, those of the finest count."""
    rows = work.rows
    taken = sums.taken[0 if sums.taken.shape[0] == 1 else model.finest, off : off + n]
    look_up(model.black, taken, n, rows[BLACK : BLACK + n])
    look_up(model.gain, taken, n, rows[GAIN : GAIN + n])
    look_up(model.floor, taken, n, rows[FLOOR : FLOOR + n])
    look_up(model.to_brightest, taken, n, rows[TO_BRIGHTEST : TO_BRIGHTEST + n])
    look_up(model.to_longest, taken, n, rows[TO_LONGEST : TO_LONGEST + n])
    zero, bloomed, lost = sums.zero[off : off + n], sums.bloomed[off : off + n], rows[LOST : LOST + n]
    unlit = np.float32(WEAK if model.zero_is_dark else VALID)
    for j in range(n):
        lost[j] = unlit if zero[j] != 0 else np.float32(VALID)
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            reason = np.float32(BLOOMING) if bloomed[j] != 0 else np.float32(SATURATED)
            lost[j] = reason if taken[j] == 0 else lost[j]


@njit(**INLINE)
def draw_exposure(sums: Any, off: int, begin: int, n: int, alike: int, model: Any, work: Any, maps: Any) -> None:
    """Write the longest exposure that any group of a pixel took into its map."""
    exposure, code = maps.exposure[begin : begin + n], work.code[0]
    if alike >= 0:
        exposure[:] = model.first[alike]
        return
    for j in range(n):
        code[j] = 0
    for k in range(sums.taken.shape[0]):
        taken = sums.taken[k, off : off + n]
        for j in range(n):
            code[j] |= np.int32(taken[j])
    look_up(model.first, code, n, exposure)
