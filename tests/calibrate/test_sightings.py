"""Sightings of whole boards and of parts meet by the ids of their corners."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.sightings import FoundBoard, Sighting, shared_corners, sighting_of


def part(camera, ids):
    return Sighting(camera, "00", np.array(ids, float)[:, None] * [1.0, 2.0], np.array(ids))


def test_two_parts_share_the_corners_both_hold():
    first, second = part("left", [1, 4, 5, 9]), part("right", [0, 4, 9, 11])
    ids, at_first, at_second = shared_corners(first, second)
    np.testing.assert_array_equal(ids, [4, 9])
    np.testing.assert_array_equal(first.corners_px[at_first], second.corners_px[at_second])


def test_a_sighting_without_ids_holds_all_corners_in_order():
    whole = Sighting("left", "00", np.zeros((6, 2)))
    ids, at_first, _ = shared_corners(whole, part("right", [2, 5]))
    np.testing.assert_array_equal(whole.known_ids, np.arange(6))
    np.testing.assert_array_equal(ids, at_first)
    np.testing.assert_array_equal(ids, [2, 5])


def test_what_was_found_keeps_ids_and_standard_deviations():
    found = FoundBoard(np.array([3, 7]), np.array([[1.0, 2.0], [3.0, 4.0]]), np.array([0.02, 0.05]), 2.5)
    sighting = sighting_of("left", "03", found)
    assert sighting.ids is not None
    np.testing.assert_array_equal(sighting.ids, [3, 7])
    np.testing.assert_array_equal(sighting.sigma_px, found.sigma_px)


def test_ids_must_belong_to_corners():
    with pytest.raises(ValueError, match="shape"):
        Sighting("left", "00", np.zeros((3, 2)), np.array([0, 1]))
