"""Marker cells of a ChArUco board."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import ImageArray


def marker_cells(columns: int, rows: int, dictionary: str, legacy_pattern: bool) -> ImageArray:
    """Return the cells (rows + 1, columns + 1, n, n) uint8 of the marker in every square: 0 black, 1 white; all 2: no marker.

    Parameters
    ----------
    columns, rows : inner corners of the board
    dictionary : name without ``DICT_``, such as ``5X5_250``
    legacy_pattern : layout of OpenCV before 4.6 for an even number of rows of squares: the first square is white
    """
    markers = cv2.aruco.getPredefinedDictionary(getattr(cv2.aruco, f"DICT_{dictionary}"))
    board = cv2.aruco.CharucoBoard((columns + 1, rows + 1), 1.0, 0.5, markers)
    board.setLegacyPattern(legacy_pattern)
    n = markers.markerSize + 2
    cells = np.full((rows + 1, columns + 1, n, n), 2, np.uint8)
    for number, corners in zip(np.ravel(board.getIds()), board.getObjPoints(), strict=True):
        column, row = np.floor(corners[0][:2]).astype(int)
        cells[row, column] = cv2.aruco.generateImageMarker(markers, int(number), n) // 255
    return cells
