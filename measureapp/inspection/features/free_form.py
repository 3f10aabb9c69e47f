"""Free-form features: regions of the nominal mesh with their measured points; nothing is fitted, the alignment places them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.feature import Feature
from measureapp.data.free_form import FreeForm
from measureapp.data.inspection_program import copy_names
from measureapp.geometry.transform import rotation_about
from measureapp.inspection.features.cut import within_box
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.deviation import signed_distances
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.uncertainty import effective_views

BORDER_MM = 0.02  # tangential offset by which a point lies beyond the border of the mesh


@dataclass(frozen=True, slots=True, eq=False)
class FoundSurface(FoundFeature):
    """A region of the nominal mesh with its measured points."""

    nominal_surface: NominalSurface | None = None

    def distances_and_normals(self, points_mm: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return signed distances (N,) of points from the nominal surface, positive out of the material, and its normals (N, 3)."""
        assert self.nominal_surface is not None
        return signed_distances(points_mm, self.nominal_surface), self.nominal_surface.closest(points_mm).normals

    def closest_points(self) -> FloatArray:
        """Return the closest points (N, 3) of the nominal surface."""
        assert self.nominal_surface is not None
        return self.nominal_surface.closest(self.points_mm).points_mm


def find_free_forms(
    described: FreeForm, points: MeasuredPoints, surface: NominalSurface | None, edges: cKDTree | None, settings: InspectionSettings
) -> Mapping[str, FoundFeature]:
    """Find a region, or all copies of its pattern, on ``points`` (in the nominal's frame)."""
    names = copy_names(described.name, described.repeat)
    if surface is None:
        reason = "is a region of the nominal mesh, and the program has no `nominal`"
        return {name: FoundFeature(name, None, f"{name} {reason}") for name in names}
    step = 0.0 if described.repeat is None else float(np.radians(described.repeat.angle_deg))
    turns = [rotation_about([0, 0, 1], k * step) for k in range(len(names))]
    return {name: _find_one(name, described, turn, points, surface, edges, settings) for name, turn in zip(names, turns, strict=True)}


def _find_one(
    name: str,
    described: FreeForm,
    turn: FloatArray,
    points: MeasuredPoints,
    surface: NominalSurface,
    edges: cKDTree | None,
    settings: InspectionSettings,
) -> FoundFeature:
    near = points.where(np.flatnonzero(within_box(points.points_mm, described, turn)))
    near = near.where(_select_points(described, turn, near, surface, edges)) if len(near) else near
    if len(near) < settings.least_points:
        return FoundFeature(name, None, f"{name}: only {len(near)} points were measured there, {settings.least_points} are needed")
    used = near.thin(settings.fit_points)
    away = signed_distances(used.points_mm, surface)
    feature = Feature(
        name,
        "surface",
        used.points_mm.mean(axis=0),
        points=len(used),
        rms_mm=float(np.sqrt(np.mean(away**2))),
        form_error_mm=float(np.ptp(away)),
        boundary_mm=np.stack([used.points_mm.min(axis=0), used.points_mm.max(axis=0)]),
    )
    views = effective_views(used.view)
    return FoundSurface(
        name, feature, "", 1.0, views, used.points_mm, None, nominal_surface=surface, view=used.view, view_errors=used.errors
    )


def _select_points(
    described: FreeForm, turn: FloatArray, points: MeasuredPoints, surface: NominalSurface, edges: cKDTree | None
) -> BoolArray:
    """Return the mask (N,) of points near the nominal, with matching normals and facing direction, away from its edges."""
    closest = surface.closest(points.points_mm)
    offset = points.points_mm - closest.points_mm
    along = np.einsum("nd,nd->n", offset, closest.normals)
    aside = np.linalg.norm(offset - along[:, None] * closest.normals, axis=1)
    chosen = (np.abs(along) < described.band_mm) & (aside < np.abs(along) + BORDER_MM)
    if points.normals is not None:
        facing = np.einsum("nd,nd->n", closest.normals, np.asarray(points.normals, float))
        chosen &= facing > np.cos(np.radians(described.normals_within_deg))
    if described.facing is not None:
        wanted = turn @ np.asarray(described.facing, float)
        chosen &= closest.normals @ (wanted / np.linalg.norm(wanted)) > np.cos(np.radians(described.facing_within_deg))
    if edges is not None and described.edge_mm > 0:
        distance, _ = edges.query(points.points_mm, distance_upper_bound=described.edge_mm)
        chosen &= ~np.isfinite(distance)
    return np.asarray(chosen)
