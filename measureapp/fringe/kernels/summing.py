"""Compiled loops that decide which exposures pixels take, and sum these, chunk by chunk.

Sums live in a stretch that stays in cache when all exposures are at hand, or in arrays of the whole image while exposures arrive
one by one; the same code works on both, so that both give the same. The readable statement stands in `phase_shift.py` and the tests.
Kernels release the interpreter, so that bands run on threads. Inner functions are forced inline: a call would count the references
of every array.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.simd.elements import any_lane, broadcast, convert, maximum, minimum, reduce_max, reduce_min, select
from measureapp.compiled.simd.memory import load, store
from measureapp.fringe.kernels.adding import ADDED, Share, add_taken, four_rows
from measureapp.fringe.kernels.records import CHUNK, COMPLETE, DIFFER

WHOLE_NUMBERS = 2  # bytes of sums that hold them exactly, so that what was added can be taken away again


@njit(**INLINE)
def clear(sums: Any, off: int) -> None:
    """Set the sums of a chunk to nothing."""
    sums.sine[:, off : off + CHUNK] = 0
    sums.cosine[:, off : off + CHUNK] = 0
    sums.total[:, off : off + CHUNK] = 0
    sums.planes[:, off : off + CHUNK] = 0


@njit(**INLINE)
def extremes(images: Any, layout: Any, at: int, scratch: Any) -> Any:
    """Find the brightest image of the groups that decide together and the darkest of all, per pixel; returns those of the chunk."""
    apart, low = scratch.high.shape[0] > 1, scratch.low
    top = broadcast(images[layout.first_image[0], at], ADDED)
    bottom = top
    for g in range(layout.steps.shape[0]):
        begin, last = layout.first_image[g], layout.first_image[g] + layout.steps[g] - 1
        high = scratch.high[g if apart else 0]
        for p in range(begin, last + 1, 4):
            a, b, c, d = four_rows(images, p, last, at)
            first = p == begin and g == 0
            first_of_group = p == begin and (apart or g == 0)
            for j in range(0, CHUNK, ADDED):
                w, x, y, z = load(a, j, ADDED), load(b, j, ADDED), load(c, j, ADDED), load(d, j, ADDED)
                bright, dark = maximum(maximum(w, x), maximum(y, z)), minimum(minimum(w, x), minimum(y, z))
                top, bottom = maximum(top, bright), minimum(bottom, dark)
                store(bright if first_of_group else maximum(bright, load(high, j, ADDED)), high, j)
                store(dark if first else minimum(dark, load(low, j, ADDED)), low, j)
    return reduce_max(top), reduce_min(bottom)


@njit(**INLINE)
def count_good(n: int, limit: Any, scratch: Any) -> Any:
    """Count those of ``n`` pixels that are above zero and unsaturated, from their `extremes`."""
    low, good = scratch.low, scratch.take
    for j in range(0, CHUNK, ADDED):
        peak = load(scratch.high[0], j, ADDED)
        for m in range(1, scratch.high.shape[0]):
            peak = maximum(peak, load(scratch.high[m], j, ADDED))
        store(convert((peak <= limit) & (load(low, j, ADDED) > 0), np.uint8), good, j)
    count = np.uint16(0)
    for j in range(n):
        count = np.uint16(count + good[j])
    return np.int64(count)


@njit(**INLINE)
def choose(exposure: int, near: Any, rule: Any, m: int, scratch: Any, sums: Any, off: int) -> Any:
    """Write how often each pixel of a chunk takes an exposure, from their `extremes`; returns the least and the most of it."""
    here, weight, bit = slice(off, off + CHUNK), rule.weights[exposure], np.uint16(1 << exposure)
    high, low, take = scratch.high[m], scratch.low, scratch.take
    taken, zero, bloomed = sums.taken[m, here], sums.zero[here], sums.bloomed[here]
    guarded = near.shape[0] > 0
    some = broadcast(rule.limit, ADDED) < rule.limit
    others = some
    for j in range(0, CHUNK, ADDED):
        before = load(taken, j, ADDED)
        takes = load(high, j, ADDED) <= rule.limit
        if rule.first_only:
            takes = takes & (before == 0)
        if guarded:
            beside = load(near, j, ADDED) != 0
            store(select(takes & beside, np.uint8(1), load(bloomed, j, ADDED)), bloomed, j)
            takes = takes & ~beside
        unlit = takes & (before == 0) & (load(low, j, ADDED) == 0)
        store(select(unlit, np.uint8(1), load(zero, j, ADDED)), zero, j)
        store(select(takes, before | bit, before), taken, j)
        store(convert(takes, np.uint8) * weight, take, j)
        some, others = some | takes, others | ~takes
    nothing = np.uint8(0)
    return nothing if any_lane(others) else weight, weight if any_lane(some) else nothing


@njit(**INLINE)
def needs_no_more(rule: Any, alike: Any) -> bool:
    """Tell whether one exposure is enough and every pixel of a chunk has it."""
    return rule.first_only and (alike > 0 or alike == COMPLETE)


@njit(**INLINE)
def all_took_one(sums: Any, off: int) -> bool:
    """Tell whether every pixel of a chunk took an exposure, for every decision."""
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + CHUNK]
        none = load(taken, 0, ADDED) == 0
        for j in range(ADDED, CHUNK, ADDED):
            none = none | (load(taken, j, ADDED) == 0)
        if any_lane(none):
            return False
    return True


@njit(**INLINE)
def note_apart(alike: Any, sums: Any, off: int) -> None:
    """Note with every pixel of a chunk the exposures that all of them took."""
    sums.taken[:, off : off + CHUNK] = np.uint16(alike)
    sums.zero[off : off + CHUNK] = 0
    sums.bloomed[off : off + CHUNK] = 0


@njit(**INLINE)
def note_taken(exposure: int, alike: Any, sums: Any, off: int) -> None:
    """Note that all pixels of a chunk take an exposure."""
    bit = 1 << exposure
    if alike >= 0:
        sums.alike[off // CHUNK] = alike | bit
        return
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + CHUNK]
        for j in range(0, CHUNK, ADDED):
            store(load(taken, j, ADDED) | np.uint16(bit), taken, j)


@njit(**INLINE)
def add_to_all(images: Any, layout: Any, rule: Any, at: int, exposure: int, scratch: Any, sums: Any, off: int) -> Any:
    """Add an exposure to the sums of all pixels of a chunk; returns the brightest and the darkest grey level of its sinusoids."""
    share = Share(np.int64(rule.weights[exposure]), scratch.take, True, exposure == 0)
    top, bottom = add_taken(images, layout, rule, 0, at, share, sums, off)
    for m in range(1, sums.total.shape[0]):
        high, low = add_taken(images, layout, rule, m, at, share, sums, off)
        top, bottom = max(top, high), min(bottom, low)
    return top, bottom


@njit(**INLINE)
def add_apart(
    images: Any,
    at: int,
    exposure: int,
    near: Any,
    layout: Any,
    rule: Any,
    added: Any,  # uint8, how often the sums hold it already
    together: bool,  # whether all pixels take it
    alike: Any,
    scratch: Any,
    sums: Any,
    off: int,
) -> None:
    """Add one exposure to the sums of those pixels of a chunk that take it, from their `extremes`."""
    weight, taking, guarded = rule.weights[exposure], False, near.shape[0] > 0
    if exposure == 0 and added == 0:
        clear(sums, off)
    if together:
        scratch.take[:] = weight
    elif alike >= 0:
        note_apart(alike, sums, off)
    for m in range(sums.total.shape[0]):
        least, most = weight, weight
        if not together:
            least, most = choose(exposure, near, rule, m, scratch, sums, off)
        if least != added or most != added:
            add_taken(images, layout, rule, m, at, Share(-np.int64(added), scratch.take, False, False), sums, off)
        taking |= most > 0
    if together:
        return
    if alike >= 0 and not (taking or guarded):
        sums.alike[off // CHUNK] = alike
    else:
        sums.alike[off // CHUNK] = COMPLETE if rule.first_only and all_took_one(sums, off) else DIFFER


@njit(**INLINE)
def add_exposure(
    images: Any,  # (P, pixels) of one exposure
    at: int,  # the first of CHUNK pixels
    exposure: int,
    near: Any,  # (CHUNK,) uint8, not 0: beside a saturated pixel; empty: no guard
    layout: Any,
    rule: Any,
    n: int,  # how many of the pixels count
    scratch: Any,
    sums: Any,
    off: int,
) -> Any:
    """Add one exposure of a chunk of pixels to their sums; returns how many are above zero and unsaturated.

    The first exposure begins the sums anew. One that all pixels take, and one that none takes, needs no decision pixel by pixel. Sums of
    whole numbers gain it before it is known whether all take it, and what pixels do not take is taken away again.
    """
    alike, weight = np.int64(0) if exposure == 0 else sums.alike[off // CHUNK], rule.weights[exposure]
    done, guarded = needs_no_more(rule, alike), near.shape[0] > 0
    hoped = not (done or guarded) and (alike >= 0 or not rule.first_only)
    added = hoped and sums.sine.itemsize == WHOLE_NUMBERS
    if added:
        top, bottom = add_to_all(images, layout, rule, at, exposure, scratch, sums, off)
    else:
        top, bottom = extremes(images, layout, at, scratch)
    clean, together = bool(top <= rule.limit and bottom > 0), bool(hoped and top <= rule.limit and (alike > 0 or bottom > 0))
    if added and not clean:
        extremes(images, layout, at, scratch)
    if not (done or (added and together)):
        add_apart(images, at, exposure, near, layout, rule, weight if added else np.uint8(0), together, alike, scratch, sums, off)
    if together:
        note_taken(exposure, alike, sums, off)
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
