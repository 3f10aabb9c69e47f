"""What stands in the squares of a ChArUco board: the black and white cells of its markers."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import ImageArray


def marker_cells(columns: int, rows: int, dictionary: str, legacy_pattern: bool) -> ImageArray:
    """Return the cells (rows + 1, columns + 1, n, n) uint8 of the marker in every square; 1 is white, 2 everywhere: no marker.

    Parameters
    ----------
    columns, rows : inner corners of the board
    dictionary : name without ``DICT_``, such as ``5X5_250``
    legacy_pattern : boards with an even number of rows of squares as OpenCV drew them before 4.6: the first square is white
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
