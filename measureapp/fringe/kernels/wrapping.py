"""Compiled loops from the sums of a group of fringes to its wrapped phase; the readable statement stands in `phase_shift.py`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.options import HALF, INLINE, LOOP, QUARTER, TINY

# Odd polynomial for atan on 0…1 in cycles, fitted by iteratively reweighted least squares; error below 1e-7 rad.
_RAD = (0.999999336, -0.33329861, 0.199465668, -0.139086327, 0.0964220148, -0.0559123465, 0.0218629532, -0.00405456218)
A1, A3, A5, A7, A9, A11, A13, A15 = (np.float32(value / (2 * np.pi)) for value in _RAD)


@njit(**LOOP, inline="always")
def atan2_cycles(sine: Any, cosine: Any) -> Any:
    """Return atan2 over 2π in float32; branch-free, so that the loop around it becomes SIMD code (numba's own is ten times slower)."""
    across = abs(cosine)
    up = abs(sine)
    small = min(across, up)
    large = max(across, up)
    q = small / (large + TINY)
    p = q * q
    angle = q * (A1 + p * (A3 + p * (A5 + p * (A7 + p * (A9 + p * (A11 + p * (A13 + p * A15)))))))
    angle = QUARTER - angle if up > across else angle
    angle = HALF - angle if cosine < 0 else angle
    return -angle if sine < 0 else angle


@njit(**INLINE)
def wrap(sine: Any, cosine: Any, n: int, sign: Any, origin: Any, phase: Any, power: Any) -> None:
    """Turn the sums of a group into wrapped phase, from column 0 in cycles, and squared modulation."""
    for j in range(n):
        s = np.float32(sine[j])
        c = np.float32(cosine[j])
        power[j] = s * s + c * c
        phase[j] = sign * atan2_cycles(s, c) - origin


@njit(**INLINE)
def correct(phase: Any, n: int, table: Any, origin: Any) -> None:
    """Take out what the projector's response does to the phase."""
    last = table.shape[0] - 1
    for j in range(n):
        turns = phase[j] + origin + HALF
        place = (turns - np.floor(turns)) * np.float32(last)
        k = min(max(int(place), 0), last - 1)
        phase[j] += table[k] + (place - np.float32(k)) * (table[k + 1] - table[k])
