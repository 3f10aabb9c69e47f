"""Compiled loops that add the images of one exposure to the sums of a chunk of pixels.

They look at the grey levels as well: looking takes as long as adding, and both together no longer, because images are waited for once.
"""

from __future__ import annotations

from typing import Any, NamedTuple

from numba import njit

from measureapp.compiled.options import INLINE
from measureapp.compiled.simd.elements import broadcast, convert, maximum, minimum, reduce_max, reduce_min
from measureapp.compiled.simd.memory import load, store
from measureapp.fringe.kernels.records import CHUNK

ADDED = 32  # pixels that are added together: a register of whole numbers of 16 bits


class Share(NamedTuple):
    """How often images are added."""

    often: Any  # int, every pixel
    take: Any  # (CHUNK,) uint8, each so many times more
    alike: Any  # bool, none of them more
    fresh: Any  # bool, the sums hold nothing of use yet


@njit(**INLINE)
def four_rows(images: Any, first: int, last: int, at: int) -> Any:
    """Return the pixels of four images from ``first`` on; where there are fewer up to ``last``, the last one again."""
    part = slice(at, at + CHUNK)
    return images[first, part], images[min(first + 1, last), part], images[min(first + 2, last), part], images[min(first + 3, last), part]


@njit(**INLINE)
def add_quad(images: Any, p: int, at: int, share: Share, counted: bool, sine: Any, cosine: Any, total: Any, top: Any, bottom: Any) -> Any:
    """Add a group of four images; returns the brightest and the darkest of ``top``, ``bottom`` and the images.

    ``total`` gains them only where they are ``counted``.
    """
    a, b, c, d = four_rows(images, p, p + 3, at)
    kind, often = sine.dtype, broadcast(sine.dtype.type(share.often), ADDED)
    for j in range(0, CHUNK, ADDED):
        w, x, y, z = load(a, j, ADDED), load(b, j, ADDED), load(c, j, ADDED), load(d, j, ADDED)
        top = maximum(top, maximum(maximum(w, x), maximum(y, z)))
        bottom = minimum(bottom, minimum(minimum(w, x), minimum(y, z)))
        times = often if share.alike else often + convert(load(share.take, j, ADDED), kind)
        first, second, third, fourth = convert(w, kind), convert(x, kind), convert(y, kind), convert(z, kind)
        across, along = times * (second - fourth), times * (first - third)
        store(across if share.fresh else load(sine, j, ADDED) + across, sine, j)
        store(along if share.fresh else load(cosine, j, ADDED) + along, cosine, j)
        if counted:
            light = times * ((first + second) + (third + fourth))
            store(light if share.fresh else load(total, j, ADDED) + light, total, j)
    return top, bottom


@njit(**INLINE)
def add_weighted(images: Any, layout: Any, g: int, at: int, share: Share, sine: Any, cosine: Any, top: Any, bottom: Any) -> Any:
    """Add a group of any number of images; otherwise like `add_quad`."""
    kind, often = sine.dtype, broadcast(sine.dtype.type(share.often), ADDED)
    p = layout.first_image[g]
    for q in range(p, p + layout.steps[g]):
        row = images[q, at : at + CHUNK]
        fresh = share.fresh and q == p
        for j in range(0, CHUNK, ADDED):
            seen = load(row, j, ADDED)
            top, bottom = maximum(top, seen), minimum(bottom, seen)
            times = often if share.alike else often + convert(load(share.take, j, ADDED), kind)
            light = times * convert(seen, kind)
            across, along = light * layout.sines[q], light * layout.cosines[q]
            store(across if fresh else load(sine, j, ADDED) + across, sine, j)
            store(along if fresh else load(cosine, j, ADDED) + along, cosine, j)
    return top, bottom


@njit(**INLINE)
def add_images(images: Any, first: int, count: int, at: int, share: Share, total: Any) -> None:
    """Add consecutive images to one sum."""
    kind, often = total.dtype, broadcast(total.dtype.type(share.often), ADDED)
    for q in range(first, first + count):
        row = images[q, at : at + CHUNK]
        fresh = share.fresh and q == first
        for j in range(0, CHUNK, ADDED):
            times = often if share.alike else often + convert(load(share.take, j, ADDED), kind)
            light = times * convert(load(row, j, ADDED), kind)
            store(light if fresh else load(total, j, ADDED) + light, total, j)


@njit(**INLINE)
def add_taken(images: Any, layout: Any, rule: Any, m: int, at: int, share: Share, sums: Any, off: int) -> Any:
    """Add all that one decision about an exposure covers: every group, or group ``m`` where each decides for itself.

    Returns the brightest and the darkest grey level of its sinusoids.
    """
    joint = sums.total.shape[0] == 1
    top = broadcast(images[layout.first_image[m], at], ADDED)
    bottom, here = top, slice(off, off + CHUNK)
    for g in range(layout.steps.shape[0]):
        if not joint and g != m:
            continue
        p = layout.first_image[g]
        counted = not joint or g == rule.finest
        sine, cosine, total = sums.sine[g, here], sums.cosine[g, here], sums.total[m, here]
        if layout.steps[g] == 4:
            top, bottom = add_quad(images, p, at, share, counted, sine, cosine, total, top, bottom)
            continue
        top, bottom = add_weighted(images, layout, g, at, share, sine, cosine, top, bottom)
        if counted:
            add_images(images, p, layout.steps[g], at, share, total)
    if joint or m == rule.finest:
        for b in range(layout.planes.shape[0]):
            add_images(images, layout.planes[b], 1, at, share, sums.planes[b, here])
    return reduce_max(top), reduce_min(bottom)
