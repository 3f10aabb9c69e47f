"""Predicted phase maps: what decoding would give of the nominal, with its noise, blur and holes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from math import tau

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.fringe import PatternSet
from measureapp.data.phase import PhaseMap, PixelState
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.prediction.light import NOT_USED, CameraExposures, PartLight
from measureapp.pipeline.prediction.seen import SeenPixels

WHITE, LARGEST_GREY = 0.5, 65535.0  # mean of fringes over white light; of stored grey levels


@dataclass(frozen=True, slots=True)
class Taking:
    """How the images of one camera are taken at one viewpoint."""

    camera: str
    viewpoint_id: str
    shape: tuple[int, int]  # rows, columns
    patterns: PatternSet
    exposures_us: tuple[int, ...]  # long to short
    longest_us: int  # exposure that the light refers to
    saturation: float
    blur_px: float  # standard deviation; 0: sharp


def predict_phase_map(seen: SeenPixels, light: PartLight, taking: Taking, settings: DecodeSettings, rng: np.random.Generator) -> PhaseMap:
    """Predict the phase map of one camera.

    Every pixel gets the phase of the projector's pixel that lights its point. Blur mixes the fringes of neighbours as complex amplitudes, so that it
    bends phases where brightness changes and spoils them at discontinuities, as in real images; then noise is added.

    Parameters
    ----------
    rng : of the noise
    """
    maps = [_predict_direction(seen, light, taking, settings, rng, number) for number in range(len(taking.patterns.directions))]
    return maps[0] if len(maps) == 1 else replace(maps[0], orthogonal=maps[1])


def _predict_direction(
    seen: SeenPixels, light: PartLight, taking: Taking, settings: DecodeSettings, rng: np.random.Generator, number: int
) -> PhaseMap:
    direction = taking.patterns.directions[number]
    alone, _ = taking.patterns.subset(direction)
    phase = seen.projector_px[:, 0 if direction == "vertical" else 1] * (tau / alone.finest_pitch_px)
    fringes = np.where(seen.lit, seen.irradiance, 0.0) * light.white * WHITE
    mean, bent, modulation = _blur_fringes(seen, fringes + light.ambient, fringes * light.contrast, phase, taking)
    exposures = CameraExposures(alone, taking.exposures_us, taking.longest_us, settings.noise_of(taking.camera), taking.saturation)
    noise = exposures.phase_noise(mean, modulation)
    faint = noise.of_all * taking.saturation < settings.faint_modulation_grey(taking.saturation)
    state = _states(seen, noise.exposure == NOT_USED, faint | (noise.sigma_rad > exposures.largest_sigma_rad(settings)))
    good = state == PixelState.VALID
    measured = bent + np.where(good, noise.sigma_rad, 0.0) * rng.standard_normal(len(bent))
    to_longest = taking.exposures_us[0] / taking.longest_us
    grey = np.minimum(mean * to_longest * taking.saturation, LARGEST_GREY)
    image = _Image(seen, taking.shape)
    states = image.of(state, PixelState.SHADOW, np.uint8)
    phases = image.of(np.where(good, measured, 0.0), 0, np.float32)
    states[_at_edges(phases, states == PixelState.VALID, settings.edge_step_rad)] = PixelState.EDGE
    valid = states == PixelState.VALID
    return PhaseMap(
        camera=taking.camera,
        viewpoint_id=taking.viewpoint_id,
        phase_rad=np.where(valid, phases, np.float32(0)),
        sigma_rad=np.where(valid, image.of(np.where(good, noise.sigma_rad, 0.0), 0, np.float32), np.float32(0)),
        modulation=image.of(np.rint(noise.modulation * taking.saturation), 0, np.uint16),
        grey=image.of(np.rint(grey), 0, np.uint16),
        state=states,
        exposure_index=image.of(noise.exposure, NOT_USED, np.int8),
        pitch_px=alone.finest_pitch_px,
        projector_px=alone.projector_px,
        saturation=taking.saturation,
        direction=direction,
        exposures_us=tuple(float(exposure) for exposure in taking.exposures_us),
    )


@dataclass(frozen=True, slots=True)
class _Image:
    """Writes values of the seen pixels into images."""

    seen: SeenPixels
    shape: tuple[int, int]

    def of(self, values: FloatArray | IntArray, empty: float, kind: type[np.generic]) -> np.ndarray:
        image = np.full(self.shape, empty, kind)
        image[self.seen.row, self.seen.column] = values
        return image


def _blur_fringes(
    seen: SeenPixels, mean: FloatArray, modulation: FloatArray, phase: FloatArray, taking: Taking
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return mean, phase and modulation of blurred fringes, (K,) each."""
    if taking.blur_px <= 0:
        return mean, phase, modulation
    image, here = _Image(seen, taking.shape), (seen.row, seen.column)

    def blurred(values: FloatArray) -> FloatArray:
        return np.asarray(
            cv2.GaussianBlur(image.of(values, 0.0, np.float64), (0, 0), taking.blur_px, borderType=cv2.BORDER_REPLICATE)[here]
        )

    waves = blurred(modulation * np.cos(phase)) + 1j * blurred(modulation * np.sin(phase))
    bend = np.angle(waves * np.exp(-1j * phase))
    return blurred(mean), phase + bend, np.abs(waves)


def _states(seen: SeenPixels, saturated: BoolArray, weak: BoolArray) -> np.ndarray:
    reasons = [(~seen.lit, PixelState.SHADOW), (saturated, PixelState.SATURATED), (weak, PixelState.WEAK_MODULATION)]
    return np.select([mask for mask, _ in reasons], [int(state) for _, state in reasons], int(PixelState.VALID))


def _at_edges(phase_rad: FloatArray, valid: BoolArray, step_rad: float) -> BoolArray:
    """Return the valid pixels (H, W) whose phase differs by more than ``step_rad`` from a valid neighbour's."""
    edge = np.zeros(valid.shape, np.bool_)
    for axis in (0, 1):
        one = (slice(None, -1), slice(None)) if axis == 0 else (slice(None), slice(None, -1))
        other = (slice(1, None), slice(None)) if axis == 0 else (slice(None), slice(1, None))
        differs = valid[one] & valid[other] & (np.abs(phase_rad[one] - phase_rad[other]) > step_rad)
        edge[one] |= differs
        edge[other] |= differs
    return edge
