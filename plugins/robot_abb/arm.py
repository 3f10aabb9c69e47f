"""The arm in degrees, as the controller has it: pose of the flange for joint angles, and the joint angles that are reached first."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import LimitError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.inverse import inverse, nearest
from measureapp.geometry.kinematics.singularity import SingularityMargins, singularity_near
from measureapp.geometry.transform import RigidTransform
from measureapp.project.geometry.robot_file import read_robot

MARGINS = SingularityMargins(shoulder_mm=5.0, elbow_rad=float(np.deg2rad(0.5)), wrist_rad=float(np.deg2rad(0.5)), condition=0.002)


class Arm:
    """An arm that keeps a distance from the limits of its joints.

    Parameters
    ----------
    margin_deg : distance that every joint keeps from its limits
    """

    def __init__(self, model: ArmModel, margin_deg: float) -> None:
        self._model = model.with_margin(float(np.deg2rad(margin_deg)))
        self.speeds_deg_per_s = np.rad2deg(model.speeds_rad_s)

    @classmethod
    def read(cls, name_or_path: str, margin_deg: float) -> Arm:
        """Read the arm of this name in `resources/robots`, a TOML file, or a URDF. Raises InputError naming the file and the field."""
        return cls(read_robot(name_or_path), margin_deg)

    def pose(self, joints_deg: FloatArray) -> RigidTransform:
        """Return base_from_flange for joint angles (6,)."""
        return self._model.forward(np.deg2rad(joints_deg))

    def joints_for(self, base_from_flange: RigidTransform, present_deg: FloatArray) -> FloatArray:
        """Return the joint angles (6,) for a pose that are reached first from the present ones.

        Raises
        ------
        LimitError
            Out of reach, at a singularity, or beyond a joint's limit in every configuration; says by how much.
        """
        present_rad = np.deg2rad(present_deg)
        try:
            solutions = inverse(self._model, base_from_flange, present_rad)
        except LimitError as error:
            raise LimitError(error.message, f"{error.hint.removesuffix('.')}; nothing was moved.") from error
        found = nearest(solutions, present_rad, self._model.speeds_rad_s)
        if near := singularity_near(found, MARGINS):
            raise LimitError(
                f"{self._model.name}: the pose has {near}.", "Shift the pose by 10 mm or tilt it by a degree; nothing was moved."
            )
        return np.rad2deg(found.joints_rad)
