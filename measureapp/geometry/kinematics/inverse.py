"""Inverse kinematics: all joint angles within the limits that reach a pose, each with its branch and margins."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from measureapp.arrays import FloatArray, read_only
from measureapp.errors import FrameMismatch
from measureapp.geometry.kinematics.arm import JOINTS, ArmModel
from measureapp.geometry.kinematics.closed_form import all_branches
from measureapp.geometry.kinematics.jacobian import inverse_condition
from measureapp.geometry.kinematics.ortho_parallel import OrthoParallelArm, ortho_parallel
from measureapp.geometry.kinematics.posture import Posture, posture_of
from measureapp.geometry.kinematics.refine import refine, seeds
from measureapp.geometry.kinematics.refusal import beyond_limits, beyond_reach, not_found
from measureapp.geometry.kinematics.turns import distinct, within_limits
from measureapp.geometry.transform import RigidTransform, orthonormalise

SEEDS = 256  # starts of the numerical solver


@dataclass(frozen=True, slots=True, eq=False)
class JointSolution:
    """Joint angles that reach a pose."""

    joints_rad: FloatArray  # (6,), read-only, within the limits
    posture: Posture | None  # branch and margins to the singularities; None for arms without a spherical wrist
    limit_margin_rad: float  # smallest distance of a joint from its limits
    condition: float  # of the Jacobian, see `inverse_condition`; 0 at a singularity


def inverse(model: ArmModel, base_from_flange: RigidTransform, current_rad: npt.ArrayLike | None = None) -> tuple[JointSolution, ...]:
    """Return all solutions within the joint limits, also those whole turns apart.

    Arms with an ortho-parallel base and a spherical wrist are solved in closed form; where a model deviates slightly from that (calibrated or
    rounded parameters), the closed form starts an iteration. Any other arm, and a deviating one where branches are lost close to a
    singularity, is solved numerically: damped least squares from 256 seeds, equal results merged, without proof that none is missed.

    Parameters
    ----------
    current_rad : (6,), default 0; at a singularity, the undetermined joint keeps this angle. The numerical solver starts here, too

    Returns
    -------
    tuple of JointSolution
        At least one; forward kinematics of each differs from the pose by less than 1e-9 mm and 1e-9 rad.

    Raises
    ------
    LimitError
        The pose is out of reach, or all solutions violate joint limits; says by how much.
    FrameMismatch
        The transform is not from the flange to the base.
    """
    goal = _goal(base_from_flange)
    current = np.zeros(JOINTS) if current_rad is None else np.asarray(current_rad, float)
    arm = ortho_parallel(model)
    found = _solve_numerically(model, goal, current[None]) if arm is None else _solve_in_closed_form(model, arm, goal, current)
    solutions = tuple(
        _solution(model, arm, joints, condition)
        for branch, condition in zip(found, inverse_condition(model, found).tolist(), strict=True)
        for joints in within_limits(branch, model.limits_rad)
    )
    if not solutions:
        raise beyond_limits(model, found)
    return solutions


def _goal(base_from_flange: RigidTransform) -> FloatArray:
    if (base_from_flange.to_frame, base_from_flange.from_frame) != ("base", "flange"):
        raise FrameMismatch(
            f"Inverse kinematics needs base_from_flange, not {base_from_flange.to_frame}_from_{base_from_flange.from_frame}.",
            "Multiply by the transforms to base and flange first.",
        )
    return orthonormalise(base_from_flange.matrix)


def _solve_in_closed_form(model: ArmModel, arm: OrthoParallelArm, goal: FloatArray, current_rad: FloatArray) -> FloatArray:
    """Return the joint angles of all branches, (N, 6), limits ignored; raises LimitError."""
    branches = all_branches(arm, goal[None], current_rad)[0]
    branches = branches[np.isfinite(branches).all(axis=1)]
    if not len(branches):
        raise beyond_reach(model, arm, goal)
    refined = refine(model, goal, branches)
    found = distinct(refined.joints_rad[refined.reached])
    coincide = arm.slack_mm == 0.0 and bool(refined.reached.all())  # branches of an exact arm, at a singularity
    return found if coincide or len(found) == len(branches) else _solve_numerically(model, goal, branches)


def _solve_numerically(model: ArmModel, goal: FloatArray, starts_rad: FloatArray) -> FloatArray:
    """Return the joint angles found from ``starts_rad`` (N, 6) and from seeds, (N, 6), limits ignored; raises LimitError."""
    refined = refine(model, goal, np.vstack([starts_rad, seeds(model.limits_rad, SEEDS)]))
    if not refined.reached.any():
        raise not_found(model, refined)
    return distinct(refined.joints_rad[refined.reached])


def _solution(model: ArmModel, arm: OrthoParallelArm | None, joints_rad: FloatArray, condition: float) -> JointSolution:
    margins = np.abs(joints_rad[:, None] - model.limits_rad)
    return JointSolution(read_only(joints_rad), posture_of(arm, joints_rad) if arm else None, float(margins.min()), condition)
