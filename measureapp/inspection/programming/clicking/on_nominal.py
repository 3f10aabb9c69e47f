"""Circle, slot, line and edge from clicks on the nominal: their entries for the program, with the nominal's own dimensions."""

from __future__ import annotations

from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.feature import Feature
from measureapp.data.feature_program import MeasuredFeature
from measureapp.errors import FitError, InspectionError
from measureapp.geometry.contours import fit_contour
from measureapp.inspection.features.shapes import signed_distances
from measureapp.inspection.programming.clicking.faces import (
    CHORD,
    LEAST_CHORD_MM,
    NEAR,
    SMOOTH_DEG,
    SharpEdges,
    clicked_facet,
    corners_of,
    fit_face,
    flat_face,
    listed,
    rounded,
    sharp_edges_near,
    smooth_face,
    wall_at,
)
from measureapp.inspection.surface.nominal import NominalSurface

Entry = dict[str, Any]
DEFAULTS = MeasuredFeature.model_fields
HEIGHT_MM, STRIP_MM, GAP_MM = (float(DEFAULTS[name].default) for name in ("height_mm", "strip_mm", "gap_mm"))
FROM_END_MM = 2.0  # of a wall, within which points are blurred by its edge
UPRIGHT, LEVEL = 0.02, 0.05  # greatest cosine between wall and axis; between line and normal of its face
STRAIGHT_DEG, PARALLEL = 2.0, 0.9994  # of edges that continue each other
SAMPLES = 9  # along a clicked line
LEAST_LINE_MM, LEAST_FACE_MM = 2.0, 1.0


def circle_on_nominal(surface: NominalSurface, place_mm: FloatArray, name: str) -> Entry:
    """Return the circle of the round wall at a click, in a slice at the height of the click.

    Raises
    ------
    InspectionError
        Not a round wall, or a cone, which has no one diameter.
    """
    wall, place = wall_at(surface, place_mm)
    found = fit_face(surface, wall, "cylinder")
    if found is None and fit_face(surface, wall, "cone") is not None:  # the chamfer of a hole
        wall, found = _beyond_chamfer(surface, wall)
    if found is None or found.direction is None:
        raise InspectionError(
            "The wall at the clicked place is not a cylinder.", "Create a slot if it has two round ends, or grow another shape by Feature."
        )
    axis = found.direction * _sign(found.direction)
    away = surface.vertices_mm[surface.triangles[wall]].mean(axis=1) - found.point_mm
    low, high = _range((corners_of(surface, wall) - found.point_mm) @ axis)
    level, height = _slice(float((place - found.point_mm) @ axis), low, high)
    return {
        "name": name,
        "shape": "circle",
        "point_mm": listed(found.point_mm + level * axis),
        "direction": listed(axis),
        "radius_mm": rounded(found.radius_mm),
        "height_mm": rounded(height),
        **_if_hole(surface, wall, away - np.outer(away @ axis, axis)),
    }


def _beyond_chamfer(surface: NominalSurface, chamfer: IntArray) -> tuple[IntArray, Feature | None]:
    """Return the cylinder beside a conical face, if there is one."""
    triangles = sharp_edges_near(surface, np.zeros(3)).triangles
    inside = np.isin(triangles, chamfer)
    for seed in np.unique(triangles[inside.any(axis=1)][~inside[inside.any(axis=1)]]):
        face = smooth_face(surface, int(seed))
        if len(face) > len(flat_face(surface, int(seed))) and (found := fit_face(surface, face, "cylinder")) is not None:
            return face, found
    return chamfer, None


def slot_on_nominal(surface: NominalSurface, place_mm: FloatArray, name: str) -> Entry:
    """Return the slot of the wall at a click, in a slice at the height of the click. Raises InspectionError where it has no two round ends."""
    wall, place = wall_at(surface, place_mm)
    vertices, normals = corners_of(surface, wall), surface.normals[wall]
    axis = np.linalg.svd(normals, full_matrices=False)[2][-1]
    axis = axis * _sign(axis)
    if float(np.abs(normals @ axis).max()) > UPRIGHT:
        raise _no_slot()
    start = slot_start(vertices, axis, name)
    try:
        found = fit_contour(start, vertices)
    except FitError:
        raise _no_slot() from None
    size = float(np.linalg.norm(np.ptp(vertices, axis=0)))
    if float(np.abs(signed_distances(found, vertices)).max()) > max(CHORD * size, LEAST_CHORD_MM):
        raise _no_slot()
    low, high = _range((vertices - found.point_mm) @ axis)
    level, height = _slice(float((place - found.point_mm) @ axis), low, high)
    away = surface.vertices_mm[surface.triangles[wall]].mean(axis=1) - found.point_mm
    return {**slot_entry(found, axis, name, level), "height_mm": rounded(height), **_if_hole(surface, wall, away)}


