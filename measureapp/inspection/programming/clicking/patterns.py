"""Hole patterns: equal holes of the nominal around a clicked one, or selected features, as copies on a circle, in a row or on a grid."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import InspectionProgram, MeasuredFeature, copy_names
from measureapp.errors import InspectionError
from measureapp.inspection.programming.clicking.faces import corners_of, fit_face, listed, rounded, smooth_faces
from measureapp.inspection.programming.clicking.on_nominal import circle_on_nominal
from measureapp.inspection.surface.nominal import NominalSurface

Entry = dict[str, Any]
SAME_MM, SAME_SIZE, PARALLEL = 0.05, 0.01, 0.9999  # of equal holes, and of their places in a regular pattern
LEAST_FACETS = 6  # of a hole
HOLES = ("circle", "cylinder", "slot", "sphere", "cone")


def pattern_on_nominal(surface: NominalSurface, place_mm: FloatArray, name: str) -> Entry:
    """Return the circle of the clicked hole, with all equal holes beside it as its copies.

    Raises
    ------
    InspectionError
        There is no equal hole, or they are not on a circle, in a row or on a grid.
    """
    entry = circle_on_nominal(surface, place_mm, name)
    axis, centre = np.asarray(entry["direction"]), np.asarray(entry["point_mm"])
    others = _equal_holes(surface, axis, centre, entry["radius_mm"], "hole" in entry)
    if not others:
        raise InspectionError("The CAD model has no other hole of this size and direction.", "Create this one as a circle.")
    places = np.vstack([centre, *others])
    first, repeat = _regular(places, axis)
    return {**entry, "point_mm": listed(places[first]), "repeat": repeat}


def pattern_of_selected(program: InspectionProgram, names: Sequence[str], features: dict[str, Feature], name: str) -> Entry:
    """Return the first of the selected features with the others as its copies.

    Parameters
    ----------
    names : selected features, in the order of their selection
    features : their nominals, or the measured ones without a nominal

    Raises
    ------
    InspectionError
        Fewer than two holes are selected, different ones, or they are not on a circle, in a row or on a grid.
    """
    entries = {one.name: one for one in program.features if isinstance(one, MeasuredFeature) and one.repeat is None}
    chosen = [entries[one] for one in names if one in entries and entries[one].shape in HOLES and entries[one].placed]
    if len(chosen) < 2 or len(chosen) < len(names):
        raise InspectionError(
            "A pattern is made of at least two holes.",
            "Select circles, cylinders or slots that are no copies of a pattern in the list of features.",
        )
    first = chosen[0]
    axis = np.asarray(first.direction or (0.0, 0.0, 1.0), float)
    axis = axis / np.linalg.norm(axis)
    for one in chosen[1:]:
        other = np.asarray(one.direction or axis, float)
        unlike = one.shape != first.shape or abs((one.radius_mm or 0.0) - (first.radius_mm or 0.0)) > SAME_SIZE * (first.radius_mm or 1.0)
        if unlike or abs(float(axis @ other)) < PARALLEL * np.linalg.norm(other):
            raise InspectionError(f"{one.name} is not equal to {first.name} in shape, size and direction.", "Select equal holes.")
    start, repeat = _regular(np.array([features[one.name].point_mm for one in chosen]), axis)
    return {**chosen[start].model_dump(mode="json", exclude_unset=True), "name": name, "repeat": repeat}


def copies_of(entry: Entry) -> tuple[str, ...]:
    """Return the name of a new feature, or those of all its copies."""
    described = MeasuredFeature.model_validate(entry)
    return copy_names(described.name, described.repeat)


def _equal_holes(surface: NominalSurface, axis: FloatArray, centre: FloatArray, radius_mm: float, is_hole: bool) -> list[FloatArray]:
    """Return the centres of the other round walls of one radius and direction, at the level of ``centre``."""
    found = []
    for face in smooth_faces(surface):
        if len(face) < LEAST_FACETS:
            continue
        vertices = corners_of(surface, face)
        along = (vertices - centre) @ axis
        across = np.linalg.norm(np.ptp(vertices - np.outer(along, axis), axis=0))
        if not along.min() < 0 < along.max() or across > 4 * radius_mm:
            continue
        wall = fit_face(surface, face, "cylinder")
        if wall is None or wall.direction is None or wall.radius_mm is None or abs(float(wall.direction @ axis)) < PARALLEL:
            continue
        place = wall.point_mm + float((centre - wall.point_mm) @ axis) * axis
        is_same = abs(wall.radius_mm - radius_mm) < max(SAME_SIZE * radius_mm, SAME_MM) and _is_hole(surface, face, place) == is_hole
        if is_same and np.linalg.norm(place - centre) > radius_mm:
            found.append(place)
    return found


def _is_hole(surface: NominalSurface, face: IntArray, centre: FloatArray) -> bool:
    away = surface.vertices_mm[surface.triangles[face]].mean(axis=1) - centre
    return float(np.mean(np.einsum("nd,nd->n", away, surface.normals[face]))) < 0


def _regular(places_mm: FloatArray, axis: FloatArray) -> tuple[int, Entry]:
    """Return which place is the first, and the pattern of all; of holes on several circles about one axis that of the first place.

    The first place remains it wherever it can: it may be the middle of a row, or no corner of a grid.
    """
    for first in range(len(places_mm)):
        places = np.vstack([places_mm[first : first + 1], np.delete(places_mm, first, axis=0)])
        found = _in_a_row(places) or _on_a_circle(places, axis) or _on_a_grid(places)
        if found is not None:
            return first, found
    away = np.linalg.norm(places_mm - places_mm.mean(axis=0), axis=1)
    found = _on_a_circle(places_mm[np.abs(away - away[0]) < SAME_MM], axis)
    if found is None:
        raise InspectionError(
            f"The {len(places_mm)} equal holes are not on a circle, in a row or on a grid.", "Create them one by one, as circles."
        )
    return 0, found


def _on_a_circle(places_mm: FloatArray, axis: FloatArray) -> Entry | None:
    """Return copies at equal angles about an axis: all around, or on an arc that begins at the first place."""
    if len(places_mm) < 3:
        return None
    u = np.cross(axis, np.eye(3)[int(np.abs(axis).argmin())])
    u = u / np.linalg.norm(u)
    flat = np.column_stack([places_mm @ u, places_mm @ np.cross(axis, u)])
    design = np.column_stack([2 * flat, np.ones(len(flat))])
    centre = np.linalg.lstsq(design, np.sum(flat**2, axis=1), rcond=None)[0][:2]
    away = flat - centre
    radii = np.linalg.norm(away, axis=1)
    if float(np.ptp(radii)) > SAME_MM:
        return None
    angles = np.sort((np.arctan2(away[:, 1], away[:, 0]) - np.arctan2(away[0, 1], away[0, 0]) + SAME_MM / radii[0]) % (2 * np.pi))
    steps = np.diff([*angles, angles[0] + 2 * np.pi])
    if float(np.ptp(steps)) * radii[0] < SAME_MM:
        step = 2 * np.pi / len(flat)
    elif float(np.ptp(steps[:-1])) * radii[0] < SAME_MM:
        step = float(steps[:-1].mean())
    else:
        return None
    point = centre[0] * u + centre[1] * np.cross(axis, u) + float(places_mm[0] @ axis) * axis
    return {"count": len(flat), "angle_deg": rounded(float(np.degrees(step))), "axis_point_mm": listed(point), "axis": listed(axis)}


def _in_a_row(places_mm: FloatArray) -> Entry | None:
    """Return copies at equal distances on a line, from the first place."""
    apart = places_mm - places_mm[0]
    away = np.linalg.norm(apart, axis=1)
    order = np.argsort(away, kind="stable")
    step = apart[order[1]]
    expected = np.arange(len(places_mm))[:, None] * step
    off = float(np.linalg.norm(apart[order] - expected, axis=1).max())
    return {"count": len(places_mm), "step_mm": listed(apart[order[-1]] / (len(places_mm) - 1))} if off < SAME_MM else None


def _on_a_grid(places_mm: FloatArray) -> Entry | None:
    """Return copies in rows from the first place, which is a corner of the grid."""
    apart = places_mm - places_mm[0]
    order = np.argsort(np.linalg.norm(apart, axis=1), kind="stable")[1:]
    step = apart[order[0]]
    across = next((one for one in apart[order] if np.linalg.norm(np.cross(step, one)) > SAME_MM * np.linalg.norm(one)), None)
    if across is None:
        return None
    counts = np.rint(apart @ np.linalg.pinv(np.stack([step, across]))).astype(int)
    columns, rows = counts.max(axis=0) + 1
    off = float(np.linalg.norm(counts @ np.stack([step, across]) - apart, axis=1).max())
    if off > SAME_MM or counts.min() < 0 or columns * rows != len(places_mm) or len(np.unique(counts, axis=0)) != len(places_mm):
        return None
    return {"count": len(places_mm), "step_mm": listed(step), "per_row": int(columns), "row_step_mm": listed(across)}
