from __future__ import annotations

import numpy as np
import pytest

from measureapp.data.fringe import GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.pattern_sets import DEFAULT_PATTERNS, PAPER_PATTERNS, PATTERN_SETS, make_pattern_sets
from measureapp.errors import DecodeError
from measureapp.fringe.decode import decode
from measureapp.fringe.patterns.check import check_patterns
from measureapp.fringe.patterns.draw import check_determines_phase, pattern_images
from measureapp.fringe.patterns.gray_code import gray_bits, period_numbers
from measureapp.fringe.unwrap import plan_heterodyne
from tests.fringe.conftest import stack_of

SHAPE = 1024, 768


def pitches(*values: float, projector_px: int = 1024) -> PatternSet:
    return PatternSet(name="t", projector_px=projector_px, groups=tuple(PhaseShiftGroup(pitch_px=value) for value in values))


def columns_error(drawn: np.ndarray, alone: PatternSet, noise_grey: float = 0.0) -> tuple[float, float]:
    """Return which share of a camera that sees patterns (P, rows, columns) as drawn decodes, and its largest error in columns."""
    random = np.random.default_rng(1)
    seen = np.clip(np.rint(drawn * 0.8 + 20 + random.normal(0, noise_grey, drawn.shape)), 0, 254).astype(np.uint8)[None]
    decoded = decode(stack_of(seen, alone))["left"]
    error = (decoded.column_px - np.arange(drawn.shape[2]))[decoded.valid]
    return float(decoded.valid.mean()), float(np.abs(error).max())


def test_a_camera_that_sees_the_patterns_as_drawn_decodes_the_columns(sets: dict[str, PatternSet]) -> None:
    for name, patterns in sets.items():
        drawn = pattern_images(patterns, 1024, 6)
        assert drawn.shape == (patterns.count, 6, 1024)
        assert drawn.dtype == np.uint8
        valid, error = columns_error(drawn, patterns)
        assert valid > 0.995, name
        assert error < 0.06, name  # rounding to whole grey levels


@pytest.mark.parametrize("name", PATTERN_SETS)
def test_every_named_set_comes_back_as_drawn_in_each_of_its_directions(name: str) -> None:
    patterns = PATTERN_SETS[name]
    drawn = pattern_images(patterns, *SHAPE)
    assert drawn.shape == (patterns.count, SHAPE[1], SHAPE[0])
    for direction in patterns.directions:
        alone, where = patterns.subset(direction)
        # every column (row) is the same, so a few of them are enough; rows are laid down to be decoded as columns
        strip = drawn[where][:, :6] if direction == "vertical" else drawn[where][:, :, :6].transpose(0, 2, 1)
        lying = alone.model_copy(
            update={"groups": tuple(group.model_copy(update={"direction": "vertical"}) for group in alone.groups), "projector_rows": None}
        )
        valid, error = columns_error(np.ascontiguousarray(strip), lying, noise_grey=0.7)
        assert valid > 0.995, direction
        # 0.76 grey levels with those lost to rounding, of B = 102; a normal error stays below five deviations
        finest = min(lying.pitches_px)
        assert error < 5 * finest / (2 * np.pi) * np.sqrt(2 / 4) * 0.76 / 102, direction


@pytest.mark.parametrize("name", [name for name in PATTERN_SETS if name.endswith("-both")])
def test_a_set_of_both_directions_gives_column_and_row_at_once(name: str) -> None:
    patterns = PATTERN_SETS[name]
    drawn = pattern_images(patterns, *SHAPE)[:, ::2, ::2]
    noise = np.random.default_rng(2).normal(0, 0.7, drawn.shape)
    decoded = decode(stack_of(np.rint(drawn * 0.8 + 20 + noise).clip(0, 254).astype(np.uint8)[None], patterns))["left"]
    assert decoded.orthogonal is not None
    bound = 5.5 * max(patterns.pitches_px) / (2 * np.pi) * np.sqrt(2 / 4) * 0.76 / 102  # of 200 000 pixels
    for phase_map, position in ((decoded, np.arange(0, 1024, 2)[None, :]), (decoded.orthogonal, np.arange(0, 768, 2)[:, None])):
        assert phase_map.valid.mean() > 0.995
        assert np.abs(phase_map.column_px - position)[phase_map.valid].max() < bound


