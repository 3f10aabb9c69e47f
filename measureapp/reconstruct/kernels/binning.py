"""Compiled loops that sort the pixels of a camera by epipolar line and phase.

A table (rows + 2, bins + 2) of int32 has a cell for every two rectified rows and every bin of the phase, and an empty border. A cell
holds one pixel with that phase on those lines as ``v << 16 | u``, with the bit REPEATED when the phase occurs far from it too; EMPTY, a
negative number, for none.
"""
# One loop over chunks of pixels: cut into functions it takes a quarter longer.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.cache_hints import prefetch
from measureapp.compiled.options import INLINE, LOOP
from measureapp.reconstruct.kernels.scratch import stack_float32, stack_int32

REPEATED = np.int32(1 << 30)
PLACE = np.int32((1 << 30) - 1)
EMPTY = np.int32(-(1 << 31))
PLACE_BITS, LOW_HALF, NOTHING = np.int32(16), np.int32(0xFFFF), np.int32(0)
NEVER, TWICE = np.uint8(0), np.uint8(1)  # how often the phase of a cell occurs on its line
LINES_PER_CELL = 2
LEAST_SINE = 0.17  # of the angle between fringes and epipolar lines; pairs below are not matched
# Pixels of one cell and surface lie this near to each other, beyond what the bin's width explains: so long is a fringe between the first
# and the last line of a cell where it crosses them at the smallest angle.
NEAR_PX = np.float32(LINES_PER_CELL / LEAST_SINE)
CHUNK = 256
NEAR = 0
SCRATCH = CHUNK
(CELL, LAST, HELD, HELD_LAST, PLACES) = (k * CHUNK for k in range(5))
INDICES = 5 * CHUNK
CELLS_APART = 8  # the cells of so many pixels lie in one cache line
ZERO, HALF = np.float32(0), np.float32(0.5)


@njit(**INLINE)
def put(table: Any, cell: Any, place: Any) -> Any:
    """Write a pixel into a cell and return what was there."""
    held = table[cell]
    table[cell] = place
    return held


@njit(**INLINE)
def is_far(held: Any, place: Any, near: Any) -> Any:
    """Whether two pixels of a cell are not of one surface."""
    across, down = (held & LOW_HALF) - (place & LOW_HALF), ((held & PLACE) >> PLACE_BITS) - (place >> PLACE_BITS)
    return (held >= NOTHING) & (max(abs(across), abs(down)) > near)


@njit(**INLINE)
def note_repeated(s: Any, at: Any, n: int, repeated: Any) -> bool:
    """Note which cells of n pixels held one of another surface; returns whether there are some."""
    some = NOTHING
    for i in range(n):
        far = is_far(at[HELD + i], at[PLACES + i], s[NEAR + i]) | is_far(at[HELD_LAST + i], at[PLACES + i], s[NEAR + i])
        some = max(some, np.int32(far))
    if some == NOTHING:
        return False
    for i in range(n):
        for k in (NOTHING, np.int32(CHUNK)):
            if is_far(at[HELD + k + i], at[PLACES + i], s[NEAR + i]):
                repeated[np.uint32(at[CELL + k + i])] = TWICE
    return True


