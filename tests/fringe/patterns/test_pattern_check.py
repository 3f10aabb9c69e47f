from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.fringe import PatternSet, PhaseShiftGroup
from measureapp.data.pattern_sets import PAPER_PATTERNS, PATTERN_SETS
from measureapp.errors import DecodeError
from measureapp.fringe.decode import decode
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.patterns.check import Contrast, check_patterns, order_decisions, wrapped_sigmas
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.unwrap import HeterodynePlan, plan_heterodyne
from tests.fringe.conftest import images_of, ramp, stack_of

TAU = 2 * np.pi
SIZE = 1024, 768
PIXELS = 1_000_000


def seen_with(sigma_rad: float, patterns: PatternSet) -> Contrast:
    """The contrast at which the wrapped phases of a set of four steps have this noise."""
    noise = Contrast().noise.variance(np.array(110.0), 255)
    contrast = Contrast(110.0, float(np.sqrt(noise / 2) / sigma_rad))
    assert wrapped_sigmas(patterns, contrast) == pytest.approx([sigma_rad] * len(patterns.pitches_px))
    return contrast


def wrong_orders(patterns: PatternSet, sigma_rad: float, seed: int) -> tuple[np.ndarray, HeterodynePlan]:
    """Unwrap noisy phases step by step as the plan says; return by how many orders of the finest pitch each pixel is off."""
    random = np.random.default_rng(seed)
    column = random.uniform(0, 1024, PIXELS)
    pitch = np.array(patterns.pitches_px)[:, None]
    phase = np.angle(np.exp(1j * (TAU * column / pitch + random.normal(0, sigma_rad, (len(pitch), PIXELS)))))
    plan = plan_heterodyne(patterns)
    factors, frequencies = np.array(plan.combinations), plan.frequencies
    value = np.mod(factors[0] @ phase + TAU * plan.guard, TAU) - TAU * plan.guard
    for k in range(1, len(factors)):
        wrapped = factors[k] @ phase
        value = wrapped + TAU * np.rint((value * frequencies[k] / frequencies[k - 1] - wrapped) / TAU)
    return np.rint((value - TAU * column / pitch.min()) / TAU), plan


@pytest.mark.parametrize(("sigma_rad", "stated"), [(0.0228, 2.72e-3), (0.03, 2.27e-2)])
def test_the_papers_order_errors_come_as_often_as_predicted(sigma_rad: float, stated: float) -> None:
    predicted = check_patterns(PAPER_PATTERNS, *SIZE, seen_with(sigma_rad, PAPER_PATTERNS))[0].order_error_probability
    assert predicted == pytest.approx(stated, rel=0.01)
    wrong, _ = wrong_orders(PAPER_PATTERNS, sigma_rad, 1)
    assert (wrong != 0).mean() == pytest.approx(predicted, abs=4 * np.sqrt(predicted / PIXELS))


@pytest.mark.parametrize(("name", "sigma_rad"), [("three-close", 0.12), ("three-wide", 0.16), ("three-wide-32", 0.2)])
def test_order_errors_of_three_pitches_come_as_often_as_predicted(name: str, sigma_rad: float) -> None:
    patterns = PATTERN_SETS[name]
    made = order_decisions(patterns, seen_with(sigma_rad, patterns))
    predicted = sum(decision.error_probability for decision in made[1:])
    wrong, plan = wrong_orders(patterns, sigma_rad, 2)
    range_orders = 1024 / patterns.finest_pitch_px / plan.frequencies[0]
    inside = np.abs(wrong) < 0.75 * range_orders  # what wraps at the edge of the range is the first decision's error
    found = (wrong[inside] != 0).mean()
    # the decisions of one chain share their phases: the sum of their probabilities is an upper bound, the largest a lower one
    largest = max(decision.error_probability for decision in made[1:])
    assert largest > 1e-4
    assert 0.9 * largest < found < 1.05 * predicted


