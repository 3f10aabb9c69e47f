"""Memory of phase maps that is used again, view after view."""

from __future__ import annotations

import weakref
from typing import Any

import numpy as np
import numpy.typing as npt

from measureapp.fringe.kernels.memory import LINE


class MapMemory:
    """Gives out arrays and takes their memory back by itself, once neither they nor any view of them are held any more.

    The first touch of memory that comes fresh from the system takes as long as a third of the decoding. Whoever decodes view after view
    (a scan, a batch) keeps one of these and passes it along. It never holds more than was in use at one time; all goes back to the
    system with it.
    """

    def __init__(self) -> None:
        self._free: dict[int, list[npt.NDArray[np.uint8]]] = {}

    def empty(self, count: int, dtype: npt.DTypeLike) -> npt.NDArray[Any]:
        """Return an array of ``count`` elements, which hold anything."""
        size = count * np.dtype(dtype).itemsize
        free = self._free.setdefault(size, [])
        try:
            memory = free.pop()
        except IndexError:
            memory = _aligned(size)
        # Views of this array refer to it, and not past it to the memory, because a memoryview stands between them.
        array = np.frombuffer(memory.data, dtype, count) if count else np.empty(0, dtype)
        weakref.finalize(array, free.append, memory).atexit = False
        return array


def _aligned(size: int) -> npt.NDArray[np.uint8]:
    """Return so many bytes that begin with a line of the cache, so that kernels may write whole lines."""
    memory = np.empty(size + LINE, np.uint8)
    begin = -memory.ctypes.data % LINE
    return memory[begin : begin + size]
