"""A part of a circle grid is used where it can be told which part it is; a wrong one is never returned."""

from __future__ import annotations

import itertools

import cv2
import numpy as np
import pytest

from measureapp.calibrate.boards.circle_grid import CircleGrid, ids_of, possible_placements, rotate_places
from measureapp.calibrate.boards.find import detect, find_board
from measureapp.data.board import CirclesDescription
from measureapp.errors import CalibrationError
from tests.calibrate.virtual_board import CIRCLES, QUARTER, shot

BOARD = CirclesDescription(kind="circles", columns=4, rows=9, spacing_mm=20.0, diameter_mm=14.0)
SYMMETRIC = CirclesDescription(kind="circles", columns=5, rows=10, spacing_mm=18.0, diameter_mm=13.0)
# The mean of some 100 pixels' gradients round an outline: grey noise of 1.5 % of the contrast in each, a gradient over 2.5 px, so
# 0.015 · 2.5 px · √2 / √100 = 0.005 px; at 50° and a quarter of the resolution half as many: 0.008 px. A cover may make an outline leave
# its ellipse by 0.3 px before the circle is left out, which shifts its centre by no more.
RMS_PX, WORST_PX = 0.03, 0.3


def drawn(board, first_x, last_x, first_y, last_y, quarter, ends):
    """What would be seen of the places of ``board`` within limits, in an image turned by quarters; ``ends``: margin seen left, right, ..."""
    places = np.array([(2 * column + row % 2, row) for row in range(board.rows) for column in range(board.columns)])
    inside = np.all((places >= (first_x, first_y)) & (places <= (last_x, last_y)), axis=1)
    beside = {
        (int(x) + a, int(y) + b)
        for x, y in places[inside]
        for a, b in itertools.product((1, -1), repeat=2)
        if (ends[0] and x + a < 0)
        or (ends[1] and x + a >= 2 * board.columns)
        or (ends[2] and y + b < 0)
        or (ends[3] and y + b >= board.rows)
    }
    empty = np.array(sorted(beside), np.int64).reshape(-1, 2)
    return CircleGrid(rotate_places(places[inside], quarter), np.zeros((inside.sum(), 2)), rotate_places(empty, quarter)), np.flatnonzero(
        inside
    )


@pytest.mark.parametrize("quarter", range(4))
def test_the_true_lie_is_always_among_the_possible_ones(quarter):
    for left, right, top, bottom in itertools.product((0, 2), (5, 7), (0, 3), (6, 8)):
        grid, ids = drawn(BOARD, left, right, top, bottom, quarter, (left == 0, right == 7, top == 0, bottom == 8))
        lies = possible_placements(BOARD, grid)
        assert any(np.array_equal(ids_of(BOARD, grid.places, lie), ids) for lie in lies), (left, right, top, bottom)


def test_one_side_with_both_of_its_ends_determines_the_part():
    grid, ids = drawn(BOARD, 0, 7, 0, 4, 0, (True, True, True, False))
    (lie,) = possible_placements(BOARD, grid)
    assert np.array_equal(ids_of(BOARD, grid.places, lie), ids)


def test_the_middle_may_be_anywhere_and_a_larger_grid_is_no_part():
    assert len(possible_placements(BOARD, drawn(BOARD, 2, 5, 2, 6, 0, (False,) * 4)[0])) > 1
    larger = CirclesDescription(kind="circles", columns=6, rows=9, spacing_mm=20.0, diameter_mm=14.0)
    assert possible_placements(BOARD, drawn(larger, 0, 11, 0, 8, 0, (True,) * 4)[0]) == []


def test_both_ends_of_a_symmetric_board_are_possible():
    whole, _ = drawn(SYMMETRIC, 0, 9, 0, 9, 0, (True,) * 4)
    assert len(possible_placements(SYMMETRIC, whole)) == 2
    assert len(possible_placements(BOARD, drawn(BOARD, 0, 7, 0, 8, 0, (True,) * 4)[0])) == 1


