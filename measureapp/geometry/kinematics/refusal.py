"""Why an arm has no solution for a pose: reach or joint limits, by how much, and what to do."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import LimitError
from measureapp.geometry.kinematics.arm import ArmModel
from measureapp.geometry.kinematics.jacobian import LENGTH_MM
from measureapp.geometry.kinematics.ortho_parallel import OrthoParallelArm
from measureapp.geometry.kinematics.refine import Refined
from measureapp.geometry.kinematics.turns import excess_rad

OTHER_AXES = "or let the linear guide or the rotary table take over"


def beyond_reach(model: ArmModel, arm: OrthoParallelArm, base_from_flange: FloatArray) -> LimitError:
    """Return the error for a wrist centre (pose: (4, 4)) beyond what the links reach."""
    wrist_mm = base_from_flange[:3, 3] + base_from_flange[:3, :3] @ arm.wrist_in_flange_mm
    forward, across, up = arm.upright @ (wrist_mm - arm.origin_mm)
    distance = float(np.hypot(forward, across))
    if distance < abs(arm.lateral_mm):
        return LimitError(
            f"The wrist of {model.name} would be {distance:.1f} mm from axis 1; its lateral offset keeps it at least "
            f"{abs(arm.lateral_mm):.1f} mm away: {abs(arm.lateral_mm) - distance:.1f} mm too near.",
            f"Move the goal away from axis 1, {OTHER_AXES}.",
        )
    radius = np.sqrt(distance**2 - arm.lateral_mm**2) * np.array([1.0, -1.0])
    from_shoulder = np.hypot(radius - arm.shoulder_mm[0], up - arm.shoulder_mm[1])
    least, greatest = arm.reach_mm
    missing = np.maximum(from_shoulder - greatest, least - from_shoulder)
    best = int(missing.argmin())
    is_far = from_shoulder[best] > greatest
    return LimitError(
        f"The wrist of {model.name} would be {from_shoulder[best]:.1f} mm from axis 2; it reaches {least:.1f}…{greatest:.1f} mm: "
        f"{missing[best]:.1f} mm too {'far' if is_far else 'near'}.",
        f"Move the goal {'closer to' if is_far else 'away from'} the robot, {OTHER_AXES}.",
    )


def beyond_limits(model: ArmModel, joints_rad: FloatArray) -> LimitError:
    """Return the error for solutions (N, 6) that all violate joint limits."""
    excess = excess_rad(joints_rad, model.limits_rad)
    best = excess[excess.max(axis=1).argmin()]
    joint = int(best.argmax())
    count = "The only solution" if len(joints_rad) == 1 else f"All {len(joints_rad)} solutions"
    return LimitError(
        f"{count} of {model.name} for this pose {'violates' if len(joints_rad) == 1 else 'violate'} joint limits; the best exceeds that of "
        f"joint {joint + 1} by {np.rad2deg(best[joint]):.1f}°.",
        f"Rotate the head about its viewing direction, change the pose, {OTHER_AXES}.",
    )


def not_found(model: ArmModel, refined: Refined) -> LimitError:
    """Return the error for a pose to which no candidate converged."""
    best = refined.errors[np.linalg.norm(refined.errors, axis=1).argmin()]
    missing_mm, missing_deg = np.linalg.norm(best[:3]) * LENGTH_MM, np.rad2deg(np.linalg.norm(best[3:]))
    return LimitError(
        f"No joint angles of {model.name} were found for this pose; the nearest miss it by {missing_mm:.1f} mm and {missing_deg:.1f}°.",
        f"It is probably out of reach: move the goal closer to the robot, {OTHER_AXES}.",
    )
