"""Edges: the intersection of two faces measured beside it, or, for a free edge, the end of the measured points.

The end of the points is not the end of the material: near an edge the fringe window, the blur of the lens and the filters remove points.
An edge between two faces is therefore extrapolated from their surfaces, which none of this shifts; a free edge needs a statement of the
width removed, and carries it in its uncertainty.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import pairwise

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.feature import Feature
from measureapp.data.feature_program import MeasuredFeature
from measureapp.inspection.features.construct import construct_one
from measureapp.inspection.features.constructions import MAKERS
from measureapp.inspection.features.cut import NominalFeature, cut_points, nominal_features
from measureapp.inspection.features.feature_errors import NOISE, Errors, ErrorSource
from measureapp.inspection.features.found_feature import EdgeProfile, FoundFeature, fit_feature
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings

SECTIONS, LEAST_IN_SECTION = 12, 8  # along an edge, and points of each face in one
LEAST_BINS, PER_BIN = 8, 40  # of a free edge; points per bin
MAD_TO_SIGMA, FAR = 1.4826, 3.5


def find_edges(described: MeasuredFeature, points: MeasuredPoints, settings: InspectionSettings) -> Mapping[str, FoundFeature]:
    """Find an edge, or all copies of its pattern, on ``points`` (in the nominal's frame)."""
    find = _find_free_edge if len(described.normals) == 1 else _find_edge
    return {one.feature.name: find(described, one, points, settings) for one in nominal_features(described)}


@dataclass(frozen=True, slots=True, eq=False)
class _Side:
    """One face beside an edge."""

    normal: FloatArray  # (3,), outward
    away: FloatArray  # (3,), in the face, away from the edge
    nominal: NominalFeature


def _find_edge(described: MeasuredFeature, nominal: NominalFeature, points: MeasuredPoints, settings: InspectionSettings) -> FoundFeature:
    name = nominal.feature.name
    sides = _sides(described, nominal)
    chosen = [cut_points(points, side.nominal, None) for side in sides]
    faces = [
        fit_feature(side.nominal, points, indices, settings, side.nominal.feature) for side, indices in zip(sides, chosen, strict=True)
    ]
    made = construct_one(partial(_edge_of_faces, name, nominal.feature), name, faces)
    if made.feature is None:
        return replace(made, nominal=nominal.feature, reason=made.reason if made.reason.startswith(name) else f"{name}: {made.reason}")
    how = f"faces up to {described.gap_mm:g} mm beside the edge"
    left_out = sum(face.feature.left_out for face in faces if face.feature is not None)
    feature = replace(made.feature, how=how, left_out=left_out, boundary_mm=_ends(made.feature, described.length_mm or 0.0))
    profile = _profile(feature, faces)
    return replace(made, feature=feature, nominal=nominal.feature, edge_profile=profile)


def _sides(described: MeasuredFeature, nominal: NominalFeature) -> tuple[_Side, _Side]:
    """Return the strips of both faces; an internal edge (``hole``) has its faces on the outer sides of each other."""
    direction = nominal.feature.direction
    assert direction is not None and described.length_mm is not None  # as the program requires
    normals = [_unit(nominal.copy_from_first @ np.asarray(one, float)) for one in described.normals]
    middle = described.gap_mm + described.strip_mm / 2
    made = []
    for number in (0, 1):
        normal, other = normals[number], normals[1 - number]
        away: FloatArray = np.cross(direction, normal)
        away = away / np.linalg.norm(away) * (-1.0 if (away @ other > 0) != described.hole else 1.0)
        feature = Feature(f"{nominal.feature.name}, face {number + 1}", "plane", nominal.feature.point_mm + middle * away, normal)
        slabs = ((direction, described.length_mm / 2), (away, described.strip_mm / 2))
        made.append(_Side(normal, away, replace(nominal, feature=feature, hole=False, slabs=slabs)))
    return made[0], made[1]


def _edge_of_faces(name: str, nominal: Feature, faces: Sequence[Feature]) -> Feature:
    """Intersect both faces; the edge has the nominal's sense, its point is the foot of the nominal's."""
    line = MAKERS["intersection"](name, 0.0, faces)
    assert line.direction is not None and nominal.direction is not None
    direction = line.direction if line.direction @ nominal.direction > 0 else -line.direction
    foot = line.point_mm + float((nominal.point_mm - line.point_mm) @ direction) * direction
    return replace(line, point_mm=foot, direction=direction)


def _profile(edge: Feature, faces: Sequence[FoundFeature]) -> EdgeProfile | None:
    """Return the edge in sections along it: each face displaced by the mean of its points in the section."""
    direction = edge.direction
    assert direction is not None
    places = [(face.points_mm - edge.point_mm) @ direction for face in faces]
    low, high = max(place.min() for place in places), min(place.max() for place in places)
    bounds = np.linspace(low, high, SECTIONS + 1)
    normals = np.stack([face.feature.direction for face in faces if face.feature is not None and face.feature.direction is not None])
    solve = np.linalg.pinv(normals)  # (3, 2): displacement of the edge from those of the faces
    found, noise = [], []
    for start, end in pairwise(bounds):
        heights, sigmas = [], []
        for face, place, normal in zip(faces, places, normals, strict=True):
            assert face.feature is not None
            inside = (place >= start) & (place < end)
            if np.count_nonzero(inside) < LEAST_IN_SECTION:
                break
            height = (face.points_mm[inside] - face.feature.point_mm) @ normal
            heights.append(float(height.mean()))
            rest = height - np.polyval(np.polyfit(place[inside], height, 1), place[inside])  # a slope is form, no noise
            sigmas.append(float(np.sqrt(rest @ rest / (len(rest) - 2) / len(rest))))
        if len(heights) == len(faces):
            found.append(edge.point_mm + (start + end) / 2 * direction + solve @ np.array(heights))
            noise.append(float(np.linalg.norm(solve * np.array(sigmas), 2)))
    return EdgeProfile(np.array(found), np.array(noise)) if len(found) >= SECTIONS // 2 else None


def _find_free_edge(
    described: MeasuredFeature, nominal: NominalFeature, points: MeasuredPoints, settings: InspectionSettings
) -> FoundFeature:
    """Find the end of the points of a face, displaced by half the stated loss, which counts with a rectangular distribution."""
    name, edge = nominal.feature.name, nominal.feature
    direction, normal = edge.direction, edge.normal
    assert direction is not None and normal is not None and described.length_mm is not None and described.loss_mm is not None
    out = _towards_nothing(points.points_mm, edge, described.strip_mm, described.length_mm)
    face = Feature(f"{name}, face", "plane", edge.point_mm - described.strip_mm / 2 * out, normal)
    slabs = ((direction, described.length_mm / 2), (out, described.strip_mm / 2 + nominal.cut.band_mm))
    strip = replace(nominal, feature=face, hole=False, slabs=slabs)
    chosen = cut_points(points, strip, None)
    plane = fit_feature(strip, points, chosen, settings, face)
    if plane.feature is None:
        return FoundFeature(name, None, f"{name}: {plane.reason}", nominal=edge)
    ends = _end_of_points(points.points_mm[chosen], edge.point_mm, direction, out)
    if ends is None:
        needed = LEAST_BINS * PER_BIN
        return FoundFeature(name, None, f"{name}: the points along the edge are too few or too uneven, {needed} are needed", nominal=edge)
    return _free_edge(described, edge, out, plane, _in_the_face(points.where(chosen), out), *ends)


def _in_the_face(used: MeasuredPoints, out: FloatArray) -> Errors:
    """Return the mean displacements (1, M) of the points along ``out`` by the errors of their views."""
    if used.errors is None or used.view is None:
        return {}
    moved = used.errors.along(used.points_mm, np.tile(out, (len(used), 1)), used.view)
    return {ErrorSource(name): columns.mean(axis=0)[None] for name, columns in moved.items()}


def _towards_nothing(points_mm: FloatArray, edge: Feature, strip_mm: float, length_mm: float) -> FloatArray:
    """Return the direction in the face, across the edge, on whose side there are fewer points."""
    assert edge.direction is not None and edge.normal is not None
    out: FloatArray = np.cross(edge.direction, edge.normal)
    out = out / np.linalg.norm(out)
    offset = points_mm - edge.point_mm
    near = (np.abs(offset @ edge.direction) < length_mm / 2) & (np.abs(offset @ edge.normal) < strip_mm)
    extent = offset[near] @ out
    beside = extent[np.abs(extent) < strip_mm]
    return -out if np.count_nonzero(beside > 0) > np.count_nonzero(beside < 0) else out


def _end_of_points(
    points_mm: FloatArray, origin_mm: FloatArray, along: FloatArray, out: FloatArray
) -> tuple[FloatArray, FloatArray] | None:
    """Return place along the edge and outermost extent (K,) of the points of each bin, corrected for their finite density."""
    place, extent = (points_mm - origin_mm) @ along, (points_mm - origin_mm) @ out
    count = len(points_mm) // PER_BIN
    if count < LEAST_BINS:
        return None
    order: IntArray = np.argsort(place, kind="stable")
    bins = np.array_split(order, count)
    middles = np.array([place[one].mean() for one in bins])
    # of n points spread evenly over a depth, the outermost is on average one spacing short of the end
    outermost = np.array([extent[one].max() + np.ptp(extent[one]) / len(one) for one in bins])
    line = np.polyfit(middles, outermost, 1)
    off = outermost - np.polyval(line, middles)
    near = np.abs(off - np.median(off)) <= FAR * max(MAD_TO_SIGMA * float(np.median(np.abs(off - np.median(off)))), 1e-6)
    return (middles[near], outermost[near]) if np.count_nonzero(near) >= LEAST_BINS else None


def _free_edge(
    described: MeasuredFeature,
    edge: Feature,
    out: FloatArray,
    plane: FoundFeature,
    in_the_face: Errors,
    place: FloatArray,
    extent: FloatArray,
) -> FoundFeature:
    assert plane.feature is not None and plane.feature.direction is not None and edge.direction is not None
    normal, loss = plane.feature.direction, described.loss_mm or 0.0
    middle = float(place.mean())
    design = np.column_stack([np.ones_like(place), place - middle])
    values = np.linalg.lstsq(design, extent, rcond=None)[0]
    rest = extent - design @ values
    covariance = float(rest @ rest) / (len(place) - 2) * np.linalg.inv(design.T @ design)
    point = edge.point_mm + middle * edge.direction + (values[0] + loss / 2) * out
    point = point - float((point - plane.feature.point_mm) @ normal) * normal
    direction = edge.direction + values[1] * out
    direction = direction - float(direction @ normal) * normal
    direction = direction / np.linalg.norm(direction)
    columns = np.zeros((6, 2))
    columns[:3, 0], columns[3:, 1] = np.sqrt(covariance[0, 0]) * out, np.sqrt(covariance[1, 1]) * out
    removed = np.zeros((6, 1))
    removed[:3, 0] = loss / np.sqrt(12.0) * out
    errors: Errors = {
        ErrorSource(NOISE, edge.name): columns,
        ErrorSource("common", f"{edge.name}, loss"): removed,
        **{source: _normal_part(rows, normal, point - plane.feature.point_mm) for source, rows in plane.errors.items()},
    }
    for source, rows in plane.other_errors.items():  # in the face as across it
        shifted = rows[:6].copy()
        if source in in_the_face:
            shifted[:3] += np.outer(out, in_the_face[source][0])
        errors = {**errors, source: shifted}
    how = f"end of the points, displaced by half the stated loss of {loss:g} mm"
    deviations = {
        "position_mm": float(np.hypot(columns[:3, 0] @ out, removed[:3, 0] @ out)),
        "direction_rad": float(np.sqrt(covariance[1, 1])),
    }
    feature = Feature(edge.name, "line", point, direction, normal=normal, points=len(place), standard_deviations=deviations, how=how)
    profile = EdgeProfile(point + np.outer(place - middle, direction) + np.outer(rest, out), np.full(len(place), float(np.std(rest))))
    return FoundFeature(
        edge.name, feature, views=plane.views, nominal=edge, other_errors=errors, view_errors=plane.view_errors, edge_profile=profile
    )


def _normal_part(rows: FloatArray, normal: FloatArray, arm_mm: FloatArray) -> FloatArray:
    """Return the errors of a point of a plane, and of a direction in it, along the plane's normal."""
    made = np.zeros_like(rows[:6])
    heights = normal @ rows[:3] - arm_mm @ rows[3:6]
    made[:3] = np.outer(normal, heights)
    return made


def _ends(edge: Feature, length_mm: float) -> FloatArray:
    assert edge.direction is not None
    return edge.point_mm + np.outer([-length_mm / 2, length_mm / 2], edge.direction)


def _unit(vector: FloatArray) -> FloatArray:
    return vector / np.linalg.norm(vector)
