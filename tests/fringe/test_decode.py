from __future__ import annotations

from math import erfc, pi, sqrt, tau

import numpy as np
import pytest

from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.pattern_sets import DEFAULT_PATTERNS, PAPER_PATTERNS
from measureapp.data.phase import PixelState
from measureapp.errors import DecodeError
from measureapp.fringe.decode import decode, decode_camera
from measureapp.fringe.fringe_origin import sampled_chunks
from measureapp.fringe.kernels.structures import CHUNK, SAMPLED_EVERY
from measureapp.fringe.noise.model import CameraNoise, phase_sigma
from measureapp.fringe.settings import DecodeSettings
from tests.fringe.conftest import EXPOSURES_US, images_of, ramp, stack_of


def predicted_sigma(mean: float, modulation: float) -> float:
    return float(phase_sigma(4, np.sqrt(CameraNoise().variance(np.array(mean), 255)), np.array(modulation)))


def test_every_kind_of_set_recovers_noisy_columns(sets: dict[str, PatternSet]) -> None:
    column = ramp()
    for name, patterns in sets.items():
        decoded = decode(stack_of(images_of(column, patterns), patterns))["left"]
        error = (decoded.column_px - column)[decoded.valid] * tau / patterns.finest_pitch_px
        assert decoded.valid.mean() > 0.98, name
        assert np.abs(error).max() < 7 * decoded.sigma_rad[decoded.valid].max(), name
        assert error.std() == pytest.approx(float(np.sqrt((decoded.sigma_rad[decoded.valid] ** 2).mean())), rel=0.12), name


def test_phase_noise_is_at_most_1_12_times_the_prediction_and_falls_by_averaging_pitches_and_exposures() -> None:
    column = ramp(100, 400)
    one = decode(stack_of(images_of(column, PAPER_PATTERNS)))["left"]
    all_five = decode(stack_of(images_of(column, PAPER_PATTERNS, EXPOSURES_US), exposures_us=EXPOSURES_US))["left"]
    single = predicted_sigma(110, 80)
    for decoded, gain in ((one, sqrt(2)), (all_five, sqrt(2) * sqrt(3))):  # five exposures carry three times the light
        error = ((decoded.column_px - column) * tau / 32)[decoded.valid]
        assert error.std() < 1.12 * single / gain
        assert error.std() > 0.9 * single / gain


def test_the_rate_of_order_errors_is_the_predicted_one_and_the_vote_mends_them() -> None:
    column = ramp(150, 600)
    images = images_of(column, PAPER_PATTERNS, mean=80.0, modulation=45.0)
    expected = erfc(pi / (45.97 * sqrt(2) * predicted_sigma(80, 45)))
    raw = decode(stack_of(images.copy()), DecodeSettings(vote_radius=0, residual_gate=0.5, edge_step_rad=1e6))["left"]
    mended = decode(stack_of(images.copy()))["left"]
    rates = [float((np.abs(each.column_px - column)[each.valid] > 16).mean()) for each in (raw, mended)]
    assert rates[0] == pytest.approx(expected, rel=0.25)
    assert rates[1] < 1e-5
    assert mended.valid.mean() > 0.99


def test_orders_without_support_are_marked_and_never_let_out() -> None:
    column = ramp(100, 400)
    decoded = decode(stack_of(images_of(column, PAPER_PATTERNS, mean=30.0, modulation=12.0)))["left"]
    wrong = np.abs(decoded.column_px - column)[decoded.valid] > 16
    assert wrong.mean() < 5e-4
    assert (decoded.state == PixelState.ORDER_CONFLICT).sum() > 20


def test_highlights_and_dark_places_are_distinguished() -> None:
    column = ramp(40, 200)
    mean, modulation = np.full(column.shape, 110.0), np.full(column.shape, 80.0)
    mean[:10], modulation[:10] = 900, 700  # saturated above 20 ms
    mean[10:20], modulation[10:20] = 3000, 2500  # in every exposure
    mean[20:25], modulation[20:25] = 12, 0  # nothing of the projector
    mean[25:30], modulation[25:30] = 110, 6
    decoded = decode(stack_of(images_of(column, PAPER_PATTERNS, EXPOSURES_US, mean, modulation), exposures_us=EXPOSURES_US))["left"]
    assert (decoded.state[10:20] == PixelState.SATURATED).mean() > 0.95
    assert (decoded.state[20:25] == PixelState.SHADOW).mean() > 0.99  # one in a thousand looks like fringes
    assert (decoded.state[25:30] == PixelState.WEAK_MODULATION).mean() > 0.99
    assert decoded.valid[32:].all()
    assert (decoded.exposure_index[10:20] == -1).mean() > 0.95
    assert (decoded.phase_rad[~decoded.valid] == 0).all()


