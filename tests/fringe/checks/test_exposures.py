"""What other exposures predict of an image is their median, whichever of them could see a pixel."""

from __future__ import annotations

import numpy as np

from measureapp.fringe.checks.exposures import median_of_others


def test_the_median_of_the_others_with_and_without_gaps_and_ties() -> None:
    rng = np.random.default_rng(6)
    for count in range(2, 7):
        radiance = rng.integers(0, 5, (count, 2, 3, 40)).astype(float)  # few values: many are equal
        radiance[rng.random(radiance.shape) < 0.3] = np.nan
        ordered = np.sort(radiance, axis=0)
        for level in range(count):
            others = np.sort(np.delete(radiance, level, axis=0), axis=0)
            known = np.isfinite(others).sum(axis=0)
            lower = np.take_along_axis(others, np.maximum(known - 1, 0)[None] // 2, axis=0)[0]  # of two in the middle the smaller one
            np.testing.assert_array_equal(median_of_others(radiance, ordered, level), lower)
