"""The state of the kinematic chain: all quantities that its adjustment estimates."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.calibration import HandEye, LinearGuide, RotationAxis

POSE = 6


@dataclass(frozen=True, slots=True, eq=False)
class ChainState:
    """All quantities of the chain."""

    flange_from_camera: FloatArray  # (4, 4)
    guide_direction: FloatArray  # (3,), unit, in base
    guide_scale: float
    axis_point_mm: FloatArray  # (3,), in guide
    axis_direction: FloatArray  # (3,), unit, in guide
    guide_from_board: FloatArray  # (4, 4), at table angle 0
    robot_changes: FloatArray  # (G, 6), error of each robot pose in its flange frame
    table_changes: FloatArray  # (K,), error of each table angle
    camera_changes: FloatArray = field(default_factory=lambda: np.zeros(0))  # (C,), where the cameras are freed
    motions: FloatArray = field(default_factory=lambda: np.zeros(0))  # (M,), coefficients of the error motions

    @classmethod
    def unchanged(
        cls, hand_eye: HandEye, guide: LinearGuide, axis: RotationAxis, guide_from_board: FloatArray, robot_poses: int
    ) -> ChainState:
        """Return the chain of a calibrated rig without errors of robot poses, table angles and cameras."""
        return cls(
            flange_from_camera=np.asarray(hand_eye.flange_from_camera.matrix),
            guide_direction=np.asarray(guide.direction),
            guide_scale=guide.scale,
            axis_point_mm=np.asarray(axis.point_mm),
            axis_direction=np.asarray(axis.direction),
            guide_from_board=np.asarray(guide_from_board),
            robot_changes=np.zeros((robot_poses, 6)),
            table_changes=np.zeros(0),
        )