@pytest.mark.parametrize("rule", ["combined", "paper"])
def test_spots_that_saturate_are_decoded_as_if_all_were_so_bright_and_the_rest_as_if_there_were_none(rule: str) -> None:
    settings = DecodeSettings(rule=rule, vote_radius=0, edge_step_rad=1e6, noise_from_images=False)
    column = ramp(40, 1300)
    dim = images_of(column, PAPER_PATTERNS, EXPOSURES_US)
    bright = images_of(column, PAPER_PATTERNS, EXPOSURES_US, mean=300.0, modulation=200.0)
    spots = np.zeros(column.shape, np.bool_)
    spots[3:5, 700] = spots[10, 100:900] = spots[20:24, 30:60] = spots[30:, 1000:] = True
    mixed = decode(stack_of(np.where(spots, bright, dim), exposures_us=EXPOSURES_US), settings)["left"]
    alone = [decode(stack_of(images, exposures_us=EXPOSURES_US), settings)["left"] for images in (bright, dim)]
    for name in ("phase_rad", "sigma_rad", "modulation", "grey", "state", "exposure_index"):
        of_bright, of_dim = (getattr(phase_map, name) for phase_map in alone)
        np.testing.assert_array_equal(getattr(mixed, name), np.where(spots, of_bright, of_dim), name)
    assert (mixed.exposure_index[spots] > 0).mean() > 0.9 > 0.1 > (mixed.exposure_index[~spots] > 0).mean()


def test_many_exposures_make_up_for_faint_fringes_where_no_order_is_in_doubt() -> None:
    column, settings = ramp(60, 400), DecodeSettings(noise_from_images=False)
    mean, modulation = 11.0, 8.0  # below the least modulation of one image, and at its noise decodable all the same
    seven_us = (100_000, 85_000, 70_000, 55_000, 40_000, 25_000, 10_000)
    images = images_of(column, DEFAULT_PATTERNS, seven_us, mean, modulation)
    light = np.array(seven_us) / seven_us[0]
    information = light**2 / CameraNoise().variance(mean * light, 255)
    assert modulation < settings.min_modulation < modulation * sqrt(float(information.sum() / information[0]))
    seven = decode(stack_of(images, DEFAULT_PATTERNS, seven_us), settings)["left"]
    error = (seven.column_px - column)[seven.valid]
    assert seven.valid.mean() > 0.99
    assert np.abs(error).max() < 7 * float(seven.sigma_rad[seven.valid].max()) * seven.pixel_of_phase()[0]
    by_itself = DecodeSettings(noise_from_images=False, vote_radius=0)
    one = decode(stack_of(images[:1].copy(), DEFAULT_PATTERNS, seven_us[:1]), by_itself)["left"]
    assert (one.state == PixelState.WEAK_MODULATION).mean() > 0.95


def test_neighbours_settle_the_orders_of_faint_fringes() -> None:
    column = ramp(60, 400)
    images = images_of(column, PAPER_PATTERNS, EXPOSURES_US, 11.0, 8.0)
    found = decode(stack_of(images.copy(), exposures_us=EXPOSURES_US))["left"]
    assert found.valid.mean() > 0.99
    assert np.abs(found.column_px - column)[found.valid].max() < 4.0  # of periods of 32 px
    for settings in (DecodeSettings(rule="paper"), DecodeSettings(vote_radius=0)):
        alone = decode(stack_of(images.copy(), exposures_us=EXPOSURES_US), settings)["left"]
        assert (alone.state == PixelState.WEAK_MODULATION).mean() > 0.95


