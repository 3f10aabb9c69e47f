"""Memory of maps over images and of clouds that is used again, view after view."""

from __future__ import annotations

import weakref
from math import prod
from typing import Any

import numpy as np
import numpy.typing as npt

LINE = 64  # bytes of a line of the processor's cache


class MapMemory:
    """Gives out arrays and takes their memory back by itself, once neither they nor any view of them are held any more.

    The first touch of memory that comes fresh from the system takes as long as a third of the decoding, and as long as all of the
    reconstruction. Whoever makes view after view (a scan, a batch) keeps one of these and passes it along. Arrays of nearly one size take
    each other's place, so it hardly holds more than was in use at one time; all goes back to the system with it.
    """

    def __init__(self) -> None:
        self._free: dict[int, list[npt.NDArray[np.uint8]]] = {}

    def empty(self, shape: int | tuple[int, ...], dtype: npt.DTypeLike) -> npt.NDArray[Any]:
        """Return an array of a shape, whose elements hold anything."""
        count = prod(shape) if isinstance(shape, tuple) else shape
        size = _rounded(count * np.dtype(dtype).itemsize)
        free = self._free.setdefault(size, [])
        try:
            memory = free.pop()
        except IndexError:
            memory = _aligned(size)
        # Views of this array refer to it, and not past it to the memory, because a memoryview stands between them.
        array = np.frombuffer(memory.data, dtype, count) if count else np.empty(0, dtype)
        weakref.finalize(array, free.append, memory).atexit = False
        return array.reshape(shape)


def at_a_line(shape: tuple[int, ...], dtype: npt.DTypeLike) -> npt.NDArray[Any]:
    """Return an array that begins with a line of the cache and holds anything: scratch memory of kernels, which no access crosses."""
    return _aligned(prod(shape) * np.dtype(dtype).itemsize).view(dtype).reshape(shape)


def _aligned(size: int) -> npt.NDArray[np.uint8]:
    """Return so many bytes that begin with a line of the cache, so that kernels may write whole lines."""
    memory = np.empty(size + LINE, np.uint8)
    begin = -memory.__array_interface__["data"][0] % LINE
    return memory[begin : begin + size]


def _rounded(size: int) -> int:
    """Return a size up to a 16th larger, one of 16 between two powers of two. What is never touched of it is never given by the system."""
    step = 1 << max(size.bit_length() - 5, 0)
    return -(-size // step) * step
