"""Cutting planes and cylinders of sections, and their flattened coordinates."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.geometry.shapes import tangents


@dataclass(frozen=True, slots=True, eq=False)
class CuttingPlane:
    """A plane; flattened coordinates are along ``across`` and perpendicular to it."""

    point_mm: FloatArray  # (3,)
    normal: FloatArray  # (3,), unit
    across: FloatArray  # (3,), unit, in the plane

    @classmethod
    def through(cls, point_mm: FloatArray, normal: FloatArray, across: FloatArray | None = None) -> CuttingPlane:
        """Return the plane through a point; ``across`` is projected into it (any tangent if None or parallel to the normal)."""
        unit = np.asarray(normal, float) / np.linalg.norm(normal)
        flat = tangents(unit)[0] if across is None else across - (across @ unit) * unit
        if np.linalg.norm(flat) < 1e-9:
            flat = tangents(unit)[0]
        return cls(read_only(point_mm, np.float64, (3,)), read_only(unit), read_only(flat / np.linalg.norm(flat)))

    def offsets_mm(self, points_mm: FloatArray) -> FloatArray:
        """Return signed distances (N,) of points from the plane."""
        return np.asarray((points_mm - self.point_mm) @ self.normal)

    def normals(self, points_mm: FloatArray) -> FloatArray:
        """Return the plane's normal at each point (N, 3)."""
        return np.broadcast_to(self.normal, points_mm.shape)

    def flatten(self, points_mm: FloatArray) -> FloatArray:
        """Return coordinates (N, 2) in the plane, in mm."""
        offset = points_mm - self.point_mm
        return np.column_stack([offset @ self.across, offset @ np.cross(self.normal, self.across)])

    def lift(self, flat_mm: FloatArray) -> FloatArray:
        """Return the points (N, 3) of the plane that lie at these coordinates (N, 2)."""
        return np.asarray(self.point_mm + flat_mm @ np.stack([self.across, np.cross(self.normal, self.across)]))


@dataclass(frozen=True, slots=True, eq=False)
class CuttingCylinder:
    """A cylinder about an axis; its curves are unrolled: length around it from ``zero``, and along the axis."""

    point_mm: FloatArray  # (3,) on the axis
    axis: FloatArray  # (3,), unit
    radius_mm: float
    zero: FloatArray  # (3,), unit, perpendicular to the axis: origin of the unrolled length, opposite the seam

    @classmethod
    def about(cls, point_mm: FloatArray, axis: FloatArray, radius_mm: float, zero: FloatArray | None = None) -> CuttingCylinder:
        """Return the cylinder about an axis; ``zero`` points from the axis to the origin of the unrolled length."""
        unit = np.asarray(axis, float) / np.linalg.norm(axis)
        flat = tangents(unit)[0] if zero is None else zero - (zero @ unit) * unit
        if np.linalg.norm(flat) < 1e-9:
            flat = tangents(unit)[0]
        return cls(read_only(point_mm, np.float64, (3,)), read_only(unit), radius_mm, read_only(flat / np.linalg.norm(flat)))

    def offsets_mm(self, points_mm: FloatArray) -> FloatArray:
        """Return signed distances (N,) of points from the cylinder, positive outside."""
        return np.linalg.norm(self._radial(points_mm), axis=1) - self.radius_mm

    def normals(self, points_mm: FloatArray) -> FloatArray:
        """Return the cylinder's outward normal at each point (N, 3)."""
        radial = self._radial(points_mm)
        return radial / np.maximum(np.linalg.norm(radial, axis=1, keepdims=True), 1e-12)

    def flatten(self, points_mm: FloatArray) -> FloatArray:
        """Return unrolled coordinates (N, 2) in mm."""
        radial = self._radial(points_mm)
        angle = np.arctan2(radial @ np.cross(self.axis, self.zero), radial @ self.zero)
        return np.column_stack([self.radius_mm * angle, (points_mm - self.point_mm) @ self.axis])

    def lift(self, flat_mm: FloatArray) -> FloatArray:
        """Return the points (N, 3) of the cylinder that lie at these unrolled coordinates (N, 2)."""
        angle = flat_mm[:, :1] / self.radius_mm
        outwards = np.cos(angle) * self.zero + np.sin(angle) * np.cross(self.axis, self.zero)
        return np.asarray(self.point_mm + self.radius_mm * outwards + flat_mm[:, 1:] * self.axis)

    def _radial(self, points_mm: FloatArray) -> FloatArray:
        offset = points_mm - self.point_mm
        return np.asarray(offset - (offset @ self.axis)[:, None] * self.axis)


CuttingSurface = CuttingPlane | CuttingCylinder
