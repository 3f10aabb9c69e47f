"""Weighted sums of the images over the exposures that each pixel uses.

Written with SIMD vectors: with plain loops decoding as a whole takes 1.4 times as long. The NumPy statement is `reference.accumulate`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE
from measureapp.compiled.simd.elements import any_lane, broadcast, convert, maximum, minimum, popcount, select
from measureapp.compiled.simd.memory import load, store
from measureapp.fringe.kernels.structures import CHUNK

LANES = 32  # pixels in one vector: a register of whole numbers of 16 bits


@njit(**INLINE)
def accumulate_chunk(images: Any, at: int, exposure: int, blocked: Any, layout: Any, rule: Any, sums: Any, place: int, work: Any) -> int:
    """Add one exposure of a chunk of pixels to the sums of those that use it; returns how many are above zero and unsaturated.

    Parameters
    ----------
    images : (P, N) of one exposure
    at : the first pixel of the chunk in the images
    blocked : (CHUNK,) uint8, not 0: beside a saturated pixel; empty: no guard against blooming
    place : the first pixel of the chunk in the sums; exposure 0 begins them anew
    """
    chunk, decisions = slice(place, place + CHUNK), sums.used.shape[0]
    if exposure == 0:
        clear(sums, chunk)
    find_extremes(images, layout, at, work)
    valid, is_used, complete = choose_pixels(exposure, blocked, rule, work, sums, place)
    sums.complete[place // CHUNK] = complete
    if not is_used:
        return valid
    for g in range(layout.steps.shape[0]):
        d = 0 if decisions == 1 else g
        has_total = decisions > 1 or g == rule.finest
        add_sinusoids(images, layout, g, at, work.weight[d], sums.sine[g, chunk], sums.cosine[g, chunk], sums.total[d, chunk], has_total)
    for b in range(layout.planes.shape[0]):
        add_image(images[layout.planes[b]], at, work.weight[0 if decisions == 1 else rule.finest], sums.planes[b, chunk])
    return valid


@njit(**INLINE)
def clear(sums: Any, chunk: Any) -> None:
    """Set the sums of a chunk to zero."""
    sums.sine[:, chunk] = 0
    sums.cosine[:, chunk] = 0
    sums.total[:, chunk] = 0
    sums.planes[:, chunk] = 0
    sums.used[:, chunk] = 0
    sums.has_zero[chunk] = 0
    sums.bloomed[chunk] = 0


@njit(**INLINE)
def find_extremes(images: Any, layout: Any, at: int, work: Any) -> None:
    """Find the brightest image of the groups that each decision covers, and the darkest of all, per pixel."""
    for g in range(layout.steps.shape[0]):
        first, last, d = layout.first_image[g], layout.first_image[g] + layout.steps[g] - 1, min(g, work.brightest.shape[0] - 1)
        brightest, darkest = work.brightest[d], work.darkest
        for p in range(first, last + 1, 4):  # four images at a time; the last one again where there are fewer
            rows = images[p], images[min(p + 1, last)], images[min(p + 2, last)], images[min(p + 3, last)]
            begins_group, begins_all = d == g and p == first, g == 0 and p == first
            for j in range(0, CHUNK, LANES):
                w, x, y, z = (
                    load(rows[0], at + j, LANES),
                    load(rows[1], at + j, LANES),
                    load(rows[2], at + j, LANES),
                    load(rows[3], at + j, LANES),
                )
                high, low = maximum(maximum(w, x), maximum(y, z)), minimum(minimum(w, x), minimum(y, z))
                store(high if begins_group else maximum(high, load(brightest, j, LANES)), brightest, j)
                store(low if begins_all else minimum(low, load(darkest, j, LANES)), darkest, j)


@njit(**INLINE)
def choose_pixels(exposure: int, blocked: Any, rule: Any, work: Any, sums: Any, place: int) -> Any:
    """Find the pixels that use an exposure, and write its weight.

    Returns
    -------
    how many pixels are above zero and unsaturated; whether any pixel uses the exposure; whether all pixels use one by now
    """
    valid, guarded, bit = 0, blocked.shape[0] > 0, np.uint16(1 << exposure)
    some = broadcast(rule.limit, LANES) < rule.limit
    unserved = some
    for j in range(0, CHUNK, LANES):
        here, is_zero = place + j, load(work.darkest, j, LANES) == 0
        above_zero = ~is_zero
        for d in range(sums.used.shape[0]):
            before, uses = load(sums.used[d], here, LANES), load(work.brightest[d], j, LANES) <= rule.limit
            above_zero = above_zero & uses
            if rule.first_only:
                uses = uses & (before == 0)
            if guarded:
                near = load(blocked, j, LANES) != 0
                store(select(uses & near, np.uint8(1), load(sums.bloomed, here, LANES)), sums.bloomed, here)
                uses = uses & ~near
            has_zero = uses & is_zero & (before == 0)
            store(select(has_zero, np.uint8(1), load(sums.has_zero, here, LANES)), sums.has_zero, here)
            used = select(uses, before | bit, before)
            store(used, sums.used[d], here)
            store(convert(uses, np.uint8) * rule.weights[exposure], work.weight[d], j)
            some, unserved = some | uses, unserved | (used == 0)
        valid += popcount(above_zero)
    return valid, any_lane(some), not any_lane(unserved)


@njit(**INLINE)
def add_sinusoids(images: Any, layout: Any, g: int, at: int, weight: Any, sine: Any, cosine: Any, total: Any, has_total: bool) -> None:
    """Add the images of a group to the sums of its sine and cosine, and to the total if it has one."""
    kind, p = sine.dtype, layout.first_image[g]
    if layout.steps[g] == 4:  # the weights of the steps are 0 and ±1: exact in whole numbers
        rows = images[p], images[p + 1], images[p + 2], images[p + 3]
        for j in range(0, CHUNK, LANES):
            first, second = convert(load(rows[0], at + j, LANES), kind), convert(load(rows[1], at + j, LANES), kind)
            third, fourth = convert(load(rows[2], at + j, LANES), kind), convert(load(rows[3], at + j, LANES), kind)
            times = convert(load(weight, j, LANES), kind)
            store(load(sine, j, LANES) + times * (second - fourth), sine, j)
            store(load(cosine, j, LANES) + times * (first - third), cosine, j)
            if has_total:
                store(load(total, j, LANES) + times * ((first + second) + (third + fourth)), total, j)
        return
    for q in range(p, p + layout.steps[g]):
        row = images[q]
        for j in range(0, CHUNK, LANES):
            grey = convert(load(weight, j, LANES), kind) * convert(load(row, at + j, LANES), kind)
            store(load(sine, j, LANES) + grey * layout.sines[q], sine, j)
            store(load(cosine, j, LANES) + grey * layout.cosines[q], cosine, j)
        if has_total:
            add_image(row, at, weight, total)


@njit(**INLINE)
def add_image(image: Any, at: int, weight: Any, total: Any) -> None:
    """Add an image to a sum."""
    for j in range(0, CHUNK, LANES):
        grey = convert(load(weight, j, LANES), total.dtype) * convert(load(image, at + j, LANES), total.dtype)
        store(load(total, j, LANES) + grey, total, j)
