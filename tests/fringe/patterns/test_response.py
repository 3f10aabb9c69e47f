from __future__ import annotations

import numpy as np
import pytest
from recorded import recorded

from measureapp.arrays import FloatArray
from measureapp.data.fringe import FringeStack, PatternSet, PhaseShiftGroup
from measureapp.data.pattern_sets import PATTERN_SETS
from measureapp.errors import DecodeError
from measureapp.fringe.decode import decode
from measureapp.fringe.patterns.draw import pattern_images
from measureapp.fringe.patterns.harmonics import (
    Harmonic,
    Waveform,
    correct_phase,
    error_rms,
    phase_correction,
    phase_error,
    waveform_of_histogram,
    waveform_of_steps,
)
from measureapp.fringe.patterns.response import PitchWaveform, ProjectorResponse, curve_of_waveform, response_of_ramp
from measureapp.fringe.patterns.response_estimate import estimate_response
from measureapp.fringe.phase_shift import wrapped_phase
from measureapp.fringe.settings import DecodeSettings
from measureapp.fringe.unwrap import plan_heterodyne
from measureapp.project.images import read_image
from measureapp.simulate.optics import project_images
from measureapp.simulate.options import LightSettings

TAU = 2 * np.pi
ODD = (
    Harmonic(order=2, share=0.15, phase_rad=0.1),
    Harmonic(order=3, share=0.03, phase_rad=-3.0),
    Harmonic(order=4, share=0.015, phase_rad=2.0),
    Harmonic(order=5, share=0.008, phase_rad=1.0),
    Harmonic(order=6, share=0.004, phase_rad=-1.0),
    Harmonic(order=7, share=0.003, phase_rad=0.4),
)


def shown(waveform: Waveform, phase: FloatArray, steps: int, shift_sign: int = -1) -> FloatArray:
    """Images (steps, ...) with A = 110 and B = 80 of fringes with these harmonics."""
    shifted = phase + (shift_sign * TAU * np.arange(steps) / steps).reshape(-1, *[1] * phase.ndim)
    harmonics = sum(h.share * np.cos(h.order * shifted + h.phase_rad) for h in waveform)
    return 110 + 80 * (np.cos(shifted) + harmonics)


def difference(phase: FloatArray, reference: FloatArray) -> FloatArray:
    return np.angle(np.exp(1j * (phase - reference)))


@pytest.mark.parametrize("shift_sign", [-1, 1])
@pytest.mark.parametrize("steps", [3, 4, 5, 6])
def test_the_phase_error_of_few_steps_is_the_one_predicted_and_the_correction_takes_it_away(steps: int, shift_sign: int) -> None:
    true = np.linspace(-np.pi, np.pi, 1000)
    phase = wrapped_phase(shown(ODD, true, steps, shift_sign), shift_sign)[0]
    assert difference(phase, true) == pytest.approx(phase_error(ODD, steps, true), abs=1e-9)
    rest = difference(correct_phase(phase, phase_correction(ODD, steps)), true)
    # orders above four times the steps are left, and a constant
    assert rest.std() < max(0.005 * difference(phase, true).std(), 1e-4)
    assert abs(rest.mean()) < 0.0025


def test_to_first_order_three_steps_suffer_from_the_second_harmonic_and_four_from_the_third() -> None:
    small = (Harmonic(order=2, share=0.001, phase_rad=0.7), Harmonic(order=3, share=0.002, phase_rad=-0.4))
    (order, amplitude, offset), *_ = phase_correction(small, 3)
    assert (order, amplitude) == (3, pytest.approx(0.001, rel=1e-3))
    assert np.exp(1j * offset) == pytest.approx(-np.exp(0.7j), abs=2e-3)
    assert phase_correction(small, 4)[0][:2] == (4, pytest.approx(0.002, rel=1e-3))
    assert phase_correction(small, 5) == ()


def test_one_percent_of_third_harmonic_costs_four_steps_seven_milliradians() -> None:
    assert error_rms((Harmonic(order=3, share=0.01, phase_rad=0.0),), 4) == pytest.approx(0.007, abs=2e-4)


