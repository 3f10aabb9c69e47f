"""Many poses at once as 4×4 matrices, and small changes of them.

A small change (ω, τ) of a pose turns it by the rotation vector ω on the left and adds τ: R' = exp(ω) R, t' = t + τ.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.calibrate.projection import cross_matrices
from measureapp.geometry.transform import RigidTransform

SMALL_TURN_RAD = 1e-4  # below it the series is exact to a part in 1e9, the quotients are not


def stack_matrices(transforms: Iterable[RigidTransform]) -> FloatArray:
    """Return the matrices (N, 4, 4) of transforms."""
    return np.array([transform.matrix for transform in transforms], float).reshape(-1, 4, 4)


def invert_poses(poses: FloatArray) -> FloatArray:
    """Return the inverses of rigid poses (..., 4, 4)."""
    result = np.zeros_like(poses)
    turned = np.swapaxes(poses[..., :3, :3], -1, -2)
    result[..., :3, :3] = turned
    result[..., :3, 3] = -(turned @ poses[..., :3, 3, None])[..., 0]
    result[..., 3, 3] = 1.0
    return result


def apply_changes(poses: FloatArray, change: FloatArray) -> FloatArray:
    """Return poses (..., 4, 4) after the small changes (..., 6)."""
    result = np.array(poses, float)
    turn = Rotation.from_rotvec(np.reshape(change[..., :3], (-1, 3))).as_matrix().reshape((*change.shape[:-1], 3, 3))
    result[..., :3, :3] = turn @ poses[..., :3, :3]
    result[..., :3, 3] = poses[..., :3, 3] + change[..., 3:]
    return result


def change_between(origin: FloatArray, goal: FloatArray) -> FloatArray:
    """Return the changes (N, 6) from the poses ``origin`` (N, 4, 4) to ``goal``."""
    turn = goal[:, :3, :3] @ np.swapaxes(origin[:, :3, :3], -1, -2)
    return np.hstack([Rotation.from_matrix(turn).as_rotvec(), goal[:, :3, 3] - origin[:, :3, 3]])


def left_jacobians(vectors: FloatArray) -> FloatArray:
    """Return J (N, 3, 3) of rotation vectors φ (N, 3): exp(φ + δ) = exp(J δ) exp(φ) for small δ [1]_.

    References
    ----------
    .. [1] T. D. Barfoot, State Estimation for Robotics, Cambridge University Press 2017, eq. (7.77).
    """
    angle = np.linalg.norm(vectors, axis=-1)[..., None, None]
    small = angle < SMALL_TURN_RAD
    safe = np.where(small, 1.0, angle)
    once = np.where(small, 0.5, (1 - np.cos(safe)) / safe**2)
    twice = np.where(small, 1 / 6, (safe - np.sin(safe)) / safe**3)
    cross = cross_matrices(vectors)
    return np.asarray(np.eye(3) + once * cross + twice * cross @ cross)


def mean_pose(poses: FloatArray) -> FloatArray:
    """Return the mean (4, 4) of poses (N, 4, 4): chordal mean of the rotations, mean of the translations."""
    result = np.eye(4)
    result[:3, :3] = Rotation.from_matrix(poses[:, :3, :3]).mean().as_matrix()
    result[:3, 3] = poses[:, :3, 3].mean(axis=0)
    return result


def median_pose(poses: FloatArray) -> FloatArray:
    """Return a pose (4, 4) in the middle of ``poses`` (N, 4, 4) that a few bad ones do not move."""
    turns = Rotation.from_matrix(poses[:, :3, :3])
    spread = np.array([np.sum((turn.inv() * turns).magnitude()) for turn in turns])
    middle = turns[int(np.argmin(spread))]
    result = np.eye(4)
    result[:3, :3] = (Rotation.from_rotvec(np.median((turns * middle.inv()).as_rotvec(), axis=0)) * middle).as_matrix()
    result[:3, 3] = np.median(poses[:, :3, 3], axis=0)
    return result
