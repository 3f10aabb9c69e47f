"""Arms for the tests, each stated by offsets and axes of its joints."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.kinematics.arm import ArmModel, homogeneous
from measureapp.geometry.kinematics.dh import DhRow, arm_from_dh
from measureapp.geometry.transform import rotation_about

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
LIMITS_DEG = ((-170.0, 170.0), (-100.0, 135.0), (-200.0, 70.0), (-270.0, 270.0), (-130.0, 130.0), (-360.0, 360.0))
SPEEDS_DEG_S = (288.0, 240.0, 300.0, 400.0, 405.0, 600.0)
TOOL0 = homogeneous(rotation_about(Y, np.pi / 2))


def arm_from_offsets(
    offsets_mm: Sequence[Sequence[float]],
    axes: Sequence[Sequence[float]],
    limits_deg: Sequence[Sequence[float]] = LIMITS_DEG,
    last_from_flange: FloatArray = TOOL0,
    name: str = "test arm",
) -> ArmModel:
    """Return an arm whose joint frames are parallel to the base with all joints at zero."""
    frames = np.array([homogeneous(np.eye(3), offset) for offset in offsets_mm])
    return ArmModel(name, frames, np.array(axes, float), last_from_flange, np.deg2rad(limits_deg), np.deg2rad(SPEEDS_DEG_S))


def irb_by_offsets() -> ArmModel:
    """IRB 1200-7/0.7 by offsets and axes, as in its URDF."""
    offsets = [(0, 0, 399.1), (0, 0, 0), (0, 0, 350), (0, 0, 42), (351, 0, 0), (82, 0, 0)]
    return arm_from_offsets(offsets, [Z, Y, Y, X, Y, X], name="IRB 1200-7/0.7")


def irb_by_dh() -> ArmModel:
    """The same arm by standard Denavit-Hartenberg rows."""
    rows = [
        DhRow(np.deg2rad(theta), d, a, np.deg2rad(alpha))
        for theta, d, a, alpha in [(0, 399.1, 0, -90), (-90, 0, 350, 0), (0, 0, 42, -90), (0, 351, 0, 90), (0, 0, 0, -90), (180, 82, 0, 0)]
    ]
    return arm_from_dh("IRB 1200-7/0.7", rows, np.deg2rad(LIMITS_DEG), np.deg2rad(SPEEDS_DEG_S))


def without_spherical_wrist() -> ArmModel:
    """An arm as collaborative robots have it: axis 4 parallel to axes 2 and 3, no common point of the wrist's axes."""
    offsets = [(0, 0, 152), (0, 120, 0), (244, -93, 0), (213, 83, 0), (0, 0, -83), (0, 82, 0)]
    limits = [(-180, 180)] * 6
    flange = homogeneous(rotation_about(X, -np.pi / 2))
    return arm_from_offsets(offsets, [Z, Y, Y, Y, Z, Y], limits, flange, "arm with an offset wrist")


def random_joints(model: ArmModel, count: int, seed: int) -> FloatArray:
    """Return joint angles (count, 6) evenly distributed within the limits."""
    low, high = model.limits_rad.T
    return np.random.default_rng(seed).uniform(low, high, (count, 6))