@pytest.mark.parametrize("gamma", [1.1, 1.8, 2.2])
def test_the_harmonics_of_a_power_law_are_those_of_the_binomial_series(gamma: float) -> None:
    levels = np.linspace(0, 255, 1021)
    found = response_of_ramp(levels, 200 * (levels / 255) ** gamma).waveform(32, "vertical")
    share = 1.0
    for harmonic in found[:4]:  # ((1 + cos φ) / 2)^γ: b_k / b_(k-1) = (γ − k + 1) / (γ + k)
        share *= (gamma - harmonic.order + 1) / (gamma + harmonic.order)
        assert harmonic.share * np.cos(harmonic.phase_rad) == pytest.approx(share, abs=2e-4)


def test_harmonics_are_found_again_in_noisy_images_of_a_dense_set() -> None:
    random = np.random.default_rng(1)
    phase = random.uniform(0, TAU, (200, 300))
    images = shown(ODD, phase, 12, 1) + random.normal(0, 2.0, (12, 200, 300))
    found = waveform_of_steps(images, 1, np.ones((200, 300), bool))
    assert [harmonic.order for harmonic in found] == [2, 3, 4, 5]
    deviation = np.sqrt(2 / 12) * 2.0 / 80 / np.sqrt(60_000)  # of each part of a mean share
    for harmonic, true in zip(found, ODD, strict=False):
        share, stated = (h.share * np.exp(1j * h.phase_rad) for h in (harmonic, true))
        assert abs(share - stated) < 5 * deviation


def test_harmonics_that_differ_over_the_image_have_a_spread_that_says_what_a_correction_leaves() -> None:
    phase = np.broadcast_to(TAU * np.arange(512) / 20.3, (256, 512))
    share = np.linspace(0.10, 0.20, 512)
    images = 110 + 80 * np.stack([np.cos(phase - d) + share * np.cos(2 * (phase - d)) for d in TAU * np.arange(12) / 12])
    found = waveform_of_steps(images, -1, np.ones(phase.shape, bool))
    assert found[0].share == pytest.approx(0.15, abs=1e-3)
    assert found[0].spread == pytest.approx(0.1 / np.sqrt(12), rel=0.05)


def test_a_ramp_gives_gamma_back() -> None:
    random = np.random.default_rng(2)
    levels = np.arange(0, 256, 15.0)
    response = response_of_ramp(levels, 8 + 180 * (levels / 255) ** 2.2 + random.normal(0, 0.05, len(levels)))
    assert response.gamma == pytest.approx(2.2, abs=0.02)
    assert response.curve is not None and np.all(np.diff(np.array(response.curve), axis=0) > 0)


@pytest.mark.parametrize("steps", [3, 4])
def test_patterns_corrected_beforehand_are_projected_as_sinusoids(steps: int) -> None:
    patterns = PatternSet(
        name="t", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32, steps=steps), PhaseShiftGroup(pitch_px=33, steps=steps))
    )
    levels = np.arange(0, 256, 5.0)
    response = response_of_ramp(levels, 10 + 200 * (levels / 255) ** 2.2)
    true = TAU * np.arange(1024) / 32

    def error(images: np.ndarray) -> float:
        light = 10 + 200 * (images[:steps, 0] / 255) ** 2.2
        return float(difference(wrapped_phase(light)[0], true).std())

    plain, prepared = error(pattern_images(patterns, 1024, 2)), error(pattern_images(patterns, 1024, 2, response))
    # eight bits: a level is 2.2 · (light share)^(1 − 1/2.2) / 255 of the range, at most 0.0086, rounded
    assert prepared < np.sqrt(2 / steps) * 2 * 0.0086 / np.sqrt(12)
    assert prepared < plain / 3
    assert np.array_equal(pattern_images(PATTERN_SETS["gray"], 1024, 2, response)[4:], pattern_images(PATTERN_SETS["gray"], 1024, 2)[4:])


@pytest.mark.parametrize("gamma", [1.5, 2.2])
def test_a_ramp_shown_by_the_virtual_projector_lets_three_steps_be_corrected_beforehand(gamma: float) -> None:
    light = LightSettings(gamma=gamma)
    levels = np.arange(0, 256, 5)
    ramp = [project_images(np.full((1, 16, 16), level, np.uint8), light).mean() for level in levels]
    response = response_of_ramp(levels.astype(float), 200 * np.array(ramp))
    patterns = PATTERN_SETS["three-close-3-step"]
    true = TAU * np.arange(1024) / 16

    def error(images: np.ndarray) -> float:
        phase = wrapped_phase(200 * project_images(images[:3, :8], light))[0][4]
        return float(difference(phase, true)[10:-10].std())

    plain, prepared = (error(pattern_images(patterns, 1024, 768, known)) for known in (None, response))
    assert plain > 0.08
    assert prepared < 0.0025  # whole levels; found: 0.001