@pytest.mark.parametrize("seed", [1, 2, 3, 4])
def test_where_faint_fringes_start_is_determined(seed: int) -> None:
    images = images_of(ramp(60, 1200), PAPER_PATTERNS, mean=9.0, modulation=6.0, seed=seed)
    for origin, shown in ((0.0, images), (-pi, 40 - images)):  # by single pixels a matter of chance
        assert decode(stack_of(shown))["left"].details["origin_rad"] == pytest.approx(origin)


def test_highlights_take_the_brightest_unsaturated_exposure_by_the_papers_rule() -> None:
    column = ramp(20, 200)
    images = images_of(column, PAPER_PATTERNS, EXPOSURES_US, 300.0, 190.0, seed=None)  # peaks 490, 392, 294, 196, 98
    for rule in ("paper", "combined"):
        decoded = decode(stack_of(images.copy(), exposures_us=EXPOSURES_US), DecodeSettings(rule=rule))["left"]
        bright = images.max(axis=1) >= 255
        expected = np.argmax(~bright, axis=0)
        assert (decoded.exposure_index == expected)[decoded.valid].all()
        assert decoded.valid_ratio_composite >= max(decoded.valid_ratio_exposures)
        share = np.array(EXPOSURES_US)[expected] / EXPOSURES_US[0]
        assert np.abs(decoded.modulation - 190 * share)[decoded.valid].max() < 1.5


def test_valid_ratios_count_pixels_above_zero_and_below_saturation() -> None:
    column = ramp(20, 200)
    images = images_of(column, PAPER_PATTERNS, EXPOSURES_US, 150.0, 148.0)
    decoded = decode(stack_of(images.copy(), exposures_us=EXPOSURES_US))["left"]
    counted = ((images > 0) & (images < 255)).all(axis=1).mean(axis=(1, 2))
    assert decoded.valid_ratio_exposures == pytest.approx(counted)


def test_valid_ratios_by_the_papers_rule_are_estimated_where_a_longer_exposure_serves() -> None:
    column = ramp(400, CHUNK)  # a chunk in every row
    mean, modulation = np.full(column.shape, 150.0), np.full(column.shape, 100.0)
    mean[100:150], modulation[100:150] = 300, 200  # saturates the longest exposures
    mean[:, ::50], modulation[:, ::50] = 14, 9  # falls to zero in the short ones
    images = images_of(column, PAPER_PATTERNS, EXPOSURES_US, mean, modulation)
    decoded = decode(stack_of(images.copy(), exposures_us=EXPOSURES_US), DecodeSettings(rule="paper"))["left"]
    counted = ((images > 0) & (images < 255)).all(axis=1).mean(axis=(1, 2))
    served = 350  # chunks that the longest exposure serves, of which some are looked at; in each a share of 2 % may be zero
    spread = np.sqrt(0.02 / (CHUNK * served / SAMPLED_EVERY))
    assert decoded.valid_ratio_exposures == pytest.approx(counted, abs=4 * spread)
    assert decoded.valid_ratio_exposures[0] == pytest.approx(counted[0])  # nothing to estimate


