"""The feature that a click means: the face of the nominal around it, or the region of the cloud that grows from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.cut import Grow
from measureapp.data.feature import Feature
from measureapp.errors import FitError, InspectionError
from measureapp.geometry.feature import Shape
from measureapp.inspection.features.regions.grow import grow_region
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.programming.clicking.faces import fit_face, flat_face, listed, rounded, smooth_face
from measureapp.inspection.surface.nominal import NominalSurface

GROWN_SHAPES: tuple[Shape, ...] = ("plane", "cylinder", "sphere", "cone")
ROUND_SHAPES: tuple[Shape, ...] = ("cylinder", "cone", "sphere")
MARGIN_MM = 1.0  # of the limits of a plane beyond its face


@dataclass(frozen=True, slots=True, eq=False)
class Picked:
    """A face of the nominal."""

    entry: dict[str, Any]  # of the program, ready for `edits.add`
    triangles: IntArray  # of the surface, to be highlighted


def pick_on_nominal(surface: NominalSurface, place_mm: FloatArray, name: str) -> Picked:
    """Return the plane, cylinder, cone or sphere of the face at a place on the nominal; elsewhere a surface point.

    Facets belong to a plane if they are connected and parallel, to a curved face if each is nearly parallel to the next.
    """
    closest = surface.closest(np.asarray(place_mm, float)[None])
    seed, place = int(closest.triangles[0]), closest.points_mm[0]
    flat, curved = flat_face(surface, seed), smooth_face(surface, seed)
    if len(curved) > len(flat):
        for shape in ROUND_SHAPES:
            if (found := fit_face(surface, curved, shape)) is not None:
                return Picked(_round_entry(surface, curved, found, name), curved)
    if len(flat) == len(curved):
        return Picked(_plane_entry(surface, flat, seed, name), flat)
    normal = surface.normals[seed]
    return Picked({"name": name, "shape": "surface_point", "point_mm": listed(place), "direction": listed(normal)}, np.array([seed]))


def shapes_at(points: MeasuredPoints, place_mm: FloatArray) -> tuple[Feature, ...]:
    """Return the shapes whose regions grow from a place on the cloud, the one with most points first.

    Raises
    ------
    InspectionError
        None does; the reason is that of a plane.
    """
    found: list[tuple[int, Feature]] = []
    reason: InspectionError | None = None
    seed = tuple(float(value) for value in place_mm)
    for shape in GROWN_SHAPES:
        try:
            grown = grow_region(points, np.ones(len(points), np.bool_), shape, np.asarray(seed), Grow(seed_mm=(seed[0], seed[1], seed[2])))
        except (InspectionError, FitError) as error:
            reason = reason or InspectionError(error.message, error.hint)
            continue
        found.append((len(grown.indices), grown.feature))
    if not found:
        raise reason or InspectionError("No shape grows from this place.", "Click another place.")
    return tuple(feature for _, feature in sorted(found, key=lambda one: -one[0]))


def _plane_entry(surface: NominalSurface, triangles: IntArray, seed: int, name: str) -> dict[str, Any]:
    corners = surface.vertices_mm[surface.triangles[triangles]]
    doubled = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    middle = np.average(corners.mean(axis=1), axis=0, weights=doubled)
    low, high = corners.reshape(-1, 3).min(axis=0) - MARGIN_MM, corners.reshape(-1, 3).max(axis=0) + MARGIN_MM
    limits = {f"{axis}_mm": [round(float(low[k]), 3), round(float(high[k]), 3)] for k, axis in enumerate("xyz")}
    return {"name": name, "shape": "plane", "point_mm": listed(middle), "direction": listed(surface.normals[seed]), "cut": limits}


def _round_entry(surface: NominalSurface, triangles: IntArray, found: Feature, name: str) -> dict[str, Any]:
    corners = surface.vertices_mm[surface.triangles[triangles]].reshape(-1, 3)
    centres = surface.vertices_mm[surface.triangles[triangles]].mean(axis=1)
    away = centres - found.point_mm
    entry: dict[str, Any] = {"name": name, "shape": found.shape, "point_mm": listed(found.point_mm), "radius_mm": rounded(found.radius_mm)}
    if found.direction is not None:
        away = away - np.outer(away @ found.direction, found.direction)
        along = (corners - found.point_mm) @ found.direction
        entry |= {"direction": listed(found.direction), "cut": {"along_mm": [round(float(along.min()), 3), round(float(along.max()), 3)]}}
    if found.half_angle_rad is not None:
        entry["half_angle_deg"] = rounded(float(np.degrees(found.half_angle_rad)))
    if float(np.mean(np.einsum("nd,nd->n", away, surface.normals[triangles]))) < 0:
        entry["hole"] = True
    return entry
