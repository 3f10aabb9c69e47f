"""The sum of exposures is as good as the images allow: against the best weights, and against the Cramér-Rao bound."""

from __future__ import annotations

from math import sqrt, tau

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.fringe import PatternSet, PhaseShiftGroup
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.decode import decode
from measureapp.fringe.exposures.weights import WHOLE_SUM, exposure_weights, sigma_loss
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.settings import DecodeSettings
from tests.fringe.conftest import EXPOSURES_US, images_of, ramp, stack_of

WIDE_US = (100_000, 25_000, 6_000)
CAMERAS = [
    (CameraNoise(), 255),
    (CameraNoise(full_well_e=10_000, read_noise_e=8), 4095),
    (CameraNoise(full_well_e=10_000, read_noise_e=2.5), 4095),
    (CameraNoise(full_well_e=60_000, read_noise_e=60), 255),
]
BRACKETS = [EXPOSURES_US, (100, 50, 25), WIDE_US, (160, 40, 10), (100, 30, 10, 3), (100, 10)]


def least_modulation(saturation: float) -> float:
    return DecodeSettings().min_modulation_grey(saturation)


@pytest.mark.parametrize(("noise", "saturation"), CAMERAS)
@pytest.mark.parametrize("exposures", BRACKETS)
def test_the_weights_lose_at_most_two_per_cent_of_the_best_for_every_pixel_that_can_be_decoded(
    noise: CameraNoise, saturation: int, exposures: tuple[int, ...]
) -> None:
    weights = np.array(exposure_weights(exposures, noise, saturation, least_modulation(saturation)))
    shares = np.array(exposures) / exposures[0]
    assert (weights >= 1).all() and weights.sum() <= WHOLE_SUM
    grey = np.geomspace(least_modulation(saturation) / 0.9, 0.55 * saturation, 30)
    assert sigma_loss(weights, shares, grey, noise, saturation).max() < 0.021  # between the levels it was chosen at


def test_the_plain_sum_of_the_papers_bracket_is_within_two_per_cent_and_kept() -> None:
    assert exposure_weights(EXPOSURES_US, CameraNoise(), 255, least_modulation(255)) == (1,) * 5
    shares = np.array(EXPOSURES_US) / EXPOSURES_US[0]
    assert sigma_loss(np.ones(5), shares, np.array([11.1, 20.0, 50.0, 120.0]), CameraNoise(), 255).max() < 0.02


@pytest.mark.parametrize("exposures", [EXPOSURES_US, WIDE_US], ids=["paper", "wide"])
@pytest.mark.parametrize(("mean", "modulation"), [(14.0, 11.0), (110.0, 80.0)], ids=["dark", "bright"])
def test_the_scatter_of_the_phase_is_that_of_the_best_combination_of_the_exposures(
    exposures: tuple[int, ...], mean: float, modulation: float
) -> None:
    column = ramp(150, 400)
    images = images_of(column, PAPER_PATTERNS, exposures, mean, modulation, seed=3)
    found = decode(stack_of(images, exposures_us=exposures), DecodeSettings(vote_radius=0, max_sigma_rad=1.0, min_modulation=5.0))["left"]
    error = ((found.column_px - column) * tau / 32)[found.valid]
    right = error[np.abs(error) < np.pi]
    shares = np.array(exposures) / exposures[0]
    each = 2 / 4 * CameraNoise().variance(mean * shares, 255) / (modulation * shares) ** 2  # of one pitch and exposure
    best = 1 / sqrt(float((1 / each).sum()) * (1 + (32 / 33) ** 2))
    scatter = float(np.sqrt(np.mean(right**2)))
    drawn = 3 / sqrt(2 * len(right))  # relative, of a scatter from so many pixels
    assert best * (1 - drawn) < scatter < best * (1.02 + drawn)
    assert float(np.median(found.sigma_rad[found.valid])) == pytest.approx(scatter, rel=0.06)  # by the noise of so many pixels


