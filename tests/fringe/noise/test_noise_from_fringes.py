"""Noise, motion and changing light by the residuals of fringe images."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from recorded import recorded

from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.data.phase import PhaseMap
from measureapp.fringe.decode import decode
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.streaming import StreamingDecoder
from measureapp.project.images import read_image
from tests.fringe.conftest import EXPOSURES_US, ramp, stack_of

COLUMN = ramp(200, 300, 100.0, 900.0)
MEAN = np.linspace(20, 120, 200)[:, None] * np.ones_like(COLUMN)


def taken(full_well_e: float, read_e: float, seed: int, move_px: float = 0.0, lamp: int | None = None, gamma: float = 1.0) -> np.ndarray:
    """Images (5, 8, H, W) of a camera; the part trembles by ``move_px`` columns, or a lamp of 30 grey levels comes on at image ``lamp``."""
    random, stack = np.random.default_rng(seed), []
    for exposure in EXPOSURES_US:
        for group in PAPER_PATTERNS.groups:
            for n in range(group.count):
                column = COLUMN + random.normal(0, move_px)
                assert isinstance(group, PhaseShiftGroup)
                wave = np.cos(2 * np.pi * (column / group.pitch_px + PAPER_PATTERNS.shift_sign * n / group.steps))
                light = MEAN * (2 * (0.5 + 0.45 * wave) ** gamma) + (30.0 if lamp is not None and len(stack) >= lamp else 0.0)
                electrons = light * exposure / EXPOSURES_US[0] * full_well_e / 255
                grey = (random.poisson(electrons) + random.normal(0, read_e, electrons.shape)) * 255 / full_well_e
                stack.append(np.clip(np.rint(grey), 0, 255).astype(np.uint8))
    return np.array(stack).reshape(len(EXPOSURES_US), 8, *COLUMN.shape)


def decoded(images: np.ndarray, settings: DecodeSettings | None = None) -> PhaseMap:
    return decode(stack_of(images, exposures_us=EXPOSURES_US), settings)["left"]


def observed_over_stated(found: PhaseMap) -> float:
    off = (found.column_px - COLUMN) * 2 * np.pi / found.pitch_px
    right = found.valid & (np.abs(off) < 0.5)  # of the right order
    return float(np.sqrt(np.mean(np.square(off[right] / found.sigma_rad[right]))))


@pytest.mark.parametrize(("full_well_e", "read_e"), [(4000.0, 15.0), (6000.0, 7.0), (20_000.0, 3.0)])
def test_the_images_give_gain_and_read_noise_so_that_the_phase_scatters_as_stated(full_well_e: float, read_e: float) -> None:
    found = decoded(taken(full_well_e, read_e, 1))
    assert found.evidence is not None and found.evidence.from_images
    assert found.evidence.full_well_e == pytest.approx(full_well_e, rel=0.15)
    assert found.evidence.scatter == pytest.approx(1.0, abs=0.1)
    assert observed_over_stated(found) == pytest.approx(1.0, abs=0.12)


def test_decoding_while_images_arrive_estimates_the_same() -> None:
    images = taken(12_000, 5, 2)
    decoder = StreamingDecoder(PAPER_PATTERNS, EXPOSURES_US, 255)
    for exposure, shown in enumerate(images):
        decoder.add("left", exposure, shown)
    one, other = decoder.finish()["left"], decoded(images)
    assert one.evidence == other.evidence
    assert np.array_equal(one.sigma_rad, other.sigma_rad)


def test_noise_that_was_measured_is_kept() -> None:
    known = CameraNoise(full_well_e=9000.0, read_noise_e=4.0)
    found = decoded(taken(9000, 4, 3), DecodeSettings(camera_noise={"left": known}))
    assert found.evidence is not None and not found.evidence.from_images
    assert found.evidence.full_well_e == 9000.0


def test_a_part_that_trembles_is_noticed_and_widens_the_stated_noise() -> None:
    still, moved = decoded(taken(100_000, 3, 4)), decoded(taken(100_000, 3, 4, move_px=0.15))
    assert still.evidence is not None and moved.evidence is not None
    assert still.evidence.vibration_rad == 0.0
    step_rad = 0.15 * 2 * np.pi / 32
    assert moved.evidence.vibration_rad == pytest.approx(step_rad * (1.5 / 4 / 10) ** 0.5, rel=0.5)
    assert np.median(moved.sigma_rad[moved.valid]) > 2 * np.median(still.sigma_rad[still.valid])
    assert observed_over_stated(moved) < 1.5


def test_a_lamp_that_comes_on_in_a_group_of_images_is_noticed() -> None:
    still, lit = decoded(taken(20_000, 3, 5)), decoded(taken(20_000, 3, 5, lamp=2))
    assert still.evidence is not None and lit.evidence is not None
    assert still.evidence.light_rad == 0.0 and abs(still.evidence.light_step) < 0.02
    assert lit.evidence.light_rad > 0.005
    assert lit.evidence.light_step > 0.1
    assert lit.evidence.light_exposure_us == 100_000


def test_a_lamp_that_comes_on_with_a_later_exposure_is_noticed_too() -> None:
    lit = decoded(taken(20_000, 3, 5, lamp=18))
    assert lit.evidence is not None
    assert lit.evidence.light_step > 0.1
    assert lit.evidence.light_exposure_us in (80_000, 60_000)


def test_a_gamma_is_neither_motion_nor_light() -> None:
    found = decoded(taken(20_000, 3, 6, gamma=1.3))
    assert found.evidence is not None
    assert found.evidence.vibration_rad == 0.0
    assert found.evidence.full_well_e == pytest.approx(20_000, rel=0.25)


@pytest.mark.parametrize("steps", [12, 4])
def test_recorded_sets_scatter_as_stated(steps: int) -> None:
    folder, every = recorded("slmaster_real_mono"), 12 // steps
    groups = (PhaseShiftGroup(pitch_px=60, steps=steps), GrayCodeGroup(planes=6, complementary=True))
    patterns = PatternSet(name="real", projector_px=1920, groups=groups, shift_sign=1)
    images = np.array([read_image(folder / f"{n:02d}.png") for n in [*range(0, 12, every), *range(12, 18)]])[None]
    found = decode(FringeStack("v", patterns, (1000,), {"one": images}, 255))["one"]
    assert 0.8 < 1 / scatter_of(found) < 1.25


@pytest.mark.parametrize("every", [1, 3])
def test_a_recorded_projector_without_gamma_correction_scatters_as_stated(every: int) -> None:
    folder = recorded("cfpe_statue")
    groups = tuple(PhaseShiftGroup(pitch_px=pitch, steps=12 // every) for pitch in (42, 45, 48))
    patterns = PatternSet(name="statue", projector_px=1920, groups=groups, shift_sign=1)
    images = np.array([read_image(folder / f"06{start + n:02d}h.png") for start in (0, 12, 24) for n in range(0, 12, every)])[None]
    assert 0.8 < 1 / scatter_of(decode(FringeStack("v", patterns, (1000,), {"one": images}, 255))["one"]) < 1.25


def scatter_of(found: PhaseMap) -> float:
    """Scatter about quadratic surfaces through 5 x 5 pixels over the stated noise, by medians."""
    y, x = np.mgrid[-2:3, -2:3].reshape(2, -1)
    surface = np.stack([np.ones(25), x, y, x * x, x * y, y * y], axis=1)
    residual = (np.eye(25) - surface @ np.linalg.pinv(surface))[12].reshape(5, 5)
    whole = cv2.erode(found.valid.astype(np.uint8), np.ones((5, 5), np.uint8), borderValue=0) > 0
    off = cv2.filter2D(found.phase_rad.astype(np.float64), -1, residual) / np.linalg.norm(residual)
    return float(1.4826 * np.median(np.abs(off[whole] / found.sigma_rad[whole])))
