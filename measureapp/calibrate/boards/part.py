"""Detection of an identifiable part of a plain checkerboard."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray
from measureapp.calibrate.boards.refine import cut_off, refine_corners, window_of
from measureapp.calibrate.boards.squares import DetectedSquares
from measureapp.calibrate.sightings import AmbiguousPart
from measureapp.data.board import BoardDescription, CheckerboardDescription

LEAST_MARKS = 12
BORDER_PX = 3.0
NEARER = 0.25  # of the distance of the next possible part


def find_part(
    grey: ImageArray, board: CheckerboardDescription, seen: DetectedSquares, expected_px: FloatArray | None = None
) -> tuple[IntArray, FloatArray, float] | None:
    """Find ids (N,), corners (N, 2) to sub-pixel and the smallest distance of neighbours, px; None where no part of ``board`` fits.

    Which part is seen follows from the sides on which the board ends in its white margin, from how many rows and columns are seen,
    and from the colours of the squares; where that leaves several, from where the marks are ``expected_px`` (all, 2), if that is known.

    Raises
    ------
    CalibrationError
        Several parts of the board look like the one that is seen, or the corners cannot be refined.
    """
    places = possible_places(board, seen)
    if seen.count < LEAST_MARKS or not places:
        return None
    quarter, row, column = places[identify_part(board, [_marks_at(board, seen, place) for place in places], expected_px)]
    grid, there = np.rot90(seen.corners_px, quarter), np.rot90(seen.there, quarter)
    ids, _ = _marks_at(board, seen, (quarter, row, column))
    spacing = min(_least(np.diff(grid, axis=axis), there, axis) for axis in (0, 1))
    inside = np.all((grid[there] > BORDER_PX) & (grid[there] < np.array(grey.shape[::-1]) - 1 - BORDER_PX), axis=1)
    corners = refine_corners(grey, grid[there][inside], spacing, window_of(spacing))
    ids = ids[inside]
    good = ~cut_off(board, ids, corners)
    return ids[good], corners[good], spacing


def identify_part(
    board: BoardDescription, parts: Sequence[tuple[IntArray, FloatArray]], expected_px: FloatArray | None, symmetry: int = 1
) -> int:
    """Identify the visible part of a board: the only candidate, or the one at the expected marks.

    Parts lie apart by whole distances of marks. The nearest is trusted where it is so much nearer to what is expected than the next one that
    an error of the expectation cannot have exchanged them.

    Parameters
    ----------
    parts : ids (N,) and pixels (N, 2) of each
    symmetry : how many candidates are the same marks on a symmetric board

    Raises
    ------
    AmbiguousPart
        There are several candidates, and no expectation.
    """
    if len(parts) <= symmetry:
        return 0
    if expected_px is not None:
        off = np.array([np.sqrt(np.mean((pixels - expected_px[ids]) ** 2)) for ids, pixels in parts])
        nearest, next_one = np.argsort(off)[:2]
        if off[nearest] < NEARER * off[next_one]:
            return int(nearest)
    raise AmbiguousPart(
        f"Only {len(parts[0][0])} of the {board.count} marks of the {board.label} can be seen, and they may be any of {len(parts) // symmetry} parts of it.",
        "Show one whole side of the board with the white margin at both of its ends, or use a ChArUco board, of which any part is enough.",
    )


def _marks_at(board: CheckerboardDescription, seen: DetectedSquares, place: tuple[int, int, int]) -> tuple[IntArray, FloatArray]:
    """Return ids (N,) and pixels (N, 2) of the corners that were found, as they lie at a place."""
    quarter, row, column = place
    there = np.rot90(seen.there, quarter)
    rows, columns = np.nonzero(there)
    return (rows + row) * board.columns + columns + column, np.rot90(seen.corners_px, quarter)[there]


def possible_places(board: CheckerboardDescription, seen: DetectedSquares) -> list[tuple[int, int, int]]:
    """Return every possible (quarter turns, first row, first column) of the detected grid on the board."""
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
