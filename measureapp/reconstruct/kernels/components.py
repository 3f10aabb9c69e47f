"""Connected components of a depth map, from runs of pixels along its rows; isolated patches are removed."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import ALLOCATING_LOOP, INLINE, LOOP
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.clean import CHUNK, STEP_SIGMAS
from measureapp.reconstruct.kernels.structures import VALID, Surface

ZERO = np.float32(0)
ISOLATED = np.uint8(PointState.ISLAND)


@njit(**ALLOCATING_LOOP)
def find_runs(
    surface: Surface,
    state: Any,  # (H, W) uint8
    removed: Any,  # (H, chunks) uint8, 1 where a chunk of a row has rejected points
    row_start: int,
    row_stop: int,
    starts: Any,  # out (H, W) int16
    stops: Any,  # out (H, W) int16
    counts: Any,  # out (H,) int32
) -> None:
    """Remove rejected points from the inverse depths, and find the runs of points of every row without a depth discontinuity."""
    border, width = surface.radius, state.shape[1]
    linked = np.zeros(width, np.uint8)  # 1 where no depth discontinuity separates a pixel from the one before
    for y in range(row_start, row_stop):
        inverse, noise, states = surface.inverse[y + border, border : border + width], surface.sigma[y], state[y]
        rejected = np.uint8(0)
        for k in range(removed.shape[1]):
            rejected |= removed[y, k]
        if rejected != 0:
            for x in range(width):
                inverse[x] = inverse[x] if states[x] == VALID else ZERO
        for x in range(1, width):
            before, own = inverse[x - 1], inverse[x]
            limit = surface.step_per_px * own + STEP_SIGMAS * noise[x] * own * own
            linked[x] = (abs(before - own) <= limit) & (before > ZERO) & (own > ZERO)
        count = 0
        for x in range(width):
            if linked[x] == 0:
                if x > 0 and inverse[x - 1] > ZERO:
                    stops[y, count] = x
                    count += 1
                if inverse[x] > ZERO:
                    starts[y, count] = x
        if inverse[width - 1] > ZERO:
            stops[y, count] = width
            count += 1
        counts[y] = count


@njit(**LOOP)
def root_of(parent: Any, index: int) -> int:
    """Return the representative of a run's component, and shorten the path to it."""
    while parent[index] != index:
        parent[index] = parent[parent[index]]
        index = parent[index]
    return index


@njit(**INLINE)
def touch(surface: Surface, y: int, low: int, high: int) -> bool:
    """Whether two runs of neighbouring rows, y the lower one, are one surface in any of their common columns."""
    border = surface.radius
    for x in range(low, high):
        above, own = surface.inverse[y - 1 + border, x + border], surface.inverse[y + border, x + border]
        if abs(above - own) <= surface.step_per_px * own + STEP_SIGMAS * surface.sigma[y, x] * own * own:
            return True
    return False


@njit(**ALLOCATING_LOOP)
def remove_small_components(
    surface: Surface,
    min_pixels: int,
    starts: Any,
    stops: Any,
    counts: Any,
    state: Any,  # in and out (H, W) uint8
    removed: Any,  # in and out (H, chunks) uint8
    points: Any,  # out (H,) int64, how many points are left in every row
) -> None:
    """Join the runs of neighbouring rows where no depth discontinuity separates them; remove components of less than ``min_pixels``."""
    height = len(counts)
    firsts = np.cumsum(counts) - counts  # index of the first run of every row
    parent = np.arange(firsts[-1] + counts[-1])
    for y in range(1, height):
        i, j = 0, 0
        while i < counts[y - 1] and j < counts[y]:
            low, high = max(starts[y - 1, i], starts[y, j]), min(stops[y - 1, i], stops[y, j])
            if touch(surface, y, low, high):
                p, q = root_of(parent, firsts[y - 1] + i), root_of(parent, firsts[y] + j)
                parent[max(p, q)] = min(p, q)
            if stops[y - 1, i] < stops[y, j]:
                i += 1
            else:
                j += 1
    size = np.zeros(len(parent), np.int64)
    for y in range(height):
        for k in range(counts[y]):
            size[root_of(parent, firsts[y] + k)] += stops[y, k] - starts[y, k]
    for y in range(height):
        points[y] = 0
        for k in range(counts[y]):
            if size[root_of(parent, firsts[y] + k)] >= min_pixels:
                points[y] += stops[y, k] - starts[y, k]
                continue
            for x in range(starts[y, k], stops[y, k]):
                state[y, x], removed[y, x // CHUNK] = ISOLATED, 1
                surface.inverse[y + surface.radius, x + surface.radius] = ZERO
