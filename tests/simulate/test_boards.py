"""The virtual rig prints boards as others print them."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.data.board import CharucoDescription, CirclesDescription
from measureapp.simulate.board_kernel import _paint
from measureapp.simulate.optics import NO_RESIDUAL
from measureapp.simulate.printed_board import _print_layout

COLOURS = np.array([1.0, 0.5])


def painted(board, x_mm, y_mm):
    layout, cells = _print_layout(board)
    return np.array([[_paint(x, y, layout, cells, COLOURS, NO_RESIDUAL) for x in x_mm] for y in y_mm])


def test_a_charuco_board_is_printed_as_opencv_draws_it():
    for legacy in (False, True):
        board = CharucoDescription(
            kind="charuco", columns=6, rows=5, square_mm=18.0, marker_mm=14.0, dictionary="5X5_100", legacy_pattern=legacy
        )
        markers = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_5X5_100)
        described = cv2.aruco.CharucoBoard((7, 6), 18.0, 14.0, markers)
        described.setLegacyPattern(legacy)
        drawn = described.generateImage((7 * 18, 6 * 18))
        seen = painted(board, np.arange(7 * 18) + 0.5 - 18.0, np.arange(6 * 18) + 0.5 - 18.0)
        np.testing.assert_array_equal(seen == 1.0, drawn > 127)


def test_circles_have_their_diameter_and_lie_within_a_white_margin():
    board = CirclesDescription(kind="circles", columns=3, rows=5, spacing_mm=10.0, diameter_mm=8.0)
    x, y = np.arange(-24.93, 76.0, 0.25), np.arange(-24.87, 66.0, 0.25)
    seen = painted(board, x, y)
    assert np.isclose((seen == 0.5).sum() * 0.0625, 15 * np.pi * 16, rtol=0.01)
    inside = (x[None] >= -20) & (x[None] <= 70) & (y[:, None] >= -20) & (y[:, None] <= 60)
    assert np.all((seen > 0)[inside])
    assert not np.any(seen[~inside])
    for mark in board.flat_corners_mm:
        assert painted(board, [mark[0]], [mark[1]])[0, 0] == 0.5
