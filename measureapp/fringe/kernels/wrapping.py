"""Compiled loops from the sums of a group of fringes to its wrapped phase; the readable statement stands in `phase_shift.py`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE
from measureapp.compiled.simd.elements import convert, floor, maximum, minimum, select
from measureapp.compiled.simd.memory import gather, load, store
from measureapp.fringe.kernels.constants import TINY
from measureapp.fringe.kernels.records import CHUNK, MODULATION, PIXELS, SPACING

# Odd polynomial for atan on 0…1 in cycles, fitted by iteratively reweighted least squares; error below 3e-7 rad.
_RAD = (0.99999611, -0.33317368, 0.19807812, -0.13233327, 0.07962338, -0.03360395, 0.0068117)
A1, A3, A5, A7, A9, A11, A13 = (np.float32(value / (2 * np.pi)) for value in _RAD)


@njit(**INLINE)
def atan2_cycles(sine: Any, cosine: Any) -> Any:
    """Return atan2 over 2π of vectors of float32."""
    across, up = abs(cosine), abs(sine)
    q = minimum(across, up) / (maximum(across, up) + TINY)
    p = q * q
    angle = q * (A1 + p * (A3 + p * (A5 + p * (A7 + p * (A9 + p * (A11 + p * A13))))))
    angle = select(up > across, 0.25 - angle, angle)
    angle = select(cosine < np.float32(0), 0.5 - angle, angle)
    return select(sine < np.float32(0), -angle, angle)


@njit(**INLINE)
def corrected(phase: Any, table: Any, origin: Any) -> Any:
    """Return phases without what the projector's response does to them."""
    last = table.shape[0] - 1
    turns = phase + origin + 0.5
    place = (turns - floor(turns)) * np.float32(last)
    k = minimum(maximum(convert(place, np.int32), np.int32(0)), np.int32(last - 1))
    low, high = gather(table, k), gather(table, k + np.int32(1))
    return phase + low + (place - convert(k, np.float32)) * (high - low)


@njit(**INLINE)
def wrap_groups(sums: Any, off: int, model: Any, work: Any) -> None:
    """Turn the sums of a chunk into wrapped phases of all groups, from column 0 in cycles, and into squared modulations.

    The least modulation of all groups, squared and in the sums, goes into its row.
    """
    for g in range(sums.sine.shape[0]):
        sine, cosine = sums.sine[g, off : off + CHUNK], sums.cosine[g, off : off + CHUNK]
        norm = model.norms[g]
        for j in range(0, CHUNK, PIXELS):
            s, c = convert(load(sine, j, PIXELS), np.float32), convert(load(cosine, j, PIXELS), np.float32)
            power = s * s + c * c
            phase = model.sine_sign * atan2_cycles(s, c) - model.origin
            if model.correction.shape[1] > 0:
                phase = corrected(phase, model.correction[g], model.origin)
            square = norm * power
            store(phase, work.phase, g * SPACING + j)
            store(power, work.power, g * SPACING + j)
            store(square if g == 0 else minimum(square, load(work.rows, MODULATION + j, PIXELS)), work.rows, MODULATION + j)
