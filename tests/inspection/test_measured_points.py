"""Points that stand for all others, spread evenly over a surface."""

from __future__ import annotations

import numpy as np

from measureapp.inspection.measured_points import thin_indices

NOISE_MM = 0.02


def wall(count: int) -> np.ndarray:
    """A noisy wall of 100 × 100 mm, its points sorted by place as those of a merged cloud are."""
    rng = np.random.default_rng(3)
    points = np.column_stack([rng.normal(0.0, NOISE_MM, count), rng.uniform(0, 100, (count, 2))])
    return points[np.argsort(points[:, 0])]


def test_thinned_points_lie_to_no_side_of_a_noisy_wall() -> None:
    points = wall(200_000)
    chosen = thin_indices(points, 2000)
    assert 1600 <= len(chosen) <= 2400
    assert abs(points[chosen, 0].mean()) < 4 * NOISE_MM / np.sqrt(len(chosen))
    assert np.all(np.diff(chosen) > 0)
    quarters = np.histogram2d(points[chosen, 1], points[chosen, 2], bins=2, range=[[0, 100], [0, 100]])[0]
    assert quarters.min() > 0.8 * quarters.mean()


def test_strays_are_not_taken_for_surface() -> None:
    strays = np.random.default_rng(4).uniform([5, 0, 0], 100, (100, 3))
    points = np.vstack([wall(200_000), strays])
    chosen = thin_indices(points, 2000)
    assert np.sum(chosen >= 200_000) == 0


def test_few_points_all_stay() -> None:
    np.testing.assert_array_equal(thin_indices(wall(50), 100), np.arange(50))
    sparse = thin_indices(wall(300), 100)
    assert 80 <= len(sparse) <= 120
