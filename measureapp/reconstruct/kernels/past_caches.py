"""Writing rows of a map that are read only when all others are written."""

from __future__ import annotations

from typing import Any

from numba import njit

from measureapp.machine_memory import STREAMED, write_past_caches
from measureapp.map_memory import LINE
from measureapp.reconstruct.kernels.options import INLINE


@njit(**INLINE)
def write_row(row: Any, out: Any) -> None:
    """Write a row past the caches, where whole lines of them can be written."""
    done = 0
    if out.ctypes.data % LINE == 0:
        done = len(row) - len(row) % STREAMED
        for i in range(0, done, STREAMED):
            write_past_caches(row, out, i)
    for i in range(done, len(row)):
        out[i] = row[i]
