"""Compiled loops that add the images of one exposure to the sums of the pixels that take it."""
# The innermost loops become SIMD code only when they are plain loops over one index.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.options import INLINE


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
