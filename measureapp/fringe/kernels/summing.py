"""Compiled loops that sum the images of one pixel over the exposures it takes, chunk by chunk.

Sums live in a chunk that stays in cache when all exposures are at hand, or in arrays of the whole image while exposures arrive
one by one; the same code works on both, so that both give the same. The readable statement stands in `phase_shift.py` and the tests.
Kernels release the interpreter, so that bands run on threads. Inner functions are forced inline: a call would count the references
of every array.
"""
# The innermost loops become SIMD code only when they are plain loops over one index.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.options import INLINE, LOOP
from measureapp.fringe.kernels.records import CHUNK, COMPLETE, DIFFER, LOOKED_AT


@njit(**INLINE)
def clear(sums: Any, off: int, n: int) -> None:
    """Set the sums of ``n`` pixels to nothing."""
    sums.sine[:, off : off + n] = 0
    sums.cosine[:, off : off + n] = 0
    sums.total[:, off : off + n] = 0
    sums.planes[:, off : off + n] = 0


@njit(**INLINE)
def bounds(images: Any, layout: Any, begin: int, n: int) -> Any:
    """Return the brightest and the darkest grey level of all sinusoids of a chunk."""
    top = images[layout.first_image[0], begin]
    bottom = top
    for g in range(layout.steps.shape[0]):
        for p in range(layout.first_image[g], layout.first_image[g] + layout.steps[g]):
            row = images[p, begin : begin + n]
            high, low = row[0], row[0]
            for j in range(n):
                high = max(high, row[j])
                low = min(low, row[j])
            top, bottom = max(top, high), min(bottom, low)
    return top, bottom


@njit(**INLINE)
def extremes(images: Any, layout: Any, begin: int, n: int, scratch: Any) -> None:
    """Find the brightest image of the groups that decide together, the brightest and the darkest of all, per pixel."""
    low, peak = scratch.low, scratch.peak
    apart = scratch.high.shape[0] > 1
    for g in range(layout.steps.shape[0]):
        first = layout.first_image[g]
        row = images[first, begin : begin + n]
        high = scratch.high[g if apart else 0]
        if apart or g == 0:
            for j in range(n):
                high[j] = row[j]
        if g == 0:
            for j in range(n):
                low[j] = row[j]
        last = first + layout.steps[g] - 1
        for p in range(first, last + 1, 2):
            one, two = images[p, begin : begin + n], images[min(p + 1, last), begin : begin + n]
            for j in range(n):
                high[j] = max(high[j], one[j], two[j])
                low[j] = min(low[j], one[j], two[j])
    high = scratch.high[0]
    for j in range(n):
        peak[j] = high[j]
    for m in range(1, scratch.high.shape[0]):
        high = scratch.high[m]
        for j in range(n):
            peak[j] = max(peak[j], high[j])


@njit(**INLINE)
def begin_quad(a: Any, b: Any, c: Any, d: Any, n: int, sine: Any, cosine: Any, total: Any, counted: bool) -> None:
    """Begin the sums of a group of four images with one exposure of all pixels; ``total`` only where it is ``counted``."""
    kind = sine.dtype.type
    if counted:
        for j in range(n):
            sine[j] = kind(b[j]) - kind(d[j])
            cosine[j] = kind(a[j]) - kind(c[j])
            total[j] = (kind(a[j]) + kind(b[j])) + (kind(c[j]) + kind(d[j]))
    else:
        for j in range(n):
            sine[j] = kind(b[j]) - kind(d[j])
            cosine[j] = kind(a[j]) - kind(c[j])


@njit(**INLINE)
def add_quad(
    a: Any, b: Any, c: Any, d: Any, n: int, sine: Any, cosine: Any, total: Any, counted: bool, take: Any, everywhere: bool
) -> None:
    """Add a group of four images of one exposure, of all pixels once or as often as ``take`` says."""
    kind = sine.dtype.type
    if everywhere and counted:
        for j in range(n):
            sine[j] += kind(b[j]) - kind(d[j])
            cosine[j] += kind(a[j]) - kind(c[j])
            total[j] += (kind(a[j]) + kind(b[j])) + (kind(c[j]) + kind(d[j]))
    elif everywhere:
        for j in range(n):
            sine[j] += kind(b[j]) - kind(d[j])
            cosine[j] += kind(a[j]) - kind(c[j])
    else:
        for j in range(n):
            sine[j] += kind(take[j]) * (kind(b[j]) - kind(d[j]))
            cosine[j] += kind(take[j]) * (kind(a[j]) - kind(c[j]))
        if counted:
            for j in range(n):
                total[j] += kind(take[j]) * ((kind(a[j]) + kind(b[j])) + (kind(c[j]) + kind(d[j])))