@pytest.mark.parametrize(
    ("mean", "modulation", "probability"),
    [(110, 100, 1e-5), (110, 80, 4.6e-4), (80, 60, 2e-3), (60, 40, 2e-2), (40, 25, 8e-2), (25, 15, 0.19)],
)
def test_the_figures_of_the_papers_scheme_at_ordinary_contrasts_are_met(mean: float, modulation: float, probability: float) -> None:
    check = check_patterns(PAPER_PATTERNS, *SIZE, Contrast(mean, modulation))[0]
    assert check.order_error_probability == pytest.approx(probability, rel=0.45)  # the table has one digit
    assert max(decision.amplification for decision in check.decisions) == pytest.approx(45.97, abs=0.01)


def test_the_contrast_for_a_probability_reaches_just_that() -> None:
    check = check_patterns(PAPER_PATTERNS, *SIZE)[0]
    modulation = check.modulation_for["1e-03"]
    assert modulation is not None
    assert check_patterns(PAPER_PATTERNS, *SIZE, Contrast(110, modulation))[0].order_error_probability == pytest.approx(1e-3, rel=1e-3)
    assert check.modulation_for["1e-06"] is None  # B would have to exceed A
    noise = float(np.sqrt(CameraNoise().variance(np.array(110.0), 255)))
    assert modulation / noise == pytest.approx(34, abs=0.5)


def test_a_single_wrapped_phase_and_the_column_have_the_noise_predicted() -> None:
    random = np.random.default_rng(5)
    patterns = PATTERN_SETS["three-close"]
    check = check_patterns(patterns, *SIZE)[0]
    pitch = np.array(patterns.pitches_px)[:, None, None]
    column, shift = random.uniform(0, 1024, 40_000), TAU * np.arange(4)[:, None] / 4
    clean = 110 + 80 * np.cos(TAU * column / pitch - shift)
    electrons = 6000 / 255
    images = np.rint((random.poisson(clean * electrons) + random.normal(0, 7, clean.shape)) / electrons)
    error = np.angle((images * np.exp(1j * shift)).sum(axis=1) * np.exp(-1j * TAU * column / pitch[:, :, 0]))
    assert error.std(axis=1) == pytest.approx(check.phase_sigma_rad, rel=0.02)
    weights = 1 / pitch[:, :, 0] ** 2
    combined = (weights * error * pitch[:, :, 0] / TAU).sum(axis=0) / weights.sum()
    assert combined.std() == pytest.approx(check.column_sigma_px, rel=0.02)


def test_five_exposures_lower_the_noise_as_the_sum_of_their_light_does() -> None:
    one, five = (wrapped_sigmas(PAPER_PATTERNS, Contrast(exposures=shares))[0] for shares in ((1.0,), (1.0, 0.8, 0.6, 0.4, 0.2)))
    assert one / five == pytest.approx(1.71, abs=0.03)


@pytest.mark.parametrize("name", ["three-close", "complementary-gray"])
@pytest.mark.parametrize(("mean", "modulation"), [(14.0, 11.0), (110.0, 80.0)], ids=["dark", "bright"])
def test_a_wide_bracket_gives_the_noise_that_decoding_has(name: str, mean: float, modulation: float) -> None:
    patterns, exposures, column = PATTERN_SETS[name], (100_000, 25_000, 6_000, 1_500), ramp(100, 400)
    images = images_of(column, patterns, exposures, mean, modulation, seed=8)
    shares = tuple(exposure / exposures[0] for exposure in exposures)
    found = decode(stack_of(images, patterns, exposures), DecodeSettings(min_modulation=5.0))["left"]
    error = (found.column_px - column)[found.valid]
    predicted = check_patterns(patterns, *SIZE, Contrast(mean, modulation, exposures=shares[::-1]))[0].column_sigma_px
    assert found.valid.mean() > 0.97
    assert error.std() == pytest.approx(predicted, rel=0.02 + 3 / np.sqrt(2 * error.size))  # and rounding to whole grey levels
    alone = check_patterns(patterns, *SIZE, Contrast(mean, modulation))[0].column_sigma_px
    variances = CameraNoise().variance(mean * np.array(shares), 255)
    plain = alone * float(np.sqrt(variances.sum() / variances[0])) / sum(shares)
    assert (predicted < 0.95 * plain) == (mean < 100)  # the plain sum would add dark noise to dark pixels


