"""Selection of the points of a feature around its nominal."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.cut import Cut, Vector
from measureapp.data.feature import Feature
from measureapp.data.feature_program import CONTOURS
from measureapp.data.free_form import FreeForm
from measureapp.data.inspection_program import MeasuredFeature
from measureapp.data.repeat import Repeat
from measureapp.geometry.transform import rotation_about
from measureapp.inspection.features.shapes import along_and_off, outward_normals, signed_distances
from measureapp.inspection.measured_points import MeasuredPoints


@dataclass(frozen=True, slots=True, eq=False)
class NominalFeature:
    """One feature of the program, or one copy of a pattern, in the nominal's frame."""

    feature: Feature
    cut: Cut
    hole: bool
    surface_point: bool
    patch_mm: float
    copy_from_first: FloatArray = field(default_factory=lambda: np.eye(3))  # rotation of the copy
    shift_mm: FloatArray = field(default_factory=lambda: np.zeros(3))  # of the copy, after its rotation
    slabs: tuple[tuple[FloatArray, float], ...] = ()  # directions (3,), and the greatest distance along each from its point


def nominal_features(described: MeasuredFeature) -> tuple[NominalFeature, ...]:
    """Return the nominal of a feature, or those of all copies of its pattern."""
    if described.repeat is None:
        return (_nominal(described, described.name, np.eye(3), np.zeros(3)),)
    pattern = described.repeat
    return tuple(_nominal(described, f"{described.name}.{k + 1}", *copy_motion(pattern, k)) for k in range(pattern.count))


def copy_motion(pattern: Repeat, k: int) -> tuple[FloatArray, FloatArray]:
    """Return rotation (3, 3) and displacement (3,) from the first copy of a pattern to copy ``k`` (from 0)."""
    if pattern.step_mm is not None:
        row, place = divmod(k, pattern.per_row or pattern.count)
        return np.eye(3), place * np.asarray(pattern.step_mm, float) + row * np.asarray(pattern.row_step_mm or (0, 0, 0), float)
    axis = np.asarray(pattern.axis, float)
    turn = rotation_about(axis / np.linalg.norm(axis), k * np.radians(pattern.angle_deg))
    point = np.asarray(pattern.axis_point_mm, float)
    return turn, point - turn @ point


def _nominal(described: MeasuredFeature, name: str, turn: FloatArray, shift_mm: FloatArray) -> NominalFeature:
    assert described.point_mm is not None  # the program requires a position unless the feature grows
    feature = _feature(described, name, turn, turn @ np.asarray(described.point_mm, float) + shift_mm)
    point = described.shape == "surface_point"
    slabs = _slabs(described, feature)
    return NominalFeature(feature, described.cut, described.hole, point, described.patch_mm, turn, shift_mm, slabs)


def _feature(described: MeasuredFeature, name: str, turn: FloatArray, point_mm: FloatArray) -> Feature:
    direction = _unit(turn, described.direction)
    angle = None if described.half_angle_deg is None else float(np.radians(described.half_angle_deg))
    if described.shape == "slot":
        along = _unit(turn, described.along)
        assert direction is not None and along is not None and described.width_mm is not None  # as the program requires
        along = along - (along @ direction) * direction
        along = along / np.linalg.norm(along)
        return Feature(name, "slot", point_mm, along, described.width_mm / 2, length_mm=described.length_mm, normal=direction)
    if described.shape in ("line", "edge"):
        return Feature(name, "line", point_mm, direction, normal=_unit(turn, described.normals[0]))
    return Feature(
        name, "point" if described.shape == "surface_point" else described.shape, point_mm, direction, described.radius_mm, angle
    )


def _unit(turn: FloatArray, vector: Vector | None) -> FloatArray | None:
    if vector is None:
        return None
    turned = turn @ np.asarray(vector, float)
    return np.asarray(turned / np.linalg.norm(turned))


