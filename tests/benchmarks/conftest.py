"""What the speed figures are measured with: threads that stay on processors of their own, and the unit, a copy by two of them."""

from __future__ import annotations

import os
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from measureapp.arrays import in_bands

TARGETS = 3
PATIENCE_S = 5.0
Copies = list[Callable[[], object]]


def keep_apart(processors: list[set[int]]) -> Callable[[int, int], None]:
    """Return work that, on as many threads at once, puts the k-th on the k-th set of processors."""
    together = threading.Barrier(len(processors))

    def work(number: int, _stop: int = 0) -> None:
        together.wait(PATIENCE_S)
        if hasattr(os, "sched_setaffinity"):
            os.sched_setaffinity(threading.get_native_id(), processors[number])

    return work


@pytest.fixture(scope="module")
def threads_apart() -> Iterator[None]:
    """Keep the threads of `in_bands` on a processor each: beside other work the scheduler may put them on one, at half the speed."""
    count = os.cpu_count() or 1
    everywhere = {*range(count)}
    in_bands(keep_apart([{number} for number in range(count)]), count, count)
    yield
    in_bands(keep_apart([everywhere] * count), count, count)


def copies_of(source: np.ndarray) -> Copies:
    """Return copies of an array by two threads, each on a processor of its own, into several targets that were written to before.

    The shortest times of them are within a few percent of each other; their median is the unit of the figures.
    """
    pool = ThreadPoolExecutor(2)
    list(pool.map(keep_apart([{0}, {(os.cpu_count() or 1) - 1}]), range(2)))
    flat = source.reshape(-1)
    halves = [slice(0, flat.size // 2), slice(flat.size // 2, flat.size)]

    def into(target: np.ndarray) -> Callable[[], object]:
        return lambda: list(pool.map(lambda half: np.copyto(target[half], flat[half]), halves))

    return [into(np.ones_like(flat)) for _ in range(TARGETS)]
