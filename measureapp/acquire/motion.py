"""How the axes get to a viewpoint, and whether they are where they were sent and stay there."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import radians

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.fringe import AxisReadback
from measureapp.data.leg import Leg
from measureapp.data.plan import Viewpoint
from measureapp.data.rig import MotionRules
from measureapp.devices.rig import Rig
from measureapp.devices.robot import JointRobot
from measureapp.errors import MotionError
from measureapp.geometry.transform import RigidTransform
from measureapp.planning.collision.build import PartSolid
from measureapp.planning.collision.cell import Cell
from measureapp.planning.collision.cell_paths import CellPaths
from measureapp.project.geometry.robot_file import arm_of


def legs_to(viewpoint: Viewpoint, rig: Rig, readback: Callable[[], AxisReadback]) -> Sequence[Leg]:
    """Return the moves to ``viewpoint``: those of the rig's checked paths, else table, guide and robot; raises as `Paths.legs_to`."""
    if rig.paths is None:
        goal = AxisReadback(viewpoint.flange.transform(), viewpoint.guide_mm, radians(viewpoint.table_deg))
        return (Leg("table", goal), Leg("guide", goal), Leg("robot", goal))
    here = readback()
    return rig.paths.legs_to(viewpoint, here, joints_of(rig))


def joints_of(rig: Rig) -> FloatArray | None:
    """Read the joint angles (6,) back; None where the robot does not tell them."""
    return rig.robot.joints_rad() if isinstance(rig.robot, JointRobot) else None


def checked(rig: Rig, part: PartSolid | None) -> Rig:
    """Return the same rig with checked paths around ``part`` on its table. Raises PlanError where the part is larger than the table."""
    return replace(rig, paths=CellPaths(Cell.of(rig.description, arm_of(rig.description), part)))


def confirm_reached(viewpoint: Viewpoint, readback: AxisReadback, rules: MotionRules) -> None:
    """Raise MotionError unless every axis reads back its goal: nothing is measured at an unconfirmed pose."""
    goal = viewpoint.flange.transform()
    distance_mm, turn_rad = _difference(readback.base_from_flange, goal)
    if not (distance_mm <= rules.position_tolerance_mm and turn_rad <= radians(rules.angle_tolerance_deg)):
        raise MotionError(
            f"{viewpoint.id}: the robot stopped away from its goal, by {distance_mm:.3f} mm and {np.degrees(turn_rad):.3f}°.",
            "Check for a collision or a protective stop, then repeat the viewpoint.",
        )
    if not abs(readback.guide_mm - viewpoint.guide_mm) <= rules.position_tolerance_mm:
        raise MotionError(
            f"{viewpoint.id}: the guide stopped at {readback.guide_mm:.3f} mm.", "Check the guide, then repeat the viewpoint."
        )
    if not abs(readback.table_rad - radians(viewpoint.table_deg)) <= radians(rules.angle_tolerance_deg):
        raise MotionError(
            f"{viewpoint.id}: the table stopped at {np.degrees(readback.table_rad):.3f}°.", "Check the table, then repeat the viewpoint."
        )


def confirm_still(viewpoint_id: str, before: AxisReadback, after: AxisReadback, rules: MotionRules) -> None:
    """Raise MotionError when an axis moved while images were taken."""
    moved_mm, turned_rad = _difference(after.base_from_flange, before.base_from_flange)
    table_rad = abs(after.table_rad - before.table_rad)
    moved = {
        "robot": not (moved_mm <= rules.position_tolerance_mm and turned_rad <= radians(rules.angle_tolerance_deg)),
        "guide": not abs(after.guide_mm - before.guide_mm) <= rules.position_tolerance_mm,
        "table": not table_rad <= radians(rules.angle_tolerance_deg),
    }
    names = [name for name, has_moved in moved.items() if has_moved]
    if names:
        raise MotionError(
            f"{viewpoint_id}: the {' and the '.join(names)} moved while images were taken.",
            "Check the drives and the brakes, then repeat the viewpoint.",
        )


def _difference(one: RigidTransform, other: RigidTransform) -> tuple[float, float]:
    """Return the distance in mm and the angle in rad between two poses; NaN where a read-back is not a number."""
    if not (np.isfinite(one.matrix).all() and np.isfinite(other.matrix).all()):
        return np.nan, np.nan
    off = one.inverse() @ other
    return float(np.linalg.norm(off.translation_mm)), off.angle_rad