def test_exposures_that_are_not_shares_of_the_longest_are_refused() -> None:
    for exposures in ((), (0.5, 0.25), (100.0, 50.0), (1.0, 0.0), (1.0, -0.5)):
        with pytest.raises(DecodeError, match="not relative to the longest"):
            check_patterns(PAPER_PATTERNS, *SIZE, Contrast(exposures=exposures))


def test_bits_of_a_gray_code_are_misread_as_often_as_predicted() -> None:
    random = np.random.default_rng(6)
    contrast = Contrast(30.0, 4.0)
    bits = order_decisions(PATTERN_SETS["complementary-gray"], contrast)[0]
    variance = lambda level: contrast.noise.variance(np.array(level), 255)  # noqa: E731
    threshold = 30 + random.normal(0, np.sqrt(variance(30.0) / 4), PIXELS)
    dark, bright = (level + random.normal(0, np.sqrt(variance(level)), PIXELS) for level in (26.0, 34.0))
    found = ((dark > threshold).mean() + (bright < threshold).mean()) / 2
    assert bits.error_probability == pytest.approx(7 * found, rel=0.03)


def test_a_plain_gray_code_goes_wrong_where_phase_and_bits_change_at_different_places() -> None:
    random = np.random.default_rng(7)
    border = order_decisions(PATTERN_SETS["gray"], Contrast())[1]
    sigma = wrapped_sigmas(PATTERN_SETS["gray"], Contrast())[0]
    share = random.uniform(0, TAU, PIXELS)
    crossed = np.floor((share + random.normal(0, sigma, PIXELS)) / TAU) != 0
    assert crossed.mean() == pytest.approx(border.error_probability, rel=0.1)


def of_pitches(*pitches_px: float) -> PatternSet:
    return PatternSet(name="made", projector_px=1024, groups=tuple(PhaseShiftGroup(pitch_px=pitch) for pitch in pitches_px))


def test_a_set_whose_range_has_no_guard_band_is_refused_with_the_range_it_needs() -> None:
    with pytest.raises(DecodeError, match=r"0\.0 px of guard band") as raised:
        check_patterns(of_pitches(1024, 128, 16), *SIZE)
    assert "1040 px" in raised.value.hint
    check_patterns(of_pitches(1040, 128, 16), *SIZE)


@pytest.mark.parametrize(("patterns", "reason"), [(of_pitches(32, 34), "beat"), (of_pitches(32), "single pitch")])
def test_an_ambiguous_set_is_refused(patterns: PatternSet, reason: str) -> None:
    with pytest.raises(DecodeError, match=reason):
        check_patterns(patterns, *SIZE)


def test_a_set_made_for_a_smaller_projector_is_refused() -> None:
    with pytest.raises(DecodeError, match="1280 px wide"):
        check_patterns(PAPER_PATTERNS, 1280, 800)
    with pytest.raises(DecodeError, match="800 px high"):
        check_patterns(PATTERN_SETS["paper-both"], 1024, 800)


@pytest.mark.parametrize(("mean", "modulation"), [(100, 120), (200, 100), (50, 0)])
def test_a_contrast_that_cannot_be_is_refused(mean: float, modulation: float) -> None:
    with pytest.raises(DecodeError) as raised:
        check_patterns(PAPER_PATTERNS, *SIZE, Contrast(mean, modulation))
    assert raised.value.hint
