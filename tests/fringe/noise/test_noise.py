"""The noise model is recovered from simulated flats and fringes, as surely as it says."""

from __future__ import annotations

import numpy as np
import pytest
from recorded import recorded

from measureapp.data.fringe import FringeStack, PatternSet, PhaseShiftGroup
from measureapp.errors import CalibrationError
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.noise.photon_transfer import NoiseEstimate, estimate_noise, rounded_variance
from measureapp.fringe.noise.stack_noise import noise_of_stack
from measureapp.project.images import read_image
from tests.fringe.conftest import pattern_level, ramp

SHARES = (0.03, 0.08, 0.2, 0.4, 0.7, 0.9)
SHAPE = (160, 240)
DRAWS = 12  # which tell a standard deviation to 21 %


def flats(
    camera: CameraNoise, saturation: int, seed: int, shares: tuple[float, ...] = SHARES, count: int = 2, drift: float = 0.0
) -> list[np.ndarray]:
    """Images of a flat with vignetting and fixed pattern at several shares of saturation, (count, H, W) each."""
    random = np.random.default_rng(seed)
    gain = camera.electrons_per_grey(saturation)
    y, x = np.mgrid[-1 : 1 : SHAPE[0] * 1j, -1 : 1 : SHAPE[1] * 1j]
    pattern = (1 - 0.2 * (x**2 + y**2)) * (1 + 0.01 * random.normal(size=SHAPE))
    levels = []
    for share in shares:
        images = []
        for number in range(count):
            light = share * saturation * pattern * (1 + drift * number)
            grey = camera.black_grey + (random.poisson(light * gain) + random.normal(0, camera.read_noise_e, SHAPE)) / gain
            images.append(np.clip(np.rint(grey / camera.step_grey) * camera.step_grey, 0, saturation))
        levels.append(np.array(images, np.uint8 if saturation <= 255 else np.uint16))
    return levels


CAMERAS = [
    (CameraNoise(full_well_e=6000, read_noise_e=7), 255),
    (CameraNoise(full_well_e=60_000, read_noise_e=60), 255),  # noise of a quarter of a grey level in the dark
    (CameraNoise(full_well_e=10_000, read_noise_e=8), 1023),
    (CameraNoise(full_well_e=10_000, read_noise_e=8), 4095),
    (CameraNoise(full_well_e=30_000, read_noise_e=20), 65535),
    (CameraNoise(full_well_e=10_000, read_noise_e=8, step_grey=16), 65535),  # 12 bits stretched to 16
    (CameraNoise(full_well_e=10_000, read_noise_e=8, black_grey=64), 4095),
]


@pytest.mark.parametrize(("camera", "saturation"), CAMERAS)
def test_gain_and_read_noise_are_recovered_with_the_predicted_scatter(camera: CameraNoise, saturation: int) -> None:
    found: list[NoiseEstimate] = []
    for seed in range(DRAWS):
        dark = flats(camera, saturation, seed + 100, (0.0,))[0] if camera.black_grey else None
        found.append(estimate_noise(flats(camera, saturation, seed), saturation, "left", dark))
    for truth, values, sds in (
        (camera.full_well_e, [e.noise.full_well_e for e in found], [e.full_well_sd_e for e in found]),
        (camera.read_noise_e, [e.noise.read_noise_e for e in found], [e.read_noise_sd_e for e in found]),
    ):
        predicted = float(np.mean(sds))
        assert abs(np.mean(values) - truth) < 4 * predicted / DRAWS**0.5
        assert 0.55 < np.std(values, ddof=1) / predicted < 1.6
        assert predicted < 0.1 * truth
    assert np.mean([e.chi2 for e in found]) == pytest.approx(1.0, abs=0.35)
    assert all(e.accepted and e.verdict.startswith("sound") for e in found)
    assert {e.noise.step_grey for e in found} == {camera.step_grey}
    assert found[0].noise.black_grey == pytest.approx(camera.black_grey, abs=0.05)


def test_read_noise_below_what_rounding_leaves_visible_is_not_claimed() -> None:
    found = estimate_noise(flats(CameraNoise(full_well_e=60_000, read_noise_e=1), 255, 1), 255)
    assert found.noise.full_well_e == pytest.approx(60_000, abs=4 * found.full_well_sd_e)
    assert found.noise.read_noise_e < 1 + 4 * found.read_noise_sd_e
    assert found.read_noise_sd_e > 1


@pytest.mark.parametrize("sigma", [0.02, 0.1, 0.2, 0.3, 0.5, 2.0])
def test_the_variance_of_rounded_values_is_that_of_a_simulation(sigma: float) -> None:
    random = np.random.default_rng(3)
    mean = random.uniform(0, 50, 400_000)
    one, two = (np.rint(mean + sigma * random.normal(size=mean.size)) for _ in range(2))
    half_squares = (one - two) ** 2 / 2
    tolerance = 4 * half_squares.std() / mean.size**0.5 + (1e-3 if sigma < 0.1 else 0)  # the series is cut off
    assert float(rounded_variance(np.array(sigma**2), 1.0)) == pytest.approx(half_squares.mean(), abs=tolerance)


def test_more_images_of_each_level_are_all_used() -> None:
    camera = CameraNoise()
    two, eight = (estimate_noise(flats(camera, 255, 1, count=count), 255) for count in (2, 8))
    assert eight.full_well_sd_e < 0.55 * two.full_well_sd_e
    assert eight.noise.full_well_e == pytest.approx(camera.full_well_e, abs=4 * eight.full_well_sd_e)


