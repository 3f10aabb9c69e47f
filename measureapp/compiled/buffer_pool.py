"""Pool of cache-line-aligned buffers for maps and clouds, reused from viewpoint to viewpoint."""

from __future__ import annotations

import weakref
from math import prod
from typing import Any

import numpy as np
import numpy.typing as npt

CACHE_LINE_BYTES = 64


class BufferPool:
    """Allocates arrays and reclaims each buffer when the last reference to its array and the array's views is gone.

    The page faults of fresh memory cost a third of the decoding time, and as much as the whole reconstruction. Code that processes many
    viewpoints (a scan, a batch) keeps one pool and passes it along. Sizes are rounded up to few size classes, so that arrays of nearly
    equal size share buffers and the pool hardly exceeds the peak of what was in use at one time. The memory returns to the system with
    the pool.
    """

    def __init__(self) -> None:
        self._free: dict[int, list[npt.NDArray[np.uint8]]] = {}

    def empty(self, shape: int | tuple[int, ...], dtype: npt.DTypeLike) -> npt.NDArray[Any]:
        """Return an uninitialised C-contiguous array that begins at a cache line."""
        count = prod(shape) if isinstance(shape, tuple) else shape
        size = _size_class(count * np.dtype(dtype).itemsize)
        free = self._free.setdefault(size, [])
        try:
            buffer = free.pop()
        except IndexError:
            buffer = _aligned_bytes(size)
        # The memoryview in between makes views of this array keep the array alive, not the buffer behind it.
        array = np.frombuffer(buffer.data, dtype, count) if count else np.empty(0, dtype)
        weakref.finalize(array, free.append, buffer).atexit = False
        return array.reshape(shape)


def aligned_empty(shape: tuple[int, ...], dtype: npt.DTypeLike) -> npt.NDArray[Any]:
    """Return an uninitialised array that begins at a cache line, so that no aligned vector access crosses two lines."""
    return _aligned_bytes(prod(shape) * np.dtype(dtype).itemsize).view(dtype).reshape(shape)


def _aligned_bytes(size: int) -> npt.NDArray[np.uint8]:
    """Return ``size`` uninitialised bytes that begin at a cache line."""
    memory = np.empty(size + CACHE_LINE_BYTES, np.uint8)
    begin = -memory.__array_interface__["data"][0] % CACHE_LINE_BYTES
    return memory[begin : begin + size]


def _size_class(size: int) -> int:
    """Round a size up to one of 16 classes per power of two, at most 1/16 larger; pages never touched are never committed."""
    step = 1 << max(size.bit_length() - 5, 0)
    return -(-size // step) * step
