"""Wrapped phases of a chunk of pixels from their sums: plain loops, which the compiler vectorises. Statement: `reference.wrap_groups`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE
from measureapp.fringe.kernels.structures import CHUNK

# Odd polynomial for atan on 0…1 in cycles, fitted by iteratively reweighted least squares; error below 3e-7 rad.
_RAD = (0.99999611, -0.33317368, 0.19807812, -0.13233327, 0.07962338, -0.03360395, 0.0068117)
A1, A3, A5, A7, A9, A11, A13 = (np.float32(value / (2 * np.pi)) for value in _RAD)
QUARTER_TURN, HALF_TURN = np.float32(0.25), np.float32(0.5)
TINY = np.float32(1e-12)  # keeps denominators off zero


@njit(**INLINE)
def nearest_integer(value: Any) -> Any:
    """Round to the nearest integer, halves upwards."""
    return np.floor(value + np.float32(0.5))


@njit(**INLINE)
def atan2_cycles(sine: Any, cosine: Any) -> Any:
    """Return atan2 over 2π, float32."""
    x, y = abs(cosine), abs(sine)
    ratio = min(x, y) / (max(x, y) + TINY)
    p = ratio * ratio
    angle = ratio * (A1 + p * (A3 + p * (A5 + p * (A7 + p * (A9 + p * (A11 + p * A13))))))
    angle = QUARTER_TURN - angle if y > x else angle
    angle = HALF_TURN - angle if cosine < 0 else angle
    return -angle if sine < 0 else angle


@njit(**INLINE)
def wrap_groups(sums: Any, place: int, model: Any, work: Any) -> None:
    """Compute the wrapped phases of all groups, and the squared modulations of their sums."""
    for g in range(sums.sine.shape[0]):
        sine, cosine = sums.sine[g, place : place + CHUNK], sums.cosine[g, place : place + CHUNK]
        phase, power, sign, origin = work.phase[g], work.power[g], model.sine_sign, model.origin
        for j in range(CHUNK):
            s, c = np.float32(sine[j]), np.float32(cosine[j])
            power[j] = s * s + c * c
            phase[j] = sign * atan2_cycles(s, c) - origin
        if model.correction.shape[1] > 0:
            correct_response(phase, model.correction[g], origin)


@njit(**INLINE)
def correct_response(phase: Any, table: Any, origin: Any) -> None:
    """Subtract the phase error that the projector's response causes, by linear interpolation in its table."""
    last = np.int32(table.shape[0] - 1)
    for j in range(CHUNK):
        turns = phase[j] + origin + HALF_TURN
        position = (turns - np.floor(turns)) * np.float32(last)
        k = min(max(np.int32(position), np.int32(0)), np.int32(last - 1))
        phase[j] += table[k] + (position - np.float32(k)) * (table[k + 1] - table[k])
