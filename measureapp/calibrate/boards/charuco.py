"""Detection of the visible corners of a ChArUco board."""

from __future__ import annotations

from typing import Any

import cv2
import numpy as np

from measureapp.arrays import FloatArray, ImageArray, IntArray
from measureapp.calibrate.boards.refine import homography, local_axes, off_the_grid, refine_corners, window_of
from measureapp.calibrate.boards.squares import full_size, shrink
from measureapp.calibrate.sightings import BoardDetectionError
from measureapp.data.board import CharucoDescription

SEARCH_PX = 1300  # a marker of 5 × 5 bits must not become smaller than some 14 px
LEAST_CORNERS = 6
FAMILIES = (cv2.aruco.DICT_5X5_1000, cv2.aruco.DICT_4X4_1000, cv2.aruco.DICT_6X6_1000, cv2.aruco.DICT_7X7_1000)  # hold the smaller ones
EDGE_PX = 1.0  # half the width of a sharp edge, kept out of the refining window


def find_charuco(grey: ImageArray, board: CharucoDescription) -> tuple[IntArray, FloatArray, float] | None:
    """Find ids (N,), corners (N, 2) to sub-pixel and the smallest distance of neighbours, px; None with fewer than six corners.

    Markers are detected in a shrunk image; only where that shows too few of them, but some, in the full one. Corners that were refined onto
    something else are rejected.

    Raises
    ------
    CalibrationError
        Markers are there that this board does not have, or the corners cannot be refined.
    """
    detector = _detector(board)  # one of its own: images are searched on several threads
    for longest in (SEARCH_PX, max(grey.shape)):
        small, scale = shrink(grey, longest)
        corners, ids, _, markers = detector.detectBoard(small)
        _require_own(board, markers)
        if ids is not None and len(ids) >= LEAST_CORNERS:
            break
        if longest >= max(grey.shape) or markers is None or not len(markers):
            return None
    order = np.argsort(np.ravel(ids))
    known = np.ravel(ids)[order].astype(np.int64)
    coarse = full_size(np.asarray(corners, np.float64).reshape(-1, 2)[order], scale)
    axes = local_axes(homography(board, known, coarse), board.flat_corners_mm[known, :2])
    spacing = board.square_mm * float(np.linalg.norm(axes, axis=2).min())
    free = spacing * (board.square_mm - board.marker_mm) / (2 * board.square_mm) - EDGE_PX
    corners_px = refine_corners(grey, coarse, spacing, window_of(spacing, free))
    good = ~off_the_grid(board, known, corners_px)
    return known[good], corners_px[good], spacing


def suggest_charuco(grey: ImageArray, board: CharucoDescription) -> BoardDetectionError | None:
    """Say what there is in an image in which ``board`` was not found."""
    small, _ = shrink(grey, SEARCH_PX)
    corners, _, _, markers = _detector(board).detectBoard(small)
    if corners is not None and len(corners):
        return BoardDetectionError(
            f"Only {len(corners)} corners of the {board.label} can be seen; at least {LEAST_CORNERS} are needed.",
            "Show more of the board.",
            "hidden",
        )
    if markers is not None and len(markers) >= LEAST_CORNERS:
        return BoardDetectionError(
            f"The {board.label} was not found: its markers are there, but not placed as on this board.",
            "Check its numbers of corners, and `legacy_pattern` for a board drawn by OpenCV before 4.6.",
            "wrong board",
        )
    mirrored = _detector(board).detectBoard(np.ascontiguousarray(small[:, ::-1]))[3]
    if mirrored is not None and len(mirrored) >= LEAST_CORNERS:
        return BoardDetectionError(
            f"The {board.label} was not found: the image is mirrored.", "Switch mirroring off in the camera's settings.", "wrong board"
        )
    return None


def has_markers(grey: ImageArray) -> bool:
    """Whether the image shows the markers of some ChArUco board."""
    small, _ = shrink(grey, SEARCH_PX)
    for family in FAMILIES:
        markers = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(family)).detectMarkers(small)[1]
        if markers is not None and len(markers) >= LEAST_CORNERS:
            return True
    return False


def _require_own(board: CharucoDescription, markers: Any) -> None:
    own = (board.columns + 1) * (board.rows + 1) // 2
    foreign = 0 if markers is None else int(np.sum(np.ravel(markers) >= own))
    if foreign > max(1, 0.05 * own):  # one may be a misread pattern
        raise BoardDetectionError(
            f"The image shows {foreign} markers that a {board.label} does not have (its own are 0 to {own - 1}).",
            "Give the size of the board that was used.",
            "wrong board",
        )


def _detector(board: CharucoDescription) -> cv2.aruco.CharucoDetector:
    markers = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, f"DICT_{board.dictionary}"))
    described = cv2.aruco.CharucoBoard((board.columns + 1, board.rows + 1), board.square_mm, board.marker_mm, markers)
    described.setLegacyPattern(board.legacy_pattern)
    return cv2.aruco.CharucoDetector(described)
