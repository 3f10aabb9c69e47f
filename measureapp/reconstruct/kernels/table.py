"""Tables of a camera's pixels by epipolar line and phase: where the search for a match starts.

A table (rows + 2, bins + 2) of int32 has a cell for every LINES_PER_CELL rectified rows and every bin of the phase, and an empty border. A
cell holds one pixel with that phase on those lines as ``row << ROW_SHIFT | column``, with the bit REPEATED where the phase occurs far from
it too; EMPTY, a negative number, for none.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.prefetch import prefetch
from measureapp.reconstruct.kernels.stack import stack_float32, stack_int32

ROW_SHIFT, COLUMN_MASK = np.int32(16), np.int32(0xFFFF)
REPEATED = np.int32(1 << 30)
PIXEL_MASK = np.int32((1 << 30) - 1)
EMPTY = np.int32(-(1 << 31))
LINES_PER_CELL = 2
MIN_SINE = 0.17  # of the angle between fringes and epipolar lines; pairs below are not matched
# Pixels of one cell and surface are this near to each other, beyond the width of the bin: the length of a fringe between the first and the
# last line of a cell where it crosses them at the smallest angle.
STRIP = 256
CELLS_PER_LINE = 8
NEAR_PX = np.float32(LINES_PER_CELL / MIN_SINE)
BIN_WIDTHS = np.float32(2.0)  # pixels of one bin and its neighbour differ by so much phase


@njit(**INLINE)
def is_far(held: Any, pixel: Any, near_px: Any) -> bool:
    """Whether a cell holds a pixel of another surface than this one."""
    dx = abs((held & COLUMN_MASK) - (pixel & COLUMN_MASK))
    dy = abs(((held & PIXEL_MASK) >> ROW_SHIFT) - (pixel >> ROW_SHIFT))
    return (held >= 0) & (max(dx, dy) > near_px)


@njit(**LOOP)
def fill_table(
    samples: Any,  # (3, h, w) float32, phase and slopes; pixels without a slope are left out
    lines: Any,  # (h, w) float32, rectified y
    direction: Any,  # (2,) float32, of the epipolar lines in the image
    lowest: Any,  # float32, phase of bin 1
    per_rad: Any,  # float32, bins per radian
    every: int,  # distance of the samples in pixels
    shape: Any,  # of the table
    repeated: Any,  # scratch, uint8, flat as the table
    table: Any,  # out, flat
) -> None:
    """Sort pixels by epipolar line and phase into a table; linear in their number."""
    height, width = lines.shape
    bins, last_row, last_bin = np.int32(shape[1]), np.int32(shape[0] - 1), np.int32(shape[1] - 1)
    table[:], repeated[:] = EMPTY, 0
    margin_rad = BIN_WIDTHS / per_rad
    lows, highs, nears = stack_int32(STRIP), stack_int32(STRIP), stack_float32(STRIP)
    some = False
    for v in range(height):
        for first in range(0, width, STRIP):
            n = min(STRIP, width - first)
            part = slice(first, first + n)
            phase, slope_x, slope_y, line = samples[0, v, part], samples[1, v, part], samples[2, v, part], lines[v, part]
            for i in range(n):  # into scratch memory: this loop is compiled to SIMD code, the next one is not
                rise = abs(slope_x[i] * direction[0] + slope_y[i] * direction[1])
                row = np.int32(line[i] * np.float32(1 / LINES_PER_CELL)) + np.int32(1)
                low = np.int32((phase[i] - rise - lowest) * per_rad) + np.int32(1)
                high = np.int32((phase[i] + rise - lowest) * per_rad) + np.int32(1)
                inside = (rise > np.float32(0)) & (row >= 1) & (row < last_row) & (low >= 1) & (high < last_bin)
                lows[i] = row * bins + low if inside else np.int32(0)
                highs[i] = row * bins + high if inside else np.int32(0)
                nears[i] = NEAR_PX + margin_rad / rise
            for i in range(0, n, CELLS_PER_LINE):
                prefetch(table, np.uint32(lows[i] + bins))
            for i in range(n):
                pixel = np.int32(v * every << ROW_SHIFT | (first + i) * every)
                for cell in range(lows[i], highs[i] + 1):
                    held = table[np.uint32(cell)]
                    table[np.uint32(cell)] = pixel
                    if is_far(held, pixel, nears[i]):
                        repeated[np.uint32(cell)], some = 1, True
    if some:
        for cell in range(len(table)):
            table[cell] |= REPEATED if repeated[cell] != 0 else np.int32(0)
    table[0] = EMPTY  # where the pixels without a cell were put


@njit(**LOOP)
def fill_gaps(table: Any, own: Any, row_start: int, row_stop: int, filled: Any) -> None:
    """Copy a table with empty cells filled from a neighbour, first in phase, then across the lines.

    What is repeated in ``own``, the table of the camera to be matched, is marked as repeated too.
    """
    rows, bins = table.shape
    for row in range(row_start, row_stop):
        for k in range(bins):
            held = table[row, k]
            if held < 0 and 0 < row < rows - 1 and 0 < k < bins - 1:
                held = max(table[row, k - 1], table[row, k + 1])
                if held < 0:
                    held = max(table[row - 1, k], table[row + 1, k])
                held = held & PIXEL_MASK if held >= 0 else held
            filled[row, k] = held | (own[row, k] & REPEATED) if held >= 0 and own[row, k] >= 0 else held


@njit(**LOOP)
def rectify_pixels(rays: Any, rotation: Any, frame: Any, row_start: int, row_stop: int, rectified: Any) -> None:
    """Write the rectified (x, y) of every pixel, from its normalised image coordinates (H, W, 2)."""
    for v in range(row_start, row_stop):
        for u in range(rays.shape[1]):
            x, y = float(rays[v, u, 0]), float(rays[v, u, 1])
            z = rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2]
            rectified[v, u, 0] = frame[0] * (rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2]) / z - frame[1]
            rectified[v, u, 1] = frame[0] * (rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2]) / z - frame[2]
