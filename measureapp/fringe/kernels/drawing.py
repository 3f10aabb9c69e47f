"""Compiled loops that write a chunk of pixels into the maps, and count what became of them."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.options import HALF, INLINE
from measureapp.fringe.kernels.records import LEVEL, MODULATION, REASON, RESIDUAL, RESIDUAL_SCALE, SIGMA, VALUE
from measureapp.machine_memory import STREAMED, write_past_caches
from measureapp.map_memory import LINE


@njit(**INLINE)
def write(row: Any, shown: Any, n: int) -> None:
    """Write a row into a map: past the caches, where the map lies so that whole lines of them can be written."""
    done = 0
    if shown.ctypes.data % LINE == 0:
        done = n - n % STREAMED
        for j in range(0, done, STREAMED):
            write_past_caches(row, shown, j)
    for j in range(done, n):
        shown[j] = row[j]


@njit(**INLINE)
def draw(begin: int, n: int, model: Any, work: Any, maps: Any) -> None:
    """Write the rows of the pixels into their maps."""
    rows = work.rows
    phase, sigma, state = maps.phase[begin : begin + n], maps.sigma[begin : begin + n], maps.state[begin : begin + n]
    shown, grey = maps.modulation[begin : begin + n], maps.grey[begin : begin + n]
    most, white = np.float32(255 if maps.modulation.itemsize == 1 else 65535), np.float32(65535)
    write(rows[VALUE : VALUE + n], phase, n)
    write(rows[SIGMA : SIGMA + n], sigma, n)
    for j in range(n):
        shown[j] = np.int32(min(rows[MODULATION + j] + HALF, most))
    for j in range(n):
        grey[j] = np.int32(min(rows[LEVEL + j] + HALF, white))
    for j in range(n):
        state[j] = np.int32(rows[REASON + j])
    if model.undecided:
        left = maps.residual[begin : begin + n]
        for j in range(n):
            left[j] = np.int32(rows[RESIDUAL + j] * np.float32(RESIDUAL_SCALE))


@njit(**INLINE)
def tally(sums: Any, off: int, n: int, alike: int, work: Any, state: Any, counts: Any) -> None:
    """Count the pixels of every state, and last those with an exposure above zero in all groups."""
    present = np.int32(0)
    for j in range(n):
        present |= np.int32(1) << np.int32(state[j])
    for reason in range(counts.shape[0] - 1):
        bit = np.int32(1) << np.int32(reason)
        if present == bit:
            counts[reason] += n
        elif present & bit:
            number = np.int32(0)
            for j in range(n):
                number += np.int32(state[j] == reason)
            counts[reason] += number
    if alike >= 0:
        counts[-1] += n if alike > 0 else 0
        return
    zero, complete = sums.zero[off : off + n], work.code[0]
    for j in range(n):
        complete[j] = np.int32(zero[j] == 0)
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            complete[j] &= np.int32(taken[j] != 0)
    whole = np.int32(0)
    for j in range(n):
        whole += complete[j]
    counts[-1] += whole
