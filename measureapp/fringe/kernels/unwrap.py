"""Temporal unwrapping of a chunk of pixels, and the mean over all pitches: plain loops, which the compiler vectorises.

The NumPy statements are `reference.unwrap_heterodyne`, `reference.unwrap_gray` and `reference.average_pitches`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE
from measureapp.fringe.kernels.structures import CHUNK
from measureapp.fringe.kernels.wrap import TINY, nearest_integer

QUARTER_TURN, HALF_TURN, THREE_QUARTERS = np.float32(0.25), np.float32(0.5), np.float32(0.75)
BIT = np.int32(1)


@njit(**INLINE)
def combine_phases(factors: Any, work: Any, combined: Any) -> None:
    """Sum the wrapped phases of all groups, each times its factor."""
    for g in range(factors.shape[0]):
        factor, phase = factors[g], work.phase[g]
        for j in range(CHUNK):
            combined[j] = factor * phase[j] if g == 0 else combined[j] + factor * phase[j]


@njit(**INLINE)
def unwrap_heterodyne(model: Any, work: Any) -> None:
    """Unwrap from the coarsest combination of the phases to the finest pitch: absolute phase and rounding residual."""
    steps, value, residual, combined = model.unwrapping, work.value, work.residual, work.combined
    combine_phases(steps.combinations[0], work, value)
    for j in range(CHUNK):
        value[j] -= np.floor(value[j] + steps.guard)
        residual[j] = np.float32(0)
    for k in range(1, steps.combinations.shape[0]):
        combine_phases(steps.combinations[k], work, combined)
        ratio, kept = steps.ratios[k], k == steps.watched
        largest = steps.watched < 0
        for j in range(CHUNK):
            decision = value[j] * ratio - combined[j]
            order = nearest_integer(decision)
            rounding = decision - order
            residual[j] = rounding if kept or (largest and abs(rounding) > abs(residual[j])) else residual[j]
            value[j] = combined[j] + order


@njit(**INLINE)
def unwrap_gray(sums: Any, place: int, layout: Any, model: Any, work: Any) -> None:
    """Number the periods by Gray code; a complementary plane, half a period apart, resolves the borders of the periods."""
    finest, chunk, value, residual = model.finest, slice(place, place + CHUNK), work.value, work.residual
    planes = sums.planes[: layout.planes.shape[0], chunk]
    read_code(planes, sums.total[0 if sums.total.shape[0] == 1 else finest, chunk], layout.steps[finest], work.code)
    code, phase, complementary = work.code, work.phase[finest], model.unwrapping.complementary
    for j in range(CHUNK):
        share = phase[j] - np.floor(phase[j])
        if complementary:
            coarse, shifted = code[j] >> BIT, (code[j] + BIT) >> BIT
            period = shifted if share < QUARTER_TURN else shifted - BIT if share >= THREE_QUARTERS else coarse
            residual[j] = np.float32(abs(coarse - period) > BIT)
        else:
            period = code[j]
            residual[j] = HALF_TURN - share
        value[j] = np.float32(period) + share


@njit(**INLINE)
def read_code(planes: Any, total: Any, steps: int, code: Any) -> None:
    """Convert Gray code to a binary number: planes brighter than the mean of the sinusoids flip the bit before."""
    code[:] = 0
    for b in range(planes.shape[0]):
        plane = planes[b]
        for j in range(CHUNK):
            bright = np.float32(steps) * np.float32(plane[j]) > np.float32(total[j])
            code[j] = code[j] + code[j] + ((code[j] & BIT) ^ np.int32(bright))


@njit(**INLINE)
def average_pitches(model: Any, work: Any) -> None:
    """Replace the absolute phase of the finest pitch by the mean of all pitches by inverse variance."""
    pitches, finest, value, weight, shift = model.pitches, model.finest, work.value, work.variance, work.combined
    own, power = pitches.weights[finest], work.power[finest]
    for j in range(CHUNK):
        weight[j] = own * power[j]
        shift[j] = np.float32(0)
    for g in range(pitches.scales.shape[0]):
        if g == finest:
            continue
        phase, power, scale = work.phase[g], work.power[g], pitches.scales[g]
        per_power, shift_per_power = pitches.weights[g], pitches.shifts[g]
        for j in range(CHUNK):
            difference = phase[j] - value[j] * scale
            shift[j] += shift_per_power * power[j] * (difference - nearest_integer(difference))
            weight[j] += per_power * power[j]
    for j in range(CHUNK):
        work.variance[j] = np.float32(1) / (weight[j] + TINY)
        value[j] += shift[j] * work.variance[j]
