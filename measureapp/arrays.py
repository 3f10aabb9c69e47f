"""Array types, read-only arrays, arrays mapped from files, and loops in parallel bands."""

from __future__ import annotations

import mmap
import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor, wait
from functools import cache
from itertools import pairwise
from typing import Any

import numpy as np
import numpy.typing as npt

FloatArray = npt.NDArray[np.floating[Any]]
IntArray = npt.NDArray[np.integer[Any]]
BoolArray = npt.NDArray[np.bool_]
ImageArray = npt.NDArray[np.unsignedinteger[Any]]

BAND_THREADS = "band"  # name of the threads that `in_bands` keeps
DROP_PAGES: int | None = getattr(mmap, "MADV_DONTNEED", None)  # of a mapped file; unknown to some systems


def read_only(array: npt.ArrayLike, dtype: npt.DTypeLike | None = None, shape: tuple[int | None, ...] | None = None) -> Any:
    """Return ``array`` as a contiguous array that cannot be written to.

    Parameters
    ----------
    array : array-like
    dtype : element type; None: unchanged
    shape : expected shape, with None for an arbitrary length

    Raises
    ------
    ValueError
        The shape differs from ``shape``, which is a programming error.
    """
    made = np.ascontiguousarray(array, dtype=dtype)
    if shape is not None and (made.ndim != len(shape) or any(w is not None and w != g for w, g in zip(shape, made.shape, strict=True))):
        raise ValueError(f"expected an array of shape {shape}, got {made.shape}")
    view = made.view()
    view.flags.writeable = False
    return view


def give_up_pages(*arrays: npt.NDArray[Any]) -> None:
    """Take arrays that are mapped from a file, read-only, out of this program's memory; used again, they come back from the file.

    Others stay as they are, and so do all of them where the system has no such request: it takes them itself when memory is short.
    """
    for array in arrays:
        base: Any = array
        while isinstance(base, np.ndarray):
            base = base.base
        mapped = base.obj if isinstance(base, memoryview) else base
        if isinstance(mapped, mmap.mmap) and memoryview(mapped).readonly and DROP_PAGES is not None:
            mapped.madvise(DROP_PAGES)


def in_bands(work: Callable[[int, int], Any], count: int, bands: int | None = None) -> list[Any]:
    """Call ``work(start, stop)`` for consecutive bands of ``0…count`` in parallel, one thread per processor including this one.

    Useful only if ``work`` releases the interpreter lock (compiled kernels, large NumPy calls).

    Returns
    -------
    list : results of the calls, in order; an exception of a call is raised
    """
    threads = processors()
    edges = np.linspace(0, count, (bands or 4 * threads) + 1).astype(int)
    limits = [(int(start), int(stop)) for start, stop in pairwise(edges) if stop > start]
    results: list[Any] = [None] * len(limits)
    queue = iter(range(len(limits)))

    def process_bands() -> None:
        for number in queue:
            results[number] = work(*limits[number])

    submitted = [_helpers(threads - 1).submit(process_bands) for _ in range(min(threads, len(limits)) - 1)]
    try:
        process_bands()
    finally:
        started = [helper for helper in submitted if not helper.cancel()]  # a busy thread is not waited for
        wait(started)
    for helper in started:
        helper.result()
    return results


@cache
def processors() -> int:
    """Return the number of processors; cached, because the system call takes as long as a small band."""
    return os.cpu_count() or 1


@cache
def _helpers(count: int) -> ThreadPoolExecutor:
    """Return a persistent thread pool, because starting a thread takes as long as many a band."""
    return ThreadPoolExecutor(count, thread_name_prefix=BAND_THREADS)
