"""Blur shifts the phase where the light changes across the image; what is known of it is taken back."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.data.calibration import CameraArrayCalibration, CameraCalibration
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.geometry.pinhole import PinholeCamera
from measureapp.geometry.transform import RigidTransform
from measureapp.reconstruct import blur
from measureapp.reconstruct.blur import correct_blur

HEIGHT, WIDTH, BLUR_PX, STEP_RAD, NOISE_RAD = 60, 80, 0.8, 3.0, 0.01
ROWS, COLUMNS = np.mgrid[:HEIGHT, :WIDTH].astype(float)
PHASE = 20.0 + 0.5 * COLUMNS + 0.2 * ROWS
INNER = (slice(9, -9), slice(9, -9))  # beyond the image nothing is known of what is blurred into its borders


def camera(blur_px: float) -> CameraArrayCalibration:
    lens = PinholeCamera(WIDTH, HEIGHT, np.array([[90.0, 0, 40], [0, 90, 30], [0, 0, 1]]), np.zeros(5))
    return CameraArrayCalibration("one", {"one": CameraCalibration("one", lens, RigidTransform.identity("camera", "one"), blur_px=blur_px)})


def seen(light: FloatArray, true_phase: FloatArray = PHASE) -> PhaseMap:
    """What a blurred camera decodes: fringes of any direction add up like their complex amplitudes."""
    amplitude = light * np.exp(1j * true_phase)
    blurred = cv2.GaussianBlur(amplitude.real, (0, 0), BLUR_PX) + 1j * cv2.GaussianBlur(amplitude.imag, (0, 0), BLUR_PX)
    phase = true_phase + np.angle(blurred * np.exp(-1j * true_phase))
    grey = np.rint(cv2.GaussianBlur(light, (0, 0), BLUR_PX)).astype(np.uint16)
    same = np.full(PHASE.shape, NOISE_RAD, np.float32)
    nothing = np.zeros(PHASE.shape, np.uint8)
    modulation = np.rint(np.abs(blurred)).astype(np.uint16)  # steep fringes lose some, and the mean none
    return PhaseMap("one", "v", phase.astype(np.float32), same, modulation, grey, nothing, nothing.astype(np.int8), 16.0, 1024)


@pytest.mark.parametrize(
    ("light", "left"),
    [
        (2000 * np.exp(0.02 * COLUMNS), 0.02),  # of the shift: what is blurred by the fringes' own slope is of the second order
        (2000 * np.exp(-0.03 * ROWS), 0.03),
        (2000 * np.exp(0.02 * COLUMNS - 0.02 * ROWS), 0.02),
        (3000 * (1 + 0.5 * np.tanh((COLUMNS - 40) / 4)), 0.03),  # a printed edge 8 px wide
        (np.where(COLUMNS >= 40, 3600.0, 2000.0), 0.13),  # one as sharp as the blur leaves it, of which differences of pixels lose a part
        (np.where(ROWS >= 30, 2600.0, 2000.0), 0.13),
    ],
)
def test_the_shift_by_changing_light_is_corrected(light: FloatArray, left: float) -> None:
    phase_map = seen(light)
    before = np.abs(phase_map.phase_rad - PHASE)[INNER].max()
    after = np.abs(correct_blur({"one": phase_map}, camera(BLUR_PX), STEP_RAD)["one"].phase_rad - PHASE)[INNER].max()
    assert before > 0.003
    assert after < left * before + 1e-4  # grey levels are whole numbers


def test_a_step_of_the_light_shifts_nothing_further_away_than_the_blur_reaches() -> None:
    made = correct_blur({"one": seen(np.where(COLUMNS >= 40, 3000.0, 2000.0))}, camera(BLUR_PX), STEP_RAD)["one"]
    beyond = INNER[0], np.r_[9:38, 42 : WIDTH - 9]
    np.testing.assert_allclose(made.phase_rad[beyond], PHASE[beyond], atol=0.003)


@pytest.mark.parametrize("bend", [0.002 * (COLUMNS - 40) ** 2, -0.003 * (ROWS - 30) ** 2, 0.002 * ((COLUMNS - 40) ** 2 + (ROWS - 30) ** 2)])
def test_the_shift_by_a_curved_surface_is_corrected(bend: FloatArray) -> None:
    round_part = PHASE + bend
    phase_map = seen(np.full(PHASE.shape, 2000.0), round_part)
    before = np.mean((phase_map.phase_rad - round_part)[INNER])
    after = np.mean((correct_blur({"one": phase_map}, camera(BLUR_PX), STEP_RAD)["one"].phase_rad - round_part)[INNER])
    assert abs(before) > 0.001
    assert abs(after) < 0.05 * abs(before)


@pytest.mark.parametrize("away", np.linspace(-0.5, 0.5, 5))
def test_an_edge_of_two_planes_is_no_bend_and_noise_hardly_grows(away: float) -> None:
    """Where the edge is within two pixels its own blur is far larger than what is taken for a bend beside it."""
    beside = np.abs(COLUMNS - 40 - away) > 2.5
    even = np.full(PHASE.shape, 2000.0)
    edge = PHASE + 0.3 * np.abs(COLUMNS - 40 - away)
    phase_map = replace(seen(even, edge), phase_rad=edge.astype(np.float32))
    made = correct_blur({"one": phase_map}, camera(BLUR_PX), STEP_RAD)["one"]
    np.testing.assert_allclose(made.phase_rad[beside], phase_map.phase_rad[beside], atol=2e-4)  # light of whole grey levels
    noise = np.random.default_rng(1).normal(0.0, 0.01, PHASE.shape)
    noisy = replace(seen(even), phase_rad=(PHASE + noise).astype(np.float32))
    left = (correct_blur({"one": noisy}, camera(BLUR_PX), STEP_RAD)["one"].phase_rad - PHASE)[INNER]
    assert left.std() < 1.05 * noise[INNER].std()


def test_at_the_edge_of_a_round_body_neither_light_nor_curvature_is_corrected_alone() -> None:
    """Towards the rim the light falls and the phase bends, both like the root of the distance; what each does all but cancels."""
    rim = 15
    away = np.sqrt(np.maximum(COLUMNS - rim + 0.5, 0.0))
    on = rim <= COLUMNS
    round_part, light = 20.0 + 1.6 * away, np.where(on, 1500.0 * (1 + 0.16 * away), 300.0)
    blurred = seen(light, np.where(on, round_part, 14.0))
    state = np.where(rim + 2 <= COLUMNS, 0, PixelState.EDGE).astype(np.uint8)
    made = correct_blur({"one": replace(blurred, state=state)}, camera(BLUR_PX), STEP_RAD)["one"].phase_rad
    error = (made - round_part)[30]
    alone = np.gradient(np.log(light), axis=1)[30] * np.gradient(round_part, axis=1)[30] * BLUR_PX**2  # what the light alone would take off
    assert alone[rim + 5] > 0.005
    assert np.abs(error[rim + 5 : rim + 12]).max() < 0.2 * alone[rim + 5]


def doubt(made: PhaseMap) -> FloatArray:
    """What `correct_blur` added to the noise, in rad."""
    return np.asarray(np.sqrt(np.maximum(made.sigma_rad.astype(float) ** 2 - NOISE_RAD**2, 0.0)))


@pytest.mark.parametrize("bend", [0.0, 0.01])
def test_beside_a_hole_the_shift_is_taken_back_by_the_other_side_and_its_doubt_counts_as_noise(bend: float) -> None:
    beside = (INNER[0], slice(57, 60))
    true_phase = PHASE + bend * (COLUMNS - 60) ** 2
    steep = seen(60 * np.exp(0.08 * COLUMNS), true_phase)
    cut = replace(steep, state=np.where(COLUMNS >= 60, PixelState.SHADOW, 0).astype(np.uint8))
    made = correct_blur({"one": cut}, camera(BLUR_PX), STEP_RAD)["one"]
    before, left = (np.abs(each.phase_rad - true_phase)[beside] for each in (steep, made))
    assert before.min() > 0.02
    assert left.max() < 0.35 * before.max()
    assert (left < 1.01 * doubt(made)[beside]).all()
    assert doubt(made)[9:-9, 9:57].max() < 0.1 * NOISE_RAD


@pytest.mark.parametrize("brighter", [1, -1])
def test_where_the_light_falls_too_fast_what_the_first_order_allows_is_taken_back_and_the_rest_counts_as_noise(brighter: int) -> None:
    """As at the border of a lit surface, where an exact correction would need more than the slopes at the pixel."""
    lit = seen(4000 / (1 + np.exp(-brighter * (COLUMNS - 40) / 1.2)) + 20)
    made = correct_blur({"one": lit}, camera(BLUR_PX), STEP_RAD)["one"]
    dim = (INNER[0], slice(35, 38) if brighter > 0 else slice(43, 46))
    before, left = (np.abs(each.phase_rad - PHASE)[dim] for each in (lit, made))
    assert left.max() < 0.7 * before.max()
    assert (left < 1.5 * doubt(made)[dim]).all()


@pytest.mark.parametrize("rim", [15.0, 15.25, 15.5, 15.75])
def test_at_the_edge_of_a_round_body_the_residual_counts_as_noise(rim: float) -> None:
    away = np.sqrt(np.maximum(COLUMNS - rim + 0.5, 0.0))
    on = rim <= COLUMNS
    round_part = 20.0 + 1.6 * away
    blurred = seen(np.where(on, 1500.0 * (1 + 0.16 * away), 300.0), np.where(on, round_part, 14.0))
    state = np.where(rim + 2 <= COLUMNS, 0, PixelState.EDGE).astype(np.uint8)
    made = correct_blur({"one": replace(blurred, state=state)}, camera(BLUR_PX), STEP_RAD)["one"]
    first = int(np.ceil(rim)) + 2
    left = np.abs(made.phase_rad - round_part)[30, first : first + 6]
    assert (left < 2.0 * doubt(made)[30, first : first + 6] + 0.1 * NOISE_RAD).all()


@pytest.mark.parametrize("away", np.linspace(-0.5, 0.5, 5))
@pytest.mark.parametrize("fold", [0.1, -0.3, 0.6])
def test_at_an_edge_of_two_planes_what_blur_does_counts_as_noise(away: float, fold: float) -> None:
    folded = PHASE + fold * np.abs(COLUMNS - 40 - away)
    made = correct_blur({"one": seen(np.full(PHASE.shape, 2000.0), folded)}, camera(BLUR_PX), STEP_RAD)["one"]
    left = np.abs(made.phase_rad - folded)[INNER]
    assert left.max() > 0.1 * abs(fold)
    assert (left < 2.0 * doubt(made)[INNER] + 0.1 * NOISE_RAD).all()


def test_flat_and_evenly_bent_parts_are_as_certain_as_they_were() -> None:
    noise = np.random.default_rng(2).normal(0.0, NOISE_RAD, PHASE.shape)
    for bend in (0.0, 0.003 * (COLUMNS - 40) ** 2):
        phase_map = seen(2000 * np.exp(0.02 * COLUMNS), PHASE + bend)
        noisy = replace(phase_map, phase_rad=(phase_map.phase_rad + noise).astype(np.float32))
        made = correct_blur({"one": noisy}, camera(BLUR_PX), STEP_RAD)["one"]
        assert np.mean(made.sigma_rad[INNER]) < 1.01 * NOISE_RAD


def test_the_error_of_interpolating_a_curved_phase_is_corrected() -> None:
    bend = 0.003 * (COLUMNS - 40) ** 2
    phase_map = seen(np.full(PHASE.shape, 2000.0), PHASE + bend)
    made = correct_blur({"one": phase_map}, camera(BLUR_PX), STEP_RAD, interpolated=["one"])["one"].phase_rad
    places = np.linspace(0, 1, 101)[:-1] + 0.005
    left, right = made[INNER][:, :-1, None], made[INNER][:, 1:, None]
    between = COLUMNS[INNER][:, :-1, None] + places
    error = left + places * (right - left) - (20.0 + 0.5 * between + 0.2 * ROWS[INNER][:, :-1, None] + 0.003 * (between - 40) ** 2)
    assert abs(error.mean()) < 0.1 * 0.006 / 12


def test_evenly_lit_fringes_a_sharp_camera_and_one_of_unknown_blur_change_nothing() -> None:
    even, steep = seen(np.full(PHASE.shape, 2000.0)), seen(2000 * np.exp(0.02 * COLUMNS))
    made = correct_blur({"one": even}, camera(BLUR_PX), STEP_RAD)["one"]
    np.testing.assert_allclose(made.phase_rad[INNER], even.phase_rad[INNER], atol=4e-6)
    assert correct_blur({"one": steep}, camera(0.0), STEP_RAD)["one"] is steep
    assert correct_blur({"other": steep}, camera(BLUR_PX), STEP_RAD)["other"] is steep


@pytest.mark.usefixtures("all_light_from_projector")
def test_pixels_without_a_phase_stay_so_and_do_not_reach_their_neighbours() -> None:
    steep = seen(2000 * np.exp(0.02 * COLUMNS))
    state, phase = np.array(steep.state), np.array(steep.phase_rad)
    state[30, 40], phase[30, 40] = PixelState.SHADOW, 0.0
    made = correct_blur({"one": replace(steep, state=state, phase_rad=phase)}, camera(BLUR_PX), STEP_RAD)["one"].phase_rad
    assert made[30, 40] == 0.0
    whole = correct_blur({"one": steep}, camera(BLUR_PX), STEP_RAD)["one"].phase_rad
    touched = np.argwhere(np.abs(made - whole) > 1e-6)
    near = {(30 + a, 40) for a in (-3, -2, 2, 3)} | {(30, 40 + a) for a in (-3, -2, 2, 3)}
    assert {(int(y), int(x)) for y, x in touched} <= {(30, 40), *near}
    np.testing.assert_allclose(made[30, [38, 42]], PHASE[30, [38, 42]], atol=1e-4)  # the shift is known from their other sides


def test_horizontal_fringes_of_the_same_images_follow() -> None:
    steep = seen(2000 * np.exp(0.02 * COLUMNS))
    made = correct_blur({"one": replace(steep, orthogonal=replace(steep, direction="horizontal"))}, camera(BLUR_PX), STEP_RAD)["one"]
    assert made.orthogonal is not None
    np.testing.assert_array_equal(made.orthogonal.phase_rad, made.phase_rad)


@pytest.fixture
def all_light_from_projector(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ambient light is found from places all over an image, by which parts of it would differ."""
    monkeypatch.setattr(blur, "projector_light", lambda phase_map, *_: phase_map.grey)


