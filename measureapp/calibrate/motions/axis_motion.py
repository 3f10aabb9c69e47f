"""The rotation axis from the whole motion of the board: start values, and maximum likelihood."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.calibrate.least_squares import Minimum, minimise_residuals
from measureapp.calibrate.poses import apply_changes, change_between
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import rotation_about

LEAST_SWEEP_RAD = np.deg2rad(2.0)
ANGLE_STEP, LENGTH_STEP = 1e-6, 1e-4
AXIS_PARAMETERS = 4


@dataclass(frozen=True, slots=True, eq=False)
class Turning:
    """An axis and the angles of the positions against the first, with the board's pose there where it is part of the model."""

    point_mm: FloatArray  # (3,)
    direction: FloatArray  # (3,), unit
    angles_rad: FloatArray  # (n,), the first is 0
    board: FloatArray  # (4, 4), camera_from_board at the first position

    def motion(self, angle_rad: float) -> FloatArray:
        """Return the motion (4, 4) by an angle about the axis."""
        result = np.eye(4)
        result[:3, :3] = rotation_about(self.direction, angle_rad)
        result[:3, 3] = self.point_mm - result[:3, :3] @ self.point_mm
        return result


def rigid_motion(origin_mm: FloatArray, goal_mm: FloatArray) -> FloatArray:
    """Return the rigid motion (4, 4) from points (m, 3) to others by least squares (Kabsch)."""
    centre, aim = origin_mm.mean(axis=0), goal_mm.mean(axis=0)
    u, _, vt = np.linalg.svd((goal_mm - aim).T @ (origin_mm - centre))
    result = np.eye(4)
    result[:3, :3] = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
    result[:3, 3] = aim - result[:3, :3] @ centre
    return result


def estimate_turning(corners_mm: FloatArray) -> Turning:
    """Return the axis and angles that the rigid motions of the corners (n, m, 3) show; right-handed for growing positions.

    Raises
    ------
    CalibrationError
        The board hardly turned.
    """
    motions = np.array([rigid_motion(corners_mm[0], goal) for goal in corners_mm])
    steps = np.array([rigid_motion(a, b)[:3, :3] for a, b in pairwise(corners_mm)])
    turns = Rotation.from_matrix(steps).as_rotvec()
    _, vectors = np.linalg.eigh(turns.T @ turns)
    direction = vectors[:, 2] * (1.0 if float(np.sum(turns @ vectors[:, 2])) >= 0 else -1.0)
    angles = np.concatenate([[0.0], np.cumsum(turns @ direction)])
    if np.ptp(angles) < LEAST_SWEEP_RAD:
        raise CalibrationError(
            f"The board turned by only {np.rad2deg(np.ptp(angles)):.2f}° in all.", "Turn the table further, best by 60° or more."
        )
    design = np.concatenate([np.eye(3) - motion[:3, :3] for motion in motions] + [direction[None]])
    target = np.concatenate([motion[:3, 3] - direction * (direction @ motion[:3, 3]) for motion in motions] + [np.zeros(1)])
    point = np.linalg.lstsq(design, target, rcond=None)[0]
    return Turning(point, direction, angles, np.eye(4))


def fit_axis_to_poses(start: Turning, poses: FloatArray, roots: FloatArray, free_angles: bool) -> tuple[Minimum[Turning], int]:
    """Fit one axis and one board pose to board poses (n, 4, 4), whitened by ``roots`` (n, 6, 6) of their information.

    Returns the minimum and its degrees of freedom. Parameters: direction (2), point (2), board (6), then the free angles.
    """

    def residuals(turning: Turning) -> FloatArray:
        predicted = np.array([turning.motion(angle) for angle in turning.angles_rad]) @ turning.board
        return np.asarray((roots @ change_between(poses, predicted)[..., None]).ravel())

    angles = len(poses) - 1 if free_angles else 0
    steps = np.array([ANGLE_STEP] * 2 + [LENGTH_STEP] * 2 + [ANGLE_STEP] * 3 + [LENGTH_STEP] * 3 + [ANGLE_STEP] * angles)
    minimum = minimise_residuals(start, residuals, _apply_step, steps)
    return minimum, 6 * len(poses) - len(steps)


def fit_axis_to_corners(start: Turning, corners_mm: FloatArray, free_angles: bool) -> tuple[Minimum[Turning], int]:
    """Fit one axis to corners (n, m, 3) of equal noise; the place of each corner on the table is estimated with it.

    For a given axis the best place of a corner is the mean of its positions turned back, so only the axis is iterated.
    """

    def residuals(turning: Turning) -> FloatArray:
        back = np.array([turning.motion(-angle) for angle in turning.angles_rad])
        turned = corners_mm @ np.swapaxes(back[:, :3, :3], 1, 2) + back[:, None, :3, 3]
        return np.asarray((turned - turned.mean(axis=0)).ravel())

    angles = len(corners_mm) - 1 if free_angles else 0
    steps = np.array([ANGLE_STEP] * 2 + [LENGTH_STEP] * 2 + [ANGLE_STEP] * angles)
    minimum = minimise_residuals(start, residuals, _apply_motion_step, steps)
    return minimum, 3 * corners_mm.shape[1] * (len(corners_mm) - 1) - len(steps)


def perpendicular_basis(direction: FloatArray) -> FloatArray:
    """Return two unit vectors (2, 3) perpendicular to ``direction`` and to each other."""
    least = np.eye(3)[int(np.argmin(np.abs(direction)))]
    first = np.cross(direction, least)
    first /= np.linalg.norm(first)
    return np.array([first, np.cross(direction, first)])


def _apply_step(turning: Turning, step: FloatArray) -> Turning:
    axis = _apply_motion_step(turning, np.concatenate([step[:AXIS_PARAMETERS], step[AXIS_PARAMETERS + 6 :]]))
    return replace(axis, board=apply_changes(turning.board, step[AXIS_PARAMETERS : AXIS_PARAMETERS + 6]))


def _apply_motion_step(turning: Turning, step: FloatArray) -> Turning:
    basis = perpendicular_basis(turning.direction)
    direction = turning.direction + step[:2] @ basis
    angles = turning.angles_rad
    if len(step) > AXIS_PARAMETERS:
        angles = angles + np.concatenate([[0.0], step[AXIS_PARAMETERS:]])
    return replace(
        turning, direction=direction / np.linalg.norm(direction), point_mm=turning.point_mm + step[2:4] @ basis, angles_rad=angles
    )
