"""Where the axes are, and the moves between two places: frames of all carriers along a move, and how far bodies travel on it."""

from __future__ import annotations

from dataclasses import dataclass, replace
from itertools import pairwise
from math import ceil, radians

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from measureapp.arrays import FloatArray
from measureapp.data.leg import Axis
from measureapp.data.plan import Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.geometry.kinematics.arm import JOINTS, ArmModel
from measureapp.planning.collision.bodies import BASE, FIXED, FLANGE, TABLE, Body, reach_mm

CARRIERS = 9  # FIXED last, so that it is also index -1
GUIDE, ROTARY, SHIFT, TURN = range(JOINTS, JOINTS + 4)  # after the joints
CHANGES = JOINTS + 4
SAME = 1e-9  # rad or mm


@dataclass(frozen=True, slots=True, eq=False)
class Placement:
    """Where the axes are."""

    base_from_flange: FloatArray  # (4, 4)
    joints_rad: FloatArray | None  # (6,); None: the robot has no kinematic model
    guide_mm: float
    table_rad: float

    def moved(self, axis: Axis, goal: Placement) -> Placement:
        """Return this placement after one axis has moved to ``goal``."""
        if axis == "table":
            return replace(self, table_rad=goal.table_rad)
        if axis == "guide":
            return replace(self, guide_mm=goal.guide_mm)
        return replace(self, base_from_flange=goal.base_from_flange, joints_rad=goal.joints_rad)

    def joints_from(self, default_rad: FloatArray) -> FloatArray:
        """Return the joint angles, or ``default_rad`` where they are not known."""
        return default_rad if self.joints_rad is None else self.joints_rad

    def is_at(self, other: Placement) -> bool:
        """Whether no axis has to move to another placement."""
        if self.joints_rad is None or other.joints_rad is None:
            same = np.allclose(self.base_from_flange, other.base_from_flange, rtol=0.0, atol=SAME)
        else:
            same = np.allclose(self.joints_rad, other.joints_rad, rtol=0.0, atol=SAME)
        return same and self.guide_mm == other.guide_mm and self.table_rad == other.table_rad

    @classmethod
    def at(cls, viewpoint: Viewpoint, joints_rad: FloatArray | None) -> Placement:
        """Return where a viewpoint is, with the joint angles chosen for it."""
        return cls(viewpoint.flange.transform().matrix, joints_rad, viewpoint.guide_mm, radians(viewpoint.table_deg))


class Mechanism:
    """Forward kinematics of the whole cell, and bounds of how far its bodies travel."""

    def __init__(self, rig: RigDescription, arm: ArmModel | None) -> None:
        self._arm = arm
        self._table = np.eye(4)
        self._table[:3, 3] = rig.table.centre_in_guide_mm
        if arm is not None:
            at_zero = arm.link_frames(np.zeros(JOINTS))
            self._link_from_zero = np.linalg.inv(at_zero)
            self._origins_mm = at_zero[:, :3, 3]

    def frames(self, start: Placement, end: Placement, shares: FloatArray) -> FloatArray:
        """Return guide_from_carrier, (N, 9, 4, 4), at ``shares`` (N,) of the way from one placement to another.

        Joints, guide and table move in proportion; without joints the flange goes straight and turns evenly.
        """
        frames = np.tile(np.eye(4), (len(shares), CARRIERS, 1, 1))
        if self._arm is not None and start.joints_rad is not None and end.joints_rad is not None:
            joints = start.joints_rad + shares[:, None] * (end.joints_rad - start.joints_rad)
            frames[:, 1 : FLANGE + 1] = self._arm.link_frames(joints) @ self._link_from_zero
        else:
            frames[:, FLANGE] = _straight(start.base_from_flange, end.base_from_flange, shares)
        frames[:, BASE : FLANGE + 1, 1, 3] += (start.guide_mm + shares * (end.guide_mm - start.guide_mm))[:, None]
        angles = start.table_rad + shares * (end.table_rad - start.table_rad)
        turned = np.tile(np.eye(4), (len(shares), 1, 1))
        turned[:, 0, 0] = turned[:, 1, 1] = np.cos(angles)
        turned[:, 1, 0] = np.sin(angles)
        turned[:, 0, 1] = -turned[:, 1, 0]
        frames[:, TABLE] = self._table @ turned
        return frames

    def changes(self, start: Placement, end: Placement) -> FloatArray:
        """Return by how much each axis changes, (10,): six joints, guide, table; without joints shift (mm) and turn (rad) of the flange."""
        changes = np.zeros(CHANGES)
        if self._arm is not None and start.joints_rad is not None and end.joints_rad is not None:
            changes[:JOINTS] = np.abs(end.joints_rad - start.joints_rad)
        else:
            way = Rotation.from_matrix(start.base_from_flange[:3, :3].T @ end.base_from_flange[:3, :3])
            changes[SHIFT] = np.linalg.norm(end.base_from_flange[:3, 3] - start.base_from_flange[:3, 3])
            changes[TURN] = way.magnitude()
        changes[GUIDE], changes[ROTARY] = abs(end.guide_mm - start.guide_mm), abs(end.table_rad - start.table_rad)
        return changes

    def travels(self, first: Body, second: Body) -> FloatArray:
        """Return how far a point of ``second`` travels at most, seen from ``first``, per unit of `changes`, (10,)."""
        factors = np.zeros(CHANGES)
        low, high, moving = first.carrier, second.carrier, second
        if high == TABLE:
            factors[ROTARY] = 0.0 if _is_round(second) else _radius_mm(second)
            low, high, moving = FIXED, first.carrier, first
        if low == FIXED and high != FIXED:
            factors[GUIDE] = 1.0
        if high > BASE and self._arm is not None:
            factors[max(low, BASE) : high] = self._reaches_mm(moving)[max(low, BASE) : high]
        elif high > BASE:
            factors[SHIFT], factors[TURN] = 1.0, reach_mm(moving, np.zeros(3))
        return factors

    def _reaches_mm(self, body: Body) -> FloatArray:
        """Return the largest distance of a body from the origin of each joint before it, whatever the angles, (carrier,)."""
        origins = self._origins_mm[: body.carrier]
        chain = [float(np.linalg.norm(other - one)) for one, other in pairwise(origins)]
        beyond = np.append(np.cumsum(chain[::-1])[::-1], 0.0)
        reaches: FloatArray = beyond + reach_mm(body, origins[-1])
        return reaches


def samples(travel_mm: float, step_mm: float) -> FloatArray:
    """Return shares of a way, 0 and 1 included, between which nothing travels more than ``step_mm``."""
    return np.linspace(0.0, 1.0, ceil(travel_mm / step_mm) + 1) if travel_mm > 0.0 else np.zeros(1)


def _is_round(body: Body) -> bool:
    """Whether turning the table does not move the body: an upright cylinder about its axis, or the table itself."""
    import fcl

    return isinstance(body.solid.geometry, fcl.Cylinder) and np.allclose(body.placed[:2, 3], 0.0)


def _radius_mm(body: Body) -> float:
    return float(np.linalg.norm(body.corners_mm[:, :2], axis=1).max()) + body.solid.margin_mm


def _straight(start: FloatArray, end: FloatArray, shares: FloatArray) -> FloatArray:
    poses = np.tile(np.eye(4), (len(shares), 1, 1))
    turns = Slerp([0.0, 1.0], Rotation.from_matrix(np.array([start[:3, :3], end[:3, :3]])))
    poses[:, :3, :3] = turns(shares).as_matrix()
    poses[:, :3, 3] = start[:3, 3] + shares[:, None] * (end[:3, 3] - start[:3, 3])
    return poses
