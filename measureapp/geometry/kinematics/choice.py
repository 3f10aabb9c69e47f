"""Which of the solutions for a pose is driven: one rule for planners and drivers, so that the checked path is the driven path."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from measureapp.errors import LimitError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.inverse import JointSolution, inverse
from measureapp.geometry.kinematics.singularity import SingularityMargins, singularity_near
from measureapp.geometry.transform import RigidTransform

DRIVEN_MARGINS = SingularityMargins(shoulder_mm=5.0, elbow_rad=float(np.deg2rad(0.5)), wrist_rad=float(np.deg2rad(0.5)), condition=0.002)
"""What even a goal given by hand keeps from singularities."""


def by_preference(model: ArmModel, base_from_flange: RigidTransform, present_rad: npt.ArrayLike) -> tuple[JointSolution, ...]:
    """Return all solutions within the limits, the one first that is reached soonest from ``present_rad`` (6,).

    The order depends on the arguments only: the time in which all joints, moving at once, get there; of equals, the sum of their times.
    Raises LimitError as `inverse`.
    """
    present = np.asarray(present_rad, float)

    def times_s(solution: JointSolution) -> tuple[float, float]:
        seconds = np.abs(solution.joints_rad - present) / model.speeds_rad_s
        return float(seconds.max()), float(seconds.sum())

    return tuple(sorted(inverse(model, base_from_flange, present), key=times_s))


def away_from_singularities(
    model: ArmModel, base_from_flange: RigidTransform, present_rad: npt.ArrayLike, margins: SingularityMargins
) -> tuple[JointSolution, ...]:
    """Return the solutions of `by_preference` that keep ``margins`` from singularities.

    Raises
    ------
    LimitError
        There is none: out of reach, beyond a joint's limit, or at a singularity in every configuration.
    """
    solutions = by_preference(model, base_from_flange, present_rad)
    near = [singularity_near(solution, margins) for solution in solutions]
    if "" not in near:
        raise LimitError(
            f"{model.name}: every configuration is near a singularity, such as {near[0]}.",
            "Shift the pose by 10 mm or tilt it by a degree.",
        )
    return tuple(solution for solution, problem in zip(solutions, near, strict=True) if not problem)


def driven(model: ArmModel, base_from_flange: RigidTransform, present_rad: npt.ArrayLike) -> JointSolution:
    """Return the solution that is driven to when only the pose is given: the first of `by_preference`, so that no step by hand turns the arm over.

    Raises
    ------
    LimitError
        Out of reach, beyond a joint's limit in every configuration, or this one is at a singularity.
    """
    solution = by_preference(model, base_from_flange, present_rad)[0]
    if near := singularity_near(solution, DRIVEN_MARGINS):
        raise LimitError(f"{model.name}: the pose has {near}.", "Shift the pose by 10 mm or tilt it by a degree.")
    return solution
