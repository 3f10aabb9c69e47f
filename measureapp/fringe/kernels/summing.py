"""Compiled loops that decide which exposures pixels take, and sum these, chunk by chunk.

Sums live in a stretch that stays in cache when all exposures are at hand, or in arrays of the whole image while exposures arrive
one by one; the same code works on both, so that both give the same. The readable statement stands in `phase_shift.py` and the tests.
Kernels release the interpreter, so that bands run on threads. Inner functions are forced inline: a call would count the references
of every array.
"""
# The innermost loops become SIMD code only when they are plain loops over one index.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.adding import add_taken
from measureapp.fringe.kernels.options import INLINE, LOOP
from measureapp.fringe.kernels.records import CHUNK, COMPLETE, DIFFER


@njit(**INLINE)
def clear(sums: Any, off: int, n: int) -> None:
    """Set the sums of ``n`` pixels to nothing."""
    sums.sine[:, off : off + n] = 0
    sums.cosine[:, off : off + n] = 0
    sums.total[:, off : off + n] = 0
    sums.planes[:, off : off + n] = 0


@njit(**INLINE)
def four_rows(images: Any, first: int, last: int, begin: int, n: int) -> Any:
    """Return ``n`` pixels of four images from ``first`` on; where there are fewer up to ``last``, the last one again."""
    part = slice(begin, begin + n)
    return images[first, part], images[min(first + 1, last), part], images[min(first + 2, last), part], images[min(first + 3, last), part]


@njit(**INLINE)
def bounds(images: Any, layout: Any, begin: int, n: int) -> Any:
    """Return the brightest and the darkest grey level of all sinusoids of a chunk."""
    top = images[layout.first_image[0], begin]
    bottom = top
    for g in range(layout.steps.shape[0]):
        last = layout.first_image[g] + layout.steps[g] - 1
        for p in range(layout.first_image[g], last + 1, 4):
            a, b, c, d = four_rows(images, p, last, begin, n)
            high, low = a[0], a[0]
            for j in range(n):
                high = max(high, max(max(a[j], b[j]), max(c[j], d[j])))  # noqa: PLW3301
                low = min(low, min(min(a[j], b[j]), min(c[j], d[j])))  # noqa: PLW3301
            top, bottom = max(top, high), min(bottom, low)
    return top, bottom


@njit(**INLINE)
def extremes(images: Any, layout: Any, begin: int, n: int, scratch: Any) -> None:
    """Find the brightest image of the groups that decide together and the darkest of all, per pixel."""
    low, apart = scratch.low, scratch.high.shape[0] > 1
    for g in range(layout.steps.shape[0]):
        first, last = layout.first_image[g], layout.first_image[g] + layout.steps[g] - 1
        row = images[first, begin : begin + n]
        high = scratch.high[g if apart else 0]
        if apart or g == 0:
            for j in range(n):
                high[j] = row[j]
        if g == 0:
            for j in range(n):
                low[j] = row[j]
        for p in range(first, last + 1, 4):
            a, b, c, d = four_rows(images, p, last, begin, n)
            for j in range(n):
                high[j] = max(high[j], max(max(a[j], b[j]), max(c[j], d[j])))  # noqa: PLW3301
                low[j] = min(low[j], min(min(a[j], b[j]), min(c[j], d[j])))  # noqa: PLW3301


@njit(**INLINE)
def count_good(n: int, limit: Any, scratch: Any) -> Any:
    """Count the pixels that are above zero and unsaturated, from their `extremes`."""
    low, high = scratch.low, scratch.high[0]
    if scratch.high.shape[0] > 1:
        peak = scratch.peak
        for j in range(n):
            peak[j] = high[j]
        for m in range(1, scratch.high.shape[0]):
            other = scratch.high[m]
            for j in range(n):
                peak[j] = max(peak[j], other[j])
        high = peak
    good = np.uint16(0)
    for j in range(n):
        good = np.uint16(good + np.uint16((high[j] <= limit) & (low[j] > 0)))
    return np.int64(good)


@njit(**INLINE)
def range_of(values: Any, n: int) -> Any:
    """Return the least and the greatest of ``n`` values."""
    least, greatest = values[0], values[0]
    for j in range(n):
        least, greatest = min(least, values[j]), max(greatest, values[j])
    return least, greatest


