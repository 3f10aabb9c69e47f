"""Duration of a joint move as the controller drives it."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform

from .arm import Arm

SAMPLES = 24
RAMPS_S = 0.6  # acceleration and braking at half of the arm's acceleration
LOWEST_RATIO = 0.01


def predicted_s(
    arm: Arm, from_deg: FloatArray, to_deg: FloatArray, speed_mm_per_s: float, speed_deg_per_s: float, speed_ratio: float
) -> float:
    """Return the predicted duration of a joint move in seconds: its longer part of path and reorientation, and its ramps.

    Parameters
    ----------
    from_deg, to_deg : (6,)
    speed_ratio : speed set at the controller, 0…1
    """
    shares = np.linspace(0.0, 1.0, SAMPLES)[:, None]
    poses = [arm.pose(joints) for joints in from_deg + shares * (to_deg - from_deg)]
    steps = [_step(before, after) for before, after in pairwise(poses)]
    path_mm, turn_deg = np.sum(steps, axis=0)
    slowest_joint_s = float(np.max(np.abs(to_deg - from_deg) / arm.speeds_deg_per_s))
    seconds = max(float(path_mm) / speed_mm_per_s, float(turn_deg) / speed_deg_per_s, slowest_joint_s)
    return seconds / max(speed_ratio, LOWEST_RATIO) + RAMPS_S


def _step(before: RigidTransform, after: RigidTransform) -> tuple[float, float]:
    step = before.inverse() @ after
    return float(np.linalg.norm(step.translation_mm)), float(np.degrees(step.angle_rad))
