"""Signed distances from fitted shapes, and their normals."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.errors import InspectionError
from measureapp.geometry.contours import contour_distances, is_contour


def along_and_off(points_mm: FloatArray, point_mm: FloatArray, direction: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Cylindrical coordinates of points (N, 3) about a line: position along it (N,), distance (N,), unit radial direction (N, 3)."""
    offset = points_mm - point_mm
    along = offset @ direction
    away = offset - along[:, None] * direction
    off = np.linalg.norm(away, axis=1)
    return along, off, away / np.maximum(off, 1e-12)[:, None]


def signed_distances(feature: Feature, points_mm: FloatArray) -> FloatArray:
    """Return the orthogonal distances (N,) of points from a plane, sphere, cylinder, cone or contour, positive outside."""
    centre, direction = feature.point_mm, feature.direction
    if is_contour(feature):
        return contour_distances(feature, points_mm)[0]
    if feature.shape == "sphere" and feature.radius_mm is not None:
        return np.linalg.norm(points_mm - centre, axis=1) - feature.radius_mm
    if direction is None:
        raise InspectionError(f"Feature {feature.name!r} has no direction.", "Measure it as a plane, cylinder or cone.")
    offset = points_mm - centre
    along = offset @ direction
    if feature.shape == "plane":
        return along
    off = np.linalg.norm(offset - along[:, None] * direction, axis=1)
    if feature.shape == "cylinder" and feature.radius_mm is not None:
        return off - feature.radius_mm
    if feature.shape == "cone" and feature.radius_mm is not None and feature.half_angle_rad is not None:
        # the direction points to the apex: the radius shrinks along it
        return (off - feature.radius_mm) * np.cos(feature.half_angle_rad) + along * np.sin(feature.half_angle_rad)
    raise InspectionError(f"There are no distances from a {feature.shape}.", "Use a plane, sphere, cylinder or cone.")


def outward_normals(feature: Feature, points_mm: FloatArray) -> FloatArray:
    """Return the unit normals (N, 3) of the shape at each point, away from its axis or centre."""
    centre, direction = feature.point_mm, feature.direction
    if is_contour(feature):
        return contour_distances(feature, points_mm)[1]
    if feature.shape == "sphere" or direction is None:
        offset = points_mm - centre
        return offset / np.maximum(np.linalg.norm(offset, axis=1), 1e-12)[:, None]
    _, _, away = along_and_off(points_mm, centre, direction)
    if feature.shape == "cylinder":
        return away
    if feature.shape == "cone" and feature.half_angle_rad is not None:
        return away * np.cos(feature.half_angle_rad) + direction * np.sin(feature.half_angle_rad)
    return np.broadcast_to(direction, points_mm.shape)
