"""Joint angles that differ by whole turns, and the limits they have to keep."""

from __future__ import annotations

import math
from itertools import product

import numpy as np
import numpy.typing as npt

from measureapp.arrays import FloatArray
from measureapp.geometry.kinematics.arm import TURN_RAD

LIMIT_TOLERANCE_RAD = 1e-9  # rounding of an angle that is exactly at its limit


def wrapped(angles_rad: npt.ArrayLike) -> FloatArray:
    """Return angles in [-π, π)."""
    return (np.asarray(angles_rad) + np.pi) % TURN_RAD - np.pi


def within_limits(joints_rad: FloatArray, limits_rad: FloatArray) -> tuple[FloatArray, ...]:
    """Return all joint angles within limits (6, 2) that differ from ``joints_rad`` (6,) by whole turns; an angle at its limit is included."""
    choices = []
    for angle, (lower, upper) in zip(joints_rad.tolist(), limits_rad.tolist(), strict=True):
        first = math.ceil((lower - LIMIT_TOLERANCE_RAD - angle) / TURN_RAD)
        last = math.floor((upper + LIMIT_TOLERANCE_RAD - angle) / TURN_RAD)
        choices.append([min(max(angle + turn * TURN_RAD, lower), upper) for turn in range(first, last + 1)])
    return tuple(np.array(choice) for choice in product(*choices))


def excess_rad(joints_rad: FloatArray, limits_rad: FloatArray) -> FloatArray:
    """Return how far each angle is beyond its nearer limit, at the best turn; 0 within. Shapes (..., 6), limits (6, 2)."""
    middle, half = limits_rad.mean(axis=1), np.ptp(limits_rad, axis=1) / 2.0
    return np.maximum(np.abs(wrapped(joints_rad - middle)) - half, 0.0)


def distinct(joints_rad: FloatArray, tolerance_rad: float = 1e-6) -> FloatArray:
    """Return the rows of (N, 6) that differ from every row before by more than ``tolerance_rad`` in some joint, whole turns aside."""
    same = np.abs(wrapped(joints_rad[:, None] - joints_rad)).max(axis=-1) <= tolerance_rad
    kept: list[int] = []
    for row in range(len(joints_rad)):
        if not same[row, kept].any():
            kept.append(row)
    return joints_rad[kept]
