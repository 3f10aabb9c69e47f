"""Synthesis of the exposures of a bracket into one wrapped phase per pitch and pixel."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray, IntArray, in_bands
from measureapp.data.fringe import FringeStack, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe import kernels
from measureapp.fringe.phase_shift import image_weights
from measureapp.fringe.settings import DecodeSettings

MOST_EXPOSURES = 16


@dataclass(frozen=True, slots=True, eq=False)
class WrappedPhases:
    """The wrapped phases of all pitches of one camera, N = H·W pixels, G pitches."""

    phase_rad: FloatArray  # (G, N) float32, in (-π, π]
    variance: FloatArray  # (G, N) float32, rad²
    mean_sum: FloatArray  # (N,) float32, mean of the finest pitch's images summed over the exposures used
    used: IntArray  # (G, N) uint16, bit e: exposure e is used
    modulation: FloatArray  # (N,) float32, least B of the pitches at the exposure taken
    grey: FloatArray  # (N,) float32, A scaled to the longest exposure
    exposure_index: IntArray  # (N,) int8, -1: saturated in all
    zero: BoolArray  # (N,), an image of the exposure taken is 0
    valid_ratio_exposures: tuple[float, ...]  # every sinusoidal image > 0 and < saturation
    valid_ratio_composite: float


def synthesise(stack: FringeStack, camera: str, settings: DecodeSettings) -> WrappedPhases:
    """Combine the exposures of one camera's images and take the wrapped phases.

    By the rule ``paper`` a pixel takes the first (brightest) exposure in which all its sinusoids stay below saturation —
    of all pitches together (joint) or of each for itself. By the rule ``combined`` it takes the sums
    Σ I sin and Σ I cos over all such exposures, which for shot noise is the inverse-variance average.
    """
    images = stack.images[camera]
    count, _, height, width = images.shape
    if count > MOST_EXPOSURES:
        raise DecodeError(f"{count} exposures are more than {MOST_EXPOSURES}.", "Leave exposures out of the bracket.")
    flat = images.reshape(count, images.shape[1], height * width).view()
    flat.flags.writeable = False
    return _weigh(stack, settings, _accumulate(stack, flat, settings))


@dataclass(slots=True, eq=False)
class _Sums:
    """Arrays that the kernels fill; the names of `WrappedPhases` where they become one."""

    sine: FloatArray
    cosine: FloatArray
    mean: FloatArray
    used: IntArray
    first: IntArray
    grey: FloatArray
    zero: BoolArray
    counts: IntArray

    @classmethod
    def empty(cls, groups: int, pixels: int, exposures: int) -> _Sums:
        sine, cosine, mean = (np.empty((groups, pixels), np.float32) for _ in range(3))
        return cls(
            sine,
            cosine,
            mean,
            np.empty((groups, pixels), np.uint16),
            np.empty(pixels, np.int8),
            np.empty(pixels, np.float32),
            np.empty(pixels, np.bool_),
            np.zeros(exposures + 1, np.int64),
        )


def _accumulate(stack: FringeStack, flat: ImageArray, settings: DecodeSettings) -> _Sums:
    exposures, _, pixels = flat.shape
    group_of, sines, cosines = image_weights(stack.patterns)
    sums = _Sums.empty(int(group_of.max()) + 1, pixels, exposures)

    def work(start: int, stop: int) -> IntArray:
        counts = np.zeros(exposures + 1, np.int64)
        kernels.accumulate(
            flat,
            group_of.astype(np.int64),
            cosines.astype(np.float32),
            sines.astype(np.float32),
            np.float32(stack.saturation),
            settings.joint,
            settings.rule == "paper",
            start,
            stop,
            sums.sine,
            sums.cosine,
            sums.mean,
            sums.used,
            sums.first,
            sums.grey,
            sums.zero,
            counts,
        )
        return counts

    sums.counts = np.sum(in_bands(work, pixels), axis=0)
    return sums


def _weigh(stack: FringeStack, settings: DecodeSettings, sums: _Sums) -> WrappedPhases:
    groups = [group for group in stack.patterns.groups if isinstance(group, PhaseShiftGroup)]
    finest = int(np.argmin([group.pitch_px for group in groups]))
    steps = np.array([group.steps for group in groups], np.float32)
    exposure = np.array(stack.exposures_us, np.float32) / np.float32(max(stack.exposures_us))
    mean_sum = sums.mean[finest] / steps[finest]
    modulation = np.empty(len(sums.first), np.float32)
    electrons = np.float32(settings.noise.electrons_per_grey(stack.saturation))
    floor = np.float32(settings.noise.floor_variance(stack.saturation))

    def work(start: int, stop: int) -> None:
        kernels.wrap_and_weigh(
            sums.sine, sums.cosine, sums.mean, sums.used, sums.first, steps, exposure, electrons, floor, start, stop, modulation, sums.grey
        )

    in_bands(work, len(modulation))
    ratios = sums.counts / len(modulation)
    return WrappedPhases(
        phase_rad=sums.sine,
        variance=sums.cosine,
        mean_sum=mean_sum,
        used=sums.used,
        modulation=modulation,
        grey=sums.grey,
        exposure_index=sums.first,
        zero=sums.zero,
        valid_ratio_exposures=tuple(float(ratio) for ratio in ratios[:-1]),
        valid_ratio_composite=float(ratios[-1]),
    )
