"""Detection of the corners of a checkerboard, their order, and properties of the detected grid."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray
from measureapp.calibrate.boards.refine import refine_corners, window_of
from measureapp.calibrate.boards.saddles import find_saddles, grow_grid
from measureapp.data.board import BoardDescription

SEARCH_PX = 1000  # longer side of the image the board is searched in
SEARCH_SEED = 1  # of this thread: the search draws lots, and one image must give one answer
LEAST_SIDE = 3  # corners of the smallest grid that tells of another or a hidden board
LEAST_ROW_SHARE = 0.5  # of the corners of an outer row must be there
RING_SHARES = (0.5, 0.88)  # of a square behind the last row of corners: within the outermost squares
MARGIN_SHARES = (1.12, 1.5)  # beyond them
LEAST_RUN, LEAST_RUN_SHARE = 4, 0.4  # neighbouring squares of a side, and share of the side, that must look like the end of a board


@dataclass(frozen=True, slots=True, eq=False)
class DetectedSquares:
    """A grid of squares of unknown size; its rows and columns turn as x and y of the image do."""

    corners_px: FloatArray  # (R, C, 2), full-size pixels, to a pixel or so
    there: BoolArray  # (R, C), which of them were found, not only expected
    even_dark: bool  # whether the square between the first two corners of the first two rows is dark
    ends_in_white: tuple[bool, ...]  # behind the last row of the grid turned by 0 to 3 quarters (`numpy.rot90`): the board ends there

    @property
    def count(self) -> int:
        """How many corners were found."""
        return int(self.there.sum())

    @property
    def size(self) -> tuple[int, int]:
        """Corners along the longer and the shorter side."""
        return max(self.there.shape), min(self.there.shape)

    @property
    def is_whole(self) -> bool:
        """Whether it ends in white all round and has every corner."""
        return all(self.ends_in_white) and bool(self.there.all())

    def is_cut_off(self, size_px: tuple[int, int]) -> bool:
        """Whether the board goes on beyond an edge of the image of this width and height: no search finds it whole."""
        for quarter, white in enumerate(self.ends_in_white):
            grid = np.rot90(self.corners_px, quarter)
            onwards = 2 * grid[-1] - grid[-2]
            if not white and np.any((onwards < 0) | (onwards > np.array(size_px) - 1)):
                return True
        return False


def find_squares(grey: ImageArray, board: BoardDescription, seen: DetectedSquares | None) -> tuple[FloatArray, float] | None:
    """Find all inner corners (N, 2) of ``board`` to sub-pixel and the smallest distance of neighbours, px; None without a board.

    Corner 0 is the same physical corner in every image and camera where the board allows it: the squares on both sides of it
    along the board's diagonal are black. On a symmetric board (`is_symmetric`) either end may come first.

    Parameters
    ----------
    seen : the grid that was detected, where it is the board; None: searched thoroughly, which takes ten times as long

    Raises
    ------
    CalibrationError
        The corners cannot be refined.
    """
    coarse = _search_thoroughly(grey, board) if seen is None else _as_whole(seen, board)
    if coarse is None:
        return None
    spacing = _least_spacing(coarse, board)
    corners = refine_corners(grey, coarse, spacing, window_of(spacing))
    return _from_black_corner(grey, _right_handed(corners, board), board), spacing


def _as_whole(seen: DetectedSquares, board: BoardDescription) -> FloatArray | None:
    """Return the corners (N, 2) of a grid that has every corner of the board, and no more; else None."""
    if not seen.there.all() or seen.size != (max(board.columns, board.rows), min(board.columns, board.rows)):
        return None
    grid = seen.corners_px if seen.there.shape == (board.rows, board.columns) else np.rot90(seen.corners_px)
    return grid.reshape(-1, 2)


def _search_thoroughly(grey: ImageArray, board: BoardDescription) -> FloatArray | None:
    small, scale = shrink(grey, SEARCH_PX)
    coarse = _search_by_symmetry(small, board)
    if coarse is None:
        coarse = _search_by_outlines(small, board)
    return None if coarse is None else full_size(coarse, scale)


def shrink(grey: ImageArray, longest_px: int) -> tuple[ImageArray, float]:
    """Return the image with its longer side at most ``longest_px``, and by what it was scaled."""
    scale = min(1.0, longest_px / max(grey.shape))
    if scale == 1.0:
        return grey, 1.0
    return np.asarray(cv2.resize(grey, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA), np.uint8), scale


def full_size(points: FloatArray, scale: float) -> FloatArray:
    """Return points of a shrunk image in the pixels of the full one."""
    return (points + 0.5) / scale - 0.5


def detect_squares(grey: ImageArray) -> DetectedSquares | None:
    """Detect the largest grid of squares, of any size from 3 × 3 corners on."""
    small, scale = shrink(grey, SEARCH_PX)
    found = grow_grid(find_saddles(small))
    if found is None:
        return None
    grid, there = _without_poor_rows(*found)
    if min(there.shape) < LEAST_SIDE:
        return None
    grid = _with_missing(grid)
    levels = levels_at(blur(small), _cells(grid))
    even = np.indices(levels.shape).sum(axis=0) % 2 == 0
    sides = tuple(_ends_in_white(small, np.rot90(grid, quarter), np.rot90(there, quarter)) for quarter in range(4))
    return DetectedSquares(full_size(grid, scale), there, bool(levels[even].mean() < levels[~even].mean()), sides)


def _without_poor_rows(grid: FloatArray, there: BoolArray) -> tuple[FloatArray, BoolArray]:
    """Remove outer rows and columns of which less than half of the corners were found."""
    while there.size:
        poor = [quarter for quarter in range(4) if np.rot90(there, quarter)[-1].mean() < LEAST_ROW_SHARE]
        if not poor:
            break
        worst = min(poor, key=lambda quarter: float(np.rot90(there, quarter)[-1].mean()))
        grid = np.rot90(np.rot90(grid, worst)[:-1], -worst)
        there = np.rot90(np.rot90(there, worst)[:-1], -worst)
    return grid, there


def _with_missing(grid: FloatArray) -> FloatArray:
    """Add where missing corners (NaN) are expected: on the straight lines through their neighbours."""
    while np.isnan(grid).any():
        wide = np.pad(grid, ((2, 2), (2, 2), (0, 0)), constant_values=np.nan)
        rows, columns = np.nonzero(np.isnan(grid[..., 0]))
        at = [(rows + 2, columns + 2, down, right) for down, right in ((0, 1), (1, 0), (0, -1), (-1, 0))]
        guesses = [2 * wide[r + down, c + right] - wide[r + 2 * down, c + 2 * right] for r, c, down, right in at]
        guesses += [(wide[r + down, c + right] + wide[r - down, c - right]) / 2 for r, c, down, right in at[:2]]
        known = ~np.isnan(guesses)
        total, count = np.where(known, guesses, 0.0).sum(axis=0), known.sum(axis=0)
        if not count.any():
            break
        grid = grid.copy()
        grid[rows, columns] = np.where(count > 0, total / np.maximum(count, 1), np.nan)
    return grid


def _search_by_symmetry(picture: ImageArray, board: BoardDescription) -> FloatArray | None:
    """Search by the symmetry of corners (A. Duda, U. Frese, British Machine Vision Conference, 2018); (N, 2)."""
    cv2.setRNGSeed(SEARCH_SEED)
    found, corners = cv2.findChessboardCornersSB(
        picture, (board.columns, board.rows), flags=cv2.CALIB_CB_NORMALIZE_IMAGE
    )  # `refine_corners` does better than ACCURACY
    return np.asarray(corners, np.float64).reshape(-1, 2) if found else None


def _search_by_outlines(picture: ImageArray, board: BoardDescription) -> FloatArray | None:
    """Search squares by their outlines (V. Vezhnevets, as in OpenCV): finds them at oblique angles of about 60°; (N, 2)."""
    outlined = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_FAST_CHECK
    found, corners = cv2.findChessboardCorners(picture, (board.columns, board.rows), flags=outlined)
    return np.asarray(corners, np.float64).reshape(-1, 2) if found else None


def _least_spacing(corners: FloatArray, board: BoardDescription) -> float:
    grid = corners.reshape(board.rows, board.columns, 2)
    return float(min(np.linalg.norm(np.diff(grid, axis=axis), axis=2).min() for axis in (0, 1)))


def _right_handed(corners: FloatArray, board: BoardDescription) -> FloatArray:
    """Order the corners so that x, y of the board turn as x, y of the image do: the board is seen from its printed side."""
    grid = corners.reshape(board.rows, board.columns, 2)
    along_x, along_y = grid[0, -1] - grid[0, 0], grid[-1, 0] - grid[0, 0]
    if along_x[0] * along_y[1] - along_x[1] * along_y[0] < 0:
        grid = grid[::-1]
    return grid.reshape(-1, 2)


def _from_black_corner(grey: ImageArray, corners: FloatArray, board: BoardDescription) -> FloatArray:
    if board.is_symmetric:
        return corners
    grid = corners.reshape(board.rows, board.columns, 2)
    levels = levels_at(blur(grey), _cells(grid))
    like_first = np.indices(levels.shape).sum(axis=0) % 2 == 0
    if levels[like_first].mean() > levels[~like_first].mean():
        return corners[::-1]
    return corners


def blur(picture: ImageArray) -> ImageArray:
    """Return the image averaged over 3 × 3 pixels."""
    return np.asarray(cv2.blur(picture, (3, 3)), np.uint8)


def levels_at(picture: ImageArray, places: FloatArray) -> FloatArray:
    """Return the grey levels (…) of the pixels nearest to places (…, 2)."""
    column, row = np.moveaxis(np.round(places).astype(int), -1, 0)
    return picture[np.clip(row, 0, picture.shape[0] - 1), np.clip(column, 0, picture.shape[1] - 1)].astype(float)


def _ends_in_white(picture: ImageArray, grid: FloatArray, there: BoolArray) -> bool:
    """Whether behind the last row there is one more row of squares, black and white in turn, and then nothing but white.

    Part of the side may be hidden. A white cover is not taken for the margin unless its edge follows the squares' along that part
    within a fifth of a square.
    """
    smooth = blur(picture)
    inner = levels_at(smooth, _cells(grid))
    limit = (np.percentile(inner, 10) + np.percentile(inner, 90)) / 2
    step = grid[-1] - grid[-2]
    start, onwards = (grid[-1, :-1] + grid[-1, 1:]) / 2, (step[:-1] + step[1:]) / 2
    size = np.array(picture.shape[::-1]) - 1
    known = there[-1, :-1] & there[-1, 1:]
    bright = {}
    for share in (*RING_SHARES, *MARGIN_SHARES):
        row = start + share * onwards
        known &= np.all((row > 0) & (row < size), axis=1)
        bright[share] = levels_at(smooth, row) > limit
    known &= np.all([bright[share] for share in MARGIN_SHARES], axis=0)
    odd = np.arange(len(start)) % 2 == 1
    turns = [known & np.all([bright[share] == (odd == other) for share in RING_SHARES], axis=0) for other in (False, True)]
    return max(_longest_run(one) for one in turns) >= max(LEAST_RUN, LEAST_RUN_SHARE * len(start))


def _longest_run(mask: BoolArray) -> int:
    ends = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    return int(np.max(ends[1::2] - ends[::2], initial=0))


def _cells(grid: FloatArray) -> FloatArray:
    """The middles (R - 1, C - 1, 2) of the squares between the corners of a grid (R, C, 2)."""
    return np.asarray((grid[:-1, :-1] + grid[1:, :-1] + grid[:-1, 1:] + grid[1:, 1:]) / 4)
