"""Propagation of the uncertainty of robot, hand-eye and cameras to what is estimated from board poses.

A guide or an axis observed by cameras on the flange is given in the robot's frames: an error of the robot's pose or of hand-eye turns and
shifts it as a whole, and does not appear in any residual, since all observations share it. The covariance of the cameras is propagated
through the derivatives of the board poses with respect to the camera parameters, without the corners of the board.
"""

from __future__ import annotations

from dataclasses import replace
from math import hypot

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.least_squares import Minimum
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.motions.chain import Chain
from measureapp.calibrate.motions.chain_state import POSE, ChainState
from measureapp.data.calibration import HandEye, LabelledCovariance, LinearGuide, RotationAxis


def propagate_robot_to_guide(guide: LinearGuide, hand_eye: HandEye, noise: AxisNoise) -> LinearGuide:
    """Add the uncertainty of robot and hand-eye to that of the guide's direction."""
    return replace(guide, direction_sigma_rad=hypot(guide.direction_sigma_rad, turn_sigma_rad(hand_eye, noise)))


def propagate_robot_to_axis(axis: RotationAxis, seen: RotationAxis, hand_eye: HandEye, noise: AxisNoise) -> RotationAxis:
    """Add the uncertainty of robot and hand-eye to ``axis``, which is ``seen`` transformed into the guide's frame."""
    turn_rad, shift_mm = axis_sigmas(seen, hand_eye, noise)
    return replace(axis, point_sigma_mm=hypot(axis.point_sigma_mm, shift_mm), direction_sigma_rad=hypot(axis.direction_sigma_rad, turn_rad))


def axis_sigmas(seen: RotationAxis, hand_eye: HandEye, noise: AxisNoise) -> tuple[float, float]:
    """Return the standard deviations of direction (rad) and point (mm) that robot and hand-eye add to an axis.

    Parameters
    ----------
    seen : in the frame of the reference camera, whose rotation displaces the axis in proportion to its distance
    """
    turn_rad = turn_sigma_rad(hand_eye, noise)
    return turn_rad, hypot(hand_eye.translation_sigma_mm, noise.robot_mm, turn_rad * hypot(*seen.point_mm))


def turn_sigma_rad(hand_eye: HandEye, noise: AxisNoise) -> float:
    """Return the standard deviation of the cameras' orientation by robot and hand-eye."""
    return hypot(hand_eye.rotation_sigma_rad, noise.robot_rad)


def whiten_camera_jacobian(chain: Chain) -> FloatArray:
    """Return the derivatives of the whitened board poses with respect to the camera parameters, (6 N + K + M, C)."""
    seen = (chain.roots @ np.asarray(chain.camera_jacobian)).reshape(POSE * len(chain.guide_mm), -1)
    return np.vstack([seen, np.zeros((chain.own_residuals, seen.shape[1]))])


def marginal_cost(chain: Chain, minimum: Minimum[ChainState], covariance: FloatArray, camera_prior: LabelledCovariance | None) -> float:
    """Return the sum of squares with the camera parameters marginalised: as if they had been estimated within their covariance."""
    if camera_prior is None or chain.cameras_freed or chain.camera_jacobian is None:
        return minimum.cost
    jacobian, seen = chain.jacobian(minimum.state), whiten_camera_jacobian(chain)
    mixed = jacobian.T @ seen
    normal = np.linalg.inv(camera_prior.covariance) + seen.T @ seen - mixed.T @ covariance @ mixed
    pull = seen.T @ chain.residuals(minimum.state)
    return max(minimum.cost - float(pull @ np.linalg.solve(normal, pull)), 0.0)


def camera_sensitivity(chain: Chain, minimum: Minimum[ChainState], covariance: FloatArray, variance: float) -> FloatArray | None:
    """Return the derivatives (P, C) of the solution with respect to cameras that are not estimated; None where those of the poses are missing.

    Parameters
    ----------
    covariance : (P, P), of the solution for cameras without error, ``variance`` times the inverse of the normal matrix
    """
    if chain.cameras_freed or chain.camera_jacobian is None:
        return None
    return np.asarray(covariance / variance @ (chain.jacobian(minimum.state).T @ whiten_camera_jacobian(chain)))


def add_camera_covariance(covariance: FloatArray, gain: FloatArray | None, camera_prior: LabelledCovariance | None) -> FloatArray:
    """Add K Σ Kᵀ for cameras that are not freed, with the sensitivity K of the solution to their parameters (`camera_sensitivity`)."""
    if camera_prior is None or gain is None:
        return covariance
    return np.asarray(covariance + gain @ camera_prior.covariance @ gain.T)
