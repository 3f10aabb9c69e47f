"""Whether the axes are where they were sent, and stay there."""

from __future__ import annotations

from math import radians

import numpy as np

from measureapp.data.fringe import AxisReadback
from measureapp.data.plan import Viewpoint
from measureapp.data.rig import MotionRules
from measureapp.errors import MotionError
from measureapp.geometry.transform import RigidTransform


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
