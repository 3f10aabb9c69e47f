from __future__ import annotations

from math import tau

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.data.pattern_sets import PAPER_PATTERNS
from measureapp.fringe.noise.model import CameraNoise

EXPOSURES_US = (100_000, 80_000, 60_000, 40_000, 20_000)


def images_of(
    column_px: FloatArray,
    patterns: PatternSet,
    exposures_us: tuple[int, ...] = (100_000,),
    mean: FloatArray | float = 110.0,
    modulation: FloatArray | float = 80.0,
    seed: int | None = 1,
    saturation: int = 255,
) -> np.ndarray:
    """What a camera sees of the patterns at projector columns (H, W): grey levels at the first exposure, shot and read noise."""
    noise = CameraNoise()
    gain = noise.electrons_per_grey(saturation)
    random = np.random.default_rng(seed)
    stack = []
    for exposure in exposures_us:
        share = exposure / exposures_us[0]
        for group in patterns.groups:
            for n in range(group.count):
                clean = share * (mean + modulation * pattern_level(group, n, column_px, patterns))
                if seed is None:
                    grey = clean
                else:
                    electrons = random.poisson(np.maximum(clean, 0) * gain) + random.normal(0, noise.read_noise_e, column_px.shape)
                    grey = electrons / gain
                stack.append(np.clip(np.rint(grey), 0, saturation))
    shape = (len(exposures_us), patterns.count, *column_px.shape)
    return np.array(stack).reshape(shape).astype(np.uint8 if saturation <= 255 else np.uint16)


def pattern_level(group: PhaseShiftGroup | GrayCodeGroup, n: int, column_px: FloatArray, patterns: PatternSet) -> FloatArray:
    """Brightness of image ``n`` of a group at fractional columns, -1…1."""
    if isinstance(group, PhaseShiftGroup):
        return np.cos(tau * column_px / group.pitch_px + patterns.shift_sign * tau * n / group.steps)
    number = np.floor(column_px / (patterns.finest_pitch_px / (2 if group.complementary else 1))).astype(int)
    code = number ^ (number >> 1)
    return 2.0 * ((code >> (group.planes - 1 - n)) & 1) - 1.0


def stack_of(
    images: np.ndarray, patterns: PatternSet = PAPER_PATTERNS, exposures_us: tuple[int, ...] = (100_000,), saturation: int = 255
) -> FringeStack:
    images.flags.writeable = False
    return FringeStack("v", patterns, exposures_us, {"left": images}, saturation)


def ramp(height: int = 60, width: int = 400, first: float = 5.0, last: float = 1015.0) -> FloatArray:
    """Projector columns of a flat surface seen obliquely."""
    return np.linspace(first, last, width)[None, :] + 0.05 * np.arange(height)[:, None]


@pytest.fixture
def sets() -> dict[str, PatternSet]:
    """One pattern set of every kind."""
    sine = PhaseShiftGroup
    return {
        "two pitches": PAPER_PATTERNS,
        "two pitches, other sign": PAPER_PATTERNS.model_copy(update={"shift_sign": 1}),
        "three pitches": PatternSet(
            name="3", projector_px=1024, groups=(sine(pitch_px=16), sine(pitch_px=17.5, steps=3), sine(pitch_px=19.5))
        ),
        "unit frequency": PatternSet(name="1", projector_px=1024, groups=(sine(pitch_px=1056), sine(pitch_px=184), sine(pitch_px=32))),
        "gray": PatternSet(name="g", projector_px=1024, groups=(sine(pitch_px=32), GrayCodeGroup(planes=5))),
        "complementary gray": PatternSet(
            name="c", projector_px=1024, groups=(sine(pitch_px=32, steps=5), GrayCodeGroup(planes=6, complementary=True))
        ),
    }
