"""Non-temporal stores of rows of a map that are read only when all others are written."""

from __future__ import annotations

from typing import Any

from numba import njit

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES
from measureapp.compiled.cache_hints import WORDS_PER_LINE, stream_line
from measureapp.compiled.options import INLINE


@njit(**INLINE)
def write_row(row: Any, out: Any) -> None:
    """Write a row by non-temporal stores, as far as it fills aligned cache lines."""
    done = 0
    if out.ctypes.data % CACHE_LINE_BYTES == 0:
        done = len(row) - len(row) % WORDS_PER_LINE
        for i in range(0, done, WORDS_PER_LINE):
            stream_line(row, out, i)
    for i in range(done, len(row)):
        out[i] = row[i]
