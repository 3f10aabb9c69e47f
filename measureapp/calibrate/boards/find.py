"""Finding the marks of a board in an image."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import FloatArray, ImageArray, IntArray
from measureapp.calibrate.boards.charuco import find_charuco, has_markers
from measureapp.calibrate.boards.circles import find_circles
from measureapp.calibrate.boards.part import find_part
from measureapp.calibrate.boards.quality import (
    LEAST_SHARE,
    are_squares,
    is_blurred,
    missing,
    partly_hidden,
    poor_image,
    require_plain,
    require_usable,
    unexpected_markers,
)
from measureapp.calibrate.boards.refine import mark_sigmas, off_the_grid
from measureapp.calibrate.boards.squares import DetectedSquares, detect_squares, find_squares
from measureapp.calibrate.sightings import Sighting
from measureapp.data.board import BoardDescription, CharucoDescription, CheckerboardDescription, CirclesDescription
from measureapp.errors import CalibrationError

PRECISION_REACH = 0.3  # half the side of the patch that says how well a mark is known, over the distance of marks


def find_board(image: ImageArray, board: BoardDescription, expected_px: FloatArray | None = None) -> Sighting:
    """Detect the marks of ``board``, each with its standard deviation: all, or the visible ones where they can be identified.

    Any part of a ChArUco board can be identified; of a checkerboard or a circle grid one that shows where the board ends.

    Parameters
    ----------
    image : (H, W) or (H, W, 3), 8 or 16 bit
    expected_px : (``board.count``, 2), approximate position of each mark, if known; distinguishes parts of equal appearance

    Raises
    ------
    AmbiguousPart
        A part of the board is seen that may be one of several.
    CalibrationError
        The board is not found, or the image is too dark, over-exposed or blurred to trust its marks; says which.
    """
    grey = as_grey8(image)
    try:
        found = _marks(grey, board, expected_px)
    except CalibrationError:
        if is_blurred(grey):
            raise missing(grey, board) from None
        raise
    if found is None:
        raise missing(grey, board)
    ids, corners, spacing = found
    sigma = mark_sigmas(grey, board, ids, corners, np.full(len(ids), PRECISION_REACH * spacing))
    edge_px = require_usable(grey, board, ids, corners, sigma)
    on_grid = ~off_the_grid(board, ids, corners)  # at an oblique angle, a corner of a complete board may be refined onto the next edge
    return Sighting("", "", corners[on_grid], ids[on_grid], sigma[on_grid], edge_px)


def _marks(grey: ImageArray, board: BoardDescription, expected_px: FloatArray | None) -> tuple[IntArray, FloatArray, float] | None:
    """Ids (N,), marks (N, 2) and the smallest distance of neighbours, px."""
    if isinstance(board, CharucoDescription):
        return find_charuco(grey, board)
    if isinstance(board, CirclesDescription):
        return _circles(grey, board, expected_px)
    return _squares(grey, board, expected_px) if isinstance(board, CheckerboardDescription) else None


def _circles(grey: ImageArray, board: CirclesDescription, expected_px: FloatArray | None) -> tuple[IntArray, FloatArray, float] | None:
    try:
        return find_circles(grey, board, expected_px)
    except CalibrationError as error:
        raise poor_image(grey, board) or error from error


def _squares(grey: ImageArray, board: CheckerboardDescription, expected_px: FloatArray | None) -> tuple[IntArray, FloatArray, float]:
    squares = detect_squares(grey)
    whole = _whole(grey, board, squares)
    if whole is not None:
        return np.arange(board.count), *whole
    if squares is None or squares.count < LEAST_SHARE * board.count:
        raise missing(grey, board)
    if not are_squares(grey, squares.corners_px):
        raise poor_image(grey, board) or (unexpected_markers() if has_markers(grey) else partly_hidden(board, squares.count))
    require_plain(grey, squares.corners_px)
    try:
        part = find_part(grey, board, squares, expected_px)
    except CalibrationError as error:
        raise poor_image(grey, board) or error from error
    if part is None:
        raise missing(grey, board, squares)
    return part


def _whole(grey: ImageArray, board: CheckerboardDescription, squares: DetectedSquares | None) -> tuple[FloatArray, float] | None:
    """All corners and their smallest distance: of the grid that was detected, or of a thorough search where that may find more."""
    if squares is not None:
        try:
            found = find_squares(grey, board, squares)
        except CalibrationError:  # one of its corners is something else
            found = None
        if found is not None or _says_enough(grey, board, squares):
            return found
    return find_squares(grey, board, None)


def _says_enough(grey: ImageArray, board: CheckerboardDescription, squares: DetectedSquares) -> bool:
    """Whether no thorough search can find more: the board goes on beyond the image's edge, or the grid ends all round at the board's size.

    Or beyond it: that is another board, of which a search for fewer corners could find as many.
    """
    if not are_squares(grey, squares.corners_px):
        return False
    longer, shorter = max(board.columns, board.rows), min(board.columns, board.rows)
    ends = all(squares.ends_in_white) and squares.size[0] >= longer and squares.size[1] >= shorter
    return ends or squares.is_cut_off((grey.shape[1], grey.shape[0]))


def detect(image: ImageArray, board: BoardDescription) -> FloatArray:
    """Find all marks of ``board`` (N, 2), ordered like ``board.corners_mm``; as `find_board`, and a part of a board is refused.

    Raises
    ------
    CalibrationError
        The board is not found, not seen whole, or the image does not allow to trust its marks.
    """
    found = find_board(image, board)
    if len(found.ids) < board.count:
        raise CalibrationError(
            f"Only {len(found.ids)} of the {board.count} marks of the {board.label} can be seen.",
            "Show the whole board, evenly lit.",
        )
    return found.corners_px


def require_unambiguous(board: BoardDescription, purpose: str) -> None:
    """Refuse a board that is symmetric under half a turn. Raises CalibrationError."""
    if board.is_symmetric:
        remedy = (
            "an odd number of rows, such as 4 × 11"
            if isinstance(board, CirclesDescription)
            else ("an even and an odd number of corners, such as 14 × 11 or 9 × 6, or a ChArUco board")
        )
        raise CalibrationError(
            f"A {board.label} is symmetric under half a turn, so {purpose} cannot use it.", f"Take a board with {remedy}."
        )


def as_grey8(image: ImageArray) -> ImageArray:
    """Return an image as (H, W) uint8; 16-bit images are scaled to their brightest pixel."""
    if image.ndim == 3:
        image = np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2GRAY))
    if image.dtype == np.uint8:
        return np.ascontiguousarray(image)
    return np.asarray(np.round(image * (255.0 / max(int(image.max()), 1))), np.uint8)
