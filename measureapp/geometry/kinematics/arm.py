"""Six revolute joints in a chain: their frames, limits and speeds, and the forward kinematics."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

import numpy as np
import numpy.typing as npt

from measureapp.arrays import FloatArray, read_only
from measureapp.errors import InputError
from measureapp.geometry.transform import RigidTransform

JOINTS = 6
Point = tuple[float, float, float]
MOST_EQUIVALENTS = 1000  # joint angles that differ by whole turns only; six joints of ±360° have 729
TURN_RAD = 2.0 * np.pi
ORTHONORMAL_TOLERANCE = 1e-9


@dataclass(frozen=True, slots=True)
class LinkBody:
    """A box or a capsule around a part of a link, in the base frame while all joints are at 0, whatever the frames of the model."""

    link: int  # 0: the base, which does not move; 6: the flange
    ends_mm: tuple[Point, Point]  # opposite corners of a box, lower one first; ends of the axis of a capsule
    radius_mm: float = 0.0  # 0: a box
    margin_mm: float = 10.0  # added all around: hoses, covers, tolerances


@dataclass(frozen=True, slots=True, eq=False)
class ArmModel:
    """A six-axis arm as a product of fixed transforms and rotations about axes.

    ``base_from_flange = T₁·R₁(q₁) · … · T₆·R₆(q₆) · last_from_flange``: a chain of a URDF as it is; `dh.arm_from_dh` brings Denavit-Hartenberg
    rows into this form. Link i is what joint i moves; its frame has its origin on the axis of joint i.

    Raises
    ------
    InputError
        Naming the joint whose numbers are impossible.
    """

    name: str
    parent_from_joint: FloatArray  # (6, 4, 4), frame of joint i at angle 0 in the frame of link i - 1 (first: the base); mm
    axes: FloatArray  # (6, 3), unit, in the frame of the joint; positive angles turn right-handed about them
    last_from_flange: FloatArray  # (4, 4), flange in the frame of link 6, z out of the flange; mm
    limits_rad: FloatArray  # (6, 2), lower and upper
    speeds_rad_s: FloatArray  # (6,), largest
    bodies: tuple[LinkBody, ...] = ()  # of the links; empty: their shape is unknown
    _motions: FloatArray = field(init=False, repr=False)  # (6, 4, 12), matrix of each joint: constant, sine and cosine terms side by side

    def __post_init__(self) -> None:
        shapes = {"parent_from_joint": (6, 4, 4), "axes": (6, 3), "last_from_flange": (4, 4), "limits_rad": (6, 2), "speeds_rad_s": (6,)}
        for name, shape in shapes.items():
            object.__setattr__(self, name, read_only(getattr(self, name), np.float64, shape))
        self._check()
        object.__setattr__(self, "_motions", read_only(_motions(self.parent_from_joint, self.axes)))

    def forward(self, joints_rad: npt.ArrayLike) -> RigidTransform:
        """Return ``base_from_flange`` for joint angles (6,)."""
        return RigidTransform(self.forward_matrices(joints_rad), "base", "flange")

    def forward_matrices(self, joints_rad: npt.ArrayLike) -> FloatArray:
        """Return the matrices of ``base_from_flange``, (..., 4, 4), for joint angles (..., 6)."""
        *_, last = self._links(joints_rad)
        return np.tensordot(last, self.last_from_flange, 1)

    def link_frames(self, joints_rad: npt.ArrayLike) -> FloatArray:
        """Return ``base_from_link`` of the six links, (..., 6, 4, 4), for joint angles (..., 6).

        How a link moved from zero, whatever the model's frames: ``link_frames(q)[i] @ inv(link_frames(zeros)[i])``.
        """
        return np.stack(tuple(self._links(joints_rad)), axis=-3)

    def with_margin(self, margin_rad: float) -> ArmModel:
        """Return the same arm with limits narrowed by ``margin_rad`` at both ends. Raises InputError where nothing is left of them."""
        return replace(self, limits_rad=self.limits_rad + np.array([margin_rad, -margin_rad]))

    def _links(self, joints_rad: npt.ArrayLike) -> Iterator[FloatArray]:
        """Yield ``base_from_link``, (..., 4, 4), link by link."""
        joints = np.asarray(joints_rad, float)
        sines, cosines = np.sin(joints)[..., None, None], np.cos(joints)[..., None, None]
        link = np.broadcast_to(np.eye(4), (*joints.shape[:-1], 4, 4))
        for joint in range(JOINTS):
            terms = np.tensordot(link, self._motions[joint], 1)  # one product of all poses, much faster than one of 4×4 matrices per pose
            link = terms[..., :4] + sines[..., joint, :, :] * terms[..., 4:8] + cosines[..., joint, :, :] * terms[..., 8:]
            yield link

    def _check(self) -> None:
        for number in range(JOINTS):
            if problem := self._problem(number):
                raise InputError(f"Joint {number + 1} of {self.name} has {problem}.", "Correct the numbers of this joint.")
        if not _is_rigid(self.last_from_flange):
            raise InputError(f"The flange of {self.name} has no rigid transform.", "Correct the numbers after joint 6.")
        equivalents = float(np.prod(np.floor(np.ptp(self.limits_rad, axis=1) / TURN_RAD) + 1.0))
        if equivalents > MOST_EQUIVALENTS:
            raise InputError(
                f"The joint limits of {self.name} allow {equivalents:.3g} equivalent positions, whole turns apart, for one pose.",
                f"Narrow the limits to the turns in use: at most {MOST_EQUIVALENTS} equivalent positions.",
            )

    def _problem(self, number: int) -> str:
        lower, upper = self.limits_rad[number]
        if not _is_rigid(self.parent_from_joint[number]):
            return "no rigid transform from the link before"
        if not abs(np.linalg.norm(self.axes[number]) - 1.0) < ORTHONORMAL_TOLERANCE:
            return "an axis that is not a unit vector"
        if not -np.inf < lower < upper < np.inf:
            return "no lower limit below its upper limit"
        return "" if 0.0 < self.speeds_rad_s[number] < np.inf else "no positive speed"


def homogeneous(rotation: npt.ArrayLike, translation_mm: npt.ArrayLike = (0.0, 0.0, 0.0)) -> FloatArray:
    """Return the 4×4 matrix of a rotation (3, 3) and a translation (3,)."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, translation_mm
    return matrix


def cross_matrix(axis: FloatArray) -> FloatArray:
    """Return the matrix (3, 3) that multiplies by ``axis`` as a cross product."""
    x, y, z = axis
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def _motions(parent_from_joint: FloatArray, axes: FloatArray) -> FloatArray:
    """Return the terms of ``T·R(q)`` by Rodrigues' formula, ``R = (1 + K²) + sin q·K - cos q·K²``, as (6, 4, 12)."""
    motions = np.zeros((JOINTS, 4, 12))
    for motion, frame, axis in zip(motions, parent_from_joint, axes, strict=True):
        cross = cross_matrix(axis)
        motion[:, :4] = frame @ homogeneous(np.eye(3) + cross @ cross)
        motion[:, 4:7], motion[:, 8:11] = frame[:, :3] @ cross, -frame[:, :3] @ cross @ cross
    return motions


def _is_rigid(matrix: FloatArray) -> bool:
    if not np.isfinite(matrix).all() or not np.array_equal(matrix[3], [0.0, 0.0, 0.0, 1.0]):
        return False
    rotation = matrix[:3, :3]
    return bool(np.allclose(rotation @ rotation.T, np.eye(3), rtol=0.0, atol=ORTHONORMAL_TOLERANCE) and np.linalg.det(rotation) > 0.0)
