"""Posture of an ortho-parallel arm: its branch, and how far it is from each singularity."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from measureapp.geometry.kinematics.ortho_parallel import OrthoParallelArm

HALF_TURN_RAD = float(np.pi)
AT_SINGULARITY = 1e-9  # rad or mm; a sign below this is rounding


@dataclass(frozen=True, slots=True)
class Posture:
    """Signed distances from the singularities of shoulder, elbow and wrist; their signs are the branch."""

    radius_mm: float  # wrist centre in front of axis 1; negative: behind it
    elbow_rad: float  # forearm from the straight arm; positive: wrist in front of the upper arm
    wrist_rad: float  # axis 6 from axis 4 about axis 5; for most arms the angle of joint 5

    @property
    def shoulder(self) -> Literal["front", "back"]:
        """Whether the wrist centre is in front of axis 1 or behind it; positive angles of joint 2 tilt an upright arm to the front."""
        return "back" if self.is_behind else "front"

    @property
    def elbow(self) -> Literal["up", "down"]:
        """Whether the elbow is above or below the line from shoulder to wrist."""
        return "up" if self.is_behind == self.is_folded_back else "down"

    @property
    def wrist(self) -> Literal["positive", "flipped"]:
        """Sign of the wrist angle."""
        return "flipped" if self.is_flipped else "positive"

    @property
    def is_behind(self) -> bool:
        """Whether the wrist centre is behind axis 1."""
        return self.radius_mm < -AT_SINGULARITY

    @property
    def is_folded_back(self) -> bool:
        """Whether the wrist centre is behind the upper arm."""
        return self.elbow_rad < -AT_SINGULARITY

    @property
    def is_flipped(self) -> bool:
        """Whether the wrist angle is negative."""
        return self.wrist_rad < -AT_SINGULARITY

    @property
    def shoulder_margin_mm(self) -> float:
        """Distance of the wrist centre from where joint 1 is undetermined."""
        return abs(self.radius_mm)

    @property
    def elbow_margin_rad(self) -> float:
        """Distance from the straight and from the folded arm."""
        return min(abs(self.elbow_rad), HALF_TURN_RAD - abs(self.elbow_rad))

    @property
    def wrist_margin_rad(self) -> float:
        """Distance from parallel axes 4 and 6."""
        return min(abs(self.wrist_rad), HALF_TURN_RAD - abs(self.wrist_rad))


def posture_of(arm: OrthoParallelArm, joints_rad: npt.ArrayLike) -> Posture:
    """Return the posture at joint angles (6,)."""
    _, second, third, _, fifth, _ = np.asarray(joints_rad, float)
    elbow_rad = arm.elbow_sense * third + arm.fore_rad - arm.upper_rad
    upper_rad = arm.upper_rad + second
    radius_mm = arm.shoulder_mm[0] + arm.upper_mm * np.sin(upper_rad) + arm.fore_mm * np.sin(upper_rad + elbow_rad)
    return Posture(float(radius_mm), _wrapped(elbow_rad), _wrapped(fifth + arm.wrist_rad))


def _wrapped(angle_rad: float) -> float:
    """Return the angle in [-π, π)."""
    return float((angle_rad + np.pi) % (2.0 * np.pi) - np.pi)