def slot_start(points_mm: FloatArray, axis: FloatArray, name: str) -> Feature:
    """Return a first estimate of the slot through points: along their greatest extent across ``axis``."""
    middle = (points_mm.min(axis=0) + points_mm.max(axis=0)) / 2
    flat = points_mm - middle
    flat = flat - np.outer(flat @ axis, axis)
    along = np.linalg.svd(flat, full_matrices=False)[2][0]
    across = np.cross(axis, along)
    lengths, widths = flat @ along, flat @ across
    centre = middle + (lengths.min() + lengths.max()) / 2 * along + (widths.min() + widths.max()) / 2 * across
    width, length = float(np.ptp(widths)), float(np.ptp(lengths))
    if width <= 0 or length < width * (1 + CHORD):
        raise InspectionError("The clicked wall is as long as wide: it is round.", "Create a circle.")
    return Feature(name, "slot", centre, along, width / 2, length_mm=length, normal=axis)


def slot_entry(found: Feature, axis: FloatArray, name: str, level_mm: float = 0.0) -> Entry:
    """Return the entry of a slot, ``level_mm`` along its axis."""
    assert found.direction is not None and found.length_mm is not None and found.radius_mm is not None
    return {
        "name": name,
        "shape": "slot",
        "point_mm": listed(found.point_mm + level_mm * axis),
        "direction": listed(axis),
        "along": listed(found.direction * _sign(found.direction)),
        "length_mm": rounded(found.length_mm),
        "width_mm": rounded(2 * found.radius_mm),
    }


def _no_slot() -> InspectionError:
    return InspectionError(
        "The wall at the clicked place is not that of a slot with two round ends.",
        "Create a circle if it is round; measure the sides of a square slot as planes.",
    )


def line_on_nominal(surface: NominalSurface, first_mm: FloatArray, second_mm: FloatArray, name: str) -> Entry:
    """Return the line between two clicks on one face. Raises InspectionError where the surface between them is not straight."""
    (_, first), (_, second) = clicked_facet(surface, first_mm), clicked_facet(surface, second_mm)
    apart = second - first
    length = float(np.linalg.norm(apart))
    if length < LEAST_LINE_MM:
        raise too_close()
    between = surface.closest(first + np.linspace(0.02, 0.98, SAMPLES)[:, None] * apart)
    off = between.points_mm - (first + np.linspace(0.02, 0.98, SAMPLES)[:, None] * apart)
    return line_entry(first, second, between.normals, float(np.linalg.norm(off, axis=1).max()), name)


def line_entry(first: FloatArray, second: FloatArray, normals: FloatArray, off_mm: float, name: str) -> Entry:
    """Return the entry of a line between two places, from the normals of the surface between them and its distance from the line."""
    length = float(np.linalg.norm(second - first))
    direction = (second - first) / length
    normal = normals.mean(axis=0)
    normal = normal / np.linalg.norm(normal)
    bent = float((normals @ normal).min()) < np.cos(np.radians(SMOOTH_DEG))
    if bent or off_mm > max(CHORD * length, 5 * LEAST_CHORD_MM) or abs(float(normal @ direction)) > LEVEL:
        raise InspectionError(
            "The surface between the two clicks is not straight.",
            "Click two places of one face, along the straight direction of a curved one.",
        )
    normal = normal - (normal @ direction) * direction
    return {
        "name": name,
        "shape": "line",
        "point_mm": listed((first + second) / 2),
        "direction": listed(direction),
        "normals": [listed(normal / np.linalg.norm(normal))],
        "length_mm": rounded(length),
        "strip_mm": STRIP_MM,
    }


def too_close() -> InspectionError:
    """Return the refusal of two clicks at the same place."""
    return InspectionError(f"The two clicks are less than {LEAST_LINE_MM:g} mm apart.", "Click the other end of the line.")


