"""Axis limits and reach, checked for a whole plan before anything moves."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from measureapp.data.plan import Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.errors import PlanError


def limit_violations(viewpoint: Viewpoint, rig: RigDescription) -> tuple[str, ...]:
    """Describe the axis limits and the reach that ``viewpoint`` violates; empty if it is reachable."""
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
    return tuple(reasons)


def check_reach(viewpoints: Iterable[Viewpoint], rig: RigDescription) -> None:
    """Refuse a plan that exceeds the rig's limits.

    Raises
    ------
    PlanError
        Naming the viewpoints and axes.
    """
    problems = [f"{viewpoint.id}: {reason}" for viewpoint in viewpoints for reason in limit_violations(viewpoint, rig)]
    if problems:
        shown = "; ".join(problems[:5]) + (f"; and {len(problems) - 5} more" if len(problems) > 5 else "")
        raise PlanError(f"The plan exceeds the limits of {rig.name}: {shown}.", "Change these viewpoints; nothing was moved.")
