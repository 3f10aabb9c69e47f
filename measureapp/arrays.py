"""Array types and the one way to make an array read-only."""

from __future__ import annotations

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


def read_only(array: npt.ArrayLike, dtype: npt.DTypeLike | None = None, shape: tuple[int | None, ...] | None = None) -> Any:
    """Return ``array`` as a contiguous array that cannot be written to.

    Parameters
    ----------
    array : array-like
    dtype : wanted element type; None keeps the one it has
    shape : wanted shape, with None where any length is right

    Raises
    ------
    ValueError
        The shape differs from ``shape``: a programming error, not one of the user.
    """
    made = np.ascontiguousarray(array, dtype=dtype)
    if shape is not None and (made.ndim != len(shape) or any(w is not None and w != g for w, g in zip(shape, made.shape, strict=True))):
        raise ValueError(f"expected an array of shape {shape}, got {made.shape}")
    view = made.view()
    view.flags.writeable = False
    return view


def in_bands(work: Callable[[int, int], Any], count: int, bands: int | None = None) -> list[Any]:
    """Call ``work(start, stop)`` for consecutive shares of ``0…count`` on one thread per processor, of which this is one.

    Worth it only where ``work`` releases the interpreter (compiled kernels, large NumPy calls).

    Returns
    -------
    list : what each call returned, in order; the exception of a call is raised
    """
    threads = processors()
    edges = np.linspace(0, count, (bands or 4 * threads) + 1).astype(int)
    shares = [(int(start), int(stop)) for start, stop in pairwise(edges) if stop > start]
    done: list[Any] = [None] * len(shares)
    queue = iter(range(len(shares)))

    def take_shares() -> None:
        for number in queue:
            done[number] = work(*shares[number])

    asked = [_helpers(threads - 1).submit(take_shares) for _ in range(min(threads, len(shares)) - 1)]
    try:
        take_shares()
    finally:
        begun = [helper for helper in asked if not helper.cancel()]  # one that is busy elsewhere is not waited for
        wait(begun)
    for helper in begun:
        helper.result()
    return done


@cache
def processors() -> int:
    """Return how many there are: asking the system takes as long as a small share."""
    return os.cpu_count() or 1


@cache
def _helpers(count: int) -> ThreadPoolExecutor:
    """Return threads that stay: starting one takes as long as many a share."""
    return ThreadPoolExecutor(count, thread_name_prefix=BAND_THREADS)
