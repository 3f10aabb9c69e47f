"""Stacks that cannot be what their pattern set says are refused by camera, exposure and image; good ones never."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from recorded import recorded

from measureapp.data.fringe import FringeStack, GrayCodeGroup, PatternSet, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe.checks.exposures import check_exposures
from measureapp.fringe.checks.stack import check_stack
from measureapp.project.images import read_image
from tests.fringe.conftest import images_of, pattern_level, ramp

SINE = PhaseShiftGroup
FOUR = PatternSet(name="4", projector_px=1024, groups=(SINE(pitch_px=32), SINE(pitch_px=33)))
THREE = PatternSet(name="3", projector_px=1024, groups=(SINE(pitch_px=32, steps=3), SINE(pitch_px=33, steps=3)))
SEVEN = PatternSet(name="7", projector_px=1024, groups=(SINE(pitch_px=32, steps=7), SINE(pitch_px=33, steps=7)))
GRAY = PatternSet(name="g", projector_px=1024, groups=(SINE(pitch_px=32), GrayCodeGroup(planes=6, complementary=True)))
BRACKET = (100_000, 50_000, 20_000)
Change = Callable[[np.ndarray], None]


def stack(patterns: PatternSet, exposures: tuple[int, ...] = BRACKET, change: Change | None = None, **scene: object) -> FringeStack:
    """A flat surface seen obliquely by one camera; ``change`` spoils its images."""
    images = images_of(ramp(), patterns, exposures, **scene)  # type: ignore[arg-type]
    if change is not None:
        change(images)
    return FringeStack("v", patterns, exposures, {"left": images}, int(scene.get("saturation", 255)))  # type: ignore[call-overload]


def copied(source: int, goal: int, exposure: int = 1) -> Change:
    def change(images: np.ndarray) -> None:
        images[exposure, goal] = images[exposure, source]

    return change


def taken_twice(patterns: PatternSet, source: int, goal: int) -> Change:
    """The projector did not step on: the same pattern, other noise."""

    def change(images: np.ndarray) -> None:
        images[0, goal] = images_of(ramp(), patterns, BRACKET, seed=7)[0, source]

    return change


def exchanged(first: int, second: int) -> Change:
    def change(images: np.ndarray) -> None:
        images[0, [first, second]] = images[0, [second, first]]

    return change


def filled(image: int, level: int | None) -> Change:
    """A constant image, or (None) the lit surface without fringes."""

    def change(images: np.ndarray) -> None:
        noise = np.random.default_rng(1).integers(-2, 3, images.shape[2:])
        images[0, image] = 190 + noise if level is None else level

    return change


@pytest.mark.parametrize("patterns", [THREE, FOUR, SEVEN, GRAY], ids=lambda patterns: patterns.name)
@pytest.mark.parametrize(
    "scene",
    [
        {},
        {"mean": 6.0, "modulation": 4.0},  # dark
        {"mean": 0.0, "modulation": 0.0},  # nothing at all
        {"mean": 900.0, "modulation": 700.0},  # saturated at every exposure
        {"mean": 150.0, "modulation": 140.0},  # saturated at the longest
        {"mean": 40.0, "modulation": 8.0},  # as much noise as fringes allow
        {"seed": None},  # rendered without noise
        {"saturation": 4095, "mean": 1800.0, "modulation": 1200.0},
    ],
    ids=["good", "dark", "black", "saturated", "partly saturated", "noisy", "noiseless", "12 bit"],
)
def test_good_stacks_pass(patterns: PatternSet, scene: dict[str, float]) -> None:
    check_stack(stack(patterns, **scene))


@pytest.mark.parametrize("patterns", [THREE, FOUR, SEVEN, GRAY], ids=lambda patterns: patterns.name)
def test_heavy_noise_passes(patterns: PatternSet) -> None:
    noise = np.random.default_rng(5).normal(0, 12, images_of(ramp(), patterns, BRACKET).shape)

    def change(images: np.ndarray) -> None:
        images[:] = np.clip(images + noise, 0, 255)

    check_stack(stack(patterns, change=change))


@pytest.mark.parametrize("gamma", [0.45, 2.2, 3.0])
@pytest.mark.parametrize("patterns", [THREE, FOUR, SEVEN, GRAY], ids=lambda patterns: patterns.name)
@pytest.mark.parametrize(("first", "last"), [(5.0, 1015.0), (300.0, 312.0), (498.0, 530.0)], ids=["wide", "confined", "one period"])
def test_a_projector_without_gamma_correction_passes_also_on_a_narrow_part(
    patterns: PatternSet, gamma: float, first: float, last: float
) -> None:
    columns = ramp(first=first, last=last)
    levels = [pattern_level(group, n, columns, patterns) for group in patterns.groups for n in range(group.count)]
    light = (0.5 + 0.5 * np.array(levels)) ** gamma
    random = np.random.default_rng(2)
    images = [np.clip(np.rint(share * (20 + 200 * light) + random.normal(0, 1, light.shape)), 0, 255) for share in (1.0, 0.5, 0.2)]
    check_stack(FringeStack("v", patterns, BRACKET, {"left": np.array(images, np.uint8)}, 255))


@pytest.mark.parametrize(
    ("patterns", "change", "words"),
    [
        (FOUR, copied(1, 2), r"Image 3 of camera 'left' at 50000 µs is the same as image 2 of camera 'left' at 50000 µs"),
        (FOUR, copied(0, 4), "Image 5 .* is the same as image 1 "),
        (THREE, copied(0, 2), "Image 3 .* is the same as image 1 "),
        (GRAY, copied(6, 8), "Image 9 .* is the same as image 7 "),
        (THREE, taken_twice(THREE, 0, 1), "Image 2 .* shows the same pattern as image 1 "),
        (FOUR, taken_twice(FOUR, 4, 6), "Image 7 .* at 100000 µs shows the same pattern as image 5 "),
        (FOUR, taken_twice(FOUR, 0, 5), "Image 6 .* shows the same pattern as image 1 "),
        (SEVEN, taken_twice(SEVEN, 2, 3), "Image 4 .* shows the same pattern as image 3 "),
        (GRAY, taken_twice(GRAY, 6, 7), "Image 8 .* shows the same Gray code plane as image 7 "),
        (FOUR, filled(2, 0), "Image 3 .* at 100000 µs is darker everywhere"),
        (FOUR, filled(5, 255), "Image 6 .* is brighter everywhere"),
        (FOUR, filled(1, None), "Image 2 .* is brighter everywhere"),
        (THREE, filled(1, 0), "Image 2 .* is darker everywhere"),
        (THREE, filled(4, None), "Image 5 .* is brighter everywhere"),
        (SEVEN, filled(9, 120), "Image 10 .* does not fit the other steps"),
        (SEVEN, taken_twice(SEVEN, 12, 2), "Image 3 .* does not fit the other steps"),
        (GRAY, filled(8, 0), "Image 9 .* is black everywhere"),
        (GRAY, filled(7, 255), "Image 8 .* is white everywhere"),
        (FOUR, exchanged(0, 1), "image . of .* and image . of .* appear to be exchanged"),
        (FOUR, exchanged(6, 7), "image . of .* and image . of .* appear to be exchanged"),
        (SEVEN, exchanged(2, 3), "image 3 of .* and image 4 of .* appear to be exchanged"),
        (SEVEN, exchanged(8, 12), "image 9 of .* and image 13 of .* appear to be exchanged"),
    ],
)
def test_a_spoilt_stack_is_refused_by_the_image(patterns: PatternSet, change: Change, words: str) -> None:
    with pytest.raises(DecodeError, match=words) as raised:
        check_stack(stack(patterns, change=change))
    assert raised.value.hint


PLAIN = PatternSet(name="p", projector_px=1024, groups=(SINE(pitch_px=32), GrayCodeGroup(planes=5)))


@pytest.mark.parametrize(
    ("drawn", "planes", "complementary", "words"),
    [
        (GRAY, 6, False, "the code is complementary, and its description does not state it"),
        (PatternSet(name="p", projector_px=1024, groups=(SINE(pitch_px=32), GrayCodeGroup(planes=6))), 6, True, "the code is plain"),
    ],
)
@pytest.mark.parametrize("turned", [0, 1])
def test_a_gray_code_of_another_kind_than_described_is_refused(drawn, planes, complementary, words, turned) -> None:
    """Whatever the origin of the sinusoids is: ``turned`` by a quarter of a period."""
    images = images_of(ramp(), drawn, BRACKET)
    images[:, :4] = np.roll(images[:, :4], turned, axis=1)
    described = drawn.model_copy(update={"groups": (SINE(pitch_px=32), GrayCodeGroup(planes=planes, complementary=complementary))})
    with pytest.raises(DecodeError, match=words) as refused:
        check_stack(FringeStack("v", described, BRACKET, {"left": images}, 255))
    assert "complementary = true" in refused.value.hint
    check_stack(FringeStack("v", drawn, BRACKET, {"left": images}, 255))


def test_inverse_planes_are_refused_with_the_number_of_those_to_give() -> None:
    images = images_of(ramp(), PLAIN, BRACKET)
    white, black = images[:, :4].max(axis=1, keepdims=True), images[:, :4].min(axis=1, keepdims=True)
    images = np.concatenate([images, white - (images[:, 4:] - black)], axis=1)
    described = PatternSet(name="i", projector_px=1024, groups=(SINE(pitch_px=32), GrayCodeGroup(planes=10)))
    with pytest.raises(DecodeError, match="inverse of image 5") as refused:
        check_stack(FringeStack("v", described, BRACKET, {"left": images}, 255))
    assert "first 5 images" in refused.value.hint


@pytest.mark.parametrize("patterns", [THREE, FOUR, GRAY], ids=lambda patterns: patterns.name)
def test_exchanged_exposures_are_named(patterns: PatternSet) -> None:
    def change(images: np.ndarray) -> None:
        images[[1, 2]] = images[[2, 1]]

    with pytest.raises(
        DecodeError, match=r"camera 'left' at 100000 µs are .* as bright as those at 50000 µs|at 50000 µs are 0\.4"
    ) as raised:
        check_stack(stack(patterns, change=change))
    assert "exchanged" in raised.value.hint or "automatic gain" in raised.value.hint


def test_an_exposure_that_was_not_taken_is_named() -> None:
    second = images_of(ramp(), FOUR, BRACKET, seed=9)[0]

    def change(images: np.ndarray) -> None:
        images[2] = second

    with pytest.raises(DecodeError, match=r"at 50000 µs are 0.50 times as bright as those at 20000 µs, not 2.50"):
        check_stack(stack(FOUR, change=change))


def test_exposures_that_flicker_by_a_tenth_pass() -> None:
    def change(images: np.ndarray) -> None:
        images[1] = np.rint(images[1] * 1.1)

    check_stack(stack(FOUR, change=change))


def bent(images: np.ndarray) -> None:
    """The response of a bad camera: 3 % of full scale off a straight line, most in the dark, and a lamp that varies by 1 %."""
    level = images / 255.0 * np.random.default_rng(3).normal(1.0, 0.01, (*images.shape[:2], 1, 1))
    images[:] = np.clip(np.rint(255.0 * (level + 0.2 * level * (1.0 - level) ** 2)), 0, 255)


def test_a_response_that_bends_makes_all_images_of_an_exposure_alike_brighter_and_passes() -> None:
    """Four equally shifted images that are brighter by the same share have the same phase."""
    check_exposures(stack(FOUR, (100_000, 80_000, 60_000, 40_000, 20_000), bent, mean=150.0, modulation=70.0))


def test_one_image_that_is_brighter_than_the_others_of_its_exposure_is_refused_as_a_whole() -> None:
    def brighter(images: np.ndarray) -> None:
        images[1, 3] = np.clip(np.rint(images[1, 3] * 1.1), 0, 255)

    with pytest.raises(
        DecodeError, match=r"Image 4 .* at 50000 µs contradicts the other exposures as a whole: it is 1\.\d+ times as bright"
    ):
        check_exposures(stack(FOUR, change=brighter))


def test_fringes_that_move_from_image_to_image_are_named_as_vibration() -> None:
    """Each image stands up to 3 px elsewhere; one image that does is a single mistake."""

    def shaken(images: np.ndarray) -> None:
        rng = np.random.default_rng(8)
        for level, image in np.ndindex(images.shape[:2]):
            images[level, image] = np.roll(images[level, image], int(rng.integers(-3, 4)), axis=-1)

    def displaced(images: np.ndarray) -> None:
        images[1, 2] = np.roll(images[1, 2], 3, axis=-1)

    exposures = (100_000, 80_000, 60_000, 40_000, 20_000)
    with pytest.raises(DecodeError, match=r"as bright as predicted: the fringes moved during the images, by vibration") as refused:
        check_exposures(stack(FOUR, exposures, shaken, mean=110.0, modulation=90.0))
    assert "wait longer after each move" in str(refused.value)
    with pytest.raises(DecodeError, match="contradicts the other exposures"):
        check_exposures(stack(FOUR, exposures, displaced, mean=110.0, modulation=90.0))


def test_cameras_of_different_bit_depths_are_refused() -> None:
    good = stack(FOUR)
    mixed = replace(good, images={**good.images, "right": good.images["left"].astype(np.uint16)})
    with pytest.raises(DecodeError, match="left: 8 bit, right: 16 bit"):
        check_stack(mixed)


def test_twelve_bit_images_among_ten_bit_ones_are_refused() -> None:
    ten = stack(FOUR, saturation=1023, mean=400.0, modulation=300.0)
    twelve = stack(FOUR, saturation=4095, mean=1800.0, modulation=1400.0)
    with pytest.raises(DecodeError, match=r"of camera 'right' .* has grey levels up to 3.*saturates at 1023"):
        check_stack(replace(ten, images={**ten.images, "right": twelve.images["left"]}))


def test_a_wrong_number_of_images_is_refused() -> None:
    good = stack(FOUR)
    with pytest.raises(DecodeError, match="'left' has images of shape"):
        check_stack(replace(good, images={"left": good.images["left"][:, :7]}))


def test_two_parts_behind_each_other_and_a_coarse_pitch_pass() -> None:
    patterns = PatternSet(name="1", projector_px=1024, groups=(SINE(pitch_px=1056), SINE(pitch_px=184), SINE(pitch_px=32)))
    columns = np.where(np.arange(400) < 200, 100.0, 628.0)[None, :] + np.linspace(0, 12, 400)[None, :] + np.zeros((60, 1))
    for chosen in (patterns, GRAY, FOUR, THREE):
        images = images_of(columns, chosen, BRACKET)
        check_stack(FringeStack("v", chosen, BRACKET, {"left": images}, 255))


def statue(folder: Path, every: int) -> FringeStack:
    groups = tuple(SINE(pitch_px=pitch, steps=12 // every) for pitch in (42, 45, 48))
    files = [folder / f"06{start + n:02d}h.png" for start in (0, 12, 24) for n in range(0, 12, every)]
    return recorded_stack(files, PatternSet(name="statue", projector_px=1920, groups=groups, shift_sign=1))


def recorded_stack(files: list[Path], patterns: PatternSet) -> FringeStack:
    return FringeStack("v", patterns, (1000,), {"one": np.array([read_image(file) for file in files])[None]}, 255)


@pytest.mark.parametrize("every", [1, 2, 3, 4])
def test_the_statue_without_gamma_correction_passes_and_is_refused_when_spoilt(every: int) -> None:
    good = statue(recorded("cfpe_statue"), every)
    check_stack(good)
    images = good.images["one"].copy()
    images[0, 1] = images[0, 0]
    with pytest.raises(DecodeError, match=r"Image 2 .* is the same as image 1"):
        check_stack(replace(good, images={"one": images}))


def test_the_other_recorded_sets_pass() -> None:
    mono, stereo, three = (recorded(name) for name in ("slmaster_real_mono", "slmaster_render_stereo", "slmaster_render_3freq"))
    gray = GrayCodeGroup(planes=6, complementary=True), GrayCodeGroup(planes=7, complementary=True)
    real = PatternSet(name="r", projector_px=1920, groups=(SINE(pitch_px=60, steps=12), gray[0]), shift_sign=1)
    pair = PatternSet(name="s", projector_px=1920, groups=(SINE(pitch_px=30), gray[1]), shift_sign=1)
    check_stack(recorded_stack([mono / f"{n:02d}.png" for n in range(18)], real))
    for side in "LR":
        check_stack(recorded_stack([stereo / side / f"{n:02d}.png" for n in (0, 3, 6, 9, *range(12, 19))], pair))
    groups = tuple(SINE(pitch_px=1920 / periods) for periods in (64, 58, 53))
    check_stack(recorded_stack([three / f"{n:02d}.png" for n in range(12)], PatternSet(name="3", projector_px=1920, groups=groups)))
