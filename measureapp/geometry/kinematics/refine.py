"""Damped least squares from approximate joint angles to a pose, for many candidates at once."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import BoolArray, FloatArray
from measureapp.geometry.kinematics.arm import JOINTS, ArmModel
from measureapp.geometry.kinematics.jacobian import LENGTH_MM, jacobian

CONVERGED = 1e-12  # norm of the error; 5e-10 mm of translation
ITERATIONS = 60
FIRST_DAMPING, LEAST_DAMPING = 1e-2, 1e-14
EASIER, HARDER = 0.2, 5.0  # damping after a step that reduced the error, and after one that did not
SEED_STEPS = 1.1127756842787055 ** -np.arange(1.0, JOINTS + 1)  # the root of x⁷ = x + 1, in six dimensions what the golden ratio is in one


@dataclass(frozen=True, slots=True, eq=False)
class Refined:
    """Candidates after refinement."""

    joints_rad: FloatArray  # (N, 6)
    errors: FloatArray  # (N, 6), remaining translation over `LENGTH_MM` and rotation in rad

    @property
    def reached(self) -> BoolArray:
        """Whether the pose was reached, (N,)."""
        return np.linalg.norm(self.errors, axis=1) < CONVERGED


def refine(model: ArmModel, base_from_flange: FloatArray, candidates_rad: FloatArray) -> Refined:
    """Minimise the error of the pose (4, 4) from every candidate (N, 6), by the Levenberg-Marquardt method.

    Candidates that already reach the pose are returned as they are.
    """
    joints = np.array(candidates_rad, float)
    errors = _errors(model, base_from_flange, joints)
    damping = np.full(len(joints), FIRST_DAMPING)
    for _ in range(ITERATIONS):
        busy = np.flatnonzero(np.linalg.norm(errors, axis=1) > CONVERGED / 10.0)
        if not len(busy):
            break
        trial = joints[busy] + _steps(model, joints[busy], errors[busy], damping[busy])
        trial_errors = _errors(model, base_from_flange, trial)
        better = np.linalg.norm(trial_errors, axis=1) < np.linalg.norm(errors[busy], axis=1)
        damping[busy] = np.maximum(damping[busy] * np.where(better, EASIER, HARDER), LEAST_DAMPING)
        joints[busy[better]], errors[busy[better]] = trial[better], trial_errors[better]
    return Refined(joints, errors)


def seeds(limits_rad: FloatArray, count: int) -> FloatArray:
    """Return evenly spread joint angles within limits, (count, 6): the additive sequence of the generalised golden ratio, the same every time."""
    fractions = (0.5 + np.arange(1, count + 1)[:, None] * SEED_STEPS) % 1.0
    return limits_rad[:, 0] + fractions * np.ptp(limits_rad, axis=1)


def _errors(model: ArmModel, goal: FloatArray, joints_rad: FloatArray) -> FloatArray:
    reached = model.forward_matrices(joints_rad)
    rotations = Rotation.from_matrix(goal[:3, :3] @ reached[:, :3, :3].swapaxes(-1, -2))
    return np.hstack([(goal[:3, 3] - reached[:, :3, 3]) / LENGTH_MM, rotations.as_rotvec()])


def _steps(model: ArmModel, joints_rad: FloatArray, errors: FloatArray, damping: FloatArray) -> FloatArray:
    rates = jacobian(model, joints_rad) * np.repeat([1.0 / LENGTH_MM, 1.0], 3)[:, None]
    transposed = rates.swapaxes(-1, -2)
    normal = transposed @ rates + damping[:, None, None] * np.eye(JOINTS)
    return np.linalg.solve(normal, transposed @ errors[..., None])[..., 0]
