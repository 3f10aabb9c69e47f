"""The light of the projector alone, without ambient light and what reaches a surface by way of others.

Such light shows no fringes: it adds to the mean grey level and not to the modulation. The room lights a part evenly, but a wall beside a
bright one receives more from it than from the room, and most where the projector lights it least. The fringes that neighbours scatter average
out over them. What is left of the grey level without the light that is modulated is such light, found at each place.
"""

from __future__ import annotations

from math import isqrt
from typing import NamedTuple

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray, in_bands
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PhaseMap

PLACES = 80_000  # over the image: light from neighbours changes over millimetres, and many pixels give a level free of noise
LEAST_STEP_PX = 2
SLOPE_PX = 2  # distance over which the slope of the phase is taken
MAX_SLOPE = 1.5  # rad/px: beyond, blur leaves less than half of the modulation
MIN_SAMPLES = 500
DARKEST_PERCENT = 1.0  # of the pixels: the least of thousands is one of noise
MIN_SPREAD = 0.02  # of differences of the modulation, relative to it: an evenly bright image does not determine the line
ITERATIONS = 5
CAUCHY = 1.5  # in units of the median residual: pixels at edges mix fringes out of phase
TINY = 1e-9
MEDIAN = 5  # places
BAND_ROWS = 64  # which stay in the cache
NEAR, FAR = 5, 15  # places over which means are taken
APART = 8  # places
LEAST_KNOWN = 0.05  # of the near places, or one or two of the far ones
MOST_AMBIENT = 0.9  # of a grey level: where more of it is ambient light there is hardly a fringe


class LightLine(NamedTuple):
    """How the mean grey level grows with the modulation."""

    per_modulation: float  # mean grey level of the projector's light over its modulation
    ambient: float  # grey level without the projector, scaled as `PhaseMap.grey` is


class _Samples(NamedTuple):
    grey: FloatArray  # (h, w) float32, of every step-th pixel
    modulation: FloatArray  # (h, w) float32, without blur, at the longest exposure
    inside: BoolArray  # (h, w) on one surface, its phase not too steep


