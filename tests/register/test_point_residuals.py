"""Distances of single points from the merged surface."""

from __future__ import annotations

import numpy as np

from measureapp.data.cloud import StitchedCloud
from measureapp.register.point_residuals import REACH_MM, MergedSurface


def flat_cloud(seed: int = 1, count: int = 20_000) -> StitchedCloud:
    points = np.random.default_rng(seed).uniform(-50, 50, (count, 3)) * [1, 1, 0]
    normals = np.tile([0.0, 0.0, 1.0], (count, 1))
    return StitchedCloud(points, normals, np.full(count, 0.01), np.full(count, 0.5), np.zeros(count, int), ())


def test_the_distance_is_taken_along_the_normal_whatever_the_gaps_between_the_points():
    surface, rng = MergedSurface(flat_cloud()), np.random.default_rng(2)
    heights = rng.normal(0, 0.02, 500)
    points = np.column_stack([rng.uniform(-40, 40, (500, 2)), heights])
    residuals, nearest = surface.residuals(points)
    assert np.allclose(residuals, heights)
    assert (nearest < 20_000).all()


def test_a_point_with_nothing_near_is_not_known():
    residuals, nearest = MergedSurface(flat_cloud()).residuals(np.array([[0, 0, 2 * REACH_MM], [0, 0, 0.5]]))
    assert np.isnan(residuals[0]) and nearest[0] == 20_000
    assert np.isclose(residuals[1], 0.5)


def test_the_spread_at_a_merged_point_is_the_rms_of_the_residuals_next_to_it():
    surface = MergedSurface(flat_cloud(count=3))
    spread = surface.rms_per_point(np.array([0.03, -0.04, np.nan, 0.1]), np.array([0, 0, 3, 2]))
    assert np.allclose(spread, [np.sqrt((0.03**2 + 0.04**2) / 2), np.nan, 0.1], equal_nan=True)
