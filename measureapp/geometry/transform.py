"""Rigid transforms between named frames."""

from __future__ import annotations

from dataclasses import dataclass
from math import cos, sin

import numpy as np
import numpy.typing as npt
from scipy.spatial.transform import Rotation

from measureapp.arrays import FloatArray, read_only
from measureapp.errors import FrameMismatch

IDENTITY = np.eye(3)
ORTHONORMAL_TOLERANCE = 1e-6 + 1e-5 * IDENTITY  # of the rotation times its transpose


@dataclass(frozen=True, slots=True, eq=False)
class RigidTransform:
    """Rigid transform of coordinates from ``from_frame`` to ``to_frame``; variables are named ``to_from``.

    ``a_from_c = a_from_b @ b_from_c``; a product with mismatched inner frames is refused.
    """

    matrix: FloatArray  # (4, 4), read-only; millimetres
    to_frame: str
    from_frame: str

    def __post_init__(self) -> None:
        matrix = read_only(self.matrix, np.float64, (4, 4))
        rotation = matrix[:3, :3]
        off = np.abs(rotation @ rotation.T - IDENTITY)
        if not (off <= ORTHONORMAL_TOLERANCE).all() or _determinant(rotation) < 0:
            raise FrameMismatch(f"{self.to_frame}_from_{self.from_frame} is not a rigid transform.", "Its 3×3 part must be a rotation.")
        object.__setattr__(self, "matrix", matrix)

    @classmethod
    def identity(cls, to_frame: str, from_frame: str) -> RigidTransform:
        """Return the identity between two coincident frames."""
        return cls(np.eye(4), to_frame, from_frame)

    @classmethod
    def from_parts(cls, rotation: npt.ArrayLike, translation_mm: npt.ArrayLike, to_frame: str, from_frame: str) -> RigidTransform:
        """Build from a 3×3 rotation and a translation (3,)."""
        matrix = np.eye(4)
        matrix[:3, :3] = rotation
        matrix[:3, 3] = translation_mm
        return cls(matrix, to_frame, from_frame)

    @classmethod
    def from_vector(cls, rotation_vector: npt.ArrayLike, translation_mm: npt.ArrayLike, to_frame: str, from_frame: str) -> RigidTransform:
        """Build from a rotation vector (3,) in radians and a translation (3,)."""
        return cls.from_parts(Rotation.from_rotvec(np.asarray(rotation_vector, float)).as_matrix(), translation_mm, to_frame, from_frame)

    @classmethod
    def from_quaternion(
        cls, quaternion_wxyz: npt.ArrayLike, translation_mm: npt.ArrayLike, to_frame: str, from_frame: str
    ) -> RigidTransform:
        """Build from a unit quaternion (w, x, y, z) and a translation (3,)."""
        w, x, y, z = np.asarray(quaternion_wxyz, float)
        return cls.from_parts(Rotation.from_quat([x, y, z, w]).as_matrix(), translation_mm, to_frame, from_frame)

    @property
    def rotation(self) -> FloatArray:
        """The 3×3 rotation."""
        return self.matrix[:3, :3]

    @property
    def translation_mm(self) -> FloatArray:
        """The translation, (3,)."""
        return self.matrix[:3, 3]

    @property
    def rotation_vector(self) -> FloatArray:
        """The rotation as a vector (3,) in radians."""
        return Rotation.from_matrix(self.rotation).as_rotvec()

    @property
    def quaternion_wxyz(self) -> FloatArray:
        """The rotation as a unit quaternion (w, x, y, z) with w >= 0."""
        x, y, z, w = Rotation.from_matrix(self.rotation).as_quat(canonical=True)
        return np.array([w, x, y, z])

    @property
    def angle_rad(self) -> float:
        """The angle of the rotation, 0…π."""
        return float(np.linalg.norm(self.rotation_vector))

    def __matmul__(self, other: RigidTransform) -> RigidTransform:
        """Compose: first ``other``, then this. Raises FrameMismatch when the inner frames differ."""
        if self.from_frame != other.to_frame:
            raise FrameMismatch(
                f"{self.to_frame}_from_{self.from_frame} cannot be multiplied by {other.to_frame}_from_{other.from_frame}.",
                "The inner frames of a product must be the same.",
            )
        product = self.matrix @ other.matrix
        return RigidTransform(orthonormalise(product), self.to_frame, other.from_frame)

    def inverse(self) -> RigidTransform:
        """Return the inverse transform."""
        inverse = np.eye(4)
        inverse[:3, :3] = self.rotation.T
        inverse[:3, 3] = -self.rotation.T @ self.translation_mm
        return RigidTransform(inverse, self.from_frame, self.to_frame)

    def apply(self, points_mm: FloatArray) -> FloatArray:
        """Transform points (..., 3)."""
        return points_mm @ self.rotation.T.astype(points_mm.dtype) + self.translation_mm.astype(points_mm.dtype)

    def rotate(self, vectors: FloatArray) -> FloatArray:
        """Rotate vectors (..., 3), without translation."""
        return vectors @ self.rotation.T.astype(vectors.dtype)


def orthonormalise(matrix: FloatArray) -> FloatArray:
    """Replace the 3×3 part of a 4×4 ``matrix`` by the nearest rotation (SVD)."""
    u, _, vt = np.linalg.svd(matrix[:3, :3])
    nearest = u @ vt
    if _determinant(nearest) < 0:
        u[:, 2] *= -1.0
        nearest = u @ vt
    result = np.array(matrix, float)
    result[:3, :3] = nearest
    return result


def _determinant(matrix: FloatArray) -> float:
    """Return the determinant (3, 3) written out: LAPACK takes twenty times as long to be called."""
    (a, b, c), (d, e, f), (g, h, i) = matrix.tolist()
    return float(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g))


def rotation_about(direction: npt.ArrayLike, angle_rad: float) -> FloatArray:
    """Return the 3×3 right-handed rotation by ``angle_rad`` about ``direction`` (Rodrigues)."""
    along = np.asarray(direction, float)
    x, y, z = (along / np.linalg.norm(along)).tolist()
    s, c = sin(angle_rad), cos(angle_rad)
    v = 1.0 - c
    return np.array(
        [
            [c + x * x * v, x * y * v - z * s, x * z * v + y * s],
            [x * y * v + z * s, c + y * y * v, y * z * v - x * s],
            [x * z * v - y * s, y * z * v + x * s, c + z * z * v],
        ]
    )
