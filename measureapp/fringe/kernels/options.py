"""How the kernels are compiled, and the numbers that all of them use."""

from __future__ import annotations

from typing import Any

import numpy as np

# With the error model of Python a division is a branch, and the loop around it stays scalar.
LOOP: dict[str, Any] = {"nogil": True, "_nrt": False, "cache": True, "error_model": "numpy", "fastmath": True}
INLINE: dict[str, Any] = {**LOOP, "forceinline": True}  # a call would count the references of every array

HALF, QUARTER, THREE_QUARTERS = np.float32(0.5), np.float32(0.25), np.float32(0.75)
TAU = np.float32(2 * np.pi)
TINY = np.float32(1e-12)
VALID, SATURATED, WEAK, SHADOW, CONFLICT, OUTSIDE, BLOOMING = 0, 1, 2, 3, 4, 5, 7  # of PixelState