@njit(**INLINE)
def add_weighted(images: Any, layout: Any, g: int, begin: int, n: int, sine: Any, cosine: Any, take: Any, everywhere: bool) -> None:
    """Add a group of any number of images of one exposure, of all pixels once or as often as ``take`` says."""
    kind = sine.dtype.type
    p = layout.first_image[g]
    for q in range(p, p + layout.steps[g]):
        row = images[q, begin : begin + n]
        weight_s = layout.sines[q]
        weight_c = layout.cosines[q]
        for j in range(n):
            value = np.float32(row[j]) if everywhere else np.float32(row[j]) * np.float32(take[j])
            sine[j] += kind(weight_s * value)
            cosine[j] += kind(weight_c * value)


@njit(**INLINE)
def add_images(images: Any, first: int, count: int, begin: int, n: int, total: Any, take: Any, everywhere: bool) -> None:
    """Add consecutive images to one sum, of all pixels once or as often as ``take`` says."""
    kind = total.dtype.type
    for q in range(first, first + count):
        row = images[q, begin : begin + n]
        if everywhere:
            for j in range(n):
                total[j] += kind(row[j])
        else:
            for j in range(n):
                total[j] += kind(row[j]) * kind(take[j])


@njit(**INLINE)
def add_taken(
    images: Any, layout: Any, rule: Any, m: int, begin: int, n: int, sums: Any, off: int, take: Any, everywhere: bool, fresh: bool
) -> None:
    """Add all that one decision about an exposure covers: every group, or group ``m`` where each decides for itself.

    Sums that are ``fresh`` hold nothing of use yet; only where pixels are taken ``everywhere``.
    """
    joint = sums.total.shape[0] == 1
    for g in range(layout.steps.shape[0]):
        if not joint and g != m:
            continue
        counted = not joint or g == rule.finest
        sine, cosine, total = sums.sine[g, off : off + n], sums.cosine[g, off : off + n], sums.total[m, off : off + n]
        p = layout.first_image[g]
        if layout.steps[g] == 4:
            a, b = images[p, begin : begin + n], images[p + 1, begin : begin + n]
            c, d = images[p + 2, begin : begin + n], images[p + 3, begin : begin + n]
            if fresh:
                begin_quad(a, b, c, d, n, sine, cosine, total, counted)
            else:
                add_quad(a, b, c, d, n, sine, cosine, total, counted, take, everywhere)
            continue
        if fresh:
            sine[:] = 0
            cosine[:] = 0
        add_weighted(images, layout, g, begin, n, sine, cosine, take, everywhere)
        if counted:
            if fresh:
                total[:] = 0
            add_images(images, p, layout.steps[g], begin, n, total, take, everywhere)
    if joint or m == rule.finest:
        for b in range(layout.planes.shape[0]):
            plane = sums.planes[b, off : off + n]
            if fresh:
                plane[:] = 0
            add_images(images, layout.planes[b], 1, begin, n, plane, take, everywhere)


@njit(**INLINE)
def take_some(
    images: Any, exposure: int, blocked: Any, layout: Any, rule: Any, m: int, begin: int, n: int, scratch: Any, sums: Any, off: int
) -> None:
    """Add one exposure where pixels decide differently."""
    take, low, high = scratch.take, scratch.low, scratch.high[m]
    taken = sums.taken[m, off : off + n]
    zero = sums.zero[off : off + n]
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
    for j in range(n):
        zero[j] |= take[j] & np.uint8(taken[j] == 0) & np.uint8(low[j] == 0)
    bit = np.uint16(1 << exposure)
    for j in range(n):
        taken[j] |= bit * np.uint16(take[j])
    weight = rule.weights[exposure]
    for j in range(n):
        take[j] *= weight
    add_taken(images, layout, rule, m, begin, n, sums, off, take, False, False)


