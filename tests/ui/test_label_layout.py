"""Labels stand near what they name and not over one another."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from ui.viewport.overlay.label_layout import place_labels

PICTURE, SIZE = (800, 600), (120, 26)


def boxes(anchors: np.ndarray) -> list[tuple[float, float, float, float]]:
    offsets = place_labels(anchors, [SIZE] * len(anchors), PICTURE)
    corners = anchors + np.array(offsets)
    return [(x, y, x + SIZE[0], y + SIZE[1]) for x, y in corners.tolist()]


def overlap(one, other) -> bool:
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


def test_labels_of_one_place_fan_out_without_touching_and_stay_in_the_picture():
    placed = boxes(np.tile([400.0, 300.0], (8, 1)))
    assert not any(overlap(one, other) for one, other in combinations(placed, 2))
    assert all(x0 >= 0 and x1 <= PICTURE[0] and y0 >= 0 and y1 <= PICTURE[1] for x0, y0, x1, y1 in placed)


def test_a_label_at_the_edge_stands_inside_the_picture():
    corners = np.array([[2.0, 2.0], [798.0, 2.0], [2.0, 598.0], [798.0, 598.0]])
    assert all(x0 >= 0 and x1 <= PICTURE[0] and y0 >= 0 and y1 <= PICTURE[1] for x0, y0, x1, y1 in boxes(corners))


def test_one_that_finds_no_room_is_still_placed_beside_what_it_names():
    offsets = place_labels(np.tile([30.0, 20.0], (3, 1)), [(60, 40)] * 3, (70, 50))
    assert len(offsets) == 3
