"""Deviations between views, sorted by a property of their points."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.pipeline.consistency.dependence import CHANCE, Dependence, compare_with_expected, estimate_dependence

CLASSES, NOISE_MM, MODEL_MM = 12, 0.01, 0.004


def drawn(rng: np.random.Generator, unexplained_mm: float = 0.0, model_mm: float = MODEL_MM) -> Dependence:
    """Return the dependence found on 3000 deviations whose classes err as the model says, and by ``unexplained_mm`` more."""
    own, other = rng.integers(0, CLASSES, (2, 3000))
    fields = rng.normal(size=(CLASSES, 4)) * MODEL_MM / 2  # the model's errors are a function of the class
    expected = fields[own] - fields[other]
    more = rng.normal(0, unexplained_mm, CLASSES)
    distance = expected @ rng.normal(size=4) * model_mm / MODEL_MM + more[own] - more[other] + rng.normal(0, NOISE_MM, len(own))
    found = estimate_dependence(distance, expected, own, other)
    assert found is not None
    return found


def test_chance_raises_nothing_where_the_model_is_right() -> None:
    found = [drawn(np.random.default_rng(seed)) for seed in range(300)]
    assert np.mean([one.unexplained_mm > 0 for one in found]) < CHANCE + 4 * np.sqrt(CHANCE / 300)
    assert np.median([one.probability for one in found]) == pytest.approx(0.5, abs=0.15)
    ratio = np.mean([one.observed_mm**2 for one in found]) / np.mean([one.expected_mm**2 for one in found])
    assert ratio == pytest.approx(1.0, abs=0.15)


@pytest.mark.parametrize("size_mm", [0.02, 0.1])
def test_what_the_model_lacks_is_found_in_its_size(size_mm: float) -> None:
    found = [drawn(np.random.default_rng(seed), size_mm).unexplained_mm for seed in range(60)]
    assert np.sqrt(np.mean(np.square(found))) == pytest.approx(size_mm, rel=0.2)


def test_points_that_share_their_class_show_nothing() -> None:
    own = np.arange(600) % 6
    assert estimate_dependence(np.ones(600), np.zeros((600, 1)), own, own) is None
    assert estimate_dependence(np.ones(600), np.zeros((600, 1)), np.full(600, -1), own) is None


def test_a_gap_is_unexplained_only_beyond_chance() -> None:
    assert compare_with_expected(0.015, 0.01, 3.0).unexplained_mm == 0
    assert compare_with_expected(0.05, 0.01, 3.0).unexplained_mm == pytest.approx(np.sqrt(0.05**2 - 0.01**2))
