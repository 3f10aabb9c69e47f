"""Boards in project files and rig settings: old checkerboards stay readable, others are told apart by kind."""

from __future__ import annotations

import json

import numpy as np
import pytest
from pydantic import TypeAdapter, ValidationError

from measureapp.data.board import AnyBoard, BoardDescription, CharucoDescription, CheckerboardDescription, CirclesDescription

BOARDS: TypeAdapter[BoardDescription] = TypeAdapter(AnyBoard)
OLD = {"columns": 14, "rows": 11, "square_mm": 15.0, "bow_mm": [0.0, 0.01, 0.0]}


def test_a_checkerboard_keeps_the_form_it_has_always_had():
    board = BOARDS.validate_python(OLD)
    assert isinstance(board, CheckerboardDescription)
    assert json.loads(board.model_dump_json()) == OLD
    assert BOARDS.validate_python({"kind": "checkerboard", **OLD}) == board


@pytest.mark.parametrize(
    "board",
    [
        CharucoDescription(kind="charuco", columns=9, rows=7, square_mm=10, marker_mm=7, dictionary="APRILTAG_36H11", legacy_pattern=True),
        CirclesDescription(kind="circles", columns=4, rows=11, spacing_mm=20, diameter_mm=12),
    ],
)
def test_other_boards_go_to_a_file_and_back(board):
    assert BOARDS.validate_json(board.model_dump_json()) == board


@pytest.mark.parametrize(
    ("document", "words"),
    [
        ({"kind": "dots", **OLD}, "checkerboard"),
        ({"kind": "charuco", **OLD, "marker_mm": 15}, "do not fit into squares"),
        ({"kind": "charuco", **OLD, "marker_mm": 11, "dictionary": "5X5_50"}, "needs 90 markers"),
        ({"kind": "charuco", **OLD, "marker_mm": 11, "dictionary": "9X9_50"}, "no dictionary"),
        ({"kind": "circles", "columns": 4, "rows": 11, "spacing_mm": 10, "diameter_mm": 14}, "too close"),
    ],
)
def test_boards_that_cannot_be_are_refused_in_words(document, words):
    with pytest.raises(ValidationError, match=words):
        BOARDS.validate_python(document)


def test_circles_are_staggered_as_opencv_orders_them():
    board = CirclesDescription(kind="circles", columns=4, rows=11, spacing_mm=20, diameter_mm=12)
    expected = [[(2 * j + i % 2) * 20.0, i * 20.0, 0.0] for i in range(11) for j in range(4)]
    np.testing.assert_array_equal(board.flat_corners_mm, expected)
    np.testing.assert_array_equal(board.marks_mm(np.array([4, 43])), [expected[4], expected[43]])