def projector_light(phase_map: PhaseMap, variance_px2: float, memory: BufferPool | None = None) -> FloatArray:
    """Return the mean grey level (H, W) float32 of the projector's light, scaled as `PhaseMap.grey` is.

    Ambient light is taken at every step-th pixel as the grey level less the light that the modulation shows, and its median over places
    around. An error of `LightLine.per_modulation` changes the result by the same factor everywhere, and its relative slope hardly. Where no
    phase tells, as at edges, ambient light is that of places around, or the mean of the image.

    Parameters
    ----------
    variance_px2 : variance of the camera's blur, which takes exp(-s² |∇φ|² / 2) of the modulation
    memory : pool that the result is taken from
    """
    step = _step_px(phase_map)
    samples = _sample(phase_map, variance_px2, step)
    line = _fit_line(samples)
    ambient = np.where(samples.inside, samples.grey - np.float32(line.per_modulation) * samples.modulation, np.float32(0))
    ambient = cv2.medianBlur(_filled(ambient, samples.inside, line.ambient), MEDIAN)
    light = (memory or BufferPool()).empty(phase_map.state.shape, np.float32)

    def subtract(start: int, stop: int) -> None:
        to_places = np.array([[1 / step, 0, 0], [0, 1 / step, start / step]])
        size, flags = (light.shape[1], stop - start), cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
        enlarged = cv2.warpAffine(ambient, to_places, size, flags=flags, borderMode=cv2.BORDER_REPLICATE)
        grey = phase_map.grey[start:stop].astype(np.float32)
        np.minimum(enlarged, np.float32(MOST_AMBIENT) * grey, out=enlarged)
        np.subtract(grey, enlarged, out=light[start:stop])

    in_bands(subtract, len(light), -(-len(light) // BAND_ROWS))
    return light


def fit_light_line(phase_map: PhaseMap, variance_px2: float) -> LightLine:
    """Fit the mean grey level as a linear function of the modulation; without ambient light where the image does not determine it.

    Differences between places near each other tell how one grows with the other: there ambient light is nearly the same, over the whole
    image it is not. Blur takes exp(-s² |∇φ|² / 2) of the modulation, but nothing of the mean: steep fringes, as of dim oblique walls, would
    bend the line.
    """
    return _fit_line(_sample(phase_map, variance_px2, _step_px(phase_map)))


def _fit_line(samples: _Samples) -> LightLine:
    grey, modulation = samples.grey[samples.inside], samples.modulation[samples.inside]
    if len(grey) < MIN_SAMPLES:
        return LightLine(1.0, 0.0)
    grey_rise, modulation_rise = (_differences(values, samples.inside) for values in (samples.grey, samples.modulation))
    if len(grey_rise) < MIN_SAMPLES or modulation_rise.std() < MIN_SPREAD * modulation.mean():
        return LightLine(1.0, 0.0)
    weight: FloatArray = np.ones(len(grey_rise), np.float32)
    slope = 1.0
    for _ in range(ITERATIONS):
        weighted = weight * modulation_rise
        slope = float(weighted @ grey_rise / (weighted @ modulation_rise))
        residual = grey_rise - np.float32(slope) * modulation_rise
        weight = 1 / (1 + (residual / (CAUCHY * np.median(np.abs(residual)) + TINY)) ** 2)
    ambient = float(np.median(grey - np.float32(slope) * modulation))
    return LightLine(slope, float(np.clip(ambient, 0.0, np.percentile(grey, DARKEST_PERCENT))))


def _differences(values: FloatArray, known: BoolArray) -> FloatArray:
    """Return differences (N,) between means around known places APART from each other, in both directions."""
    there, values = known.astype(np.float32), np.where(known, values, np.float32(0))
    means = cv2.blur(values, (NEAR, NEAR)) / np.maximum(cv2.blur(there, (NEAR, NEAR)), np.float32(TINY))
    across, down = known[:, APART:] & known[:, :-APART], known[APART:] & known[:-APART]
    return np.concatenate([(means[:, APART:] - means[:, :-APART])[across], (means[APART:] - means[:-APART])[down]])


def _step_px(phase_map: PhaseMap) -> int:
    return max(LEAST_STEP_PX, isqrt(phase_map.state.size // PLACES))


def _sample(phase_map: PhaseMap, variance_px2: float, step: int) -> _Samples:
    height, width = phase_map.state.shape
    rows, columns = np.arange(0, height, step), np.arange(0, width, step)

    def aside(image: FloatArray | IntArray, down: int, right: int) -> FloatArray | IntArray:
        """Take an image SLOPE_PX beside the samples, at its border where it ends before."""
        return image[np.clip(rows + down, 0, height - 1)[:, None], np.clip(columns + right, 0, width - 1)]

    sides = ((0, SLOPE_PX), (0, -SLOPE_PX), (SLOPE_PX, 0), (-SLOPE_PX, 0))
    right, left, below, above = (aside(phase_map.phase_rad, *side) for side in sides)
    squared_slope = ((right - left) ** 2 + (below - above) ** 2) / np.float32(2 * SLOPE_PX) ** 2
    inside = np.all([aside(phase_map.state, *side) == 0 for side in ((0, 0), *sides)], axis=0) & (squared_slope < MAX_SLOPE**2)
    relative = np.array([phase_map.exposures_us[0] / exposure for exposure in phase_map.exposures_us] or [1.0], np.float32)
    exposure = np.clip(phase_map.exposure_index[::step, ::step], 0, len(relative) - 1)
    without_blur = np.exp(np.float32(variance_px2 / 2) * np.minimum(squared_slope, np.float32(MAX_SLOPE**2)))
    modulation = phase_map.modulation[::step, ::step] * relative[exposure] * without_blur
    return _Samples(phase_map.grey[::step, ::step].astype(np.float32), modulation, inside)


def _filled(values: FloatArray, known: BoolArray, otherwise: float) -> FloatArray:
    """Replace the unknown of some values (h, w), which are 0, by the mean of the known ones near, or far, or by a number."""
    there = known.astype(np.float32)
    filled = np.full_like(values, otherwise)
    for reach, least in ((FAR, 1.5 / FAR**2), (NEAR, LEAST_KNOWN)):
        share = cv2.blur(there, (reach, reach))
        enough = share > least
        filled[enough] = cv2.blur(values, (reach, reach))[enough] / share[enough]
    filled[known] = values[known]
    return filled
