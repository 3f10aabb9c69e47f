"""Vibration: the projector's image stands elsewhere in each image of the cameras."""

from __future__ import annotations

from math import floor

import numpy as np

from measureapp.arrays import FloatArray


def displaced(pattern: FloatArray, columns_px: float) -> FloatArray:
    """Return a pattern (h, w) displaced along its rows; outside it continues as at its border.

    Between columns it is interpolated linearly, which takes 0.5 % at most of the modulation of fringes of 32 px.
    """
    whole = floor(columns_px)
    part = np.float32(columns_px - whole)
    here, left = (np.clip(np.arange(pattern.shape[1]) - whole - step, 0, pattern.shape[1] - 1) for step in (0, 1))
    return np.asarray((1 - part) * pattern[:, here] + part * pattern[:, left], pattern.dtype)
