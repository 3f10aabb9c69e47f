"""The arm in degrees, as the controller has it: pose of the flange for joint angles, and the joint angles that are reached first."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import LimitError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.choice import driven
from measureapp.geometry.transform import RigidTransform
from measureapp.project.geometry.robot_file import read_robot

ROUNDING_DEG = 1e-6


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
        """Return the joint angles (6,) for a pose that `driven` chooses.

        Raises
        ------
        LimitError
            Out of reach, at a singularity, or beyond a joint's limit in every configuration; says by how much.
        """
        try:
            solution = driven(self._model, base_from_flange, np.deg2rad(present_deg))
        except LimitError as error:
            raise LimitError(error.message, f"{error.hint.removesuffix('.')}; nothing was moved.") from error
        return np.rad2deg(solution.joints_rad)

    def check_limits(self, joints_deg: FloatArray) -> None:
        """Raise LimitError unless every joint angle (6,) is within its limits."""
        low_deg, high_deg = np.rad2deg(self._model.limits_rad).T
        beyond = np.maximum(low_deg - joints_deg, joints_deg - high_deg)
        if not beyond.max() <= ROUNDING_DEG:  # NaN is refused, too
            joint = int(np.nanargmax(beyond)) if np.isfinite(beyond).any() else 0
            raise LimitError(
                f"{self._model.name}: joint {joint + 1} at {joints_deg[joint]:.2f}° is outside {low_deg[joint]:.4g}…{high_deg[joint]:.4g}°.",
                "Choose a goal inside the limits; nothing was moved.",
            )
