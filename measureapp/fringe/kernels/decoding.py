"""The compiled loop over an image whose exposures are all at hand: every chunk is summed and solved while its sums are in cache."""

from __future__ import annotations

from typing import Any

from numba import njit

from measureapp.fringe.kernels.options import LOOP
from measureapp.fringe.kernels.records import CHUNK
from measureapp.fringe.kernels.solving import solve
from measureapp.fringe.kernels.summing import add_exposures


@njit(**LOOP)
def sum_and_solve(
    images: Any,  # (E, P, N)
    blocked: Any,  # empty: no guard against blooming
    layout: Any,
    rule: Any,
    model: Any,
    scratch: Any,
    sums: Any,  # of one chunk
    work: Any,
    start: int,
    stop: int,
    maps: Any,
    seen: Any,  # see `add_exposures`
    counts: Any,  # see `solve`
) -> None:
    """Turn the images of pixels ``start … stop``, whole chunks, into their maps."""
    exposures, count, pixels = images.shape
    surely_needed = 1 if rule.first_only else exposures
    coming = images[:surely_needed].reshape(surely_needed * count, pixels)
    for begin in range(start, stop, CHUNK):
        end = min(begin + CHUNK, stop)
        add_exposures(images, 0, blocked, layout, rule, scratch, sums, begin, begin, end, seen)
        solve(sums, begin, coming, layout, model, work, begin, end, maps, counts)
