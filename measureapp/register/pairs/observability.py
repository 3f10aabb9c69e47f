"""Which motions of a view the common surface does not hold, so that only the axes do."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray

FAR = 20.0  # in radii of the view: an axis further away than this means a shift


def unheld(information: FloatArray, centre_mm: FloatArray, radius_mm: float, weak_mm: float) -> tuple[str, ...]:
    """Name the motions that the surface leaves open by more than ``weak_mm`` (standard deviation at the view's outer points).

    Parameters
    ----------
    information : (6, 6), inverse covariance of shift (mm) and turn (rad) about ``centre_mm`` by the common surfaces alone
    radius_mm : how far the view's points lie from its centre; makes a turn comparable with a shift
    """
    length = np.array([1.0, 1.0, 1.0, 1 / radius_mm, 1 / radius_mm, 1 / radius_mm])
    values, vectors = np.linalg.eigh(information * np.outer(length, length))
    return tuple(
        _named(vector * length, centre_mm, radius_mm) for value, vector in zip(values, vectors.T, strict=True) if value < weak_mm**-2
    )


def _named(motion: FloatArray, centre_mm: FloatArray, radius_mm: float) -> str:
    """Say what a small motion (6,) is: a shift, or a turn about a line."""
    shift, turn = motion[:3], motion[3:]
    square = float(turn @ turn)
    arm = np.cross(turn, shift) / square if square > 0 else np.full(3, np.inf)
    if not np.linalg.norm(arm) < FAR * radius_mm:
        return f"a shift along {_direction(shift)}"
    return f"a turn about {_direction(turn)} through {_point(centre_mm + arm)} mm"


def _direction(vector: FloatArray) -> str:
    unit = vector / max(float(np.linalg.norm(vector)), 1e-300)
    unit = unit * (1.0 if unit[np.argmax(np.abs(unit))] > 0 else -1.0)
    return "(" + ", ".join(f"{value + 0.0:.2f}" for value in np.round(unit, 2)) + ")"


def _point(point_mm: FloatArray) -> str:
    return "(" + ", ".join(f"{value + 0.0:.0f}" for value in np.round(point_mm)) + ")"
