"""The arm in degrees, as the controller has it: pose of the flange for joint angles, and the joint angles that are reached first."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.inverse import inverse
from measureapp.geometry.transform import RigidTransform
from measureapp.project.geometry.robot_file import read_robot


class Arm:
    """An arm that keeps a distance from the limits of its joints.

    Parameters
    ----------
    margin_deg : distance that every joint keeps from its limits
    """

    def __init__(self, model: ArmModel, margin_deg: float) -> None:
        self._model = replace(model, limits_rad=model.limits_rad + np.deg2rad([margin_deg, -margin_deg]))
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

        At a singularity the joint that the pose leaves open keeps its present angle.

        Raises
        ------
        LimitError
            Out of reach, or beyond a joint's limit in every configuration; says by how much.
        """
        solutions = inverse(self._model, base_from_flange, np.deg2rad(present_deg))
        found = [np.rad2deg(solution.joints_rad) for solution in solutions]
        return min(found, key=lambda one: float(np.max(np.abs(one - present_deg) / self.speeds_deg_per_s)))
