"""The proposed bracket gives what it promises when it is really taken, and more than the paper's in the same time."""

from __future__ import annotations

import functools

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.fringe import FringeStack, PatternSet, PhaseShiftGroup
from measureapp.data.phase import PixelState
from measureapp.data.plan import ExposureBracket
from measureapp.errors import DecodeError
from measureapp.fringe.decode import decode
from measureapp.fringe.exposures.bracket import BracketLimits, BracketProposal, propose_bracket
from measureapp.fringe.exposures.probe import read_probe
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.settings import DecodeSettings
from tests.fringe.conftest import images_of, ramp

PAPER = ExposureBracket().exposures_us
PATTERNS = PatternSet(name="3", projector_px=1024, groups=tuple(PhaseShiftGroup(pitch_px=pitch) for pitch in (16, 17.5, 19.5)))
FULL_US = 100_000
PAPER_TIME_S = 12 * (0.3 + 5 * 0.069)


def scene(seed: int, brightness: float = 1.0, spread: float = 0.9, shape: tuple[int, int] = (100, 240)) -> tuple[FloatArray, FloatArray]:
    """Log-normal albedo in patches, with highlights: (A, B) in grey levels at 100 ms."""
    random = np.random.default_rng(seed)
    patches = np.exp(spread * random.normal(size=(shape[0] // 10, shape[1] // 10)))
    albedo = brightness * np.kron(patches, np.ones((10, 10)))
    return 90.0 * albedo, 70.0 * albedo


def taken(
    seed: int, exposures: tuple[int, ...], patterns: PatternSet = PATTERNS, noise_seed: int = 3, brightness: float = 1.0
) -> FringeStack:
    mean, modulation = scene(seed, brightness)
    share = exposures[0] / FULL_US
    columns = ramp(*mean.shape)
    images = images_of(columns, patterns, exposures, share * mean, share * modulation, noise_seed)
    return FringeStack("v", patterns, exposures, {"left": images}, 255)


@functools.cache
def proposal(seed: int, limits: BracketLimits, brightness: float = 1.0) -> BracketProposal:
    return propose_bracket(read_probe(taken(seed, (100_000, 4_000), brightness=brightness), {}), PATTERNS, limits)


@functools.cache
def observed(seed: int, exposures: tuple[int, ...], brightness: float = 1.0) -> tuple[float, float]:
    """Share of the pixels whose phase is right, and the median of their predicted noise, after really taking the bracket."""
    mean, _ = scene(seed, brightness)
    settings = DecodeSettings(edge_step_rad=1e6)
    decoded = decode(taken(seed, exposures, noise_seed=11, brightness=brightness), settings)["left"]
    usable = np.isin(decoded.state, (PixelState.VALID, PixelState.BLOOMING))
    right = usable & (np.abs(decoded.column_px - ramp(*mean.shape)) < PATTERNS.finest_pitch_px / 2)
    return float(right.mean()), float(np.median(decoded.sigma_rad[decoded.valid]))


@pytest.mark.parametrize("seed", [1, pytest.param(2, marks=pytest.mark.slow)])
@pytest.mark.parametrize("brightness", [0.3, 1.0, 3.0])
def test_what_is_predicted_is_observed_when_the_bracket_is_taken(seed: int, brightness: float) -> None:
    found = proposal(seed, BracketLimits(PAPER_TIME_S), brightness)
    for figures in (found.figures, found.compared["paper"]):
        share, sigma = observed(seed, figures.exposures_us, brightness)
        assert share == pytest.approx(figures.decodable_share, abs=0.02)
        assert sigma == pytest.approx(figures.median_sigma_rad, rel=0.1)


@pytest.mark.parametrize("seed", [1, *(pytest.param(seed, marks=pytest.mark.slow) for seed in (2, 3))])
@pytest.mark.parametrize("brightness", [0.3, 1.0, 3.0])
def test_in_the_time_of_the_papers_bracket_it_is_at_least_as_good(seed: int, brightness: float) -> None:
    found = proposal(seed, BracketLimits(PAPER_TIME_S), brightness)
    paper = found.compared["paper"]
    assert paper.time_s == pytest.approx(PAPER_TIME_S)
    assert found.figures.time_s <= PAPER_TIME_S * (1 + 1e-6)
    share, _ = observed(seed, found.exposures_us, brightness)
    paper_share, _ = observed(seed, PAPER, brightness)
    assert 1 - share < 0.5 * (1 - paper_share)


def test_more_exposures_pay_less_and_less_and_the_proposal_stops_there() -> None:
    found = proposal(1, BracketLimits(PAPER_TIME_S, most=8), 0.3)
    assert [len(figures.exposures_us) for figures in found.by_count] == list(range(1, 9))
    assert found.by_count[1].decodable_share > found.by_count[0].decodable_share + 0.05
    assert found.figures.worth >= max(figures.worth for figures in found.by_count) - 0.001
    assert len(found.exposures_us) < 5
    assert "do not pay" in found.note
    assert found.bracket.exposures_us == found.exposures_us


def test_time_number_and_multiples_are_obeyed() -> None:
    for budget in (1.2, 2.0, 4.0):
        found = proposal(2, BracketLimits(budget, most=3, multiple_us=10_000))
        assert found.figures.time_s <= budget
        assert 1 <= len(found.exposures_us) <= 3
        assert all(exposure % 10_000 == 0 for exposure in found.exposures_us)
    sixty = proposal(2, BracketLimits(4.0, multiple_us=1e6 / 120))
    assert all(abs(exposure / (1e6 / 120) - round(exposure / (1e6 / 120))) < 1e-3 for exposure in sixty.exposures_us)
    with pytest.raises(DecodeError, match="do not suffice for one exposure of 12 images"):
        proposal(2, BracketLimits(0.5))
    with pytest.raises(DecodeError, match="No multiple of 500000 µs fits"):
        proposal(2, BracketLimits(3.0, multiple_us=500_000))


def test_an_exposure_is_followed_by_its_read_out_and_images_by_their_transfer() -> None:
    """A pattern stays until the rolling shutter has read the last row: a bracket of short exposures is no shorter than its read-outs."""
    found = proposal(2, BracketLimits(12 * 3 * 0.069, most=8))
    assert len(found.by_count) == 2  # a third would not leave it any time
    assert found.figures.time_s == pytest.approx(12 * sum(one * 1e-6 + 0.069 for one in found.exposures_us))
    slow = BracketLimits(12 * 3 * 0.15, readout_ms=69.0, transfer_ms=150.0)
    assert slow.image_time_s(20_000) == 0.15 and slow.image_time_s(100_000) == pytest.approx(0.169)


def test_a_scene_without_light_is_refused() -> None:
    with pytest.raises(DecodeError, match="No camera sees fringes at 100000 µs") as raised:
        proposal(1, BracketLimits(4.0), brightness=0.001)
    assert "longer exposure" in raised.value.hint


def test_a_scene_saturated_at_the_shortest_probe_exposure_is_refused() -> None:
    with pytest.raises(DecodeError, match="saturated even at 4000 µs") as raised:
        proposal(1, BracketLimits(4.0), brightness=1000.0)
    assert "500 µs" in raised.value.hint


def test_a_scene_that_is_too_dark_for_the_time_is_refused() -> None:
    probe = read_probe(taken(1, (2_000_000,), brightness=0.002), {})
    with pytest.raises(DecodeError, match="makes a pixel decodable"):
        propose_bracket(probe, PATTERNS, BracketLimits(1.0, longest_us=20_000))


def test_a_probe_that_saturates_a_part_of_the_scene_says_so_and_still_serves_it() -> None:
    found = propose_bracket(read_probe(taken(1, (100_000,), brightness=2.0), {}), PATTERNS, BracketLimits(PAPER_TIME_S))
    assert found.unknown_share > 0.3
    assert "probe with 25000 µs" in found.note
    share, _ = observed(1, found.exposures_us, brightness=2.0)
    assert share > observed(1, PAPER, brightness=2.0)[0]


def test_a_noisier_camera_is_given_longer_exposures_or_fewer_pixels() -> None:
    quiet = proposal(1, BracketLimits(PAPER_TIME_S))
    loud = propose_bracket(
        read_probe(taken(1, (100_000, 4_000)), {"left": CameraNoise(full_well_e=1000, read_noise_e=20)}),
        PATTERNS,
        BracketLimits(PAPER_TIME_S),
    )
    assert loud.figures.median_sigma_rad > 1.5 * quiet.figures.median_sigma_rad
    assert loud.figures.decodable_share < quiet.figures.decodable_share
