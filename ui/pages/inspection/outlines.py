"""Outlines of fitted features, for the 3-D view."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from measureapp.data.feature import Feature

STEPS = 73
CROSS_MM = 6.0
AXIS_MM = 30.0  # half length of an axis in a preview
DASH = 3  # steps of a dash, and of the gap behind it


def outline(feature: Feature) -> np.ndarray:
    """Return a polyline (K, 3) around a feature: the convex hull of its boundary in its plane, its circle or slot, or a line itself."""
    if feature.shape == "slot" and feature.normal is not None:
        return _slot(feature)
    if feature.shape == "line" and feature.boundary_mm is not None:
        half = float(np.abs(_axis(feature)) @ np.ptp(feature.boundary_mm, axis=0)) / 2  # of the box around its points
        return feature.point_mm + np.outer([-half, half], _axis(feature))
    if feature.radius_mm is not None:
        return _circle(feature.point_mm, _axis(feature), feature.radius_mm)
    if feature.boundary_mm is not None and len(feature.boundary_mm) >= 3:
        return _hull(feature.boundary_mm, feature.point_mm, _axis(feature))
    return _circle(feature.point_mm, _axis(feature), CROSS_MM)


def preview_lines(feature: Feature) -> list[np.ndarray]:
    """Return a constructed feature in dashes, as it is not there yet: its outline, and the axis of a line or cylinder."""
    whole = [outline(feature)]
    if feature.direction is not None and feature.shape in ("line", "cylinder", "cone"):
        whole.append(feature.point_mm + np.linspace(-AXIS_MM, AXIS_MM, STEPS)[:, None] * _axis(feature))
    dashes = [line[start : start + DASH + 1] for line in whole for start in range(0, len(line) - 1, 2 * DASH)]
    return [dash for dash in dashes if len(dash) > 1]


def _axis(feature: Feature) -> np.ndarray:
    return np.array([0.0, 0.0, 1.0]) if feature.direction is None else np.asarray(feature.direction)


def _across(axis: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    u = np.cross(axis, [1.0, 0.0, 0.0] if abs(axis[0]) < 0.9 else [0.0, 1.0, 0.0])
    u /= np.linalg.norm(u)
    return u, np.cross(axis, u)


def _circle(centre: np.ndarray, axis: np.ndarray, radius: float) -> np.ndarray:
    u, v = _across(axis)
    angle = np.linspace(0.0, 2 * np.pi, STEPS)[:, None]
    return centre + radius * (np.cos(angle) * u + np.sin(angle) * v)


def _slot(feature: Feature) -> np.ndarray:
    """Return the straight sides and round ends of a slot."""
    along, radius = _axis(feature), feature.radius_mm or 0.0
    across = np.cross(np.asarray(feature.normal), along)
    half = (feature.length_mm or 0.0) / 2 - radius
    angle = np.linspace(-np.pi / 2, np.pi / 2, STEPS // 2)[:, None]
    ends = [side * (half * along + radius * (np.cos(angle) * along + np.sin(angle) * across)) for side in (1.0, -1.0)]
    return feature.point_mm + np.vstack([*ends, ends[0][:1]])


def _hull(points: np.ndarray, centre: np.ndarray, axis: np.ndarray) -> np.ndarray:
    from scipy.spatial import ConvexHull, QhullError

    u, v = _across(axis)
    flat = np.column_stack([(points - centre) @ u, (points - centre) @ v])
    try:
        corners = ConvexHull(flat).vertices
    except QhullError:  # collinear points
        return np.asarray(points)
    closed = flat[np.append(corners, corners[0])]
    return centre + closed[:, :1] * u + closed[:, 1:] * v
