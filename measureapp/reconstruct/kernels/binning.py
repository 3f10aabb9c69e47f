"""Compiled loops that sort the pixels of a camera by epipolar line and phase.

A table (rows + 2, bins + 2) of int32 has a cell for every two rectified rows and every bin of the phase, and an empty border. A cell
holds one pixel with that phase on those lines as ``v << 16 | u``, with the bit REPEATED when the phase occurs far from it too; −1 for
none.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.options import LOOP
from measureapp.reconstruct.kernels.slopes import PHASE, SLOPE_X, SLOPE_Y

REPEATED = np.int32(1 << 30)
PLACE = np.int32((1 << 30) - 1)
LINES_PER_CELL = 2
LEAST_SINE = 0.17  # of the angle between fringes and epipolar lines; pairs below are not matched
# Pixels of one cell and surface lie this near to each other, beyond what the bin's width explains: so long is a fringe between the first
# and the last line of a cell where it crosses them at the smallest angle.
NEAR_PX = np.float32(LINES_PER_CELL / LEAST_SINE)


@njit(**LOOP)
def fill_table(
    pixels: Any,  # (H, W, 4) float32, see `slopes`; pixels without a slope are left out: no surface hangs together there
    lines: Any,  # (H, W, 2) float32, rectified (x, y)
    along_x: Any,  # float32, direction of the epipolar lines in the image
    along_y: Any,
    lowest: Any,  # float32, phase of bin 1
    per_rad: Any,  # float32, bins per radian
    every: int,  # take one pixel of so many in both directions
    table: Any,  # out
) -> None:
    """Sort pixels into a table; linear in their number, and wrong phases spoil no cells but their own."""
    height, width = lines.shape[:2]
    last_row, last_bin = table.shape[0] - 1, table.shape[1] - 1
    table[:] = -1
    margin = np.float32(2.0) / per_rad
    for v in range(0, height, every):
        for u in range(0, width, every):
            rise = abs(pixels[v, u, SLOPE_X] * along_x + pixels[v, u, SLOPE_Y] * along_y)
            if rise == 0:
                continue
            row = int(lines[v, u, 1] * np.float32(0.5)) + 1
            low = int((pixels[v, u, PHASE] - rise - lowest) * per_rad) + 1
            high = int((pixels[v, u, PHASE] + rise - lowest) * per_rad) + 1
            if row < 1 or row >= last_row or low < 1 or high >= last_bin:
                continue
            place = np.int32((v << 16) | u)
            for k in range(low, high + 1):
                held = table[row, k]
                if held < 0:
                    table[row, k] = place
                    continue
                apart = max(abs((held & 0xFFFF) - u), abs(((held & PLACE) >> 16) - v))
                repeated = held & REPEATED
                if apart * rise > NEAR_PX * rise + margin:
                    repeated = REPEATED
                table[row, k] = place | repeated


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
