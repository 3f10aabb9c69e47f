"""Decoding exposure by exposure, both directions, guards and reasons."""

from __future__ import annotations

import tracemalloc
from dataclasses import fields
from math import tau

import numpy as np
import pytest

from measureapp.data.fringe import PatternSet, PhaseShiftGroup
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.errors import DecodeError
from measureapp.fringe.decode import decode, decode_camera
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.streaming import StreamingDecoder
from tests.fringe.conftest import EXPOSURES_US, images_of, ramp, stack_of


def shiny_images(patterns: PatternSet, seed: int = 4) -> np.ndarray:
    """A ramp with a highlight, a dark band and a depth step, 90 × 400 px: several chunks, not a whole number of them."""
    column = ramp(90, 400)
    column[:, 220:] = np.clip(column[:, 220:] + 120, 0, 1018)
    mean, modulation = np.full(column.shape, 110.0), np.full(column.shape, 80.0)
    mean[20:30, 50:90], modulation[20:30, 50:90] = 400, 300
    mean[60:70], modulation[60:70] = 14, 9
    return images_of(column, patterns, EXPOSURES_US, mean, modulation, seed=seed)


def streamed(images: np.ndarray, patterns: PatternSet, settings: DecodeSettings) -> PhaseMap:
    decoder = StreamingDecoder(patterns, EXPOSURES_US, 255, settings, "v")
    for exposure in range(len(EXPOSURES_US)):
        decoder.add("left", exposure, images[exposure])
    return decoder.finish()["left"]


def assert_same(one: PhaseMap, other: PhaseMap) -> None:
    for field in fields(PhaseMap):
        if field.name != "across":
            assert np.array_equal(getattr(one, field.name), getattr(other, field.name)), field.name


@pytest.mark.parametrize(
    "settings", [DecodeSettings(), DecodeSettings(rule="paper"), DecodeSettings(joint=False)], ids=["all", "paper", "each"]
)
def test_exposures_one_by_one_give_the_same_bits_as_all_at_once(sets: dict[str, PatternSet], settings: DecodeSettings) -> None:
    for patterns in sets.values():
        images = shiny_images(patterns)
        at_once = decode_camera(stack_of(images, patterns, EXPOSURES_US), "left", settings)
        assert_same(streamed(images, patterns, settings), at_once)


def test_exposures_out_of_order_missing_or_twice_are_refused() -> None:
    images = shiny_images(PAPER_PATTERNS)
    decoder = StreamingDecoder(PAPER_PATTERNS, EXPOSURES_US, 255)
    decoder.add("left", 0, images[0])
    with pytest.raises(DecodeError, match="exposure 3, but exposure 2 of 5 is due"):
        decoder.add("left", 2, images[2])
    with pytest.raises(DecodeError, match="exposure 1, but exposure 2 of 5 is due"):
        decoder.add("left", 0, images[0])
    with pytest.raises(DecodeError, match="camera left are missing"):
        decoder.finish()
    with pytest.raises(DecodeError, match="changed size or bit depth"):
        decoder.add("left", 1, images[1].astype(np.uint16))
    with pytest.raises(DecodeError, match="one exposure has 8 images"):
        decoder.add("right", 0, images[0][:7])


def test_a_set_with_both_directions_gives_columns_and_rows() -> None:
    sine = PhaseShiftGroup
    both = PatternSet(
        name="both",
        projector_px=1024,
        projector_rows=768,
        groups=(
            sine(pitch_px=32),
            sine(pitch_px=33),
            sine(pitch_px=24, direction="horizontal"),
            sine(pitch_px=24.7, direction="horizontal"),
        ),
    )
    column, row = ramp(80, 300), np.linspace(5, 760, 80)[:, None] + 0.02 * np.arange(300)[None, :]
    images = np.concatenate([images_of(at, both.subset(way)[0]) for at, way in ((column, "vertical"), (row, "horizontal"))], axis=1)
    found = decode(stack_of(images, both))["left"]
    assert found.orthogonal is not None and found.direction == "vertical" and found.orthogonal.direction == "horizontal"
    for decoded, truth in ((found, column), (found.orthogonal, row)):
        assert decoded.valid.mean() > 0.98
        assert np.abs(decoded.column_px - truth)[decoded.valid].max() < 1.0


def test_a_set_with_horizontal_fringes_only_gives_the_rows() -> None:
    groups = tuple(PhaseShiftGroup(pitch_px=pitch, direction="horizontal") for pitch in (24, 24.7))
    patterns = PatternSet(name="rows", projector_px=1024, projector_rows=768, groups=groups)
    row = np.linspace(5, 760, 80)[:, None] + np.zeros(300)[None, :]
    found = decode(stack_of(images_of(row, patterns), patterns))["left"]
    assert found.orthogonal is None and found.direction == "horizontal" and found.projector_px == 768
    assert np.abs(found.column_px - row)[found.valid].max() < 1.0


