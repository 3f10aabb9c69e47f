"""A part of a checkerboard is used where it can be told which part it is, and refused with the reason where it cannot."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

from measureapp.calibrate.boards.find import detect, find_board
from measureapp.calibrate.boards.part import possible_places
from measureapp.calibrate.boards.squares import DetectedSquares
from measureapp.data.board import CheckerboardDescription
from measureapp.errors import CalibrationError
from tests.calibrate.virtual_board import CHECKER, shot

BOARD = CheckerboardDescription(columns=6, rows=5, square_mm=10.0)
NOT_SEEN = (False,) * 4


def drawn(rows, columns, first_row, first_column, quarter, ends):
    """What `detect_squares` would say of a part of `BOARD` in an image turned by quarters; corners hold their ids."""
    ids = np.arange(BOARD.count).reshape(BOARD.rows, BOARD.columns)[first_row : first_row + rows, first_column : first_column + columns]
    turned = np.rot90(ids, quarter)
    row, column = divmod(int(turned[0, 0]), BOARD.columns)
    other_row, other_column = divmod(int(turned[1, 1]), BOARD.columns)
    even_dark = (min(row, other_row) + min(column, other_column)) % 2 == 0
    sides = tuple(ends[(side + quarter) % 4] for side in range(4))
    return DetectedSquares(np.dstack([turned, turned]).astype(float), np.ones(turned.shape, bool), even_dark, sides), ids


def true_ends(rows, columns, row, column):
    return (row + rows == BOARD.rows, column == 0, row == 0, column + columns == BOARD.columns)


@pytest.mark.parametrize("quarter", range(4))
def test_the_true_place_is_always_among_the_possible_ones(quarter):
    for rows, columns in itertools.product(range(3, 6), range(3, 7)):
        for row, column in itertools.product(range(BOARD.rows - rows + 1), range(BOARD.columns - columns + 1)):
            seen, ids = drawn(rows, columns, row, column, quarter, true_ends(rows, columns, row, column))
            possible = possible_places(BOARD, seen)
            places = [
                np.arange(BOARD.count).reshape(BOARD.rows, BOARD.columns)[r : r + rows, c : c + columns]
                for turn, r, c in possible
                if np.array_equal(np.rot90(seen.corners_px[..., 0], turn), ids)
            ]
            assert any(np.array_equal(place, ids) for place in places), (rows, columns, row, column)


def test_one_side_of_the_board_with_both_of_its_ends_suffices():
    seen, _ = drawn(5, 4, 0, 0, 0, (True, True, True, False))
    assert possible_places(BOARD, seen) == [(0, 0, 0)]


def test_the_middle_of_a_board_may_be_anywhere():
    seen, _ = drawn(3, 3, 1, 1, 0, NOT_SEEN)
    assert len(possible_places(BOARD, seen)) > 1


def test_a_larger_grid_is_no_part():
    seen = DetectedSquares(np.zeros((7, 5, 2)), np.ones((7, 5), bool), True, NOT_SEEN)
    assert possible_places(BOARD, seen) == []


@pytest.mark.parametrize(
    ("towards_mm", "roll_deg"), [((100.0, 0.0), 0), ((-100.0, 0.0), 0), ((100.0, 0.0), 180), ((0.0, 95.0), 90), ((0.0, -95.0), 90)]
)
def test_a_board_half_out_of_the_image_is_found_with_its_ids(towards_mm, roll_deg):
    seen = shot(CHECKER, 15, 60, roll_deg, aside_mm=towards_mm)
    size = np.array(seen.image.shape[::-1])
    inside = np.all((seen.marks_px > 20) & (seen.marks_px < size - 20), axis=1)
    assert 40 < inside.sum() < CHECKER.count
    found = find_board(seen.image, CHECKER)
    assert len(found.ids) >= 0.8 * inside.sum()
    off = found.corners_px - seen.marks_px[found.ids]
    assert np.abs(off).max() < 0.3  # a wrong identity is off by a whole square
    assert np.sqrt(np.mean((off / found.sigma_px[:, None]) ** 2)) < 2
    with pytest.raises(CalibrationError, match=f"Only {len(found.ids)} of the 154 marks"):
        detect(seen.image, CHECKER)


@pytest.mark.parametrize("part", [(slice(300, 600), slice(500, 700)), (slice(None), slice(0, 520))], ids=["middle", "side"])
def test_a_cover_leaves_the_rest_of_the_board_usable(part):
    seen = shot(CHECKER, 35)
    image = np.array(seen.image)
    image[part] = 60  # a grey sheet
    found = find_board(image, CHECKER)
    assert 0 < len(found.ids) < CHECKER.count
    assert np.abs(found.corners_px - seen.marks_px[found.ids]).max() < 0.3


def test_a_corner_of_the_board_alone_is_refused_as_ambiguous():
    seen = shot(CHECKER, 15, 60, 0)
    image = np.full_like(seen.image, 70)
    middle = seen.marks_px.mean(axis=0).astype(int)
    image[: middle[1], : middle[0]] = seen.image[: middle[1], : middle[0]]
    with pytest.raises(CalibrationError, match="they may be any of") as refusal:
        find_board(image, CHECKER)
    assert "ChArUco" in refusal.value.hint


def test_a_white_sheet_is_not_taken_for_the_margin():
    """It ends somewhere within a square, so the row of squares before it is cut."""
    seen = shot(CHECKER, 0, 60, 0)
    spacing = np.linalg.norm(seen.marks_px[1] - seen.marks_px[0])
    for share in (0.1, 0.35, 0.6, 0.8):
        image = np.array(seen.image)
        edge = round(seen.marks_px[8::14, 0].mean() + share * spacing)
        image[:, edge:] = int(np.percentile(seen.image, 97))
        image[: int(seen.marks_px[14 * 3, 1])] = 70  # fewer rows than the board has
        image[int(seen.marks_px[14 * 8, 1]) :] = 70
        try:
            found = find_board(image, CHECKER)
        except CalibrationError:
            continue
        assert np.abs(found.corners_px - seen.marks_px[found.ids]).max() < 0.3, share