def columns_of(whole: PhaseMap, width: int) -> PhaseMap:
    names = ("phase_rad", "sigma_rad", "modulation", "grey", "state", "exposure_index")
    return replace(whole, **{name: np.ascontiguousarray(getattr(whole, name)[:, :width]) for name in names})


@pytest.mark.usefixtures("all_light_from_projector")
@pytest.mark.parametrize("width", [28, 29, 43, 45])
def test_columns_beyond_the_last_whole_vector_are_corrected_like_all_others(width: int) -> None:
    whole = seen(2000 * np.exp(0.02 * COLUMNS), PHASE + 0.004 * COLUMNS**2 + 0.003 * ROWS**2)
    part = columns_of(whole, width)
    wide, narrow = (correct_blur({"one": each}, camera(BLUR_PX), STEP_RAD)["one"] for each in (whole, part))
    assert np.array_equal(narrow.phase_rad[:, :-6], wide.phase_rad[:, : width - 6])
    assert np.array_equal(narrow.sigma_rad[:, :-6], wide.sigma_rad[:, : width - 6])
    assert np.array_equal(narrow.phase_rad[:, -6:], part.phase_rad[:, -6:])
    assert not np.array_equal(narrow.phase_rad, part.phase_rad)


def test_images_too_narrow_for_it_stay() -> None:
    part = columns_of(seen(2000 * np.exp(0.02 * COLUMNS)), 12)
    assert np.array_equal(correct_blur({"one": part}, camera(BLUR_PX), STEP_RAD)["one"].phase_rad, part.phase_rad)
