"""A part of a plain checkerboard, where it can be told which part it is."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.calibrate.board_refine import off_the_grid, refined, window_of
from measureapp.calibrate.board_squares import SquaresInSight
from measureapp.calibrate.sightings import BoardRefused
from measureapp.data.board import BoardDescription, CheckerboardDescription

LEAST_MARKS = 12
BORDER_PX = 3.0


def find_part(grey: ImageArray, board: CheckerboardDescription, seen: SquaresInSight) -> tuple[IntArray, FloatArray, float] | None:
    """Find ids (N,), corners (N, 2) to sub-pixel and the smallest distance of neighbours, px; None where no part of ``board`` fits.

    Which part is seen follows from the sides on which the board ends in its white margin, from how many rows and columns are seen,
    and from the colours of the squares.

    Raises
    ------
    CalibrationError
        Several parts of the board look like the one that is seen, or the corners cannot be refined.
    """
    places = places_of(board, seen)
    if seen.count < LEAST_MARKS or not places:
        return None
    if len(places) > 1:
        raise may_be_any(board, seen.count, len(places))
    quarter, row, column = places[0]
    grid, there = np.rot90(seen.corners_px, quarter), np.rot90(seen.there, quarter)
    rows, columns = np.nonzero(there)
    ids = (rows + row) * board.columns + columns + column
    spacing = min(_least(np.diff(grid, axis=axis), there, axis) for axis in (0, 1))
    inside = np.all((grid[there] > BORDER_PX) & (grid[there] < np.array(grey.shape[::-1]) - 1 - BORDER_PX), axis=1)
    corners = refined(grey, grid[there][inside], spacing, window_of(spacing))
    ids = ids[inside]
    good = ~off_the_grid(board, ids, corners)
    return ids[good], corners[good], spacing


def may_be_any(board: BoardDescription, seen: int, parts: int) -> BoardRefused:
    """Return what is to be said of ``seen`` marks that several parts of a board look like."""
    return BoardRefused(
        f"Only {seen} of the {board.count} marks of the {board.label} can be seen, and they may be any of {parts} parts of it.",
        "Show one whole side of the board with the white margin at both of its ends, or use a ChArUco board, of which any part is enough.",
        "hidden",
    )


def places_of(board: CheckerboardDescription, seen: SquaresInSight) -> list[tuple[int, int, int]]:
    """Return every (quarter turns, first row, first column) at which the grid that is seen may lie on the board."""
    found = []
    for quarter in range(4):
        there = np.rot90(seen.there, quarter)
        rows, columns = there.shape
        ends = [seen.ends_in_white[(quarter + side) % 4] for side in range(4)]  # last row, then the first column, first row, last column
        even_dark = seen.even_dark ^ _first_cell_changes(seen.there.shape, quarter)
        found += [
            (quarter, row, column)
            for row in range(board.rows - rows + 1)
            for column in range(board.columns - columns + 1)
            if ((row + column) % 2 == 0) == even_dark
            and not (ends[0] and row + rows != board.rows)
            and not (ends[1] and column != 0)
            and not (ends[2] and row != 0)
            and not (ends[3] and column + columns != board.columns)
        ]
    return found


def _first_cell_changes(shape: tuple[int, ...], quarter: int) -> bool:
    """Whether the first square of the grid turned by quarters has the other colour than that of the grid as it is."""
    rows, columns = shape[0] - 1, shape[1] - 1
    first = {0: 0, 1: columns - 1, 2: rows + columns - 2, 3: rows - 1}[quarter]
    return first % 2 == 1


def _least(steps: FloatArray, there: BoolArray, axis: int) -> float:
    """The smallest distance of two neighbouring corners that were both found."""
    both = there[1:] & there[:-1] if axis == 0 else there[:, 1:] & there[:, :-1]
    return float(np.linalg.norm(steps, axis=2)[both].min(initial=np.inf))
