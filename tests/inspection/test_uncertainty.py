"""Errors that neighbouring points share widen the standard deviation of a mean."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.inspection.features.surface_point import QUADRIC
from measureapp.inspection.uncertainty import correlation_factor

CORRELATION_MM = 8.0


def patch(half_mm: float, count: int, shared_mm: float, seed: int) -> tuple[FloatArray, FloatArray]:
    """Points on a plane whose errors are alike within squares of ``shared_mm``, half of their variance; 0: independent."""
    rng = np.random.default_rng(seed)
    points = np.column_stack([rng.uniform(-half_mm, half_mm, (count, 2)), np.zeros(count)])
    own = rng.normal(size=count)
    if shared_mm == 0:
        return points, own
    cell = np.unique(np.floor(points[:, :2] / shared_mm), axis=0, return_inverse=True)[1].ravel()
    return points, np.sqrt(0.5) * (own + rng.normal(size=cell.max() + 1)[cell])


@pytest.mark.parametrize("half_mm", [5.0, 40.0])
def test_independent_errors_widen_nothing(half_mm: float) -> None:
    found = [correlation_factor(*patch(half_mm, 4000, 0, seed), CORRELATION_MM) for seed in range(20)]
    assert 1.0 <= np.mean(found) < 1.1


@pytest.mark.parametrize(("half_mm", "shared_mm", "count"), [(5.0, 0.5, 4000), (40.0, 4.0, 4000)])
def test_shared_errors_show_in_small_and_in_large_patches(half_mm: float, shared_mm: float, count: int) -> None:
    per_square = count * (shared_mm / (2 * half_mm)) ** 2
    found = [correlation_factor(*patch(half_mm, count, shared_mm, seed), CORRELATION_MM) for seed in range(20)]
    assert np.mean(found) == pytest.approx(np.sqrt(0.5 * (1 + per_square)), rel=0.2)


def test_a_point_of_a_small_patch_errs_as_much_as_its_neighbours_share() -> None:
    """Errors alike over 1 mm, in patches of 10 mm: the factor states what the height of a quadric at the middle scatters by.

    Of the scatter 200 patches tell 5 %. Of the factor a part goes missing, as the quadric takes off what is alike over half the patch.
    """
    heights, stated = [], []
    for seed in range(200):
        points, errors = patch(5.0, 2000, 1.0, seed)
        u, v, _ = points.T
        design = np.column_stack([np.ones_like(u), u, v, u * u, u * v, v * v])
        solution, *_ = np.linalg.lstsq(design, errors)
        residuals = errors - design @ solution
        own = np.sqrt(residuals @ residuals / (len(errors) - QUADRIC) * np.linalg.inv(design.T @ design)[0, 0])
        heights.append(solution[0])
        stated.append(own * correlation_factor(points, residuals, CORRELATION_MM, QUADRIC))
    assert np.std(heights) == pytest.approx(np.sqrt(np.mean(np.square(stated))), rel=0.15)


def test_a_few_points_have_no_neighbours() -> None:
    assert correlation_factor(np.zeros((1, 3)), np.ones(1), CORRELATION_MM) == 1.0
    assert correlation_factor(np.eye(3), np.zeros(3), CORRELATION_MM) == 1.0
