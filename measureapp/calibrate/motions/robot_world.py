"""Closed solutions of A X = Z B, which find the board's place Z = base_from_board together with X = flange_from_camera."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.poses import invert_poses
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import orthonormalise

LEAST_SINGULAR_SHARE = 1e-9


def shah(base_from_flange: FloatArray, camera_from_board: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Solve both rotations as the leading singular vectors of Σ R_B ⊗ R_A, then both translations [1]_.

    Parameters
    ----------
    base_from_flange, camera_from_board : (N, 4, 4)

    Returns
    -------
    flange_from_camera, base_from_board : (4, 4)

    Raises
    ------
    CalibrationError
        The rotations do not determine X and Z.

    References
    ----------
    .. [1] M. Shah, ASME Journal of Mechanisms and Robotics 5(3), 031007, 2013.
    """
    seen = invert_poses(camera_from_board)
    total = sum(np.kron(b[:3, :3], a[:3, :3]) for a, b in zip(base_from_flange, seen, strict=True))
    u, _, vt = np.linalg.svd(total)
    return _with_translations(_rotation(vt[0]), _rotation(u[:, 0]), base_from_flange, seen)


def li_wang_wu(base_from_flange: FloatArray, camera_from_board: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Solve rotations and translations of X and Z as one linear system of Kronecker products, then make them rigid [1]_.

    The rotations are made orthonormal and the translations found once more with them. Parameters, Returns, Raises as `shah`.

    References
    ----------
    .. [1] A. Li, L. Wang, D. Wu, International Journal of the Physical Sciences 5(10), 1530-1536, 2010.
    """
    seen = invert_poses(camera_from_board)
    unit = max(float(np.mean(np.linalg.norm(base_from_flange[:, :3, 3], axis=1))), 1e-9)
    rows, right = np.zeros((len(seen), 12, 24)), np.zeros((len(seen), 12))
    for index, (a, b) in enumerate(zip(base_from_flange, seen, strict=True)):
        rows[index, :9, :9] = np.kron(np.eye(3), a[:3, :3])
        rows[index, :9, 9:18] = -np.kron(b[:3, :3].T, np.eye(3))
        rows[index, 9:, 9:18] = np.kron(b[:3, 3] / unit, np.eye(3))
        rows[index, 9:, 18:21] = -a[:3, :3]
        rows[index, 9:, 21:] = np.eye(3)
        right[index, 9:] = a[:3, 3] / unit
    solution, _, rank, _ = np.linalg.lstsq(rows.reshape(-1, 24), right.ravel(), rcond=LEAST_SINGULAR_SHARE)
    if rank < 24:
        raise CalibrationError("The poses do not determine the hand-eye transform.", "Add poses with larger rotations and translations.")
    return _with_translations(_rotation(solution[:9]), _rotation(solution[9:18]), base_from_flange, seen)


def _rotation(columns: FloatArray) -> FloatArray:
    """Return the rotation (3, 3) nearest to the stacked columns (9,) of a multiple, positive or negative, of one."""
    matrix = columns.reshape(3, 3).T
    determinant = float(np.linalg.det(matrix))
    if abs(determinant) < 1e-12:
        raise CalibrationError("The poses do not determine the rotation.", "Add poses turned about different axes.")
    result = np.eye(4)
    result[:3, :3] = matrix / np.cbrt(determinant)
    return orthonormalise(result)[:3, :3]


def _with_translations(rx: FloatArray, rz: FloatArray, robot: FloatArray, seen: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Solve R_A t_X - t_Z = R_Z t_B - t_A for given rotations by linear least squares."""
    rows = np.concatenate([robot[:, :3, :3], np.tile(-np.eye(3), (len(robot), 1, 1))], axis=2).reshape(-1, 6)
    right = (seen[:, :3, 3] @ rz.T - robot[:, :3, 3]).ravel()
    shift = np.linalg.lstsq(rows, right, rcond=None)[0]
    x, z = np.eye(4), np.eye(4)
    x[:3, :3], x[:3, 3] = rx, shift[:3]
    z[:3, :3], z[:3, 3] = rz, shift[3:]
    return x, z


ROBOT_WORLD_METHODS: Mapping[str, Callable[[FloatArray, FloatArray], tuple[FloatArray, FloatArray]]] = {
    "shah": shah,
    "li_wang_wu": li_wang_wu,
}