@njit(**LOOP)
def fill_table(
    samples: Any,  # (3, h, w) float32, phase and slopes; samples without a slope are left out: no surface hangs together there
    levels: Any,  # (h, w) float32, rectified y
    along_x: Any,  # float32, direction of the epipolar lines in the image
    along_y: Any,
    lowest: Any,  # float32, phase of bin 1
    per_rad: Any,  # float32, bins per radian
    every: int,  # samples are so many pixels apart in both directions
    shape: Any,  # of the table
    repeated: Any,  # scratch, flat, as many uint8
    table: Any,  # out, flat
) -> None:
    """Sort pixels into a table; linear in their number, and wrong phases spoil no cells but their own.

    Neighbours mostly share a cell, so that what is written is read again at once. What is written must not wait for that: which cells are
    repeated is noted elsewhere.
    """
    height, width = levels.shape
    bins = np.int32(shape[1])
    last_row, last_bin = np.int32(shape[0] - 1), np.int32(shape[1] - 1)
    table[:] = EMPTY
    repeated[:] = NEVER
    ever = False
    margin = np.float32(2.0) / per_rad
    step = np.int32(every)
    s, at = stack_float32(SCRATCH), stack_int32(INDICES)
    for v in range(height):
        row_of = np.int32(v * every << PLACE_BITS)
        for first in range(0, width, CHUNK):
            n = min(CHUNK, width - first)
            part, begin = slice(first, first + n), np.int32(first)
            phases, slopes_x, slopes_y, ys = samples[0, v, part], samples[1, v, part], samples[2, v, part], levels[v, part]
            for i in range(n):
                phase = phases[i]
                rise = abs(slopes_x[i] * along_x + slopes_y[i] * along_y)
                row = np.int32(ys[i] * HALF) + np.int32(1)
                low = np.int32((phase - rise - lowest) * per_rad) + np.int32(1)
                high = np.int32((phase + rise - lowest) * per_rad) + np.int32(1)
                inside = (row >= 1) & (row < last_row) & (low >= 1) & (high < last_bin) & (rise > ZERO)
                at[CELL + i] = row * bins + low if inside else NOTHING
                at[LAST + i] = row * bins + high if inside else NOTHING
                at[PLACES + i] = row_of | ((begin + np.int32(i)) * step)
                s[NEAR + i] = NEAR_PX + margin / rise
            for i in range(0, n, CELLS_APART):  # the next row of pixels begins a row of the table, which waits far away
                prefetch(table, np.uint32(at[CELL + i] + bins))
            for i in range(n):
                cell, last, place = at[CELL + i], at[LAST + i], at[PLACES + i]
                at[HELD + i] = put(table, np.uint32(cell), place)
                at[HELD_LAST + i] = put(table, np.uint32(last), place)
                for between in range(cell + 1, last):
                    if is_far(put(table, np.uint32(between), place), place, s[NEAR + i]):
                        repeated[np.uint32(between)] = TWICE
                        ever = True
            ever |= note_repeated(s, at, n, repeated)
    if ever:
        for k in range(len(table)):
            table[k] |= REPEATED if repeated[k] == TWICE else NOTHING
    table[0] = EMPTY  # where pixels were put that have no cell


@njit(**LOOP)
def spread_table(table: Any, here: Any, row_start: int, row_stop: int, wider: Any) -> None:
    """Write into ``wider`` the table with empty cells filled from a neighbour, first in the phase, then across the lines.

    What is repeated in ``here``, the table of the camera to be matched, is marked too.
    """
    rows, bins = table.shape
    for row in range(row_start, row_stop):
        for k in range(bins):
            held = table[row, k]
            if held < 0 and 0 < row < rows - 1 and 0 < k < bins - 1:
                held = max(table[row, k - 1], table[row, k + 1])
                if held < 0:
                    held = max(table[row - 1, k], table[row + 1, k])
                held = held & PLACE if held >= 0 else held
            own = here[row, k]
            wider[row, k] = held | (own & REPEATED) if held >= 0 and own >= 0 else held


@njit(**LOOP)
def rectified_lines(rays: Any, turn: Any, frame: Any, row_start: int, row_stop: int, lines: Any) -> None:
    """Write the rectified (x, y) of every pixel, from its normalised coordinates (H, W, 2)."""
    for v in range(row_start, row_stop):
        for u in range(rays.shape[1]):
            nx, ny = float(rays[v, u, 0]), float(rays[v, u, 1])
            z = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
            lines[v, u, 0] = frame[0] * (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) / z - frame[1]
            lines[v, u, 1] = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) / z - frame[2]
