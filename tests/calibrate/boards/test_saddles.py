"""Saddle points are corners of squares and nothing else, and the grid that grows from them is the board's."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from measureapp.calibrate.boards.saddles import Saddles, find_saddles, grow_grid
from tests.calibrate.virtual_board import CHECKER, HALF, shot


def lattice(rows, columns, first, missing=()):
    """Saddles of a board in perspective, ``first`` (row, column) the strongest, and where each lies."""
    places = [first] + [(row, column) for row in range(rows) for column in range(columns) if (row, column) not in (first, *missing)]
    matrix = np.array([[30.0, 6.0, 100.0], [-4.0, 26.0, 80.0], [0.012, 0.004, 1.0]])
    high = np.array([(column, row, 1.0) for row, column in places]) @ matrix.T
    seconds = np.array([(1.0 - 2 * ((row + column) % 2), 0.0) for row, column in places])
    return Saddles(high[:, :2] / high[:, 2:], seconds), places


def neighbours_of(grid, there, points):
    """Pairs of saddles that the grid has side by side."""
    number = {tuple(point): index for index, point in enumerate(points)}
    pairs = set()
    for axis in (0, 1):
        first, second = np.moveaxis(grid, axis, 0)[:-1], np.moveaxis(grid, axis, 0)[1:]
        both = np.moveaxis(there, axis, 0)[:-1] & np.moveaxis(there, axis, 0)[1:]
        pairs |= {frozenset((number[tuple(one)], number[tuple(other)])) for one, other in zip(first[both], second[both], strict=True)}
    return pairs


@pytest.mark.parametrize("first", [(4, 4), (0, 0), (1, 5), (7, 9), (3, 0)])
def test_the_whole_board_grows_from_any_corner(first):
    saddles, places = lattice(8, 10, first)
    grid, there = grow_grid(saddles)
    assert there.all() and sorted(there.shape) == [8, 10]
    pairs = neighbours_of(grid, there, saddles.points_px)
    assert all(abs(places[a][0] - places[b][0]) + abs(places[a][1] - places[b][1]) == 1 for a, b in pairs)


def test_a_step_that_passes_a_nearer_corner_by_starts_no_grid():
    """Beside a missing corner only knight's moves have an opposite: the grid of such steps would be another, sheared one."""
    saddles, places = lattice(8, 10, (4, 4), missing=[(3, 4)])
    grid, there = grow_grid(saddles)
    assert there.sum() == 79 and sorted(there.shape) == [8, 10]
    assert all(
        abs(places[a][0] - places[b][0]) + abs(places[a][1] - places[b][1]) == 1 for a, b in neighbours_of(grid, there, saddles.points_px)
    )


def test_saddles_of_unrelated_places_form_no_grid(generator):
    points = generator.uniform(0, 900, size=(60, 2))
    seconds = np.where(generator.random(60) < 0.5, 1.0, -1.0)
    found = grow_grid(Saddles(points, np.column_stack([seconds, np.zeros(60)])))
    assert found is None or found[1].sum() < 15


def test_no_corner_of_a_board_is_overlooked_and_nothing_else_is_one():
    seen = shot(CHECKER, 35, size=HALF)
    points = find_saddles(seen.image).points_px
    away = np.linalg.norm(points[:, None] - seen.marks_px, axis=2)
    assert away.min(axis=0).max() < 1.0
    assert np.count_nonzero(away.min(axis=1) > 2.0) == 0


@pytest.mark.parametrize("grey", [0, 128, 255])
def test_an_image_of_nothing_has_no_saddles(grey):
    assert len(find_saddles(np.full((300, 400), grey, np.uint8)).points_px) == 0
    assert grow_grid(Saddles(np.empty((0, 2)), np.empty((0, 2)))) is None


def test_noise_and_lines_form_no_grid(generator):
    image = np.clip(generator.normal(120, 12, size=(480, 640)), 0, 255).astype(np.uint8)
    for at in range(20, 480, 30):
        cv2.line(image, (0, at), (639, at + 10), 220, 5)
    found = grow_grid(find_saddles(image))
    assert found is None or found[1].sum() < 15
