"""The distance of two clicked points and its uncertainty."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.inspection.point_distance import point_distance
from measureapp.inspection.settings import UncertaintySettings

EXACT = UncertaintySettings(placement_mm=0.0, systematic_mm=0.0, systematic_relative=0.0)


def test_the_interval_holds_the_true_distance_in_95_of_100_cases_where_the_noise_runs_along_it():
    rng, truth = np.random.default_rng(3), np.array([[0.0, 0, 0], [120.0, 0, 0]])
    trials, sigmas, held = 4000, (0.02, 0.03), 0
    for _ in range(trials):
        noisy = truth + np.column_stack([rng.normal(0, sigmas), np.zeros((2, 2))])
        value, uncertainty = point_distance(noisy, sigmas, same_view=True, settings=EXACT)
        held += abs(value - 120.0) <= uncertainty
    share = 0.9545
    assert abs(held / trials - share) < 4 * np.sqrt(share * (1 - share) / trials)


def test_points_of_two_views_and_long_distances_are_less_certain():
    near, far = np.array([[0.0, 0, 0], [10.0, 0, 0]]), np.array([[0.0, 0, 0], [1000.0, 0, 0]])
    settings = UncertaintySettings()
    one, two = (point_distance(near, (0.01, 0.01), same)[1] for same in (True, False))
    assert two**2 - one**2 == pytest.approx(4 * 2 * settings.placement_mm**2)
    long = point_distance(far, (0.01, 0.01), same_view=True)[1]
    assert long**2 - one**2 == pytest.approx(4 * settings.systematic_relative**2 * (1000.0**2 - 10.0**2))