def _slabs(described: MeasuredFeature, feature: Feature) -> tuple[tuple[FloatArray, float], ...]:
    """Return the limits of the slice or strip of a contour."""
    if described.shape not in CONTOURS or feature.direction is None:
        return ()
    if feature.shape == "line":
        assert feature.normal is not None and described.length_mm is not None  # as the program requires
        across = np.cross(feature.direction, feature.normal)
        return ((feature.direction, described.length_mm / 2), (across / np.linalg.norm(across), described.strip_mm / 2))
    return ((feature.direction if feature.normal is None else feature.normal, described.height_mm / 2),)


def within_box(points_mm: FloatArray, cut: Cut | FreeForm, copy_from_first: FloatArray, shift_mm: FloatArray | None = None) -> BoolArray:
    """Return the mask (N,) of the points within the x, y and z limits, moved to the first copy."""
    inside = np.ones(len(points_mm), bool)
    as_first = (points_mm if shift_mm is None else points_mm - shift_mm) @ copy_from_first
    for axis, extent in enumerate((cut.x_mm, cut.y_mm, cut.z_mm)):
        if extent is not None:
            inside &= (as_first[:, axis] > extent[0]) & (as_first[:, axis] < extent[1])
    return inside


def cut_points(points: MeasuredPoints, nominal: NominalFeature, edges: cKDTree | None) -> IntArray:
    """Return the indices of the points of ``nominal``; ``points`` are in the nominal's frame.

    They lie within the band about the nominal surface and the limits of the cut, at a distance from sharp edges, with matching normals.
    """
    near = np.flatnonzero(_within_band(points.points_mm, nominal))
    near = near[_within_extents(points.points_mm[near], nominal)]
    if points.normals is not None:
        near = near[_normals_agree(points.points_mm[near], np.asarray(points.normals)[near], nominal)]
    wanted = not nominal.slabs or "edge_mm" in nominal.cut.model_fields_set  # a slice of a wall may be near edges everywhere
    if edges is not None and wanted and nominal.cut.edge_mm > 0 and len(near):
        distance, _ = edges.query(points.points_mm[near], distance_upper_bound=nominal.cut.edge_mm)
        near = near[~np.isfinite(distance)]
    return near


def _within_band(points_mm: FloatArray, nominal: NominalFeature) -> BoolArray:
    if not nominal.surface_point:
        return np.abs(signed_distances(nominal.feature, points_mm)) < nominal.cut.band_mm
    direction = nominal.feature.direction
    assert direction is not None
    along = (points_mm - nominal.feature.point_mm) @ direction
    squared = np.sum((points_mm - nominal.feature.point_mm) ** 2, axis=1) - along**2
    return (np.abs(along) < nominal.cut.band_mm) & (squared < nominal.patch_mm**2)


def _within_extents(points_mm: FloatArray, nominal: NominalFeature) -> BoolArray:
    cut = nominal.cut
    inside = within_box(points_mm, cut, nominal.copy_from_first, nominal.shift_mm)
    if nominal.feature.direction is not None and (cut.along_mm or cut.radial_mm):
        along, off, _ = along_and_off(points_mm, nominal.feature.point_mm, nominal.feature.direction)
        for values, extent in ((along, cut.along_mm), (off, cut.radial_mm)):
            if extent is not None:
                inside &= (values > extent[0]) & (values < extent[1])
    for direction, most in nominal.slabs:
        inside &= np.abs((points_mm - nominal.feature.point_mm) @ direction) < most
    return inside


def _normals_agree(points_mm: FloatArray, normals: FloatArray, nominal: NominalFeature) -> BoolArray:
    sign = -1.0 if nominal.hole else 1.0
    facing = sign * np.einsum("nd,nd->n", outward_normals_of(nominal, points_mm), normals.astype(float))
    return facing > np.cos(np.radians(nominal.cut.normals_within_deg))


def outward_normals_of(nominal: NominalFeature, points_mm: FloatArray) -> FloatArray:
    """Return the normals of the nominal surface at each point; for a surface point, its direction."""
    direction = nominal.feature.direction
    if nominal.surface_point and direction is not None:
        return np.broadcast_to(direction, points_mm.shape)
    return outward_normals(nominal.feature, points_mm)