@njit(**INLINE)
def choose(exposure: int, blocked: Any, rule: Any, m: int, begin: int, n: int, scratch: Any, sums: Any, off: int) -> Any:
    """Write how often each of ``n`` pixels takes an exposure, from their `extremes`; returns the least and the most of it."""
    take, low, high = scratch.take, scratch.low, scratch.high[m]
    taken = sums.taken[m, off : off + n]
    limit = rule.limit
    for j in range(n):
        take[j] = np.uint8(high[j] <= limit)
    if rule.first_only:
        for j in range(n):
            take[j] &= np.uint8(taken[j] == 0)
    if blocked.shape[0] > 0:
        near = blocked[begin : begin + n]
        bloomed = sums.bloomed[off : off + n]
        for j in range(n):
            bloomed[j] |= take[j] & np.uint8(near[j] != 0)
            take[j] &= np.uint8(near[j] == 0)
    least, most = range_of(take, n)
    if most == 0:
        return least, most
    if range_of(low, n)[0] == 0:
        zero = sums.zero[off : off + n]
        for j in range(n):
            zero[j] |= take[j] & np.uint8(taken[j] == 0) & np.uint8(low[j] == 0)
    bit = np.uint16(1 << exposure)
    for j in range(n):
        taken[j] |= bit * np.uint16(take[j])
    weight = rule.weights[exposure]
    for j in range(n):
        take[j] *= weight
    return np.uint8(least * weight), np.uint8(most * weight)


@njit(**INLINE)
def needs_no_more(rule: Any, alike: Any) -> bool:
    """Tell whether one exposure is enough and every pixel of a chunk has it."""
    return rule.first_only and (alike > 0 or alike == COMPLETE)


@njit(**INLINE)
def all_took_one(n: int, sums: Any, off: int) -> bool:
    """Tell whether every pixel of a chunk took an exposure, for every decision."""
    took = np.uint16(1)
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            took &= np.uint16(taken[j] != 0)
    return took != 0


@njit(**INLINE)
def begin_chunk(exposure: int, weight: Any, together: bool, alike: Any, n: int, scratch: Any, sums: Any, off: int) -> None:
    """Prepare the sums of a chunk for one more exposure, which all its pixels take ``together`` or not."""
    if exposure == 0 and not (together and weight == 1):
        clear(sums, off, n)
    if together:
        for j in range(n):
            scratch.take[j] = weight
    elif alike >= 0:
        sums.taken[:, off : off + n] = np.uint16(alike)
        sums.zero[off : off + n] = 0
        sums.bloomed[off : off + n] = 0


@njit(**INLINE)
def all_take(exposure: int, alike: Any, n: int, sums: Any, off: int) -> None:
    """Note that all pixels of a chunk take an exposure."""
    bit = 1 << exposure
    if alike >= 0:
        sums.alike[off // CHUNK] = alike | bit
        return
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            taken[j] |= np.uint16(bit)


@njit(**INLINE)
def add_exposure(
    images: Any,  # (P, N) of one exposure
    exposure: int,
    blocked: Any,  # (N,) uint8, not 0: beside a saturated pixel; empty: no guard
    layout: Any,
    rule: Any,
    begin: int,
    n: int,
    scratch: Any,
    sums: Any,
    off: int,
) -> Any:
    """Add one exposure of a chunk of ``n`` pixels to their sums; returns how many are above zero and unsaturated.

    The first exposure begins the sums anew. One that all pixels take, and one that none takes, needs no decision pixel by pixel.
    """
    alike, weight, guarded = np.int64(0) if exposure == 0 else sums.alike[off // CHUNK], rule.weights[exposure], blocked.shape[0] > 0
    done = needs_no_more(rule, alike)
    top, bottom = bounds(images, layout, begin, n)
    clean = bool(top <= rule.limit and bottom > 0)
    if clean and done:
        return n
    due = alike > 0 or (bottom > 0 and (alike == 0 or not rule.first_only))
    together = bool(top <= rule.limit and due and not (done or guarded))
    if not done:
        begin_chunk(exposure, weight, together, alike, n, scratch, sums, off)
    if not (together and clean):
        extremes(images, layout, begin, n, scratch)
    taking = False
    for m in range(0 if done else sums.total.shape[0]):
        least, most = weight, weight
        if not together:
            least, most = choose(exposure, blocked, rule, m, begin, n, scratch, sums, off)
        if most > 0:
            fresh = together and exposure == 0 and weight == 1
            add_taken(images, layout, rule, m, begin, n, sums, off, scratch.take, least == 1 and most == 1, fresh)
            taking = True
    if together:
        all_take(exposure, alike, n, sums, off)
    elif alike >= 0 and not (taking or done or guarded):
        sums.alike[off // CHUNK] = alike
    elif not done:
        sums.alike[off // CHUNK] = COMPLETE if rule.first_only and all_took_one(n, sums, off) else DIFFER
    return n if clean else count_good(n, rule.limit, scratch)


@njit(**LOOP)
def mark_saturated(images: Any, layout: Any, limit: Any, start: int, stop: int, saturated: Any) -> None:
    """Mark pixels ``start … stop`` of one exposure (P, N) of which a sinusoid is above ``limit``."""
    for begin in range(start, stop, CHUNK):
        n = min(CHUNK, stop - begin)
        out = saturated[begin : begin + n]
        for j in range(n):
            out[j] = 0
        for g in range(layout.steps.shape[0]):
            for p in range(layout.first_image[g], layout.first_image[g] + layout.steps[g]):
                row = images[p, begin : begin + n]
                for j in range(n):
                    out[j] |= np.uint8(row[j] > limit)
