"""The compiled loop over the pixels of an image: every stretch is summed, and solved while its sums are in cache.

A stretch is long, and read exposure by exposure, because the hardware prefetcher follows a limited number of streams: the images of one
exposure, but not those of all, with which memory is half as fast.

There is one such loop for all that is done with images and sums, for the machine code of each would take as long to make.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import LOOP
from measureapp.fringe.kernels.prefetching import prefetch_chunk
from measureapp.fringe.kernels.records import CHUNK, LOOKED_AT, PREFETCHED_EXPOSURES, STRETCH
from measureapp.fringe.kernels.solving import solve
from measureapp.fringe.kernels.summing import add_exposure, needs_no_more


@njit(**LOOP)
def sum_and_solve(
    images: Any,  # (E, P, N) consecutive exposures to add to the sums; may be none
    tails: Any,  # (E, P, CHUNK) their last chunk where it is not a whole one, filled up
    exposure: int,  # number of the first of them
    blocked: Any,  # (N and more,) uint8, whole chunks, not 0: beside a saturated pixel; empty: no guard
    layout: Any,
    rule: Any,
    model: Any,
    scratch: Any,
    sums: Any,
    base: int,  # pixel that the sums begin with; -1: they are of one stretch, and of no use after it is solved
    work: Any,
    start: int,
    stop: int,
    solves: bool,  # whether the sums are turned into maps
    maps: Any,
    seen: Any,  # (2, 2, all exposures) int64, gains the pixels looked at, and those above zero and unsaturated: due, and of the sample
    counts: Any,  # see `solve`
) -> None:
    """Add exposures of pixels ``start … stop`` to their sums, and turn these into their maps.

    Sums and maps hold whole chunks of CHUNK pixels; only the last one of the image may have fewer that count. Where one exposure is
    enough, chunks whose pixels have it are not looked at any more, but for a sample that is counted.
    """
    soon = images[:1] if rule.first_only else images[:PREFETCHED_EXPOSURES]
    for first in range(start, stop, STRETCH):
        last, place = min(first + STRETCH, stop), first - base if base >= 0 else 0
        for e in range(images.shape[0]):
            for begin in range(first, last, CHUNK):
                n, off = min(CHUNK, last - begin), place + begin - first
                sampled = np.int64(exposure + e > 0 and needs_no_more(rule, sums.alike[off // CHUNK]))
                if sampled and (begin // CHUNK) % LOOKED_AT != 0:
                    continue
                whole = n == CHUNK
                shown, at = (images[e] if whole else tails[e]), (begin if whole else 0)
                near = blocked[begin : begin + CHUNK]
                good = add_exposure(shown, at, exposure + e, near, layout, rule, n, scratch, sums, off)
                if rule.first_only and e + 1 < images.shape[0] and not needs_no_more(rule, sums.alike[off // CHUNK]):
                    prefetch_chunk(images[e + 1], layout, begin)
                seen[sampled, 0, exposure + e] += n
                seen[sampled, 1, exposure + e] += good
        if solves:
            for begin in range(first, last, CHUNK):
                ahead = begin + STRETCH if begin + STRETCH + CHUNK <= stop else -1
                solve(sums, place + begin - first, soon, ahead, layout, model, work, begin, min(CHUNK, last - begin), maps, counts)
