"""Compiled loops that find what hangs together on a depth map, from runs of pixels; ``inverse`` and the chunks of a row are those of `cleaning`."""
# One loop over pixels, as in the other kernels.
# ruff: noqa: PLR0912

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import ALLOCATING_LOOP, LOOP
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.cleaning import CHUNK

ZERO, SIGMAS = np.float32(0), np.float32(8.0)
ISLAND = np.uint8(PointState.ISLAND)


@njit(**ALLOCATING_LOOP)
def find_runs(
    inverse: Any,
    sigma: Any,
    fate: Any,
    per_px: Any,
    border: int,
    row_start: int,
    row_stop: int,
    removed: Any,  # (H, chunks) uint8, 1 where points of a chunk of a row are not trusted
    starts: Any,  # out (H, W) int16
    stops: Any,  # out
    counts: Any,  # out (H,) int32
) -> None:
    """Take rejected points out of ``inverse`` and find the runs of points of every row without a depth step."""
    width = sigma.shape[1]
    linked = np.zeros(width + 1, np.uint8)
    for y in range(row_start, row_stop):
        inv, noise, judged = inverse[y + border, border : border + width], sigma[y], fate[y]
        some = np.uint8(0)
        for k in range(removed.shape[1]):
            some |= removed[y, k]
        if some != 0:
            for x in range(width):
                inv[x] = inv[x] if judged[x] == 0 else ZERO
        before = inv[0 : width - 1]
        here, s_here = inv[1:width], noise[1:width]
        flags = linked[1:width]
        for x in range(width - 1):
            a, b = before[x], here[x]
            flags[x] = (abs(a - b) <= per_px * b + SIGMAS * s_here[x] * b * b) & (a > ZERO) & (b > ZERO)
        count = 0
        for x in range(width):
            if linked[x]:
                continue
            if x > 0 and inv[x - 1] > ZERO:
                stops[y, count] = x
                count += 1
            if inv[x] > ZERO:
                starts[y, count] = x
        if inv[width - 1] > ZERO:
            stops[y, count] = width
            count += 1
        counts[y] = count


@njit(**LOOP)
def root_of(parent: Any, index: int) -> int:
    """Return the representative of a run's island, shortening the way to it."""
    while parent[index] != index:
        parent[index] = parent[parent[index]]
        index = parent[index]
    return index


@njit(**ALLOCATING_LOOP)
def drop_islands(
    inverse: Any,
    sigma: Any,
    per_px: Any,
    border: int,
    least: int,
    starts: Any,
    stops: Any,
    counts: Any,
    fate: Any,
    removed: Any,
    points: Any,
) -> None:
    """Join the runs of neighbouring rows where no depth step parts them, and remove what stays smaller than ``least`` pixels.

    Writes into ``points`` (H,) how many points are left in every row.
    """
    height = len(counts)
    total = 0
    for y in range(height):
        total += counts[y]
    parent = np.arange(total).astype(np.int32)
    above = 0
    for y in range(1, height):
        here = above + counts[y - 1]
        i, j = 0, 0
        while i < counts[y - 1] and j < counts[y]:
            low, high = max(starts[y - 1, i], starts[y, j]), min(stops[y - 1, i], stops[y, j])
            for x in range(low, high):
                a, b = inverse[y - 1 + border, x + border], inverse[y + border, x + border]
                if abs(a - b) <= per_px * b + SIGMAS * sigma[y, x] * b * b:
                    p, q = root_of(parent, above + i), root_of(parent, here + j)
                    parent[max(p, q)] = min(p, q)
                    break
            if stops[y - 1, i] < stops[y, j]:
                i += 1
            else:
                j += 1
        above = here
    size = np.zeros(total, np.int32)
    index = 0
    for y in range(height):
        for k in range(counts[y]):
            size[root_of(parent, index)] += stops[y, k] - starts[y, k]
            index += 1
    index = 0
    for y in range(height):
        points[y] = 0
        for k in range(counts[y]):
            if size[root_of(parent, index)] < least:
                for x in range(starts[y, k], stops[y, k]):
                    fate[y, x] = ISLAND
                    inverse[y + border, x + border] = ZERO
                    removed[y, x // CHUNK] = 1
            else:
                points[y] += stops[y, k] - starts[y, k]
            index += 1
