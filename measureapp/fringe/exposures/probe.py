"""Rates of light and fringes of every pixel, from a quick probe capture of a scene."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, ImageArray
from measureapp.data.fringe import FringeStack, PhaseShiftGroup
from measureapp.errors import DecodeError
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.phase_shift import wrapped_phase

MOST_PIXELS = 10_000  # of a camera
SEEN = 4.0  # standard deviations by which a pixel's modulation must exceed its noise
LEAST_LIT, MOST_UNKNOWN = 0.002, 0.9
BEYOND_BOUND = 8.0  # a saturated pixel is assumed to be up to this many times as bright as saturation


@dataclass(frozen=True, slots=True, eq=False)
class ProbedCamera:
    """A sample of the pixels of one camera that have fringes; rates in grey levels per µs."""

    camera: str
    mean_rate: FloatArray  # (n,) of A
    swing_rate: FloatArray  # (n,) of B
    is_bound: BoolArray  # (n,), saturated at every probe exposure: the true rates are at least these
    noise: CameraNoise
    saturation: float
    shortest_us: int  # of the probe

    @property
    def unknown_share(self) -> float:
        """Share of the pixels that are saturated at every exposure of the probe."""
        return float(self.is_bound.mean())


def read_probe(stack: FringeStack, noise: Mapping[str, CameraNoise]) -> dict[str, ProbedCamera]:
    """Estimate the rates of light from a probe: one pattern group or more at one exposure or more.

    Mean A and modulation B grow in proportion to the exposure. They are summed over the exposures that do not saturate a
    pixel, which is the best estimate for shot noise. Of a pixel that saturates in all, only the least rate is known.

    Raises
    ------
    DecodeError
        No camera sees fringes, or nearly all pixels are saturated at the shortest exposure.
    """
    cameras = {name: _camera(stack, name, noise.get(name, CameraNoise())) for name in stack.images}
    lit = {name: camera for name, camera in cameras.items() if camera is not None}
    if not lit:
        raise DecodeError(
            f"No camera sees fringes at {max(stack.exposures_us)} µs.",
            "Probe with a longer exposure, open the apertures, or check the projector.",
        )
    unknown = np.mean([camera.unknown_share for camera in lit.values()])
    if unknown > MOST_UNKNOWN:
        shortest = min(stack.exposures_us)
        raise DecodeError(
            f"{unknown:.0%} of the lit pixels are saturated even at {shortest} µs.",
            f"Probe with {max(1, shortest // 8)} µs, or dim the projector.",
        )
    return lit


def _camera(stack: FringeStack, name: str, noise: CameraNoise) -> ProbedCamera | None:
    """Return None where less than 0.2 % of the pixels have fringes."""
    images = stack.images[name]
    pixels = images.reshape(*images.shape[:2], -1)
    pixels = pixels[..., :: max(1, pixels.shape[2] // MOST_PIXELS)].astype(np.float32)
    exposures = np.array(stack.exposures_us, np.float64)
    clear = pixels.max(axis=1) < stack.saturation  # (exposures, n)
    time = (clear * exposures[:, None]).sum(axis=0)
    mean, power, count = _sum_exposures(stack, pixels * clear[:, None, :])
    variance = clear.sum(axis=0) * noise.floor_variance(stack.saturation) + mean / noise.electrons_per_grey(stack.saturation)
    swing = np.sqrt(np.maximum(power - 4 * variance / count, 0.0))
    known = time > 0
    seen = known & (swing > SEEN * np.sqrt(2 * variance / count))
    bound = ~known
    if (seen | bound).mean() < LEAST_LIT:
        return None
    rates = np.maximum(time, 1e-9)
    mean_rate, swing_rate = mean / rates, swing / rates
    contrast = float(np.median(swing_rate[seen] / mean_rate[seen])) if seen.any() else 0.8
    peak = stack.saturation / exposures.min() * np.geomspace(1.0, BEYOND_BOUND, max(1, int(bound.sum())))
    mean_rate[bound] = (peak / (1 + contrast))[: int(bound.sum())]
    swing_rate[bound] = mean_rate[bound] * contrast
    chosen = seen | bound
    return ProbedCamera(name, mean_rate[chosen], swing_rate[chosen], bound[chosen], noise, float(stack.saturation), int(exposures.min()))


def _sum_exposures(stack: FringeStack, pixels: ImageArray | FloatArray) -> tuple[FloatArray, FloatArray, int]:
    """Return A and B² of the summed exposures, averaged over the pitches, each (n,), and the number of images."""
    total = pixels.sum(axis=0, dtype=np.float64)
    means, powers, count, start = [], [], 0, 0
    for group in stack.patterns.groups:
        images = total[start : start + group.count]
        start += group.count
        if isinstance(group, PhaseShiftGroup):
            _, modulation, mean = wrapped_phase(images, stack.patterns.shift_sign)
            means.append(mean)
            powers.append(modulation**2)
            count = count or group.steps
    if not means:
        raise DecodeError("The probe has no sinusoids.", "Probe with a phase-shift group.")
    return np.mean(means, axis=0), np.mean(powers, axis=0), count
