"""Time that the axes need from one viewpoint to the next: table, then guide, then robot, as the engine moves them."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from pydantic import Field

from measureapp.arrays import FloatArray
from measureapp.data.model import Model
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import LimitError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.inverse import inverse
from measureapp.geometry.kinematics.singularity import singularity_near


class AxisSpeeds(Model):
    """Speeds and accelerations of the axes, and the time that each takes to settle."""

    table_deg_s: float = Field(default=30.0, gt=0)
    table_deg_s2: float = Field(default=60.0, gt=0)
    guide_mm_s: float = Field(default=200.0, gt=0)
    guide_mm_s2: float = Field(default=500.0, gt=0)
    robot_share: float = Field(default=0.25, gt=0, le=1, description="of the largest joint speeds")
    robot_mm_s: float = Field(default=250.0, gt=0, description="of the flange, for arms without a kinematic model")
    robot_deg_s: float = Field(default=45.0, gt=0, description="of the flange, for arms without a kinematic model")
    robot_ramp_s: float = Field(default=0.4, ge=0, description="to accelerate and brake")
    settle_s: float = Field(default=0.3, ge=0, description="of each axis that has moved")


def travel_times_s(viewpoints: Sequence[Viewpoint], rig: RigDescription, arm: ArmModel | None, speeds: AxisSpeeds) -> FloatArray:
    """Return the times (V, V) from the viewpoint of the row to that of the column.

    The robot takes the shortest way between any of its configurations, all joints moving at once.
    """
    table = np.array([one.table_deg for one in viewpoints])
    guide = np.array([one.guide_mm for one in viewpoints])
    times = _ramp_s(table, speeds.table_deg_s, speeds.table_deg_s2, speeds.settle_s)
    times += _ramp_s(guide, speeds.guide_mm_s, speeds.guide_mm_s2, speeds.settle_s)
    flanges = list(dict.fromkeys(one.flange for one in viewpoints))
    place = np.array([flanges.index(one.flange) for one in viewpoints], int)
    times += _robot_s(flanges, arm, speeds)[np.ix_(place, place)]
    wait = rig.motion.settle_s * (times > 0.0)
    return np.asarray(times + wait)


def _ramp_s(places: FloatArray, speed: float, acceleration: float, settle_s: float) -> FloatArray:
    """Return the times of one axis with trapezoidal, or for short ways triangular, profiles of speed."""
    way = np.abs(places[:, None] - places)
    short = way < speed**2 / acceleration
    moving = np.where(short, 2.0 * np.sqrt(way / acceleration), way / speed + speed / acceleration)
    return np.where(way > 0.0, moving + settle_s, 0.0)


def _robot_s(flanges: Sequence[FlangePose], arm: ArmModel | None, speeds: AxisSpeeds) -> FloatArray:
    count = len(flanges)
    times = np.zeros((count, count))
    joints = [_joints(flange, arm) for flange in flanges]
    for start in range(count):
        for end in range(start + 1, count):
            ways = _between(flanges[start], flanges[end], speeds)
            first, last = joints[start], joints[end]
            if arm is not None and first is not None and last is not None:
                differences = np.abs(first[:, None] - last[None]) / (speeds.robot_share * arm.speeds_rad_s)
                ways = float(differences.max(axis=2).min())
            times[start, end] = times[end, start] = ways + speeds.robot_ramp_s + speeds.settle_s
    return times


def _joints(flange: FlangePose, arm: ArmModel | None) -> FloatArray | None:
    """Return the joint angles (n, 6) that reach a pose away from singularities; None if none do, or without an arm."""
    if arm is None:
        return None
    try:
        solutions = [one for one in inverse(arm, flange.transform()) if not singularity_near(one)]
    except LimitError:
        return None
    return np.array([one.joints_rad for one in solutions]) if solutions else None


def _between(start: FlangePose, end: FlangePose, speeds: AxisSpeeds) -> float:
    way = start.transform().inverse() @ end.transform()
    return max(float(np.linalg.norm(way.translation_mm)) / speeds.robot_mm_s, float(np.degrees(way.angle_rad)) / speeds.robot_deg_s)
