"""Errors that neighbouring points share widen the standard deviation of a mean."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.inspection.uncertainty import shared_error_factor

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
    found = [shared_error_factor(*patch(half_mm, 4000, 0, seed), CORRELATION_MM) for seed in range(20)]
    assert 1.0 <= np.mean(found) < 1.1


@pytest.mark.parametrize(("half_mm", "shared_mm", "count"), [(5.0, 0.5, 4000), (40.0, 4.0, 4000)])
def test_shared_errors_show_in_small_and_in_large_patches(half_mm: float, shared_mm: float, count: int) -> None:
    per_square = count * (shared_mm / (2 * half_mm)) ** 2
    found = [shared_error_factor(*patch(half_mm, count, shared_mm, seed), CORRELATION_MM) for seed in range(20)]
    assert np.mean(found) == pytest.approx(np.sqrt(0.5 * (1 + per_square)), rel=0.2)


def test_a_few_points_have_no_neighbours() -> None:
    assert shared_error_factor(np.zeros((1, 3)), np.ones(1), CORRELATION_MM) == 1.0
    assert shared_error_factor(np.eye(3), np.zeros(3), CORRELATION_MM) == 1.0
