"""Forward kinematics of the virtual controller's arm (IRB 1200-7/0.7), stated by offsets and axes as in the robot's URDF."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform, rotation_about

X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
# Offset of each joint from the one before, mm, and its axis, in the base frame with all joints at zero.
JOINTS = (
    ((0.0, 0.0, 399.1), Z),
    ((0.0, 0.0, 0.0), Y),
    ((0.0, 0.0, 350.0), Y),
    ((0.0, 0.0, 42.0), X),
    ((351.0, 0.0, 0.0), Y),
    ((82.0, 0.0, 0.0), X),
)
LIMITS_DEG = np.array([[-170, 170], [-100, 135], [-200, 70], [-270, 270], [-130, 130], [-360, 360]], float)
SPEED_DEG_PER_S = np.array([288, 240, 300, 400, 405, 600], float)
ACCELERATION_DEG_PER_S2 = SPEED_DEG_PER_S / 0.3


def flange_pose(joints_deg: FloatArray) -> RigidTransform:
    """Return base_from_flange for joint angles (6,) in degrees; z points out of the flange."""
    rotation, position = np.eye(3), np.zeros(3)
    for (offset, axis), angle in zip(JOINTS, np.deg2rad(joints_deg), strict=True):
        position = position + rotation @ np.array(offset)
        rotation = rotation @ rotation_about(axis, float(angle))
    tool0 = rotation_about(Y, np.pi / 2)
    return RigidTransform.from_parts(rotation @ tool0, position, "base", "flange")


def configuration(joints_deg: FloatArray) -> tuple[int, int, int, int]:
    """Return cf1, cf4, cf6 (quarter revolutions of axes 1, 4, 6) and cfx (0: the wrist's sign is not distinguished here)."""
    quarters = [int(np.floor(joints_deg[axis] / 90.0)) for axis in (0, 3, 5)]
    return quarters[0], quarters[1], quarters[2], 0
