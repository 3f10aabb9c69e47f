"""What of a calibration changes from pixel to pixel, where kernels need it; `reconstruct.cubics` fits the coefficients."""

from __future__ import annotations

from typing import Any

from numba import njit

from measureapp.compiled.options import INLINE


@njit(**INLINE)
def cubic(c: Any, s: Any, t: Any) -> Any:
    """Return the value of a cubic polynomial of two variables."""
    return c[0] + s * (c[1] + s * (c[3] + s * c[6])) + t * (c[2] + s * (c[4] + s * c[7]) + t * (c[5] + s * c[8] + t * c[9]))
