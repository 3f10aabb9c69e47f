"""Standard deviations and yield on the recorded sets, beside a plain decoder; `-s` prints the table of `resources/docs/measurements.md`."""

from __future__ import annotations

import sys
from dataclasses import replace

import numpy as np
import pytest
from recorded import recorded

from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.project.images import read_image
from tests.other_worlds.figures import Figures, figures_of
from tests.reconstruct.diagnosis.test_diagnose_decoded import cameras_of
from tests.reconstruct.test_far_and_faint import dimmed

pytestmark = pytest.mark.slow

FOUR_OF_TWELVE = (0, 3, 6, 9)


def stack(name: str, files: dict[str, list[str]], groups: tuple[PhaseShiftGroup | GrayCodeGroup, ...]) -> FringeStack:
    images = {camera: np.array([read_image(recorded(name) / file) for file in every])[None] for camera, every in files.items()}
    return FringeStack("v", PatternSet(name="r", projector_px=1920, groups=groups, shift_sign=1), (1000,), images, 255)


def numbered(numbers: list[int], pattern: str = "{:02d}.png") -> list[str]:
    return [pattern.format(number) for number in numbers]


def rendered_pair() -> FringeStack:
    numbers = [*FOUR_OF_TWELVE, *range(12, 19)]
    files = {camera: numbered(numbers, camera[0].upper() + "/{:02d}.png") for camera in ("left", "right")}
    return stack("slmaster_render_stereo", files, (PhaseShiftGroup(pitch_px=30), GrayCodeGroup(planes=7, complementary=True)))


def real_camera(every: int) -> FringeStack:
    numbers = [*range(0, 12, every), *range(12, 18)]
    groups = (PhaseShiftGroup(pitch_px=60, steps=12 // every), GrayCodeGroup(planes=6, complementary=True))
    return stack("slmaster_real_mono", {"one": numbered(numbers)}, groups)


def statue(every: int) -> FringeStack:
    numbers = [start + n for start in (0, 12, 24) for n in range(0, 12, every)]
    groups = tuple(PhaseShiftGroup(pitch_px=pitch, steps=12 // every) for pitch in (42, 45, 48))
    return stack("cfpe_statue", {"one": numbered(numbers, "06{:02d}h.png")}, groups)


def checked(name: str, figures: Figures, most_wrong: float = 1e-3) -> None:
    sys.stdout.write("\n" + figures.row(name))
    assert figures.decoded > 0.95
    assert figures.wrong < most_wrong
    assert 0.8 < figures.phase_ratio < 1.25
    if figures.pairs:
        assert figures.points > 0.95
        assert 0.8 < figures.point_ratio < 1.25


def test_the_rendered_pair() -> None:
    checked("rendered pair", figures_of(rendered_pair(), cameras_of(recorded("slmaster_render_stereo"))))


def test_the_rendered_pair_dimmed() -> None:
    bright = rendered_pair()
    faint = replace(bright, images={name: dimmed(images, 0.08, 1) for name, images in bright.images.items()})
    checked("rendered pair, dimmed", figures_of(faint, cameras_of(recorded("slmaster_render_stereo")), (5.0, 15.0)))


def test_three_rendered_pitches() -> None:
    groups = tuple(PhaseShiftGroup(pitch_px=1920 / periods) for periods in (64, 58, 53))
    checked("rendered, three pitches", figures_of(stack("slmaster_render_3freq", {"one": numbered([*range(12)])}, groups)))


@pytest.mark.parametrize("every", [1, 3])
def test_the_real_camera(every: int) -> None:
    checked(f"real camera, {12 // every} steps", figures_of(real_camera(every)))


@pytest.mark.parametrize("every", [1, 3])
def test_the_statue(every: int) -> None:
    checked(f"statue, {12 // every} steps", figures_of(statue(every)))