@pytest.mark.parametrize("chunks_in_a_row", [1, 2, 3, 4, 5, 8])
def test_samples_of_an_image_lie_in_all_its_columns_and_rows(chunks_in_a_row: int) -> None:
    width, height = chunks_in_a_row * CHUNK, 1536
    chosen = np.array([begin for begin, _ in sampled_chunks(width * height, 128)])
    assert len(chosen) == 128
    assert np.bincount(chosen % width // CHUNK, minlength=chunks_in_a_row).min() >= 0.7 * 128 / chunks_in_a_row
    assert np.diff(chosen // width, prepend=0, append=height).max() < 3 * height / 128
    looked_at = CHUNK * np.arange(0, width * height // CHUNK, SAMPLED_EVERY)
    assert np.bincount(looked_at % width // CHUNK, minlength=chunks_in_a_row).min() >= 0.9 * len(looked_at) / chunks_in_a_row - 1
    assert sampled_chunks(3 * CHUNK + 1, 16) == [(0, CHUNK), (CHUNK, 2 * CHUNK), (2 * CHUNK, 3 * CHUNK), (3 * CHUNK, 3 * CHUNK + 1)]


def test_one_pitch_may_take_another_exposure_where_exposures_are_chosen_per_frequency() -> None:
    column = ramp(20, 200)
    images = images_of(column, PAPER_PATTERNS, EXPOSURES_US, seed=None)
    images[0, 4] = 255  # spoils the second pitch at the longest exposure only
    joint, apart = (
        decode_camera(
            stack_of(images.copy(), exposures_us=EXPOSURES_US), "left", DecodeSettings(rule="paper", joint=joint, noise_from_images=False)
        )
        for joint in (True, False)
    )
    assert (joint.exposure_index == 1).all()
    assert (apart.exposure_index == 0).all()
    assert joint.valid.all() and apart.valid.all()
    single, shorter = predicted_sigma(110, 80), predicted_sigma(88, 64)
    expected = 1 / sqrt(1 / single**2 + (32 / 33) ** 2 / shorter**2)
    assert np.median(apart.sigma_rad) == pytest.approx(expected, rel=0.02)
    assert np.median(joint.sigma_rad) == pytest.approx(shorter / sqrt(1 + (32 / 33) ** 2), rel=0.02)


def test_a_twelve_bit_camera_decodes_as_well_as_an_eight_bit_one() -> None:
    column = ramp(30, 200)
    images = images_of(column, PAPER_PATTERNS, mean=1770.0, modulation=1285.0, saturation=4095)
    decoded = decode(stack_of(images, saturation=4095))["left"]
    assert decoded.valid.mean() > 0.99
    assert ((decoded.column_px - column) * tau / 32)[decoded.valid].std() < 1.12 * predicted_sigma(110, 80) / sqrt(2)


def test_a_step_in_depth_is_marked_as_edge() -> None:
    column = ramp(30, 200, 100, 700)
    column[:, 100:] += 200
    decoded = decode(stack_of(images_of(column, PAPER_PATTERNS)))["left"]
    assert (decoded.state[:, 99:101] == PixelState.EDGE).all()
    assert decoded.valid[:, :98].mean() > 0.99


def test_columns_beyond_the_projector_are_out_of_range() -> None:
    decoded = decode(stack_of(images_of(ramp(20, 300, 900, 1038), PAPER_PATTERNS)))["left"]
    assert (decoded.state == PixelState.OUT_OF_RANGE)[:, -15:].mean() > 0.95


def test_patterns_that_start_with_a_trough_are_recognised(sets: dict[str, PatternSet]) -> None:
    column = ramp(40, 500)
    for name in ("two pitches", "three pitches", "complementary gray"):
        patterns = sets[name]
        images = images_of(column, patterns)
        bits = sum(group.count for group in patterns.groups if group.kind == "phase-shift")
        images[:, :bits] = 220 - images[:, :bits]
        decoded = decode(stack_of(images, patterns))["left"]
        assert decoded.details["origin_rad"] == pytest.approx(-pi)
        error = (decoded.column_px - column) * tau / patterns.finest_pitch_px
        assert decoded.valid.mean() > 0.97, name
        assert np.abs(error[decoded.valid]).max() < 0.3, name


def test_where_fringes_start_is_determined_from_a_part_in_a_strip_of_the_image() -> None:
    width = 4 * CHUNK  # steps between samples of the image would be whole rows
    column = ramp(768, width, last=975.0)
    lit = np.broadcast_to(np.where(np.arange(width) < 3 * CHUNK, 0.0, 80.0), column.shape)
    decoded = decode(stack_of(220 - images_of(column, PAPER_PATTERNS, modulation=lit)))["left"]
    assert decoded.details["origin_rad"] == pytest.approx(-pi)
    error = (decoded.column_px - column) * tau / 32
    assert decoded.valid[:, 3 * CHUNK :].mean() > 0.97
    assert np.abs(error[decoded.valid]).max() < 0.3


def test_the_start_of_the_fringes_is_determined_from_a_part_that_fills_a_hundredth_of_the_image(sets: dict[str, PatternSet]) -> None:
    for name in ("two pitches", "complementary gray"):
        patterns = sets[name]
        part = images_of(ramp(30, 200), patterns)
        bits = sum(group.count for group in patterns.groups if group.kind == "phase-shift")
        part[:, :bits] = 220 - part[:, :bits]
        images = np.zeros((*part.shape[:2], 600, 1024), np.uint8)
        images[..., 250:280, 100:300] = part  # between the rows that are looked at first
        decoded = decode(stack_of(images, patterns))["left"]
        assert decoded.details["origin_rad"] == pytest.approx(-pi), name
        assert decoded.valid[250:280, 100:300].mean() > 0.9, name


def test_the_wrong_shift_sign_is_recognised_against_a_gray_code(sets: dict[str, PatternSet]) -> None:
    patterns = sets["complementary gray"]
    images = images_of(ramp(), patterns)
    with pytest.raises(DecodeError, match="decreases where the Gray code increases") as raised:
        decode(stack_of(images, patterns.model_copy(update={"shift_sign": 1})))
    assert "shift_sign" in raised.value.hint


@pytest.mark.parametrize("trough", [False, True], ids=["crest", "trough"])
@pytest.mark.parametrize("complementary", [False, True], ids=["plain", "complementary"])
@pytest.mark.parametrize(("steps", "shift_sign"), [(3, -1), (4, 1), (5, 1), (8, -1)])
def test_noise_free_borders_that_fall_exactly_on_pixels_are_read_rightly(
    steps: int, shift_sign: int, complementary: bool, trough: bool
) -> None:
    planes = GrayCodeGroup(planes=6 if complementary else 5, complementary=complementary)
    patterns = PatternSet(
        name="exact", projector_px=1024, shift_sign=shift_sign, groups=(PhaseShiftGroup(pitch_px=32, steps=steps), planes)
    )
    column = np.repeat(np.arange(1024.0)[None], 20, axis=0)
    images = images_of(column, patterns, seed=None)
    if trough:
        images[:, :steps] = images_of(column + 16, patterns, seed=None)[:, :steps]
    decoded = decode(stack_of(images, patterns))["left"]
    assert decoded.origin_rad == pytest.approx(-pi if trough else 0.0)
    assert decoded.valid.all()
    rounding = 2 / steps * (0.5 * steps) / 80 * 32 / tau  # no grey level is off by more than half of one
    assert np.abs(decoded.column_px - column).max() < rounding
    with pytest.raises(DecodeError, match="decreases where the Gray code increases"):
        decode(stack_of(images, patterns.model_copy(update={"shift_sign": -shift_sign})))


def test_images_that_do_not_fit_the_set_are_refused() -> None:
    with pytest.raises(DecodeError, match="1 exposures of 8 images"):
        decode(stack_of(np.zeros((1, 7, 5, 5), np.uint8)))
    with pytest.raises(DecodeError, match="float32 images"):
        decode(FringeStack("v", PAPER_PATTERNS, (1,), {"left": np.zeros((1, 8, 5, 5), np.float32)}, 255))


@pytest.mark.parametrize("rule", ["combined", "paper"])
@pytest.mark.parametrize("guard_px", [0, 2])
def test_pixels_beyond_the_last_whole_chunk_are_decoded_like_all_others(rule: str, guard_px: int) -> None:
    images = images_of(ramp(48, 333), PAPER_PATTERNS, EXPOSURES_US, mean=150.0, modulation=110.0)
    settings = DecodeSettings(rule=rule, vote_radius=0, edge_step_rad=1e6, blooming_radius_px=guard_px, noise_from_images=False)
    rows = 41
    assert rows * 333 % CHUNK != 0
    whole = decode(stack_of(images.copy(), exposures_us=EXPOSURES_US), settings)["left"]
    part = decode(stack_of(images[:, :, :rows].copy(), exposures_us=EXPOSURES_US), settings)["left"]
    for name in ("phase_rad", "sigma_rad", "modulation", "grey", "state", "exposure_index"):
        mine, its = getattr(part, name), getattr(whole, name)
        assert np.array_equal(mine[: -guard_px or None], its[: rows - guard_px]), name
    assert sum(part.details[state.name.lower()] for state in PixelState) == rows * 333
    assert part.details["valid"] == part.valid.sum()
    assert part.valid_ratio_composite == pytest.approx(float((part.exposure_index >= 0).mean()), abs=1e-12)
