"""The light in an image that is not the projector's: that of the room, and the grey level of a camera that sees nothing.

Fringes tell it from the projector's: over all pixels the mean grey level grows in proportion to the modulation, from where there is none.
"""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.phase import PhaseMap

SAMPLES = 20_000  # pixels are enough to tell a hundredth of the light
BESIDE = 2  # px between two pixels by which the slope of the phase is told
STEEPEST = 0.5  # rad/px: beyond, blur takes from the modulation, not from the mean
LEAST_SAMPLES = 500
LEAST_SPREAD = 0.05  # of the modulation: where all is equally bright there is no slope of the light to be told either
STEPS = 5
CAUCHY = 1.5  # in units of the usual residual: pixels at edges mix fringes out of step
TINY = 1e-9


def other_light(phase_map: PhaseMap) -> float:
    """Return the grey level without the projector's light, scaled as `PhaseMap.grey` is; 0 where it cannot be told."""
    grey, modulation = _sample(phase_map)
    if len(grey) < LEAST_SAMPLES or modulation.std() < LEAST_SPREAD * modulation.mean():
        return 0.0
    columns = np.column_stack([modulation, np.ones(len(grey))])
    weight: FloatArray = np.ones(len(grey))
    line: FloatArray = np.zeros(2)
    for _ in range(STEPS):
        line = np.linalg.solve((columns * weight[:, None]).T @ columns, (columns * weight[:, None]).T @ grey)
        left = grey - columns @ line
        weight = 1 / (1 + (left / (CAUCHY * np.median(np.abs(left)) + TINY)) ** 2)
    return float(np.clip(line[1], 0.0, grey.min()))


def _sample(phase_map: PhaseMap) -> tuple[FloatArray, FloatArray]:
    """Return grey levels and modulation (N,), both at the longest exposure, of some pixels all over the image."""
    step = max(1, int(np.sqrt(phase_map.state.size / SAMPLES)))
    here = (slice(None, None, step), slice(BESIDE, None, step))
    there = (slice(None, None, step), slice(None, -BESIDE, step))
    rows, columns = phase_map.state[here].shape
    before = phase_map.state[there][:rows, :columns]
    run = np.abs(phase_map.phase_rad[here] - phase_map.phase_rad[there][:rows, :columns])
    chosen = (phase_map.state[here] == 0) & (before == 0) & (run < STEEPEST * BESIDE)
    longest = np.array([phase_map.exposures_us[0] / exposure for exposure in phase_map.exposures_us] or [1.0])
    taken = np.clip(phase_map.exposure_index[here][chosen], 0, len(longest) - 1)
    return phase_map.grey[here][chosen].astype(float), phase_map.modulation[here][chosen] * longest[taken]
