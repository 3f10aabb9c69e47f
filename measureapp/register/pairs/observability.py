"""Observability: motions of a view that the common surface does not constrain, so that the kinematic position alone does."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray

FAR = 20.0  # in radii of the view: a rotation about an axis further away is a translation


def find_unconstrained_motions(information: FloatArray, centre_mm: FloatArray, radius_mm: float, weak_mm: float) -> tuple[str, ...]:
    """Describe the motions that the surface determines worse than ``weak_mm`` (standard deviation at the view's outer points).

    Parameters
    ----------
    information : (6, 6), inverse covariance of translation (mm) and rotation (rad) about ``centre_mm`` by the common surfaces alone
    radius_mm : rms distance of the view's points from its centre; scales rotations to lengths
    """
    length = np.array([1.0, 1.0, 1.0, 1 / radius_mm, 1 / radius_mm, 1 / radius_mm])
    values, vectors = np.linalg.eigh(information * np.outer(length, length))
    return tuple(
        _describe_motion(vector * length, centre_mm, radius_mm)
        for value, vector in zip(values, vectors.T, strict=True)
        if value < weak_mm**-2
    )


def _describe_motion(motion: FloatArray, centre_mm: FloatArray, radius_mm: float) -> str:
    """Describe a small motion (6,): a translation, or a rotation about an axis."""
    shift, turn = motion[:3], motion[3:]
    square = float(turn @ turn)
    arm = np.cross(turn, shift) / square if square > 0 else np.full(3, np.inf)
    if not np.linalg.norm(arm) < FAR * radius_mm:
        return f"translation along {_format_direction(shift)}"
    return f"rotation about {_format_direction(turn)} through {_format_point(centre_mm + arm)} mm"


def _format_direction(vector: FloatArray) -> str:
    unit = vector / max(float(np.linalg.norm(vector)), 1e-300)
    unit = unit * (1.0 if unit[np.argmax(np.abs(unit))] > 0 else -1.0)
    return "(" + ", ".join(f"{value + 0.0:.2f}" for value in np.round(unit, 2)) + ")"


def _format_point(point_mm: FloatArray) -> str:
    return "(" + ", ".join(f"{value + 0.0:.0f}" for value in np.round(point_mm)) + ")"