def test_horizontal_fringes_are_constant_along_rows_and_vertical_ones_along_columns() -> None:
    patterns = PATTERN_SETS["complementary-gray-both"]
    drawn = pattern_images(patterns, *SHAPE)
    for direction, axis in (("vertical", 1), ("horizontal", 2)):
        images = drawn[patterns.subset(direction)[1]]
        assert np.all(np.ptp(images, axis=axis) == 0)
        assert np.all(np.ptp(images, axis=3 - axis) > 250)


@pytest.mark.parametrize("size", [(1024, 768), (912, 1140), (1280, 800), (1920, 1080), (3840, 2160), (640, 480), (64, 64)])
def test_the_named_sets_cover_projectors_of_any_size_with_a_guard_band(size: tuple[int, int]) -> None:
    for name, patterns in make_pattern_sets(*size).items():
        for check in check_patterns(patterns, *size):
            wanted = 0.0 if "gray" in name else 1 / 32 - 1e-3 if name.startswith("paper") else 1 / 16 - 1e-9
            assert check.guard_px >= wanted * check.extent_px, (name, check)


def test_the_papers_set_is_four_steps_at_32_and_33_px() -> None:
    assert PAPER_PATTERNS.groups == (PhaseShiftGroup(pitch_px=32, steps=4), PhaseShiftGroup(pitch_px=33, steps=4))
    assert PAPER_PATTERNS.projector_px == 1024


def test_the_noise_of_the_papers_order_decision_is_46_times_that_of_the_phase() -> None:
    assert plan_heterodyne(PAPER_PATTERNS).amplification == pytest.approx(45.97, abs=0.01)


def test_the_default_set_decides_orders_four_times_as_quietly_as_the_papers() -> None:
    assert plan_heterodyne(DEFAULT_PATTERNS).amplification < 46 / 4


@pytest.mark.parametrize(("name", "amplification"), [("three-wide-32", 5.92), ("three-wide", 8.31), ("hierarchical", 5**0.5)])
def test_sets_of_widely_spaced_pitches_amplify_by_the_ratio_of_neighbours(name: str, amplification: float) -> None:
    assert plan_heterodyne(PATTERN_SETS[name]).amplification == pytest.approx(amplification, abs=0.01)


def test_three_pitches_are_unwrapped_by_the_quietest_chain() -> None:
    plan = plan_heterodyne(pitches(1920 / 64, 1920 / 58, 1920 / 53, projector_px=1920))
    assert plan.amplification < 14.5
    assert plan.combinations[-1] == (1, 0, 0)


def test_no_other_chain_of_three_pitches_has_a_quieter_worst_decision() -> None:
    """All chains of at most four decisions between all combinations, tried one by one."""
    patterns = pitches(20, 23, 55, projector_px=400)
    frequencies = 400 / np.array(patterns.pitches_px)
    stations = np.array(np.meshgrid(*[range(-2, 3)] * 3)).reshape(3, -1).T
    beats = stations @ frequencies
    stations, beats = stations[beats > 1e-3], beats[beats > 1e-3]
    goal = int(np.flatnonzero((stations == (1, 0, 0)).all(axis=1))[0])
    noise = np.linalg.norm((beats[None, :] / beats[:, None])[:, :, None] * stations[:, None] - stations[None], axis=2)
    noise[beats[None, :] <= beats[:, None] * (1 + 1e-6)] = np.inf
    worst = np.where(beats <= 1 + 1e-6, 0.0, np.inf)
    for _ in range(6):
        worst = np.minimum(worst, np.maximum(worst[:, None], noise).min(axis=0))
    assert plan_heterodyne(patterns).amplification == pytest.approx(worst[goal])


def test_a_start_with_a_guard_band_is_preferred_when_it_costs_little() -> None:
    plan = plan_heterodyne(pitches(16, 32.985, 68, projector_px=64))
    assert plan.guard >= 1 / 128 - 1e-3


