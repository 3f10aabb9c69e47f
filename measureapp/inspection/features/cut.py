"""Selection of the points of a feature around its nominal."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.cut import Cut
from measureapp.data.feature import Feature
from measureapp.data.free_form import FreeForm
from measureapp.data.inspection_program import MeasuredFeature
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


def nominal_features(described: MeasuredFeature) -> tuple[NominalFeature, ...]:
    """Return the nominal of a feature, or those of all copies of its pattern."""
    if described.repeat is None:
        return (_nominal(described, described.name, np.eye(3)),)
    angle = np.radians(described.repeat.angle_deg)
    return tuple(
        _nominal(described, f"{described.name}.{k + 1}", rotation_about([0, 0, 1], k * angle)) for k in range(described.repeat.count)
    )


def _nominal(described: MeasuredFeature, name: str, turn: FloatArray) -> NominalFeature:
    surface_point = described.shape == "surface_point"
    assert described.point_mm is not None  # the program requires a position unless the feature grows
    direction = None if described.direction is None else turn @ np.asarray(described.direction, float)
    feature = Feature(
        name,
        "point" if described.shape == "surface_point" else described.shape,
        turn @ np.asarray(described.point_mm, float),
        None if direction is None else direction / np.linalg.norm(direction),
        described.radius_mm,
        None if described.half_angle_deg is None else float(np.radians(described.half_angle_deg)),
    )
    return NominalFeature(feature, described.cut, described.hole, surface_point, described.patch_mm, turn)


def within_box(points_mm: FloatArray, cut: Cut | FreeForm, copy_from_first: FloatArray) -> BoolArray:
    """Return the mask (N,) of the points within the x, y and z limits, rotated to the first copy."""
    inside = np.ones(len(points_mm), bool)
    as_first = points_mm @ copy_from_first
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
    if edges is not None and nominal.cut.edge_mm > 0 and len(near):
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
    inside = within_box(points_mm, cut, nominal.copy_from_first)
    if nominal.feature.direction is not None and (cut.along_mm or cut.radial_mm):
        along, off, _ = along_and_off(points_mm, nominal.feature.point_mm, nominal.feature.direction)
        for values, extent in ((along, cut.along_mm), (off, cut.radial_mm)):
            if extent is not None:
                inside &= (values > extent[0]) & (values < extent[1])
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
