"""Singularities of an arm near joint angles, where it cannot move in every direction and joints turn fast."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.geometry.kinematics.inverse import JointSolution


@dataclass(frozen=True, slots=True)
class SingularityMargins:
    """Least distances to keep from singularities."""

    shoulder_mm: float  # wrist centre from the place where joint 1 is undetermined
    elbow_rad: float  # forearm from the straight and from the folded arm
    wrist_rad: float  # axis 6 from axis 4
    condition: float  # of the Jacobian, smallest over largest singular value; for arms without a spherical wrist


GOAL_MARGINS = SingularityMargins(40.0, float(np.deg2rad(5.0)), float(np.deg2rad(5.0)), 0.02)
"""For goals that are approached and left at usual speeds."""


def singularity_near(solution: JointSolution, margins: SingularityMargins = GOAL_MARGINS) -> str:
    """Describe the singularity that ``solution`` comes nearer to than ``margins``; empty if there is none."""
    posture = solution.posture
    if posture is None:
        return f"a singularity (condition {solution.condition:.3f})" if solution.condition < margins.condition else ""
    if posture.shoulder_margin_mm < margins.shoulder_mm:
        return f"the wrist {posture.shoulder_margin_mm:.1f} mm from axis 1, where joint 1 is not determined"
    if posture.elbow_margin_rad < margins.elbow_rad:
        straight = "straight" if abs(posture.elbow_rad) < np.pi / 2.0 else "folded"
        return f"the elbow {np.rad2deg(posture.elbow_margin_rad):.2f}° from the {straight} arm, a singularity"
    if posture.wrist_margin_rad < margins.wrist_rad:
        return f"joint 5 at {np.rad2deg(solution.joints_rad[4]):.2f}°, a singularity of the wrist (axes 4 and 6 in line)"
    return ""