def edge_on_nominal(surface: NominalSurface, place_mm: FloatArray, name: str) -> Entry:
    """Return the straight edge between two faces next to a click.

    Raises
    ------
    InspectionError
        No sharp edge near, a curved one, or faces too narrow to be extrapolated to their edge.
    """
    _, place = clicked_facet(surface, place_mm)
    edges = sharp_edges_near(surface, place)
    if (
        len(edges.distances_mm) == 0
        or (seed := int(edges.distances_mm.argmin())) < 0
        or edges.distances_mm[seed] > NEAR * surface.diagonal_mm
    ):
        raise InspectionError(
            "There is no sharp edge of the CAD model near the clicked place.",
            "Click closer to it; where the edge is rounded, construct the intersection of its two faces.",
        )
    chain, direction = _straight_chain(surface, edges, seed)
    ends = surface.vertices_mm[np.unique(edges.vertices[chain])]
    origin = surface.vertices_mm[edges.vertices[seed, 0]]
    low, high = _range((ends - origin) @ direction)
    faces = [flat_face(surface, int(one)) for one in edges.triangles[seed]]
    normals = surface.normals[edges.triangles[seed]]
    centre = surface.vertices_mm[surface.triangles[edges.triangles[seed, 1]]].mean(axis=0)
    is_inner = float((centre - origin) @ normals[0]) > 0  # the second face rises above the first
    width = min(_width(surface, face, origin, direction, normals[k], normals[1 - k], is_inner) for k, face in enumerate(faces))
    if width < LEAST_FACE_MM:
        raise InspectionError(f"A face beside this edge is only {width:.1f} mm wide.", "Click an edge between two wider faces.")
    gap = min(GAP_MM, width / 4)
    trimmed = min(gap, (high - low) / 10)
    return {
        "name": name,
        "shape": "edge",
        "point_mm": listed(origin + (low + high) / 2 * direction),
        "direction": listed(direction),
        "normals": [listed(one) for one in normals],
        "length_mm": rounded(high - low - 2 * trimmed),
        "strip_mm": rounded(min(STRIP_MM, width - gap)),
        "gap_mm": rounded(gap),
        **({"hole": True} if is_inner else {}),
    }


def _straight_chain(surface: NominalSurface, edges: SharpEdges, seed: int) -> tuple[IntArray, FloatArray]:
    """Return the edges that continue one in a straight line between the same faces, and their direction."""
    start, end = surface.vertices_mm[edges.vertices[:, 0]], surface.vertices_mm[edges.vertices[:, 1]]
    directions = (end - start) / np.maximum(np.linalg.norm(end - start, axis=1, keepdims=True), 1e-12)
    direction = directions[seed] * _sign(directions[seed])
    mine, normals = surface.normals[edges.triangles[seed]], surface.normals[edges.triangles]
    in_order = np.einsum("nkd,kd->nk", normals, mine).min(axis=1)
    reversed_order = np.einsum("nkd,kd->nk", normals[:, ::-1], mine).min(axis=1)
    same = np.maximum(in_order, reversed_order) > PARALLEL
    same &= np.abs(directions @ direction) > np.cos(np.radians(STRAIGHT_DEG))
    chain, known = {seed}, set(edges.vertices[seed].tolist())
    while new := {int(k) for k in np.flatnonzero(np.isin(edges.vertices, list(known)).any(axis=1) & same)} - chain:
        chain |= new
        known |= {int(one) for one in edges.vertices[list(new)].ravel()}
    members = np.array(sorted(chain))
    onwards = np.isin(edges.vertices, list(known)).any(axis=1) & ~np.isin(np.arange(len(directions)), members)
    turns = np.abs(directions[onwards] @ direction)
    if np.any((turns > np.cos(np.radians(SMOOTH_DEG + STRAIGHT_DEG))) & (turns < np.cos(np.radians(STRAIGHT_DEG / 4)))):
        raise InspectionError("The edge at the clicked place is curved.", "Create a circle there, or a line on one of its faces.")
    return members, direction


def _width(
    surface: NominalSurface,
    face: IntArray,
    origin: FloatArray,
    direction: FloatArray,
    normal: FloatArray,
    other: FloatArray,
    is_inner: bool,
) -> float:
    """Return how far a face extends from an edge of it."""
    away = np.cross(direction, normal)
    away = away * (-1.0 if (away @ other > 0) != is_inner else 1.0)
    return float(((corners_of(surface, face) - origin) @ away).max())


def _slice(level: float, low: float, high: float) -> tuple[float, float]:
    """Return middle and height of the slice of a wall from ``low`` to ``high`` at a level, away from the ends of the wall if it can be."""
    height = min(HEIGHT_MM, 0.8 * (high - low))
    margin = min(FROM_END_MM + height / 2, (high - low) / 2)
    return float(np.clip(level, low + margin, high - margin)), height


def _if_hole(surface: NominalSurface, wall: IntArray, away: FloatArray) -> Entry:
    """Return the statement that the material is outside, where it is."""
    return {"hole": True} if float(np.mean(np.einsum("nd,nd->n", away, surface.normals[wall]))) < 0 else {}


def _range(values: FloatArray) -> tuple[float, float]:
    return float(values.min()), float(values.max())


def _sign(direction: FloatArray) -> float:
    """Return the sign that makes the greatest component of a direction positive."""
    return 1.0 if direction[int(np.abs(direction).argmax())] > 0 else -1.0
