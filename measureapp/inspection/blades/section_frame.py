"""Coordinate frame of a blade section: points of one blade, flattened into the section's plane."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.blade_section import BladeSection
from measureapp.geometry.transform import rotation_about
from measureapp.inspection.blades.profile import Shape
from measureapp.inspection.surface.cutting_surface import CuttingCylinder, CuttingPlane, CuttingSurface

TURN = 1e-5  # rad, step of the numerical derivative
BEYOND = 0.1  # of the chord: points count up to this far beyond the nominal edges


@dataclass(frozen=True, slots=True, eq=False)
class SectionFrame:
    """Cutting surface of the first blade, and the nominal chord in it."""

    described: BladeSection
    surface: CuttingSurface
    origin_mm: FloatArray  # (2,): the leading edge
    axes: FloatArray  # (2, 2): along the chord, and to its left
    shape: Shape

    @classmethod
    def of(cls, described: BladeSection) -> SectionFrame:
        """Return the frame of the first blade of a program's section."""
        axis_point, axis = np.asarray(described.axis_point_mm, float), np.asarray(described.axis, float)
        ends = np.array([described.leading_mm, described.trailing_mm], float)
        if described.radius_mm is not None:
            surface: CuttingSurface = CuttingCylinder.about(axis_point, axis, described.radius_mm, ends.mean(axis=0) - axis_point)
        else:
            surface = CuttingPlane.through(np.asarray(described.plane_point_mm, float), np.asarray(described.plane_normal, float), axis)
        flat = surface.flatten(ends)
        chord = flat[1] - flat[0]
        length = float(np.linalg.norm(chord))
        along = chord / length
        shape = Shape(length, "leading" in described.open_ends, "trailing" in described.open_ends)
        return cls(described, surface, flat[0], np.stack([along, [-along[1], along[0]]]), shape)

    def rotate_to_first(self, points_mm: FloatArray, number: int) -> FloatArray:
        """Rotate points (N, 3) about the axis so that blade ``number`` (from 0) coincides with the first."""
        return self.rotate(points_mm, -2 * np.pi * number / self.described.count)

    def rotate(self, points_mm: FloatArray, angle_rad: float) -> FloatArray:
        """Rotate points (N, 3) about the axis."""
        point = np.asarray(self.described.axis_point_mm, float)
        return np.asarray((points_mm - point) @ rotation_about(self.described.axis, angle_rad).T + point)

    def flatten(self, points_mm: FloatArray) -> FloatArray:
        """Return coordinates (N, 2) along the nominal chord from the leading edge, and to its left."""
        return np.asarray((self.surface.flatten(points_mm) - self.origin_mm) @ self.axes.T)

    def lift(self, flat_mm: FloatArray, number: int) -> FloatArray:
        """Return the points (N, 3) on blade ``number`` (from 0) that lie at these coordinates (N, 2) of the section."""
        return self.rotate(self.surface.lift(flat_mm @ self.axes + self.origin_mm), 2 * np.pi * number / self.described.count)

    def select_points(self, points_mm: FloatArray, number: int, most: int) -> IntArray:
        """Return the indices of the points (N, 3) of the section of blade ``number`` (from 0), at most ``most``, evenly chosen."""
        chosen = self.chosen(self.rotate_to_first(points_mm, number))
        return chosen if len(chosen) <= most else chosen[np.linspace(0, len(chosen) - 1, most).astype(int)]

    def chosen(self, points_mm: FloatArray) -> IntArray:
        """Return the indices of the points of the section of the first blade, among points rotated to it."""
        near = np.flatnonzero(np.abs(self.surface.offsets_mm(points_mm)) < self.described.width_mm / 2)
        flat = self.flatten(points_mm[near])
        length, described = self.shape.chord_mm, self.described
        low = 0.0 if self.shape.open_leading else -BEYOND * length
        high = length if self.shape.open_trailing else (1 + BEYOND) * length
        inside = (flat[:, 0] > low) & (flat[:, 0] < high) & (np.abs(flat[:, 1]) < described.beside_mm)
        middle = np.asarray(described.leading_mm, float) + np.asarray(described.trailing_mm, float)
        offset = points_mm[near] - np.asarray(described.axis_point_mm, float)
        inside &= offset @ (middle / 2 - np.asarray(described.axis_point_mm, float)) > 0 if described.count > 1 else True
        return near[inside]

    def effect_of_turn(self, points_mm: FloatArray) -> FloatArray:
        """Return the derivative (N, 2) of section coordinates with respect to a rotation about the axis, mm per rad."""
        return (self.flatten(self.rotate(points_mm, TURN)) - self.flatten(points_mm)) / TURN

    def stagger_rad(self, chord: FloatArray, start_mm: FloatArray) -> float:
        """Return the stagger: angle from the axis to the chord, or for a plane normal to the axis, from the ray through the leading end.

        ``chord`` and ``start_mm`` are in the section's coordinates; counter-clockwise is positive.
        """
        flat = chord @ self.axes
        if isinstance(self.surface, CuttingCylinder):
            reference = np.array([0.0, 1.0])
        else:
            axis = np.asarray(self.described.axis, float) / np.linalg.norm(self.described.axis)
            across = np.stack([self.surface.across, np.cross(self.surface.normal, self.surface.across)])
            reference = across @ axis
            if np.linalg.norm(reference) < 1e-6:
                centre = self.surface.flatten(np.asarray(self.described.axis_point_mm, float)[None])[0]
                reference = start_mm @ self.axes + self.origin_mm - centre
        cross = reference[0] * flat[1] - reference[1] * flat[0]
        return float(np.arctan2(cross, reference @ flat))
