"""Time that the axes need from one viewpoint to the next: table, then guide, then robot, as the engine moves them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import LimitError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.inverse import inverse
from measureapp.geometry.kinematics.singularity import singularity_near


@dataclass(frozen=True, slots=True)
class AxisSpeeds:
    """Speeds and accelerations of the axes, and the time that each takes to settle. Defaults are usual ones."""

    table_deg_s: float = 30.0
    table_deg_s2: float = 60.0
    guide_mm_s: float = 200.0
    guide_mm_s2: float = 500.0
    robot_share: float = 0.25  # of the largest joint speeds
    joints_deg_s: tuple[float, ...] | None = None  # largest ones; None: those of the kinematic model
    robot_mm_s: float = 250.0  # of the flange, for arms without a kinematic model
    robot_deg_s: float = 45.0
    flange_limits: bool = False  # whether these limit arms with a kinematic model as well
    robot_ramp_s: float = 0.4  # to accelerate and brake
    settle_s: float = 0.3  # of each axis that has moved

    @classmethod
    def of(cls, rig: RigDescription) -> AxisSpeeds:
        """Return the speeds that a rig states, and usual ones for the others."""
        stated = {
            "table_deg_s": rig.table.speed_deg_s,
            "table_deg_s2": rig.table.acceleration_deg_s2,
            "guide_mm_s": rig.guide.speed_mm_s,
            "guide_mm_s2": rig.guide.acceleration_mm_s2,
            "robot_share": rig.robot.speed_share,
            "joints_deg_s": rig.robot.joint_speeds_deg_s,
            "robot_mm_s": rig.robot.speed_mm_s,
            "robot_deg_s": rig.robot.speed_deg_s,
            "robot_ramp_s": rig.robot.ramp_s,
        }
        known: dict[str, Any] = {name: value for name, value in stated.items() if value is not None}
        return cls(**known, flange_limits="robot_mm_s" in known or "robot_deg_s" in known)


def assumed_speeds(rig: RigDescription, arm: ArmModel | None) -> tuple[str, ...]:
    """Return the axes whose speeds the description does not state, in words: predicted times assume usual ones."""
    robot, guide, table = rig.robot, rig.guide, rig.table
    by_joints = arm is not None and robot.speed_share is not None
    missing = {
        "robot": not by_joints and robot.speed_mm_s is None,
        "guide": guide.speed_mm_s is None,
        "table": table.speed_deg_s is None,
    }
    return tuple(name for name, absent in missing.items() if absent)


def speeds_note(rig: RigDescription, arm: ArmModel | None) -> str:
    """Return a sentence that names the axes whose speeds are assumed; empty if all are stated."""
    missing = assumed_speeds(rig, arm)
    if not missing:
        return ""
    names = missing[0] if len(missing) == 1 else f"{', '.join(missing[:-1])} and {missing[-1]}"
    return f"The rig description states no speed of {names}: the time assumes usual ones."


def travel_times_s(
    viewpoints: Sequence[Viewpoint], rig: RigDescription, arm: ArmModel | None, speeds: AxisSpeeds | None = None
) -> FloatArray:
    """Return the times (V, V) from the viewpoint of the row to that of the column, without the wait there before images are taken.

    The robot takes the shortest way between any of its configurations, all joints moving at once.

    Parameters
    ----------
    speeds : default: those that the rig states, `AxisSpeeds.of`
    """
    speeds = speeds or AxisSpeeds.of(rig)
    table = np.array([one.table_deg for one in viewpoints])
    guide = np.array([one.guide_mm for one in viewpoints])
    times = _ramp_s(table, speeds.table_deg_s, speeds.table_deg_s2, speeds.settle_s)
    times += _ramp_s(guide, speeds.guide_mm_s, speeds.guide_mm_s2, speeds.settle_s)
    flanges = list(dict.fromkeys(one.flange for one in viewpoints))
    place = np.array([flanges.index(one.flange) for one in viewpoints], int)
    times += _robot_s(flanges, arm, speeds)[np.ix_(place, place)]
    return times


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
    fastest = None if arm is None else arm.speeds_rad_s if speeds.joints_deg_s is None else np.radians(speeds.joints_deg_s)
    for start in range(count):
        for end in range(start + 1, count):
            ways = _between(flanges[start], flanges[end], speeds)
            first, last = joints[start], joints[end]
            if fastest is not None and first is not None and last is not None:
                differences = np.abs(first[:, None] - last[None]) / (speeds.robot_share * fastest)
                by_joints = float(differences.max(axis=2).min())
                ways = max(ways, by_joints) if speeds.flange_limits else by_joints
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