def test_the_curve_follows_from_the_harmonics_of_a_dense_set() -> None:
    levels = np.linspace(0, 255, 256)
    response = response_of_ramp(levels, 200 * (levels / 255) ** 1.8)
    found = ProjectorResponse(curve=curve_of_waveform(response.waveform(32, "vertical")[:4]))
    assert found.gamma == pytest.approx(1.8, abs=0.01)
    share = np.linspace(0.05, 1, 50)
    assert found.level_for(share) == pytest.approx(255 * share ** (1 / 1.8), abs=1.5)


def scene(random: np.random.Generator) -> FloatArray:
    """True phases of a curved surface under fringes of 32 px, (400, 600)."""
    y, x = np.mgrid[:400, :600]
    return TAU / 17.3 * x + 9 * np.sin(x / 90) * np.cos(y / 70) + 0.02 * y + random.uniform(0, TAU)


@pytest.mark.parametrize("steps", [3, 4])
def test_few_steps_distinguish_their_own_error_from_how_unevenly_their_phases_are_spread(steps: int) -> None:
    random = np.random.default_rng(3)
    true = scene(random)
    levels = np.linspace(0, 255, 256)
    power_law = response_of_ramp(levels, 200 * (levels / 255) ** {3: 1.3, 4: 2.5}[steps]).waveform(32, "vertical")
    images = shown(power_law, true, steps) + random.normal(0, 2.0, (steps, *true.shape))
    phase = wrapped_phase(images)[0]
    waveform = waveform_of_histogram(phase.ravel(), steps)
    before, after = (difference(p, true).std() for p in (phase, correct_phase(phase, phase_correction(waveform, steps))))
    noise = np.sqrt(2 / steps) * 2.0 / 80
    assert before > 1.3 * noise
    assert after < 1.05 * noise


def test_phases_without_an_error_are_left_alone() -> None:
    random = np.random.default_rng(4)
    true = scene(random)
    phase = wrapped_phase(shown((), true, 4) + random.normal(0, 2.0, (4, *true.shape)))[0]
    assert waveform_of_histogram(phase.ravel(), 4) == ()


def stack_of(images: np.ndarray, patterns: PatternSet) -> FringeStack:
    return FringeStack("v", patterns, (1000,), {"left": np.clip(np.rint(images), 0, 255).astype(np.uint8)[None]}, 255)


def test_a_response_corrects_groups_in_their_order_each_by_the_nearest_pitch_of_its_direction() -> None:
    small, large = ((Harmonic(order=2, share=share, phase_rad=0.0),) for share in (0.01, 0.1))
    response = ProjectorResponse(
        waveforms=(
            PitchWaveform(pitch_px=16, harmonics=small),
            PitchWaveform(pitch_px=64, harmonics=large),
            PitchWaveform(direction="horizontal", pitch_px=30, harmonics=large),
        )
    )
    groups = (
        PhaseShiftGroup(pitch_px=20, steps=3),
        PhaseShiftGroup(pitch_px=60, steps=3),
        PhaseShiftGroup(pitch_px=20, steps=3, direction="horizontal"),
        PhaseShiftGroup(pitch_px=60, steps=4),
    )
    patterns = PatternSet.model_construct(name="t", projector_px=1024, projector_rows=768, groups=groups, shift_sign=-1)
    made = response.phase_correction(patterns)
    assert [terms[0][1] if terms else 0.0 for terms in made] == pytest.approx([0.01, 0.1, 0.1, 0.0], rel=0.02)