def test_pixels_near_saturation_do_not_use_that_exposure_and_say_so_when_none_is_left() -> None:
    column = ramp(40, 300)
    images = images_of(column, PAPER_PATTERNS, EXPOSURES_US)
    images[:3, :, 20, 100] = 255
    images[:, :, 30, 200] = 255
    settings = DecodeSettings(blooming_radius_px=2, edge_step_rad=1e6)
    found = decode_camera(stack_of(images.copy(), exposures_us=EXPOSURES_US), "left", settings)
    assert (found.exposure_index[18:23, 98:103] == 3).all()
    assert found.valid[18:23, 98:103].all()
    around = found.state[28:33, 198:203].copy()
    assert around[2, 2] == PixelState.SATURATED
    around[2, 2] = PixelState.BLOOMING
    assert (around == PixelState.BLOOMING).all()
    assert (found.state == PixelState.BLOOMING).sum() == 24
    assert_same(streamed(images, PAPER_PATTERNS, settings), found)


def test_known_harmonics_of_the_projector_are_corrected_in_the_phase() -> None:
    column = ramp(60, 400)
    images = images_of(column, PAPER_PATTERNS, seed=None).astype(float)
    for group, pitch in enumerate((32, 33)):
        for n in range(4):
            images[0, 4 * group + n] += 0.05 * 80 * np.cos(3 * (tau * column / pitch - tau * n / 4))
    noisy = np.rint(images).astype(np.uint8)
    plain = decode(stack_of(noisy.copy()), DecodeSettings(vote_radius=0))["left"]
    correction = (((4, 0.05, np.pi),),) * 2  # of four steps the third harmonic leaves −b sin 4φ
    mended = decode(stack_of(noisy.copy()), DecodeSettings(vote_radius=0, phase_correction=correction))["left"]
    errors = [float(((each.column_px - column) * tau / 32)[each.valid].std()) for each in (plain, mended)]
    assert errors[1] < 0.3 * errors[0]


def test_a_correction_for_another_set_is_refused() -> None:
    with pytest.raises(DecodeError, match="phase correction is for 1 pitches"):
        decode(stack_of(shiny_images(PAPER_PATTERNS)[:1]), DecodeSettings(phase_correction=(((4, 0.1, 0.0),),)))


def test_each_camera_may_have_its_own_noise() -> None:
    images = shiny_images(PAPER_PATTERNS)
    stack = stack_of(images, exposures_us=EXPOSURES_US)
    poor = CameraNoise(full_well_e=1500)
    noisy = DecodeSettings(camera_noise={"left": poor})
    plain, other = decode_camera(stack, "left", DecodeSettings()), decode_camera(stack, "left", noisy)
    both = plain.valid & other.valid & (plain.modulation > 50)
    grey = np.array([110 * exposure / EXPOSURES_US[0] for exposure in EXPOSURES_US])
    expected = np.sqrt(poor.variance(grey, 255).sum() / CameraNoise().variance(grey, 255).sum())
    assert np.median(other.sigma_rad[both] / plain.sigma_rad[both]) == pytest.approx(float(expected), rel=0.01)


def test_the_snr_is_that_of_one_image_with_the_same_phase_noise() -> None:
    found = decode(stack_of(images_of(ramp(), PAPER_PATTERNS)))["left"]
    expected = 80 / np.sqrt(CameraNoise().variance(np.array(110.0), 255))
    assert np.median(found.snr[found.valid]) == pytest.approx(float(expected), rel=0.02)
    assert (found.snr[~found.valid] == 0).all()
    assert sum(found.reasons.values()) == found.state.size


def test_combining_all_exposures_lowers_the_noise_everywhere_and_loses_no_pixel() -> None:
    images = shiny_images(PAPER_PATTERNS)
    stack = stack_of(images, exposures_us=EXPOSURES_US)
    settings = {rule: DecodeSettings(rule=rule, vote_radius=0, residual_gate=0.5, edge_step_rad=1e6) for rule in ("paper", "combined")}
    paper, combined = (decode_camera(stack, "left", settings[rule]) for rule in ("paper", "combined"))
    assert combined.valid_ratio_composite == pytest.approx(paper.valid_ratio_composite, abs=0.002)
    both = paper.valid & combined.valid
    assert np.median(combined.sigma_rad[both]) < 0.7 * np.median(paper.sigma_rad[both])
    assert (combined.sigma_rad[both] <= 1.1 * paper.sigma_rad[both]).all()


def test_decoding_needs_at_most_twice_the_memory_of_its_result() -> None:
    column = ramp(500, 800)
    images = np.ascontiguousarray(images_of(column, PAPER_PATTERNS, EXPOSURES_US))
    stack = stack_of(images, exposures_us=EXPOSURES_US)
    decode_camera(stack, "left", DecodeSettings())
    tracemalloc.start()
    found = decode_camera(stack, "left", DecodeSettings())
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    arrays = (found.phase_rad, found.sigma_rad, found.modulation, found.grey, found.state, found.exposure_index)
    assert peak < 2 * sum(array.nbytes for array in arrays)
