"""Sightings of whole boards and of parts meet by the ids of their corners."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.sightings import Sighting


def test_a_sighting_without_ids_holds_all_corners_in_order():
    np.testing.assert_array_equal(Sighting("left", "00", np.zeros((6, 2))).ids, np.arange(6))


def test_what_was_found_keeps_ids_and_standard_deviations():
    found = Sighting("", "", np.array([[1.0, 2.0], [3.0, 4.0]]), np.array([3, 7]), np.array([0.02, 0.05]), 2.5)
    sighting = found.of("left", "03")
    assert sighting.ids is not None
    np.testing.assert_array_equal(sighting.ids, [3, 7])
    np.testing.assert_array_equal(sighting.sigma_px, found.sigma_px)


def test_ids_must_belong_to_corners():
    with pytest.raises(ValueError, match="shape"):
        Sighting("left", "00", np.zeros((3, 2)), np.array([0, 1]))