@pytest.mark.parametrize(
    ("aside_mm", "roll_deg"), [((120.0, 0.0), 0), ((-120.0, 0.0), 0), ((120.0, 0.0), 180), ((0.0, 110.0), 90), ((0.0, -110.0), 90)]
)
def test_a_grid_half_out_of_the_image_is_found_with_its_ids(aside_mm, roll_deg):
    seen = shot(CIRCLES, 15, 60, roll_deg, aside_mm=aside_mm)
    found = find_board(seen.image, CIRCLES)
    assert 20 < len(found.ids) < CIRCLES.count
    off = found.corners_px - seen.marks_px[found.ids]
    assert np.sqrt(np.mean(off**2)) < RMS_PX
    assert np.sqrt(np.mean((off / found.sigma_px[:, None]) ** 2)) < 2
    with pytest.raises(CalibrationError, match=f"Only {len(found.ids)} of the 105 marks"):
        detect(seen.image, CIRCLES)


@pytest.mark.parametrize("part", [(slice(300, 600), slice(500, 700)), (slice(None), slice(0, 520))], ids=["middle", "side"])
def test_a_cover_leaves_the_rest_of_the_grid_usable(part):
    seen = shot(CIRCLES, 35)
    image = np.array(seen.image)
    image[part] = 60
    found = find_board(image, CIRCLES)
    assert 0 < len(found.ids) < CIRCLES.count
    assert np.sqrt(np.mean((found.corners_px - seen.marks_px[found.ids]) ** 2)) < RMS_PX


def test_the_middle_of_a_grid_is_refused_as_ambiguous():
    seen = shot(CIRCLES, 15, 60, 0)
    image = np.full_like(seen.image, 70)
    image[300:700, 400:900] = seen.image[300:700, 400:900]
    with pytest.raises(CalibrationError, match="they may be any of") as refusal:
        find_board(image, CIRCLES)
    assert "ChArUco" in refusal.value.hint


def covered(image, marks_px, columns, generator):
    """Lay a grey or a white sheet over a part of the image, often along the board; or cut the image off."""
    image, (height, width) = np.array(image), image.shape
    level = int(generator.choice([60, np.percentile(image, 97)]))
    how = generator.integers(3)
    if how == 0:
        middle, size = generator.uniform((0, 0), (width, height)), generator.uniform(60, 400, 2)
        corners = cv2.boxPoints((middle.tolist(), size.tolist(), float(generator.uniform(0, 180))))
        return cv2.fillConvexPoly(image, corners.astype(int), level)
    if how == 1:
        left, right = sorted(generator.integers(0, width, 2))
        top, bottom = sorted(generator.integers(0, height, 2))
        cut = np.full_like(image, 70)
        cut[top:bottom, left:right] = image[top:bottom, left:right]
        return cut
    along = marks_px[int(generator.choice([1, 2 * columns]))] - marks_px[0]
    angle = np.arctan2(along[1], along[0]) + (generator.normal(0, 0.03) if generator.random() < 0.6 else generator.uniform(0, 2 * np.pi))
    edge = marks_px[generator.integers(len(marks_px))] + generator.normal(0, 10, 2)
    y, x = np.mgrid[:height, :width]
    beyond = (x - edge[0]) * np.sin(angle) > (y - edge[1]) * np.cos(angle)
    image[beyond if generator.random() < 0.5 else ~beyond] = level
    return image


@pytest.mark.parametrize("covers", [2, pytest.param(20, marks=pytest.mark.slow)])
@pytest.mark.parametrize("board", [CIRCLES, BOARD, SYMMETRIC], ids=["7x15", "4x9", "symmetric"])
def test_no_circle_is_ever_taken_for_another_one(board, covers, generator):
    used = 0
    for tilt, roll, aside in itertools.product((0, 50), (0, 133, 270), ((0.0, 0.0), (90.0, 60.0))):
        seen = shot(board, tilt, 100, roll, QUARTER, aside_mm=aside)
        for _ in range(covers):
            try:
                found = find_board(covered(seen.image, seen.marks_px, board.columns, generator), board)
            except CalibrationError:
                continue
            ids = (found.ids, board.count - 1 - found.ids) if board.is_symmetric else (found.ids,)
            off = min((found.corners_px - seen.marks_px[one] for one in ids), key=lambda one: np.abs(one).max())
            assert np.abs(off).max() < WORST_PX
            assert np.median(np.abs(off)) < RMS_PX / 2  # of those that nothing cuts
            used += len(found.ids) < board.count
    assert used >= covers
