"""Closed solutions of A X = X B for the hand-eye transform X = flange_from_camera."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np
from scipy.spatial import transform
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray
from measureapp.calibrate.motions.relative import Motions
from measureapp.calibrate.projection import cross_matrices
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import orthonormalise

TSAI_LEAST_COSINE = 0.1  # of half the angle of X: closer to half a turn, Tsai's rotation vector is taken from another frame


def tsai_lenz(motions: Motions) -> FloatArray:
    """Solve rotation from the modified Rodrigues vectors, then translation [1]_.

    References
    ----------
    .. [1] R. Y. Tsai, R. K. Lenz, IEEE Trans. Robotics and Automation 5(3), 345-358, 1989.
    """
    half = _half_turn_near(motions)
    rotation = half[:3, :3] @ _tsai_rotation(Motions(half.T @ motions.flange @ half, motions.camera))
    return _with_translation(rotation, motions)


def _tsai_rotation(motions: Motions) -> FloatArray:
    a, b = (2 * quaternion[:, 1:] for quaternion in motions.quaternions())
    vector = np.linalg.lstsq(cross_matrices(a + b).reshape(-1, 3), (b - a).ravel(), rcond=None)[0]
    return Rotation.from_quat([*vector, 1.0]).as_matrix()


def _half_turn_near(motions: Motions) -> FloatArray:
    """Return the half turn (4, 4) that X is close to, or the identity: at half a turn Tsai's vector of X is infinite.

    Across the axis of X the sum of the motions' vectors shrinks by the cosine of half its angle.
    """
    a, b = (quaternion[:, 1:] for quaternion in motions.quaternions())
    values, vectors = np.linalg.eigh((a + b).T @ (a + b))
    half = np.eye(4)
    if values[1] < TSAI_LEAST_COSINE**2 * np.linalg.eigvalsh(4 * a.T @ a)[1]:
        half[:3, :3] = Rotation.from_rotvec(np.pi * vectors[:, 2]).as_matrix()
    return half


def park_martin(motions: Motions) -> FloatArray:
    """Solve the rotation as the best turn between the logarithms of the motions, then translation [1]_.

    References
    ----------
    .. [1] F. C. Park, B. J. Martin, IEEE Trans. Robotics and Automation 10(5), 717-721, 1994.
    """
    alpha, beta = (Rotation.from_matrix(part[:, :3, :3]).as_rotvec() for part in (motions.flange, motions.camera))
    return _with_translation(Rotation.align_vectors(alpha, beta)[0].as_matrix(), motions)


def horaud_dornaika(motions: Motions) -> FloatArray:
    """Solve the rotation as the one that best turns the camera's unit axes into the flange's, then translation [1]_.

    The paper's smallest eigenvector, of quaternions, and the singular vectors of `align_vectors` minimise the same sum of squares.

    References
    ----------
    .. [1] R. Horaud, F. Dornaika, International Journal of Robotics Research 14(3), 195-210, 1995.
    """
    a, b = (part[:, 1:] / np.linalg.norm(part[:, 1:], axis=1, keepdims=True) for part in motions.quaternions())
    return _with_translation(Rotation.align_vectors(a, b)[0].as_matrix(), motions)


def daniilidis(motions: Motions) -> FloatArray:
    """Solve rotation and translation at once with dual quaternions [1]_.

    References
    ----------
    .. [1] K. Daniilidis, International Journal of Robotics Research 18(3), 286-298, 1999.
    """
    unit = _length_unit(motions)
    a, b = (_dual_quaternions(part, unit) for part in (motions.flange, motions.camera))
    less, more = a - b, cross_matrices((a + b)[:, [[1, 2, 3], [5, 6, 7]]])
    rows = np.zeros((len(a), 6, 8))
    rows[:, :3, 0] = rows[:, 3:, 4] = less[:, 1:4]
    rows[:, :3, 1:4] = rows[:, 3:, 5:] = more[:, 0]
    rows[:, 3:, 0] = less[:, 5:]
    rows[:, 3:, 1:4] = more[:, 1]
    _, _, vt = np.linalg.svd(rows.reshape(-1, 8), full_matrices=False)
    result = transform.RigidTransform.from_dual_quat(_unit_dual_quaternion(vt[6], vt[7]), scalar_first=True).as_matrix()
    result[:3, 3] *= unit
    return np.asarray(result)


def _dual_quaternions(poses: FloatArray, length_unit: float) -> FloatArray:
    """Return poses (K, 4, 4) as unit dual quaternions (K, 8), the scalar of each half first and that of the real half not negative."""
    scaled = np.array(poses)
    scaled[:, :3, 3] /= length_unit
    result = transform.RigidTransform.from_matrix(scaled).as_dual_quat(scalar_first=True)
    return np.where(result[:, :1] < 0, -result, result)


def _unit_dual_quaternion(first: FloatArray, second: FloatArray) -> FloatArray:
    """Combine two null vectors so that the real part has length 1 and the dual part is orthogonal to it."""
    u1, v1, u2, v2 = first[:4], first[4:], second[:4], second[4:]
    square, linear, constant = float(u1 @ v1), float(u1 @ v2 + u2 @ v1), float(u2 @ v2)
    if abs(square) < 1e-14 * max(abs(linear), abs(constant), 1e-30):
        weights = [(1.0, 0.0), (-constant, linear)]
    else:
        root = np.sqrt(max(linear**2 - 4 * square * constant, 0.0))
        weights = [((-linear + sign * root) / (2 * square), 1.0) for sign in (1, -1)]
    combined = [w1 * first + w2 * second for w1, w2 in weights]
    best = max(combined, key=lambda vector: float(np.linalg.norm(vector[:4])) / max(float(np.linalg.norm(vector)), 1e-300))
    return best / np.linalg.norm(best[:4])


def andreff(motions: Motions) -> FloatArray:
    """Solve rotation and translation as one linear system, then make the rotation orthonormal [1]_.

    References
    ----------
    .. [1] N. Andreff, R. Horaud, B. Espiau, Proc. 3-D Digital Imaging and Modeling, 430-435, 1999.
    """
    unit = _length_unit(motions)
    count = len(motions.flange)
    rows, right = np.zeros((count, 12, 12)), np.zeros((count, 12))
    for index, (a, b) in enumerate(zip(motions.flange, motions.camera, strict=True)):
        rows[index, :9, :9] = np.eye(9) - np.kron(a[:3, :3], b[:3, :3])
        rows[index, 9:, :9] = np.kron(np.eye(3), b[:3, 3] / unit)
        rows[index, 9:, 9:] = np.eye(3) - a[:3, :3]
        right[index, 9:] = a[:3, 3] / unit
    solution = np.linalg.lstsq(rows.reshape(-1, 12), right.ravel(), rcond=None)[0]
    matrix = np.eye(4)
    matrix[:3, :3] = solution[:9].reshape(3, 3)
    if np.linalg.det(matrix[:3, :3]) <= 0:
        raise CalibrationError("The motions do not determine the rotation.", "Add poses with larger rotations and translations.")
    return _with_translation(orthonormalise(matrix)[:3, :3], motions)


def _length_unit(motions: Motions) -> float:
    """Return a length that makes translations and rotations of the motions comparable."""
    return max(float(np.mean(np.linalg.norm(motions.camera[:, :3, 3], axis=1))), 1e-9)


def _with_translation(rotation: FloatArray, motions: Motions) -> FloatArray:
    """Solve (R_A - I) t = R t_B - t_A for a given rotation by linear least squares."""
    rows = (motions.flange[:, :3, :3] - np.eye(3)).reshape(-1, 3)
    right = (motions.camera[:, :3, 3] @ rotation.T - motions.flange[:, :3, 3]).ravel()
    result = np.eye(4)
    result[:3, :3] = rotation
    result[:3, 3] = np.linalg.lstsq(rows, right, rcond=None)[0]
    return result


METHODS: Mapping[str, Callable[[Motions], FloatArray]] = {
    "tsai_lenz": tsai_lenz,
    "park_martin": park_martin,
    "horaud": horaud_dornaika,
    "daniilidis": daniilidis,
    "andreff": andreff,
}
