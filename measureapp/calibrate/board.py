"""Finding the corners of a checkerboard in an image."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.board import CheckerboardDescription
from measureapp.errors import CalibrationError

SEARCH_PX = 1000  # longer side of the image the board is searched in
WINDOW_SHARE = 0.35  # half the refining window over the distance of neighbouring corners: its diagonal ends at the next edge
WINDOW_LIMITS_PX = (2, 12)
LARGEST_SHIFT = 0.75  # a corner that wanders further than this share of the window has found another edge
REFINE_UNTIL = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_MAX_ITER, 60, 1e-4)


def detect(image: ImageArray, board: CheckerboardDescription) -> FloatArray:
    """Find the inner corners of ``board``, ordered like ``board.corners_mm``.

    Corner 0 is the same physical corner in every image and camera where the board allows it: the squares on both sides of it
    along the board's diagonal are black. On a symmetric board (`is_symmetric`) either end may come first.

    Parameters
    ----------
    image : (H, W) or (H, W, 3), 8 or 16 bit

    Returns
    -------
    corners_px : (N, 2) float64, (x, y)

    Raises
    ------
    CalibrationError
        The board is not found, or its corners cannot be refined.
    """
    grey = as_grey8(image)
    corners = refined(grey, _found(grey, board), board)
    return _from_black_corner(grey, _right_handed(corners, board), board)


def require_unambiguous(board: CheckerboardDescription, purpose: str) -> None:
    """Refuse a board that looks the same after half a turn. Raises CalibrationError."""
    if board.is_symmetric:
        raise CalibrationError(
            f"A board of {board.columns} × {board.rows} corners looks the same after half a turn, so {purpose} cannot use it.",
            "Take a board with an even and an odd number of corners, such as 14 × 11 or 9 × 6.",
        )


def as_grey8(image: ImageArray) -> ImageArray:
    """Return an image as (H, W) uint8; 16-bit images are scaled to their brightest pixel."""
    if image.ndim == 3:
        image = np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY))
    if image.dtype == np.uint8:
        return np.ascontiguousarray(image)
    return np.asarray(np.round(image * (255.0 / max(int(image.max()), 1))), np.uint8)


def refined(grey: ImageArray, corners: FloatArray, board: CheckerboardDescription) -> FloatArray:
    """Refine corners (N, 2) to sub-pixel with a window that fits the squares as they appear in this image [1]_.

    References
    ----------
    .. [1] W. Förstner, E. Gülch, Proc. ISPRS Intercommission Conference, 281-305, 1987.
    """
    grid = corners.reshape(board.rows, board.columns, 2)
    spacing = min(np.linalg.norm(np.diff(grid, axis=axis), axis=2).min() for axis in (0, 1))
    window = int(np.clip(WINDOW_SHARE * spacing, *WINDOW_LIMITS_PX))
    start = np.ascontiguousarray(corners, np.float32).reshape(-1, 1, 2)
    better = np.asarray(cv2.cornerSubPix(grey, start.copy(), (window, window), (-1, -1), REFINE_UNTIL), np.float64).reshape(-1, 2)
    shift = np.linalg.norm(better - corners, axis=1)
    if spacing < 2 * WINDOW_LIMITS_PX[0] or not np.all(shift <= LARGEST_SHIFT * max(window, 4)):
        raise CalibrationError(
            "The corners of the board cannot be refined.", "Take a sharper image, or move closer so that the squares appear larger."
        )
    return better


def _found(grey: ImageArray, board: CheckerboardDescription) -> FloatArray:
    scale = min(1.0, SEARCH_PX / max(grey.shape))
    small = grey if scale == 1.0 else np.asarray(cv2.resize(grey, None, fx=scale, fy=scale, interpolation=cv2.INTER_AREA), np.uint8)
    corners = _search(small, board)
    if corners is not None:
        return (corners + 0.5) / scale - 0.5
    raise CalibrationError(
        f"The board of {board.columns} × {board.rows} corners was not found.",
        "The whole board must be visible, sharp and not over-exposed; check its number of inner corners.",
    )


def _search(picture: ImageArray, board: CheckerboardDescription) -> FloatArray | None:
    size = (board.columns, board.rows)
    found, corners = cv2.findChessboardCornersSB(picture, size, flags=cv2.CALIB_CB_NORMALIZE_IMAGE)  # `refined` does better than ACCURACY
    if not found:
        flags = cv2.CALIB_CB_ADAPTIVE_THRESH | cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_FAST_CHECK
        found, corners = cv2.findChessboardCorners(picture, size, flags=flags)
    if not found:
        flags = cv2.CALIB_CB_NORMALIZE_IMAGE | cv2.CALIB_CB_EXHAUSTIVE | cv2.CALIB_CB_ACCURACY
        found, corners = cv2.findChessboardCornersSB(picture, size, flags=flags)
    return np.asarray(corners, np.float64).reshape(-1, 2) if found else None


def _right_handed(corners: FloatArray, board: CheckerboardDescription) -> FloatArray:
    """Order the corners so that x, y of the board turn as x, y of the image do: the board is seen from its printed side."""
    grid = corners.reshape(board.rows, board.columns, 2)
    along_x, along_y = grid[0, -1] - grid[0, 0], grid[-1, 0] - grid[0, 0]
    if along_x[0] * along_y[1] - along_x[1] * along_y[0] < 0:
        grid = grid[::-1]
    return grid.reshape(-1, 2)


def _from_black_corner(grey: ImageArray, corners: FloatArray, board: CheckerboardDescription) -> FloatArray:
    if board.is_symmetric:
        return corners
    grid = corners.reshape(board.rows, board.columns, 2)
    centres = (grid[:-1, :-1] + grid[1:, :-1] + grid[:-1, 1:] + grid[1:, 1:]) / 4
    column, row = np.round(centres).astype(int).reshape(-1, 2).T
    smooth = np.asarray(cv2.blur(grey, (3, 3)), float)
    levels = smooth[np.clip(row, 0, grey.shape[0] - 1), np.clip(column, 0, grey.shape[1] - 1)].reshape(centres.shape[:2])
    like_first = np.indices(levels.shape).sum(axis=0) % 2 == 0
    if levels[like_first].mean() > levels[~like_first].mean():
        return corners[::-1]
    return corners
