"""Unit check of clouds against their poses: in millimetres, the placed views must overlap on one part."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.data.cloud import PointCloud
from measureapp.data.length_unit import OTHER_UNITS
from measureapp.errors import RegistrationError
from measureapp.geometry.transform import RigidTransform

APART, TOGETHER = 3.0, 1.0  # spread of the placed views over their own size
CLOSER = 0.5  # the spread in another unit must be below this multiple of that in millimetres


def check_unit(clouds: Sequence[PointCloud], poses: Sequence[RigidTransform]) -> None:
    """Refuse clouds (frame camera) that lie apart in millimetres but overlap in another unit.

    Raises
    ------
    RegistrationError
        Names the likely unit.
    """
    middles = np.stack([np.median(cloud.points_mm, axis=0) for cloud in clouds])
    sizes = np.array([np.linalg.norm(np.subtract(*np.percentile(cloud.points_mm, [95, 5], axis=0))) for cloud in clouds])

    def apart_mm(factor: float) -> float:
        placed = np.stack([pose.apply(factor * middle[None])[0] for pose, middle in zip(poses, middles, strict=True)])
        return float(np.median(np.linalg.norm(placed - np.median(placed, axis=0), axis=1)))

    def spread(factor: float) -> float:
        return apart_mm(factor) / max(factor * float(np.median(sizes)), 1e-9)

    if spread(1.0) < APART:
        return
    unit = min(OTHER_UNITS, key=lambda one: spread(one.in_mm))
    if spread(unit.in_mm) < TOGETHER and apart_mm(unit.in_mm) < CLOSER * apart_mm(1.0):
        raise RegistrationError(
            f"Placed by their poses, the clouds lie {spread(1.0):.0f} times their own size apart; read as {unit.words}, they overlap.",
            f"If they are in {unit.words}, use `--unit {unit}`; otherwise export the clouds in millimetres.",
        )