def test_the_estimate_of_a_recorded_stack_names_what_each_number_of_steps_keeps() -> None:
    random = np.random.default_rng(5)
    patterns = PatternSet(
        name="t", projector_px=1024, groups=(PhaseShiftGroup(pitch_px=32, steps=12), PhaseShiftGroup(pitch_px=33, steps=4))
    )
    true = scene(random)
    images = np.concatenate([shown(ODD, true, 12), shown(ODD, true * 32 / 33, 4)])
    response, reports = estimate_response(stack_of(images + random.normal(0, 1.0, images.shape), patterns), "left")
    assert [report.pitch_px for report in reports] == [32.0]  # four steps tell less than twelve
    kept = {entry.steps: entry for entry in reports[0].kept}
    assert set(kept) == {3, 4, 5, 6}
    for steps in (3, 4, 6):
        noise = np.sqrt(2 / steps - 2 / 12) * np.sqrt(1 + 1 / 12) / 80  # the few steps are part of the twelve; whole grey levels
        assert kept[steps].measured_without_rad == pytest.approx(np.hypot(error_rms(ODD, steps), noise), rel=0.03)
    assert kept[3].measured_with_rad is not None
    assert kept[3].measured_with_rad == pytest.approx(np.hypot(np.sqrt(1 / 2) * 1.04 / 80, error_rms(ODD[5:], 3)), abs=0.002)
    assert len(response.phase_correction(patterns)) == 2
    with pytest.raises(DecodeError, match="0 pixels"):
        estimate_response(stack_of(images * 0 + 7, patterns), "left")


@pytest.mark.parametrize(
    ("levels", "grey", "reason"),
    [
        ([0, 100, 200, 255], [0, 10, 50, 100], "4 different levels"),
        ([0, 50, 50, 100, 200, 255], [0, 2, 2, 10, 50, 100], "5 different levels among 6"),
        ([50, 100, 150, 200, 250, 255], [2, 10, 20, 50, 90, 100], "50…255"),
        ([0, 50, 100, 150, 200, 255], [100, 80, 60, 40, 20, 0], "rises by -100"),
        ([0, 50, 100, 150, 200, 255], [0, 60, 120, 255, 255, 255], "saturates"),
    ],
)
def test_a_ramp_that_determines_no_curve_is_refused(levels: list[float], grey: list[float], reason: str) -> None:
    with pytest.raises(DecodeError, match=reason) as raised:
        response_of_ramp(np.array(levels), np.array(grey))
    assert raised.value.hint


def test_what_cannot_be_known_is_refused() -> None:
    with pytest.raises(DecodeError, match="4 shifted images"):
        waveform_of_steps(np.ones((4, 100, 100)), -1, np.ones((100, 100), bool))
    with pytest.raises(DecodeError, match="12 pixels"):
        waveform_of_histogram(np.zeros(12), 3)
    with pytest.raises(DecodeError, match="no curve"):
        ProjectorResponse(waveforms=(PitchWaveform(pitch_px=32),)).level_for(np.ones(3))
    with pytest.raises(DecodeError, match="too strong for 3 steps"):
        phase_correction((Harmonic(order=2, share=0.8, phase_rad=0.0),), 3)
    with pytest.raises(ValueError, match="ascend"):
        ProjectorResponse(curve=((0.0, 0.0), (100.0, 0.5), (200.0, 0.4), (255.0, 1.0)))


STATUE_PX = (42.0, 45.0, 48.0)


