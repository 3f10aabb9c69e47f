"""Compiled loop that finds the pixels of one camera in another: same epipolar line, same phase.

``lines`` (H, W, 2) are the rectified coordinates (x, y) of every pixel of a pair; equal y is the same epipolar line; ``pixels``
(H, W, 4) are the records of `kernels.slopes`. The loop works on chunks of pixels in lanes of scratch arrays: ``s`` for numbers of the
pixel that is matched and of what it is matched with, ``at`` for indices. All places of a chunk are known before anything is fetched from
them, so that the processor waits for many at once.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.reconstruct.kernels.constants import PIXELS
from measureapp.reconstruct.kernels.lanes import (
    CHUNK,
    PLACES,
    ROWS_AHEAD,
    SCRATCH,
    ZERO,
    Found,
    count_wanted,
    forget,
    keep_unsettled,
    mark_unsettled,
    prefetch_pixels,
    some_of,
    take_all,
    take_wanted,
    write_group,
    write_listed,
)
from measureapp.reconstruct.kernels.scratch import stack_float32, stack_int32
from measureapp.reconstruct.kernels.seen import MATCHED, WITHOUT_PARTNER
from measureapp.reconstruct.kernels.steps import aim, fetch, jump, look_up, newton

ITERATIONS = 6
EDGE = np.float32(1.001)


@njit(**INLINE)
def settle(s: Any, at: Any, n: int, mostly: bool, partner: Any, limits: Any, out: Found) -> None:
    """Take steps with n pixels until all have settled; ``mostly`` says that they lie side by side in their row, and begins the next."""
    shape, images, cubics, to_unit, numbers = partner[2], partner[3:7], partner[7], partner[8], partner[13]
    width = np.int32(shape[1])
    for step in range(ITERATIONS):
        first, last = step == 0, step == ITERATIONS - 1
        aim(s, at, n, width, cubics, to_unit)
        fetch(s, at, n, width, images)
        for i in range(0, n, PIXELS):
            made = newton(s, i, limits, numbers, last, mostly & first)
            if mostly & first & (i + PIXELS <= n):
                write_group(at, i, made.depth, made.gain, made.variance, made.code, out)
            else:
                write_listed(s, at, i, n, made.depth, made.gain, made.variance, made.code, out)
            mark_unsettled(s, at, i, made.unsettled, made.next_u, made.next_v)
        n = keep_unsettled(s, at, n)
        if n == 0:
            break


@njit(**INLINE)
def count_matched(reason: Any) -> Any:
    """Count the matched pixels of a row."""
    found = np.int32(0)
    for x in range(len(reason)):
        found += reason[x] == MATCHED
    return found


@njit(**LOOP)
def match(
    rays: Any,  # (H, 2 W) float32, normalised image coordinates of the camera
    phase: Any,
    skip: Any,  # (H, W) uint8, 0 for pixels to match
    partner: Any,  # what is needed of the other camera:
    #     (H, 2 W) float32, where the pixels of the camera that is matched lie in the rectified image
    #     (3,) float32, third row of the turn to it: the rectified depth of a ray
    #     (H, W) of the other camera's image, and flat: its phases, quads, records of pixels and rectified coordinates
    #     four cubic polynomials: ∂x/∂u, ∂x/∂v, ∂y/∂u, ∂y/∂v of the latter
    #     (u0, per u, v0, per v): their variables are (u − u0) · per u, (v − v0) · per v
    #     shape of the other camera's table; the table with what is repeated in this one's, flat; lowest phase; bins per radian
    #     (focal, x0 here − x0 there, baseline), float32
    row_start: int,
    row_stop: int,
    column_start: int,
    column_stop: int,
    found: Found,  # out
) -> int:
    """Match pixels by their phase along the epipolar line; returns how many.

    From a pixel with nearly that phase on nearly that line a step of Newton's method in both leads to the place where phase and line
    are right; the phase is read there between four pixels, so that its variance is known, and the small rest follows the slope over
    several pixels. Pixels whose phase occurs at more than one place of the epipolar line, in either camera, are not matched.
    """
    lines, turn, shape, images = partner[0], partner[1], partner[2], partner[3:7]
    cubics, to_unit, table = partner[7], partner[8], (partner[10], partner[9], partner[11], partner[12])
    columns, width = phase.shape[1], np.int32(shape[1])
    limits = (np.float32(shape[1]) - EDGE, np.float32(shape[0]) - EDGE)
    s, at = stack_float32(SCRATCH), stack_int32(PLACES)
    s[:], at[:] = ZERO, 0
    matched = 0
    # Down the columns: what a row takes from the other camera is near at hand for the next.
    for first in range(column_start, column_stop, CHUNK):
        forget(s)
        n = min(CHUNK, column_stop - first)
        part, pairs = slice(first, first + n), slice(2 * first, 2 * (first + n))
        for y in range(row_start, row_stop):
            out = some_of(found, y - row_start, first - column_start, n)
            own = (phase[y, part], lines[y, pairs], rays[y, pairs], turn, skip[y, part])
            wanted = count_wanted(own[4], n)
            mostly = 2 * wanted > n
            if wanted > 0:
                prefetch_pixels(phase, lines, rays, skip, (y + ROWS_AHEAD) * columns + first, n)
            if not mostly:
                out.depth[:] = ZERO
                out.reason[:] = WITHOUT_PARTNER
                forget(s)
            if wanted == 0:
                continue
            if mostly:
                take_all(s, at, n, *own)
                count = n
            else:
                count = take_wanted(s, at, n, *own)
            look_up(s, at, count, *table)
            jump(s, at, count, width, images, cubics, to_unit, limits)
            settle(s, at, count, mostly, partner, limits, out)
            matched += count_matched(out.reason)
    return matched
