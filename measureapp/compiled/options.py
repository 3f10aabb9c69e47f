"""Options of ``numba.njit`` for the kernels."""

from __future__ import annotations

from typing import Any

# Array allocation allowed. nogil: bands of rows run on threads. error_model="numpy": division by zero gives infinity; Python's check is a
# branch that keeps the loop scalar. fastmath: reassociation, fused multiply-add and approximate reciprocals; NaN and infinity are
# assumed not to occur.
ALLOCATING_LOOP: dict[str, Any] = {"nogil": True, "cache": True, "error_model": "numpy", "fastmath": True}
# Nothing is allocated. Without numba's runtime (_nrt) array slices are not reference-counted; threads would contend for the counters.
LOOP: dict[str, Any] = {**ALLOCATING_LOOP, "_nrt": False}
# Functions called by a kernel, always inlined: a call would pass vectors through memory and count references of array arguments.
INLINE: dict[str, Any] = {**LOOP, "forceinline": True}