def statue(every: int) -> FringeStack:
    """The statue with 12 / ``every`` steps of each pitch; a real projector whose gamma nobody corrected."""
    folder = recorded("cfpe_statue")
    images = np.array([read_image(folder / f"06{start + n:02d}h.png") for start in (0, 12, 24) for n in range(0, 12, every)])
    groups = tuple(PhaseShiftGroup(pitch_px=pitch, steps=12 // every) for pitch in STATUE_PX)
    patterns = PatternSet(name="statue", projector_px=1920, groups=groups, shift_sign=1)
    return FringeStack("statue", patterns, (1000,), {"one": images[None]}, 255)


def wrapped(stack: FringeStack, response: ProjectorResponse | None = None) -> tuple[FloatArray, FloatArray]:
    """The wrapped phases (3, H, W) and where every pitch has B > 10 and no saturated pixel."""
    images = stack.images["one"][0].reshape(3, -1, 480, 640).astype(float)
    decoded = [wrapped_phase(group, 1) for group in images]
    usable = np.all([m > 10 for _, m, _ in decoded], axis=0) & (images.max(axis=(0, 1)) < 255)
    phase = np.array([p for p, _, _ in decoded])
    if response is not None:
        phase = np.array([correct_phase(p, terms) for p, terms in zip(phase, response.phase_correction(stack.patterns), strict=True)])
    return phase, usable


def unwrapped(phase: FloatArray, patterns: PatternSet) -> FloatArray:
    """Follow the plan without vote or gate; the patterns of the statue start with a crest."""
    plan = plan_heterodyne(patterns)
    factors, frequencies = np.array(plan.combinations), plan.frequencies
    value = np.mod(np.tensordot(factors[0], phase, 1) + TAU * plan.guard, TAU) - TAU * plan.guard
    for k in range(1, len(factors)):
        here = np.tensordot(factors[k], phase, 1)
        value = here + TAU * np.rint((value * frequencies[k] / frequencies[k - 1] - here) / TAU)
    return value


def errors(few: FringeStack, response: ProjectorResponse | None) -> tuple[float, float]:
    """Return rms of the phase error of the finest pitch and the share of wrong orders, against twelve steps."""
    truth_phase, both = wrapped(statue(1))
    phase, usable = wrapped(few, response)
    both &= usable
    off = (unwrapped(phase, few.patterns) - unwrapped(truth_phase, statue(1).patterns))[both]
    wrong = np.abs(off) > np.pi
    return float(off[~wrong].std()), float(wrong.mean())


@pytest.mark.parametrize("known_from", ["twelve steps", "the few steps themselves"])
def test_the_correction_takes_the_gamma_of_the_statue_out_of_three_steps(known_from: str) -> None:
    few = statue(4)
    response, _ = estimate_response(statue(1) if known_from == "twelve steps" else few, "one")
    (rms, wrong), (rms_after, wrong_after) = errors(few, None), errors(few, response)
    assert rms == pytest.approx(0.117, abs=0.004)
    assert wrong > 0.15
    assert rms_after < 0.030  # found: 0.027
    assert wrong_after < 0.005  # found: 0.003


@pytest.mark.parametrize("known_from", ["twelve steps", "the few steps themselves"])
def test_the_correction_lowers_the_error_of_four_steps_of_the_statue(known_from: str) -> None:
    few = statue(3)
    response, _ = estimate_response(statue(1) if known_from == "twelve steps" else few, "one")
    (rms, wrong), (rms_after, wrong_after) = errors(few, None), errors(few, response)
    assert rms == pytest.approx(0.020, abs=0.001)
    assert rms_after < 0.85 * rms  # found: 0.0158 rad; what is left is noise and harmonics that differ over the image
    assert wrong_after <= wrong < 0.002


@pytest.mark.parametrize(("every", "rms_bound", "wrong_bound"), [(4, 0.020, 2e-4), (3, 0.012, 1e-5)])
def test_the_statue_decoded_from_few_steps_with_the_correction_agrees_with_twelve(every: int, rms_bound: float, wrong_bound: float) -> None:
    few, truth = statue(every), decode(statue(1))["one"]
    response, _ = estimate_response(few, "one")
    plain = decode(few)["one"]
    mended = decode(few, DecodeSettings(phase_correction=response.phase_correction(few.patterns)))["one"]
    rms, wrong = {}, {}
    for name, phase_map in (("plain", plain), ("mended", mended)):
        both = truth.valid & phase_map.valid
        off = (phase_map.phase_rad - truth.phase_rad)[both]
        wrong[name] = float((np.abs(off) > np.pi).mean())
        rms[name] = float(off[np.abs(off) <= np.pi].std())
    # found with the correction, faint pixels among them: three steps 0.017 rad, 6.7e-5 wrong orders; four steps 0.0111 rad, none wrong
    assert rms["mended"] < min(rms_bound, 0.9 * rms["plain"])
    assert wrong["mended"] < wrong_bound
    assert mended.valid.sum() >= plain.valid.sum()


def test_twelve_steps_of_the_statue_determine_its_gamma() -> None:
    response, reports = estimate_response(statue(1), "one")
    assert response.gamma == pytest.approx(1.5, abs=0.1)
    assert len(reports) == 3
    assert [kept.steps for kept in reports[0].kept] == [3, 4, 5, 6]