@njit(**INLINE)
def take_all(images: Any, exposure: int, layout: Any, rule: Any, begin: int, n: int, scratch: Any, sums: Any, off: int) -> None:
    """Add one exposure that all pixels can take where they took different ones before."""
    bit = np.uint16(1 << exposure)
    weight = rule.weights[exposure]
    for j in range(n):
        scratch.take[j] = weight
    for m in range(sums.total.shape[0]):
        add_taken(images, layout, rule, m, begin, n, sums, off, scratch.take, weight == 1, False)
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            taken[j] |= bit


@njit(**INLINE)
def take_together(images: Any, exposure: int, layout: Any, rule: Any, begin: int, n: int, scratch: Any, sums: Any, off: int) -> None:
    """Add one exposure that all pixels can take and that took the same ones before; the first one begins the sums."""
    weight = rule.weights[exposure]
    if weight > 1:
        if exposure == 0:
            clear(sums, off, n)
        for j in range(n):
            scratch.take[j] = weight
    for m in range(sums.total.shape[0]):
        if exposure == 0 and weight == 1:
            add_taken(images, layout, rule, m, begin, n, sums, off, scratch.take, True, True)
        else:
            add_taken(images, layout, rule, m, begin, n, sums, off, scratch.take, weight == 1, False)


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
def accumulate(
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
    """Add one exposure of ``n`` pixels to their sums; returns how many of them are above zero and unsaturated in it."""
    chunk = off // CHUNK
    alike = sums.alike[chunk]
    done = needs_no_more(rule, alike)
    top, bottom = bounds(images, layout, begin, n)
    clean = top <= rule.limit
    together = clean and alike >= 0 and not done and blocked.shape[0] == 0 and (alike > 0 or bottom > 0)
    if together:
        take_together(images, exposure, layout, rule, begin, n, scratch, sums, off)
        sums.alike[chunk] = alike | (1 << exposure)
    elif exposure == 0:
        clear(sums, off, n)
    if clean and bottom > 0 and (together or done):
        return n
    if clean and bottom > 0 and alike < 0 and blocked.shape[0] == 0 and not rule.first_only:
        take_all(images, exposure, layout, rule, begin, n, scratch, sums, off)
        return n
    extremes(images, layout, begin, n, scratch)
    low, peak, limit = scratch.low, scratch.peak, rule.limit
    good = np.int32(0)
    for j in range(n):
        good += np.int32((peak[j] <= limit) & (low[j] > 0))
    if together or done:
        return good
    if alike >= 0:
        sums.taken[:, off : off + n] = np.uint16(alike)
        sums.zero[off : off + n] = 0
        sums.bloomed[off : off + n] = 0
    for m in range(sums.total.shape[0]):
        take_some(images, exposure, blocked, layout, rule, m, begin, n, scratch, sums, off)
    sums.alike[chunk] = COMPLETE if rule.first_only and all_took_one(n, sums, off) else DIFFER
    return good


@njit(**LOOP)
def add_exposures(
    images: Any,  # (E, P, N) consecutive exposures
    exposure: int,  # number of the first of them
    blocked: Any,
    layout: Any,
    rule: Any,
    scratch: Any,
    sums: Any,
    base: int,  # pixel that the sums begin with
    start: int,
    stop: int,
    seen: Any,  # (2, 2, all exposures) int64, gains the pixels looked at, and those above zero and unsaturated: due, and of the sample
) -> None:
    """Add exposures of pixels ``start … stop``, whole chunks, to their sums; the first exposure begins them anew.

    Where one exposure is enough, chunks whose pixels have it are not looked at any more, but for a sample that is counted.
    """
    for begin in range(start, stop, CHUNK):
        n, off = min(CHUNK, stop - begin), begin - base
        if exposure == 0:
            sums.alike[off // CHUNK] = 0
        for e in range(images.shape[0]):
            sampled = np.int64(needs_no_more(rule, sums.alike[off // CHUNK]))
            if sampled and (begin // CHUNK) % LOOKED_AT != 0:
                continue
            good = accumulate(images[e], exposure + e, blocked, layout, rule, begin, n, scratch, sums, off)
            seen[sampled, 0, exposure + e] += n
            seen[sampled, 1, exposure + e] += good


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
