"""Compiled loop that finds the pixels of one camera in another: same epipolar line, same phase.

``lines`` (H, W, 2) are the rectified coordinates (x, y) of every pixel of a pair; equal y is the same epipolar line; ``pixels``
(H, W, 4) are the records of `kernels.slopes`. The loop works on chunks of pixels in lanes of scratch arrays: ``s`` for numbers of the
pixel that is matched, ``at`` for indices, ``r`` for records as they are fetched from the other camera, ``g`` for these in lanes. What
arithmetic reads and what it writes are different arrays or lanes of one stride: only then does the compiler use SIMD instructions.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.lanes import (
    CHUNK,
    PLACES,
    SCRATCH,
    ZERO,
    Found,
    ask_for,
    count_matched,
    count_wanted,
    forget,
    keep_nearest,
    keep_unsettled,
    list_wanted,
    load,
    load_listed,
    some_of,
    store_all,
    store_some,
)
from measureapp.reconstruct.kernels.options import INLINE, LOOP
from measureapp.reconstruct.kernels.scratch import stack_float32, stack_int32
from measureapp.reconstruct.kernels.seen import WITHOUT_PARTNER
from measureapp.reconstruct.kernels.steps import GATHERED, fetch, fetch_start, jump, look_up, newton

ITERATIONS = 6
EDGE = np.float32(1.001)


@njit(**INLINE)
def start_row(s: Any, g: Any, at: Any, n: int, mostly: bool, row: Any, turn: Any, table: Any, width: Any, images: Any) -> int:
    """Load what is wanted of n pixels of a row, and look up where to begin in the other camera; returns how many are in the lanes then."""
    phase, lines, rays, skip = row
    held, shape, lowest, per_rad = table
    if mostly:
        load(s, n, phase, lines, rays, turn, skip)
    else:
        n = list_wanted(at, n, skip)
        load_listed(s, at, n, phase, lines, rays, turn)
        forget(s)
    look_up(s, at, n, held, shape, lowest, per_rad, width)
    fetch_start(s, g, at, n, images[2], images[3])
    return n


@njit(**INLINE)
def settle(
    s: Any, g: Any, r: Any, at: Any, n: int, width: Any, images: Any, cubics: Any, to_unit: Any, limits: Any, numbers: Any, out: Found
) -> None:
    """Take further steps with those of n pixels that have not settled."""
    for step in range(1, ITERATIONS):
        n = keep_unsettled(s, at, n)
        if n == 0:
            break
        fetch(s, g, r, at, n, width, *images)
        newton(s, g, n, cubics, to_unit, limits, numbers, step == ITERATIONS - 1)
        store_some(s, at, n, out)


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
    cubics, to_unit, table, numbers = partner[7], partner[8], (partner[10], partner[9], partner[11], partner[12]), partner[13]
    columns, width = phase.shape[1], np.int32(shape[1])
    limits = (np.float32(shape[1]) - EDGE, np.float32(shape[0]) - EDGE)
    s, at = stack_float32(SCRATCH), stack_int32(PLACES)
    r, g, later = stack_float32(GATHERED), stack_float32(GATHERED), stack_float32(GATHERED)
    g[:] = ZERO
    matched = 0
    found.depth[:] = ZERO
    found.reason[:] = WITHOUT_PARTNER
    # Down the columns: what a row takes from the other camera is near at hand for the next.
    for first in range(column_start, column_stop, CHUNK):
        forget(s)
        for y in range(row_start, row_stop):
            n = min(CHUNK, column_stop - first)
            part, pairs = slice(first, first + n), slice(2 * first, 2 * (first + n))
            out = some_of(found, y - row_start, first - column_start, n)
            wanted = count_wanted(skip[y, part], n)
            ask_for(phase, lines, rays, skip, (y + 1) * columns + first, n)
            if wanted == 0:
                continue
            mostly = 2 * wanted > n
            own = (phase[y, part], lines[y, pairs], rays[y, pairs], skip[y, part])
            n = start_row(s, g, at, n, mostly, own, turn, table, width, images)
            jump(s, g, n, cubics, to_unit, limits[0], limits[1])
            fetch(s, g, r, at, n, width, *images)
            newton(s, g, n, cubics, to_unit, limits, numbers, False)
            if mostly:
                store_all(s, at, n, out)
                keep_nearest(s, n)
            else:
                store_some(s, at, n, out)
            settle(s, later, r, at, n, width, images, cubics, to_unit, limits, numbers, out)
    for row in range(row_stop - row_start):
        matched += count_matched(found.reason[row])
    return matched
