"""The feature that a click means: the face of the nominal around it, or the region of the cloud that grows from it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.cut import Grow
from measureapp.data.feature import Feature
from measureapp.errors import FitError, InspectionError
from measureapp.geometry.feature import Shape
from measureapp.geometry.fits import distances_mm, fit
from measureapp.inspection.features.regions.grow import grow_region
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.surface.nominal import NominalSurface

FLAT_DEG, SMOOTH_DEG = 1.0, 20.0  # greatest angle to the clicked facet, and between neighbouring facets of a curved face
CHORD = 5e-3  # greatest distance of vertices from a shape, relative to the size of the face
LEAST_CHORD_MM = 0.01
GROWN_SHAPES: tuple[Shape, ...] = ("plane", "cylinder", "sphere", "cone")
ROUND_SHAPES: tuple[Shape, ...] = ("cylinder", "cone", "sphere")
MARGIN_MM = 1.0  # of the limits of a plane beyond its face
DIGITS = 6


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
    flat = _connected(surface, surface.normals @ surface.normals[seed] > np.cos(np.radians(FLAT_DEG)), seed, -1.0)
    curved = _connected(surface, np.ones(len(surface.triangles), np.bool_), seed, float(np.cos(np.radians(SMOOTH_DEG))))
    if len(curved) > len(flat):
        for shape in ROUND_SHAPES:
            if (found := _fits(surface, curved, shape)) is not None:
                return Picked(_round_entry(surface, curved, found, name), curved)
    if len(flat) == len(curved):
        return Picked(_plane_entry(surface, flat, seed, name), flat)
    normal = surface.normals[seed]
    return Picked({"name": name, "shape": "surface_point", "point_mm": _listed(place), "direction": _listed(normal)}, np.array([seed]))


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


def _connected(surface: NominalSurface, allowed: BoolArray, seed: int, least_cosine: float) -> IntArray:
    """Return the triangles connected to ``seed`` by edges between allowed ones that are at most so sharp."""
    pairs, cosines = surface.face_neighbours
    kept = pairs[(cosines >= least_cosine) & allowed[pairs].all(axis=1)]
    count = len(surface.triangles)
    links = coo_matrix((np.ones(len(kept), np.int8), (kept[:, 0], kept[:, 1])), shape=(count, count))
    _, labels = connected_components(links, directed=False)
    return np.flatnonzero(labels == labels[seed])


def _fits(surface: NominalSurface, triangles: IntArray, shape: Shape) -> Feature | None:
    vertices = surface.vertices_mm[np.unique(surface.triangles[triangles])]
    size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    try:
        found = fit(shape, vertices)
    except FitError:
        return None
    most = float(np.abs(distances_mm(found, vertices)).max())
    small = (found.radius_mm or 0.0) < 5 * size
    return found if small and most < max(CHORD * size, LEAST_CHORD_MM) else None


def _plane_entry(surface: NominalSurface, triangles: IntArray, seed: int, name: str) -> dict[str, Any]:
    corners = surface.vertices_mm[surface.triangles[triangles]]
    doubled = np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1)
    middle = np.average(corners.mean(axis=1), axis=0, weights=doubled)
    low, high = corners.reshape(-1, 3).min(axis=0) - MARGIN_MM, corners.reshape(-1, 3).max(axis=0) + MARGIN_MM
    limits = {f"{axis}_mm": [round(float(low[k]), 3), round(float(high[k]), 3)] for k, axis in enumerate("xyz")}
    return {"name": name, "shape": "plane", "point_mm": _listed(middle), "direction": _listed(surface.normals[seed]), "cut": limits}


def _round_entry(surface: NominalSurface, triangles: IntArray, found: Feature, name: str) -> dict[str, Any]:
    corners = surface.vertices_mm[surface.triangles[triangles]].reshape(-1, 3)
    centres = surface.vertices_mm[surface.triangles[triangles]].mean(axis=1)
    away = centres - found.point_mm
    entry: dict[str, Any] = {"name": name, "shape": found.shape, "point_mm": _listed(found.point_mm), "radius_mm": _number(found.radius_mm)}
    if found.direction is not None:
        away = away - np.outer(away @ found.direction, found.direction)
        along = (corners - found.point_mm) @ found.direction
        entry |= {"direction": _listed(found.direction), "cut": {"along_mm": [round(float(along.min()), 3), round(float(along.max()), 3)]}}
    if found.half_angle_rad is not None:
        entry["half_angle_deg"] = _number(float(np.degrees(found.half_angle_rad)))
    if float(np.mean(np.einsum("nd,nd->n", away, surface.normals[triangles]))) < 0:
        entry["hole"] = True
    return entry


def _listed(vector: FloatArray) -> list[float]:
    return [_number(float(value)) for value in vector]


def _number(value: float | None) -> float:
    return round(value or 0.0, DIGITS) + 0.0
