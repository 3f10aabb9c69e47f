"""A head whose cameras moved is found from the epipolar residuals of a scan."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.calibrate.drift import epipolar_drift
from measureapp.errors import CalibrationError

DISTANCE_MM = 550.0


def residuals(generator, sigma_px, offset_px=0.0):
    wrong = generator.uniform(-20, 20, 50)  # wrong matches
    return np.concatenate([generator.normal(offset_px, sigma_px, 2000), wrong])


def test_the_noise_of_a_good_calibration_is_good(head, generator):
    finding = epipolar_drift(0.1, residuals(generator, 0.12), head, DISTANCE_MM)
    assert finding.verdict == "good"
    assert finding.residual_px == pytest.approx(0.12, rel=0.1)


def test_a_knocked_head_is_found_and_told_in_pixels_and_millimetres(head, generator):
    finding = epipolar_drift(0.1, residuals(generator, 0.12, 1.5), head, DISTANCE_MM)
    assert finding.verdict == "drifted"
    assert finding.error_mm == pytest.approx(1.5 * DISTANCE_MM / head.cameras["left"].pinhole.matrix[0, 0], rel=0.05)
    assert "px" in finding.sentence and "mm" in finding.sentence and "calibrate them again" in finding.sentence


def test_a_small_change_asks_for_a_check(head, generator):
    assert epipolar_drift(0.1, residuals(generator, 0.12, 0.25), head, DISTANCE_MM).verdict == "watch"


def test_a_calibration_that_left_next_to_nothing_does_not_cry_wolf(head, generator):
    assert epipolar_drift(0.001, residuals(generator, 0.06), head, DISTANCE_MM).verdict == "good"


@pytest.mark.parametrize("given", [np.zeros(10), np.full(500, np.nan)])
def test_too_few_or_missing_residuals_are_refused(head, given):
    with pytest.raises(CalibrationError, match="do not tell"):
        epipolar_drift(0.1, given, head, DISTANCE_MM)