def test_saturated_levels_and_a_lamp_that_drifts_by_a_percent_do_no_harm() -> None:
    camera = CameraNoise()
    found = estimate_noise(flats(camera, 255, 2, (*SHARES, 1.1, 1.6), drift=0.01), 255)
    assert found.noise.full_well_e == pytest.approx(camera.full_well_e, rel=0.02)
    assert found.noise.read_noise_e == pytest.approx(camera.read_noise_e, abs=0.6)


def test_a_few_pixels_that_moved_or_blink_do_no_harm() -> None:
    camera = CameraNoise()
    levels = flats(camera, 255, 2)
    for images in levels:
        images[0, ::37, ::41] = 200
    found = estimate_noise(levels, 255)
    assert found.noise.full_well_e == pytest.approx(camera.full_well_e, rel=0.03)


@pytest.mark.parametrize(
    ("levels", "words"),
    [
        (flats(CameraNoise(), 255, 1, (1.9, 2.5)), "saturated, black, or too small"),
        (flats(CameraNoise(), 255, 1, (0.0,)), "saturated, black, or too small"),
        (flats(CameraNoise(full_well_e=10_000), 4095, 1, (0.05,)), "usable brightness levels from"),
        (flats(CameraNoise(), 255, 1, drift=0.05), "level 1 of camera 'left' differ by 5|level 2 of camera 'left' differ by 5"),
        (flats(CameraNoise(), 255, 1, count=1), "level 1 of camera 'left' has a single image"),
        (flats(CameraNoise(full_well_e=10_000, black_grey=30), 255, 1), "it has a black level"),
    ],
    ids=["saturated", "dark", "one level", "drift", "single", "black level"],
)
def test_flats_without_an_answer_are_refused_in_words(levels: list[np.ndarray], words: str) -> None:
    with pytest.raises(CalibrationError, match=words) as raised:
        estimate_noise(levels, 255 if levels[0].dtype == np.uint8 else 4095, "left")
    assert raised.value.hint


def test_images_that_are_not_raw_are_refused_or_reported() -> None:
    levels = flats(CameraNoise(), 255, 1)
    smoothed = [np.rint(255 * (images / 255.0) ** 0.45).astype(np.uint8) for images in levels]
    with pytest.raises(CalibrationError, match="does not grow with its brightness") as raised:
        estimate_noise(smoothed, 255)
    assert "gamma" in raised.value.hint
    bent = [np.rint(255 * (images / 255.0) ** 1.5).astype(np.uint8) for images in levels]
    try:
        assert not estimate_noise(bent, 255).verdict.startswith("sound")
    except CalibrationError as error:
        assert "black level" in error.message


def fringes(steps: int, gamma: float, seed: int) -> FringeStack:
    """Fringes on a surface of uneven albedo, shown by a projector with this response."""
    random = np.random.default_rng(seed)
    columns, camera = ramp(240, 400), CameraNoise()
    albedo = np.linspace(0.15, 1.0, len(columns))[:, None]
    patterns = PatternSet(name="p", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32, steps=steps),))
    gain = camera.electrons_per_grey(255)
    images = []
    for n in range(steps):
        light = (0.5 + 0.5 * pattern_level(patterns.groups[0], n, columns, patterns)) ** gamma
        electrons = random.poisson(albedo * (20 + 200 * light) * gain) + random.normal(0, camera.read_noise_e, columns.shape)
        images.append(np.clip(np.rint(electrons / gain), 0, 255))
    return FringeStack("v", patterns, (1000,), {"left": np.array([images], np.uint8)}, 255)


@pytest.mark.parametrize(("steps", "gamma"), [(4, 1.0), (5, 1.0), (6, 1.0), (8, 1.0), (12, 1.0), (12, 2.2)])
def test_fringe_images_determine_the_noise_within_its_stated_uncertainty(steps: int, gamma: float) -> None:
    found = [noise_of_stack(fringes(steps, gamma, seed), "left") for seed in range(8)]
    for truth, values, sds in (
        (6000.0, [e.noise.full_well_e for e in found], [e.full_well_sd_e for e in found]),
        (7.0, [e.noise.read_noise_e for e in found], [e.read_noise_sd_e for e in found]),
    ):
        assert abs(np.mean(values) - truth) < 4 * np.mean(sds) / 8**0.5
        assert 0.4 < np.std(values, ddof=1) / np.mean(sds) < 1.9
    assert all(e.accepted for e in found)


@pytest.mark.parametrize("steps", [3, 4, 5, 6])
def test_harmonics_of_the_projector_are_never_taken_for_noise(steps: int) -> None:
    try:
        found = noise_of_stack(fringes(steps, 2.2, 1), "left")
    except CalibrationError as error:
        assert error.hint
    else:
        assert not found.accepted or found.noise.full_well_e == pytest.approx(6000, rel=0.05)


def test_recorded_fringes_with_harmonics_are_reported_as_poor_or_refused() -> None:
    folder = recorded("cfpe_statue")
    groups = tuple(PhaseShiftGroup(pitch_px=pitch, steps=12) for pitch in (42, 45, 48))
    images = np.array([read_image(folder / f"06{n:02d}h.png") for n in range(36)])[None]
    patterns = PatternSet(name="statue", projector_px=1920, groups=groups, shift_sign=1)
    found = noise_of_stack(FringeStack("v", patterns, (1000,), {"one": images}, 255), "one")
    assert not found.accepted
    assert found.verdict.startswith("poor")
    dark = [point for point in found.points if point.mean < 60]
    assert all(point.variance < 3.5 for point in dark)  # the shot noise of the darker part is seen all the same
