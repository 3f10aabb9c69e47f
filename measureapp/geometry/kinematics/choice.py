"""Which of the solutions for a pose is driven: one rule for planners and drivers, so that the checked path is the driven path."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from measureapp.errors import LimitError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.inverse import JointSolution, inverse
from measureapp.geometry.kinematics.singularity import GOAL_MARGINS, SingularityMargins, singularity_near
from measureapp.geometry.transform import RigidTransform

DRIVEN_MARGINS = SingularityMargins(shoulder_mm=5.0, elbow_rad=float(np.deg2rad(0.5)), wrist_rad=float(np.deg2rad(0.5)), condition=0.002)
"""What even a goal without a better configuration keeps from singularities."""


def by_preference(
    model: ArmModel, base_from_flange: RigidTransform, present_rad: npt.ArrayLike, margins: SingularityMargins = DRIVEN_MARGINS
) -> tuple[JointSolution, ...]:
    """Return the solutions that may be driven to, the one to drive first: away from singularities, and then reached soonest.

    The order depends on the arguments only. Solutions within `GOAL_MARGINS` of a singularity come last, those within ``margins`` are left
    out; among the others the time counts in which all joints, moving at once, get there from ``present_rad`` (6,).

    Raises
    ------
    LimitError
        Out of reach, at a singularity, or beyond a joint's limit in every configuration; says by how much.
    """
    present = np.asarray(present_rad, float)
    solutions = inverse(model, base_from_flange, present)
    near = [singularity_near(solution, margins) for solution in solutions]
    drivable = [solution for solution, problem in zip(solutions, near, strict=True) if not problem]
    if not drivable:
        raise LimitError(f"{model.name}: the pose has {near[0]}.", "Shift the pose by 10 mm or tilt it by a degree.")

    def rank(solution: JointSolution) -> tuple[bool, float, float]:
        seconds = np.abs(solution.joints_rad - present) / model.speeds_rad_s
        return bool(singularity_near(solution, GOAL_MARGINS)), float(seconds.max()), float(seconds.sum())

    return tuple(sorted(drivable, key=rank))
