"""NumPy statements of the tables by epipolar line and phase."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.reconstruct.kernels.table import (
    BIN_WIDTHS,
    COLUMN_MASK,
    EMPTY,
    LINES_PER_CELL,
    NEAR_PX,
    PIXEL_MASK,
    REPEATED,
    ROW_SHIFT,
)


def fill_table(
    samples: FloatArray, lines: FloatArray, direction: tuple[float, float], lowest: float, per_rad: float, every: int,
    shape: tuple[int, int], repeated: IntArray, table: IntArray,
) -> None:  # fmt: skip
    """Sort pixels into cells; the last one stays, and cells with pixels of different surfaces are marked as repeated.

    Pixels are entered cell by cell in their order: sorted by cell, each but the first of a cell is compared with the one before it.
    """
    repeated[:] = 0
    phase, rise = samples[0], np.abs(samples[1] * direction[0] + samples[2] * direction[1])
    row = (lines * np.float32(1 / LINES_PER_CELL)).astype(np.int64) + 1
    low, high = (((phase + sign * rise - lowest) * per_rad).astype(np.int64) + 1 for sign in (-1, 1))
    inside = (rise > 0) & (row >= 1) & (row < shape[0] - 1) & (low >= 1) & (high < shape[1] - 1)
    v, u = np.nonzero(inside)
    count = (high - low + 1)[inside]
    number = np.repeat(np.arange(len(count)), count)  # of the pixel that every entry is of
    offset = np.arange(len(number)) - np.repeat(np.cumsum(count) - count, count)
    cell = (row * shape[1] + low)[inside][number] + offset
    order = np.argsort(cell, kind="stable")
    cell, x, y = cell[order], (u * every)[number][order], (v * every)[number][order]
    near = (NEAR_PX + BIN_WIDTHS / per_rad / np.where(rise > 0, rise, 1))[inside][number][order]
    same_cell = cell[1:] == cell[:-1]
    apart = np.maximum(np.abs(np.diff(x)), np.abs(np.diff(y))) > near[1:]
    table[:] = EMPTY
    table[cell] = y << ROW_SHIFT | x
    repeated[cell[1:][same_cell & apart]] = 1
    table[repeated != 0] |= REPEATED


def fill_gaps(table: IntArray, own: IntArray, row_start: int, row_stop: int, filled: IntArray) -> None:
    """Fill empty cells from a neighbour, first in phase, then across the lines; mark what is repeated in ``own``."""
    across = np.full_like(table, EMPTY)
    across[1:-1, 1:-1] = np.maximum(table[1:-1, :-2], table[1:-1, 2:])
    along = np.full_like(table, EMPTY)
    along[1:-1, 1:-1] = np.maximum(table[:-2, 1:-1], table[2:, 1:-1])
    neighbour = np.where(across >= 0, across, along)
    held = np.where(table >= 0, table, np.where(neighbour >= 0, neighbour & PIXEL_MASK, table))
    marked = np.where((held >= 0) & (own >= 0), held | (own & REPEATED), held)
    filled[row_start:row_stop] = marked[row_start:row_stop]


def rectify_pixels(rays: FloatArray, rotation: FloatArray, frame: FloatArray, row_start: int, row_stop: int, rectified: FloatArray) -> None:
    """Rotate the viewing rays to the rectified axes and project them."""
    part = rays[row_start:row_stop].astype(np.float64)
    x, y, z = np.moveaxis(np.concatenate([part, np.ones_like(part[..., :1])], axis=-1) @ np.asarray(rotation).T, -1, 0)
    rectified[row_start:row_stop] = np.stack([frame[0] * x / z - frame[1], frame[0] * y / z - frame[2]], axis=-1)


def unpack(held: IntArray) -> tuple[IntArray, IntArray]:
    """Return row and column of the pixels that cells hold."""
    return (held & PIXEL_MASK) >> ROW_SHIFT, held & COLUMN_MASK
