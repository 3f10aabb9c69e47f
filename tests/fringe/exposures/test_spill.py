"""Sensors that spill over are told from those that do not, and the guard pays for the former."""

from __future__ import annotations

from math import tau

import cv2
import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.fringe import FringeStack
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.decode import decode
from measureapp.fringe.exposures.spill import spill_radius_px
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.settings import DecodeSettings
from tests.fringe.conftest import ramp, stack_of

EXPOSURES_US = (100_000, 40_000, 16_000)
SHAPE = (120, 400)


def scene() -> tuple[FloatArray, FloatArray]:
    """Grey levels at the longest exposure, mean and modulation, of a dull surface with round highlights; a lens blurs it."""
    mean = np.full(SHAPE, 70.0)
    for number in range(8):
        cv2.circle(mean, (30 + 48 * number, 30 + 60 * (number % 2)), 6 + number % 3, 800.0, -1)
    mean = cv2.GaussianBlur(mean, (0, 0), 0.8)
    return mean, 0.7 * mean


def images(spilling: float, reach_px: float, seed: int) -> np.ndarray:
    """Images of a chip that gives a share of the charge beyond its full well to the pixels around, falling off over ``reach_px``."""
    random, noise = np.random.default_rng(seed), CameraNoise()
    per_grey = noise.electrons_per_grey(255)
    mean, modulation = scene()
    column = ramp(*SHAPE)
    y, x = np.mgrid[-12:13, -12:13]
    spread = np.exp(-np.hypot(x, y) / reach_px)
    taken = []
    for exposure in EXPOSURES_US:
        for group in PAPER_PATTERNS.groups:
            for n in range(group.count):
                clean = exposure / EXPOSURES_US[0] * (mean + modulation * np.cos(tau * column / group.pitch_px - tau * n / group.count))
                over = np.maximum(clean - 255, 0)
                clean = clean + spilling * cv2.filter2D(over, cv2.CV_64F, spread / spread.sum())
                electrons = random.poisson(clean * per_grey) + random.normal(0, noise.read_noise_e, SHAPE)
                taken.append(np.clip(np.rint(electrons / per_grey), 0, 255))
    return np.array(taken, np.uint8).reshape(len(EXPOSURES_US), PAPER_PATTERNS.count, *SHAPE)


def spilling_stack(spilling: float, reach_px: float = 1.0, seed: int = 1) -> FringeStack:
    return stack_of(images(spilling, reach_px, seed), exposures_us=EXPOSURES_US)


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_a_sensor_that_does_not_spill_over_needs_no_guard_even_behind_a_lens_that_blurs(seed: int) -> None:
    assert spill_radius_px(spilling_stack(0.0, seed=seed), "left", CameraNoise()) == 0


def test_a_wide_dark_surrounding_whose_grey_levels_are_mostly_rounding_is_no_spill() -> None:
    lit = images(0.0, 1.0, seed=1)
    dark = np.random.default_rng(2).random((*lit.shape[:3], 3000)) < 0.4
    stack = stack_of(np.concatenate([lit, dark.astype(np.uint8)], axis=-1), exposures_us=EXPOSURES_US)
    assert spill_radius_px(stack, "left", CameraNoise()) == 0


def test_a_single_exposure_or_no_highlight_determines_nothing() -> None:
    stack = spilling_stack(0.1)
    alone = FringeStack("v", PAPER_PATTERNS, EXPOSURES_US[:1], {"left": stack.images["left"][:1]}, 255)
    assert spill_radius_px(alone, "left", CameraNoise()) == 0
    dull = np.array(stack.images["left"][1:])[..., :4, :]
    assert spill_radius_px(stack_of(dull, exposures_us=EXPOSURES_US[1:]), "left", CameraNoise()) == 0


@pytest.mark.parametrize("reach_px", [0.7, 1.5])
def test_the_radius_grows_with_the_spill_and_the_guard_takes_its_error_out_of_the_phase(reach_px: float) -> None:
    stack = spilling_stack(0.1, reach_px)
    radius = spill_radius_px(stack, "left", CameraNoise())
    assert radius >= 1
    column = ramp(*SHAPE)
    errors, shares = [], []
    mean, _ = scene()
    around = cv2.dilate((mean > 300).astype(np.uint8), np.ones((2 * radius + 1,) * 2, np.uint8)) > 0
    for guard in (0, radius):
        found = decode(stack, DecodeSettings(blooming_radius_px=guard))["left"]
        rim = found.valid & around
        error = (found.column_px - column)[rim] * tau / 32 / found.sigma_rad[rim]
        errors.append(float(np.sqrt(np.mean(np.clip(error, -20, 20) ** 2))))
        shares.append(float(found.valid.mean()))
    assert errors[0] > 1.3  # in standard deviations of the phase
    assert errors[1] < 1.1  # noise alone is left
    assert shares[1] > shares[0] - 0.02