@pytest.mark.parametrize("count", [5, 7, 10, 16])
def test_many_pitches_are_planned_quickly_and_each_half_of_the_one_before_is_as_quiet_as_can_be(count: int) -> None:
    patterns = pitches(*(4096 / 2**k for k in range(min(count, 10))), *(9.0 + 0.1 * k for k in range(count - 10)), projector_px=4000)
    plan = plan_heterodyne(patterns)
    assert plan.amplification <= 5**0.5 + 1e-9
    assert plan.decision_weights.shape == (len(plan.combinations), count)


def test_more_pitches_than_can_be_planned_are_refused() -> None:
    with pytest.raises(DecodeError, match="25 pitches"):
        plan_heterodyne(pitches(*(32 + k for k in range(25))))


@pytest.mark.parametrize("complementary", [False, True])
def test_the_bits_drawn_number_the_periods_though_the_phase_is_noisy(complementary: bool) -> None:
    position = np.linspace(0, 1023.9, 20_000)
    group = GrayCodeGroup(planes=7, complementary=complementary)
    pitch = 16.0 if complementary else 8.0
    bits = gray_bits(group, pitch, position)
    assert np.abs(np.diff(bits.astype(int), axis=1)).sum(axis=0).max() == 1  # one plane changes at a time
    true = position / pitch
    noise = np.random.default_rng(3).uniform(-0.2, 0.2, len(position)) if complementary else 0.0
    phase = np.mod(2 * np.pi * (true + noise) + 1e-9, 2 * np.pi)
    found = period_numbers(bits, phase, complementary) + phase / (2 * np.pi)
    assert np.abs(found - true - noise).max() < 1e-6


@pytest.mark.parametrize("complementary", [False, True])
def test_the_decoder_numbers_periods_as_the_readable_statement_does(complementary: bool) -> None:
    patterns = PATTERN_SETS["complementary-gray" if complementary else "gray"]
    drawn = pattern_images(patterns, 1024, 6)
    decoded = decode(stack_of(np.rint(drawn * 0.8 + 20).astype(np.uint8)[None], patterns))["left"]
    phase = np.mod(2 * np.pi * np.arange(1024) / 16, 2 * np.pi)
    stated = period_numbers(drawn[4:, 0] > 127, phase, complementary)
    valid = decoded.valid[3]
    share = np.mod(decoded.column_px[3] / 16, 1)
    inside = valid & (share > 0.01) & (share < 0.99)
    assert inside.sum() > 900
    assert np.array_equal(np.floor(decoded.column_px[3] / 16)[inside].astype(int), stated[inside])


@pytest.mark.parametrize(
    ("patterns", "reason"),
    [
        (pitches(32), "single pitch"),
        (pitches(32, 34), "beat"),
        (PatternSet(name="g", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32), GrayCodeGroup(planes=4))), "planes"),
        (
            PatternSet(name="c", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32), GrayCodeGroup(planes=5, complementary=True))),
            "planes",
        ),
        (PatternSet(name="s", projector_px=1024, groups=(GrayCodeGroup(planes=10),)), "sinusoids"),
        (
            PatternSet(
                name="h",
                projector_px=1024,
                projector_rows=768,
                groups=(*PAPER_PATTERNS.groups, PhaseShiftGroup(pitch_px=32, direction="horizontal")),
            ),
            "768 rows",
        ),
    ],
)
def test_a_set_that_does_not_determine_the_phase_is_refused_with_the_reason(patterns: PatternSet, reason: str) -> None:
    with pytest.raises(DecodeError, match=reason) as raised:
        check_determines_phase(patterns)
    assert raised.value.hint


def test_a_projector_larger_than_the_set_is_refused() -> None:
    with pytest.raises(DecodeError, match="1280 px wide"):
        pattern_images(PAPER_PATTERNS, 1280, 4)
    with pytest.raises(DecodeError, match="800 px high"):
        pattern_images(PATTERN_SETS["paper-both"], 1024, 800)
