"""What is said of how well two cameras fit, from samples."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.reconstruct.matching.figures import MIN_SAMPLES, evaluate_pair


def samples(count: int, shift_px: float, sigma_px: float = 0.1) -> np.ndarray:
    """Return distances about ``shift_px`` and their variance, (count, 2)."""
    off = np.random.default_rng(1).normal(shift_px, sigma_px, count)
    return np.column_stack([off, np.full(count, sigma_px**2)])


def test_the_figure_of_many_samples_is_the_shift_behind_their_noise() -> None:
    figures = evaluate_pair(("left", "right"), 1000, [samples(1000, 0.5)])
    # the standard error of the median is 1.25 · 0.1 / √1000 = 0.004
    assert figures.epipolar_px == pytest.approx(0.5, abs=4 * 0.004)


def test_few_samples_give_no_figure_in_either_direction() -> None:
    few = samples(MIN_SAMPLES - 1, 7.0)
    figures = evaluate_pair(("left", "right"), 1000, [few], few)
    assert figures.epipolar_px is None and figures.epipolar_rms_px is None and figures.across_px is None
