"""Kinematic placement: clouds in the part's frame by the kinematic chain, and the stations of the robot."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.data.cloud import PointCloud
from measureapp.data.fringe import AxisReadback
from measureapp.geometry.transform import RigidTransform

SAME_STATION_MM = 0.2
SAME_STATION_RAD = 3e-4


def place(cloud: PointCloud, part_from_camera: RigidTransform) -> PointCloud:
    """Transform a cloud to the part's frame; raises FrameMismatch unless it is in the transform's ``from_frame``."""
    return cloud.seen_from(part_from_camera)


def number_stations(readbacks: Sequence[AxisReadback]) -> tuple[int, ...]:
    """Number the stations (poses of robot and guide) of views, one number per view.

    Views of one station differ by the table angle only and share the robot's pose error.
    """
    seen: list[RigidTransform] = []
    numbers = []
    for readback in readbacks:
        shift = RigidTransform.from_parts(np.eye(3), [0.0, readback.guide_mm, 0.0], "guide", "base")
        pose = shift @ readback.base_from_flange
        number = next((i for i, other in enumerate(seen) if _same(other, pose)), len(seen))
        if number == len(seen):
            seen.append(pose)
        numbers.append(number)
    return tuple(numbers)


def _same(a: RigidTransform, b: RigidTransform) -> bool:
    change = a.inverse() @ b
    return float(np.linalg.norm(change.translation_mm)) < SAME_STATION_MM and change.angle_rad < SAME_STATION_RAD