def cramer_rao_sigma(
    phase: FloatArray, mean: float, modulation: float, patterns: PatternSet, shares: FloatArray, noise: CameraNoise
) -> FloatArray:
    """The bound on the standard deviation of the absolute phase, where mean, modulation and phase of every pitch are unknown, (K,).

    Normal images with the variance of their own mean grey level (shot, read and quantisation noise) have the Fisher information
    Σ J Jᵀ/v + ½ Σ (∂v) (∂v)ᵀ/v² [1]_; of the unknowns the phase's information is what the others leave of it.

    References
    ----------
    .. [1] S. M. Kay, Fundamentals of Statistical Signal Processing: Estimation Theory, 1993, eq. 3.31.
    """
    per_grey = 1 / noise.electrons_per_grey(255)
    total = np.zeros(len(phase))
    for group in patterns.groups:
        assert isinstance(group, PhaseShiftGroup)
        scale = patterns.finest_pitch_px / group.pitch_px
        information = np.zeros((len(phase), 3, 3))
        for share in shares:
            angle = (phase * scale)[:, None] + patterns.shift_sign * tau * np.arange(group.steps) / group.steps
            variance = noise.variance(share * (mean + modulation * np.cos(angle)), 255)
            slope = share * np.stack([np.ones_like(angle), np.cos(angle), -modulation * np.sin(angle)], axis=1)
            information += np.einsum("kin,kjn->kij", slope / variance[:, None], slope)
            information += np.einsum("kin,kjn->kij", per_grey * slope / variance[:, None], per_grey * slope / variance[:, None]) / 2
        total += scale**2 / np.linalg.inv(information)[:, 2, 2]
    return np.asarray(1 / np.sqrt(total))


@pytest.mark.parametrize("exposures", [EXPOSURES_US[:1], EXPOSURES_US, WIDE_US], ids=["one", "paper", "wide"])
@pytest.mark.parametrize(("mean", "modulation"), [(14.0, 11.0), (40.0, 28.0), (110.0, 80.0), (130.0, 105.0)])
def test_phase_noise_stays_within_twelve_per_cent_of_the_cramer_rao_bound_for_noise_that_depends_on_the_signal(
    exposures: tuple[int, ...], mean: float, modulation: float
) -> None:
    column = ramp(150, 400)
    images = images_of(column, PAPER_PATTERNS, exposures, mean, modulation, seed=4)
    found = decode(stack_of(images, exposures_us=exposures), DecodeSettings(vote_radius=0, max_sigma_rad=1.0, min_modulation=5.0))["left"]
    error = np.where(found.valid, (found.column_px - column) * tau / 32, np.inf)
    right = np.abs(error) < np.pi
    phases = np.linspace(0, 33 * tau, 2000, endpoint=False)  # all phases of both pitches occur equally often
    bound = cramer_rao_sigma(phases, mean, modulation, PAPER_PATTERNS, np.array(exposures) / exposures[0], CameraNoise())
    least = float(np.sqrt(np.mean(bound**2)))
    scatter = float(np.sqrt(np.mean(error[right] ** 2)))
    drawn = 3 / sqrt(2 * right.sum())
    assert least * (1 - drawn) < scatter < 1.12 * least * (1 + drawn)


def test_repaired_orders_leave_no_more_noise_than_right_ones() -> None:
    column = ramp(150, 400)
    images = images_of(column, PAPER_PATTERNS, EXPOSURES_US[:1], 40.0, 28.0, seed=4)
    found = decode(stack_of(images, exposures_us=EXPOSURES_US[:1]), DecodeSettings(max_sigma_rad=1.0, min_modulation=5.0))["left"]
    assert found.details["orders_repaired"] > 0.02 * column.size
    error = np.where(found.valid, (found.column_px - column) * tau / 32, np.inf)
    right = np.abs(error) < np.pi
    phases = np.linspace(0, 33 * tau, 2000, endpoint=False)
    bound = cramer_rao_sigma(phases, 40.0, 28.0, PAPER_PATTERNS, np.ones(1), CameraNoise())
    scatter = float(np.sqrt(np.mean(error[right] ** 2)))
    assert scatter < 1.12 * float(np.sqrt(np.mean(bound**2))) * (1 + 3 / sqrt(2 * right.sum()))
