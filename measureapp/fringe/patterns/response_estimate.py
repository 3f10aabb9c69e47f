"""The projector's response from recorded fringes: the waveform from dense sets, from few steps at least their own phase error."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.fringe import Direction, FringeStack, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe.patterns.harmonics import (
    Waveform,
    correct_phase,
    error_rms,
    kept_rms,
    phase_correction,
    waveform_of_histogram,
    waveform_of_steps,
)
from measureapp.fringe.patterns.response import PitchWaveform, ProjectorResponse, curve_of_waveform
from measureapp.fringe.phase_shift import wrapped_phase

DENSE_STEPS = 6
LEAST_MODULATION = 10.0 / 255.0  # of saturation
MOST_PIXELS = 1_000_000  # rows are skipped above this
FEWEST_STEPS = 3


@dataclass(frozen=True, slots=True)
class KeptError:
    """Phase error that the harmonics cause with a number of steps, rms over a period, in radians."""

    steps: int
    without_rad: float  # from the waveform
    with_rad: float | None  # after the correction, because the waveform differs over the image; None where that is not known
    measured_without_rad: float | None  # a dense set thinned to these steps against all of them; noise included
    measured_with_rad: float | None


@dataclass(frozen=True, slots=True)
class PitchReport:
    """Waveform of one phase-shift group, and the phase errors that it causes."""

    direction: Direction
    pitch_px: float
    steps: int
    pixels: int
    waveform: Waveform
    kept: tuple[KeptError, ...]


def estimate_response(stack: FringeStack, camera: str, name: str = "projector") -> tuple[ProjectorResponse, tuple[PitchReport, ...]]:
    """Estimate the response from the recorded fringes of one camera.

    Groups of six or more steps determine the harmonics of the waveform, and the coarsest of them the curve. Where all groups have
    fewer, each determines the harmonic that disturbs its own number of steps, from the uneven distribution of its phases; that
    needs a scene with many fringes.

    Raises
    ------
    DecodeError
        Too few pixels show fringes, or no correctable error was found.
    """
    dense = any(isinstance(group, PhaseShiftGroup) and group.steps >= DENSE_STEPS for group in stack.patterns.groups)
    reports, first = [], 0
    for group in stack.patterns.groups:
        if isinstance(group, PhaseShiftGroup) and (group.steps >= DENSE_STEPS or not dense):
            images, usable = _best_exposure(stack, camera, first, group)
            reports.append(_estimate_waveform(images, usable, group, stack.patterns.shift_sign))
        first += group.count
    if not any(report.waveform for report in reports):
        raise DecodeError(
            f"The phases of camera {camera!r} show no error of the projector beyond the unevenness of the scene.",
            "Nothing needs correcting; or record twelve steps of one pitch to see smaller errors.",
        )
    coarsest = max(reports, key=lambda report: report.pitch_px)
    response = ProjectorResponse(
        name=name,
        curve=curve_of_waveform(coarsest.waveform) if dense else None,
        waveforms=tuple(PitchWaveform(direction=r.direction, pitch_px=r.pitch_px, harmonics=r.waveform) for r in reports),
    )
    return response, tuple(reports)


def _best_exposure(stack: FringeStack, camera: str, first: int, group: PhaseShiftGroup) -> tuple[FloatArray, BoolArray]:
    """Return the images (N, H, W) of the exposure that shows most of the group, and where they are neither saturated nor dark."""
    best: tuple[FloatArray, BoolArray] | None = None
    for exposure in stack.images[camera]:
        images = exposure[first : first + group.count]
        every = max(1, round(images[0].size / MOST_PIXELS))
        shown = images[:, ::every].astype(np.float32)
        _, modulation, _ = wrapped_phase(shown, stack.patterns.shift_sign)
        usable = np.asarray((shown.max(axis=0) < stack.saturation) & (modulation > LEAST_MODULATION * stack.saturation))
        if best is None or usable.sum() > best[1].sum():
            best = shown, usable
    assert best is not None  # a stack has at least one exposure
    return best


def _estimate_waveform(images: FloatArray, usable: BoolArray, group: PhaseShiftGroup, shift_sign: int) -> PitchReport:
    dense = group.steps >= DENSE_STEPS
    if dense:
        waveform = waveform_of_steps(images, shift_sign, usable)
    else:
        waveform = waveform_of_histogram(wrapped_phase(images, shift_sign)[0][usable], group.steps)
    # the lowest harmonic that disturbs N steps is N − 1
    counts = range(FEWEST_STEPS, waveform[-1].order + 2) if dense else [group.steps] * len(waveform)
    kept = tuple(_phase_error(images, usable, waveform, steps, shift_sign) for steps in counts)
    return PitchReport(group.direction, group.pitch_px, group.steps, int(usable.sum()), waveform, kept)


def _phase_error(images: FloatArray, usable: BoolArray, waveform: Waveform, steps: int, shift_sign: int) -> KeptError:
    predicted = error_rms(waveform, steps), kept_rms(waveform, steps) if len(images) > steps else None
    if len(images) % steps or len(images) == steps:
        return KeptError(steps, *predicted, None, None)
    reference = wrapped_phase(images, shift_sign)[0][usable]
    few = wrapped_phase(images[:: len(images) // steps], shift_sign)[0][usable]
    rectified = correct_phase(few, phase_correction(waveform, steps))
    return KeptError(steps, *predicted, _distance(few, reference), _distance(rectified, reference))


def _distance(phase: FloatArray, reference: FloatArray) -> float:
    return float(np.sqrt(np.mean(np.angle(np.exp(1j * (phase - reference))) ** 2)))
