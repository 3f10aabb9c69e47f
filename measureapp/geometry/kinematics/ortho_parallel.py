"""Geometry of arms with an ortho-parallel base and a spherical wrist, recognised from any `ArmModel`.

Axis 2 is perpendicular to axis 1 and parallel to axis 3; axes 4, 5 and 6 meet in one point, neighbours at right angles. Most industrial arms
are of this kind [1]_.

References
----------
.. [1] M. Brandstötter, A. Angerer, M. Hofbaur, Proc. Austrian Robotics Workshop, 7-11, 2014.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.geometry.kinematics.arm import JOINTS, ArmModel

LARGEST_SKEW = 2e-3  # rad; a calibrated model, or one with rounded angles, is within
LARGEST_OFFSET_MM = 1.0  # distance of a wrist axis from the wrist centre
SHORTEST_LINK_MM = 1.0
ROUNDING_MM = 1e-9  # deviation of an exact model


@dataclass(frozen=True, slots=True, eq=False)
class OrthoParallelArm:
    """Lengths and angles of such an arm, with all joints at 0.

    Upright axes: `across` is axis 2; `up` is axis 1, turned to the base's z; `forward` is where positive angles of joint 2 tilt an upright
    arm. Angles in the plane of the arm are counted from up to forward. Positions are relative to `origin_mm`, a point on axis 1.
    """

    upright: FloatArray  # (3, 3), rows forward, across, up in the base
    origin_mm: FloatArray  # (3,), in the base
    turn_sense: float  # 1 if axis 1 points up, else -1
    elbow_sense: float  # 1 if axis 3 points as axis 2 does, else -1
    lateral_mm: float  # wrist centre beside axis 1, along `across`
    shoulder_mm: FloatArray  # (2,), axis 2: forward and up
    upper_mm: float  # axis 2 to axis 3
    upper_rad: float
    fore_mm: float  # axis 3 to wrist centre
    fore_rad: float
    wrist_axes: FloatArray  # (3, 3), rows axes 4, 5, 6 in the base
    wrist_rad: float  # angle from axis 4 to axis 6 about axis 5
    base_from_flange: FloatArray  # (3, 3), rotation
    wrist_in_flange_mm: FloatArray  # (3,)
    slack_mm: float  # how far beyond this geometry's reach the model may still reach; 0 if it has exactly this geometry

    @property
    def reach_mm(self) -> tuple[float, float]:
        """Least and greatest distance of the wrist centre from axis 2, in the plane of the arm."""
        return abs(self.upper_mm - self.fore_mm), self.upper_mm + self.fore_mm


@lru_cache(maxsize=16)
def ortho_parallel(model: ArmModel) -> OrthoParallelArm | None:
    """Return the geometry of the ortho-parallel arm nearest to ``model``; None if the model is of another kind."""
    links, flange = model.link_frames(np.zeros(JOINTS)), model.forward_matrices(np.zeros(JOINTS))
    axes, points_mm = np.einsum("jab,jb->ja", links[:, :3, :3], model.axes), links[:, :3, 3]
    wrist_mm = _meeting_point(points_mm[3:], axes[3:])
    offsets_mm = np.linalg.norm(np.cross(wrist_mm - points_mm[3:], axes[3:]), axis=1)
    skew = _skew(axes)
    if skew > LARGEST_SKEW or offsets_mm.max() > LARGEST_OFFSET_MM:
        return None
    upright, turn_sense = _upright(axes)
    wrist, shoulder, elbow = (upright @ (point - points_mm[0]) for point in (wrist_mm, points_mm[1], points_mm[2]))
    upper_mm, upper_rad = _in_plane(elbow - shoulder)
    fore_mm, fore_rad = _in_plane(wrist - elbow)
    if min(upper_mm, fore_mm) < SHORTEST_LINK_MM:
        return None
    return OrthoParallelArm(
        upright=upright,
        origin_mm=points_mm[0],
        turn_sense=turn_sense,
        elbow_sense=float(np.sign(axes[1] @ axes[2])),
        lateral_mm=float(wrist[1]),
        shoulder_mm=shoulder[[0, 2]],
        upper_mm=upper_mm,
        upper_rad=upper_rad,
        fore_mm=fore_mm,
        fore_rad=fore_rad,
        wrist_axes=axes[3:],
        wrist_rad=float(np.arctan2(np.cross(axes[3], axes[5]) @ axes[4], axes[3] @ axes[5])),
        base_from_flange=flange[:3, :3],
        wrist_in_flange_mm=flange[:3, :3].T @ (wrist_mm - flange[:3, 3]),
        slack_mm=_slack_mm(skew * (upper_mm + fore_mm) + float(offsets_mm.max())),
    )


def _skew(axes: FloatArray) -> float:
    """Return the largest sine of the deviation from a right angle (axes 1 and 2, 4 and 5, 5 and 6) or from parallel (2 and 3)."""
    sines = [axes[0] @ axes[1], axes[3] @ axes[4], axes[4] @ axes[5], np.linalg.norm(np.cross(axes[1], axes[2]))]
    return float(np.abs(sines).max())


def _slack_mm(deviation_mm: float) -> float:
    return deviation_mm if deviation_mm > ROUNDING_MM else 0.0


def _upright(axes: FloatArray) -> tuple[FloatArray, float]:
    """Return rows forward, across, up (right-handed) and the sense of joint 1 about up."""
    sense = -1.0 if axes[0, 2] < 0.0 else 1.0
    across = axes[1]
    up = sense * axes[0] - (sense * axes[0] @ across) * across
    up /= np.linalg.norm(up)
    return np.array([np.cross(across, up), across, up]), sense


def _in_plane(vector_mm: FloatArray) -> tuple[float, float]:
    """Return length and angle, from up to forward, of a vector's part in the plane of the arm."""
    return float(np.hypot(vector_mm[0], vector_mm[2])), float(np.arctan2(vector_mm[0], vector_mm[2]))


def _meeting_point(points_mm: FloatArray, axes: FloatArray) -> FloatArray:
    """Return the point (3,) with the least sum of squared distances from lines."""
    across = np.eye(3) - axes[:, :, None] * axes[:, None, :]
    return np.linalg.lstsq(across.sum(axis=0), np.einsum("jab,jb->a", across, points_mm), rcond=None)[0]
