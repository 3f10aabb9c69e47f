"""Axis limits, reach and singularities, checked for a whole plan before anything moves."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

import numpy as np

from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import LimitError, PlanError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.inverse import inverse
from measureapp.geometry.kinematics.singularity import singularity_near

LIMIT_MARGIN_RAD = float(np.deg2rad(2.0))  # what drivers keep from the limits of joints unless they are told otherwise
POSES_KEPT = 4096  # a plan is checked many times while it is edited


def limit_violations(viewpoint: Viewpoint, rig: RigDescription, arm: ArmModel | None = None) -> tuple[str, ...]:
    """Describe the axis limits and the reach that ``viewpoint`` violates; empty if it is reachable.

    Parameters
    ----------
    arm : of the rig's robot; also checks the limits of its joints and the distance from singularities. None: reach only
    """
    reasons = []
    low, high = rig.guide.limits_mm
    if not low <= viewpoint.guide_mm <= high:
        reasons.append(f"guide at {viewpoint.guide_mm:.1f} mm is outside {low:g}…{high:g} mm")
    low, high = rig.table.limits_deg
    if not low <= viewpoint.table_deg <= high:
        reasons.append(f"table at {viewpoint.table_deg:.1f}° is outside {low:g}…{high:g}°")
    reach = float(np.linalg.norm(np.subtract(viewpoint.flange.position_mm, rig.robot.shoulder_mm)))
    if not rig.robot.min_reach_mm <= reach <= rig.robot.max_reach_mm:
        reasons.append(f"flange {reach:.0f} mm from the shoulder is outside {rig.robot.min_reach_mm:g}…{rig.robot.max_reach_mm:g} mm")
    elif arm is not None and (problem := _joint_violation(viewpoint.flange, arm)):
        reasons.append(problem)
    return tuple(reasons)


def check_reach(viewpoints: Iterable[Viewpoint], rig: RigDescription, arm: ArmModel | None = None) -> None:
    """Refuse a plan that exceeds the rig's limits, see `limit_violations`.

    Raises
    ------
    PlanError
        Naming the viewpoints and axes.
    """
    problems = [f"{viewpoint.id}: {reason}" for viewpoint in viewpoints for reason in limit_violations(viewpoint, rig, arm)]
    if problems:
        shown = "; ".join(problems[:5]) + (f"; and {len(problems) - 5} more" if len(problems) > 5 else "")
        raise PlanError(f"The plan exceeds the limits of {rig.name}: {shown}.", "Change these viewpoints; nothing was moved.")


@lru_cache(maxsize=POSES_KEPT)
def _joint_violation(flange: FlangePose, arm: ArmModel) -> str:
    """Describe why no joint angles are suitable for this pose; empty if some are away from limits and singularities."""
    try:
        solutions = inverse(_with_margin(arm), flange.transform())
    except LimitError as error:
        return error.message.removesuffix(".")
    near = [singularity_near(solution) for solution in solutions]
    return "" if "" in near else f"{arm.name}: every configuration is near a singularity, such as {near[0]}"


@lru_cache(maxsize=8)
def _with_margin(arm: ArmModel) -> ArmModel:
    return arm.with_margin(LIMIT_MARGIN_RAD)
