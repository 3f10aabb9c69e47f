"""Circle, slot, line and edge from clicks on the measured points, where there is no nominal: shapes are fitted to the points around."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.cut import Grow
from measureapp.data.feature import Feature
from measureapp.errors import FitError, InspectionError
from measureapp.geometry.contours import fit_contour
from measureapp.geometry.fits import fit
from measureapp.inspection.features.regions.grow import Region, grow_region
from measureapp.inspection.features.shapes import along_and_off, signed_distances
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.programming.clicking.faces import listed, rounded
from measureapp.inspection.programming.clicking.on_nominal import (
    GAP_MM,
    HEIGHT_MM,
    LEAST_LINE_MM,
    STRIP_MM,
    line_entry,
    slot_entry,
    too_close,
)

Entry = dict[str, Any]
PATCH, REACH_MM = 40, 3.0  # points of a local plane, and their greatest distance from a click
SPREAD, UPRIGHT = 0.3, 0.35  # least spread of the normals of a wall, greatest cosine between them and its axis
NEAR_WALL, LEAST_NEAR_MM, WALL_MM = 0.1, 0.5, 6.0  # from a clicked wall: relative to its radius; and along its axis
LEAST_POINTS, FIT_POINTS = 60, 20_000
CHANGED = 0.15  # greatest relative change of a size by its fit
SAMPLES = 9


def circle_on_points(points: MeasuredPoints, places_mm: Sequence[FloatArray], name: str) -> Entry:
    """Return the circle through three clicks on a round wall; the wall around them determines its axis, if enough of it was measured.

    Raises
    ------
    InspectionError
        Clicks on a flat face, or on no one wall.
    """
    normals, places = _patches(points, places_mm)
    axis = _axis_of_wall(normals)
    u, v = _across(axis)
    flat = np.column_stack([places @ u, places @ v])
    centre = _centre(flat)
    radius = float(np.linalg.norm(flat - centre, axis=1).mean())
    facing = np.einsum("nd,nd->n", (flat - centre) / radius, np.column_stack([normals @ u, normals @ v]))
    if len({bool(one > 0) for one in facing}) > 1 or float(np.abs(facing).min()) < 1 - UPRIGHT:
        raise _no_wall()
    start = Feature(name, "cylinder", centre[0] * u + centre[1] * v + float((places @ axis).mean()) * axis, axis, radius)
    found = _fit_wall(points, start, float(facing.mean()))
    assert found.direction is not None
    level = float((places @ found.direction).mean() - found.point_mm @ found.direction)
    return {
        "name": name,
        "shape": "circle",
        "point_mm": listed(found.point_mm + level * found.direction),
        "direction": listed(found.direction),
        "radius_mm": rounded(found.radius_mm),
        "height_mm": HEIGHT_MM,
        **({"hole": True} if facing.mean() < 0 else {}),
    }


def slot_on_points(points: MeasuredPoints, places_mm: Sequence[FloatArray], name: str) -> Entry:
    """Return the slot through four clicks: its two ends, then its two sides. Raises InspectionError where they are on no slot."""
    normals, places = _patches(points, places_mm)
    axis = _axis_of_wall(normals)
    apart = places[1] - places[0]
    along = apart - float(apart @ axis) * axis
    length = float(np.linalg.norm(along))
    if length < LEAST_LINE_MM:
        raise too_close()
    along = along / length
    across = np.cross(axis, along)
    sides = [float((one - places[0]) @ across) for one in places[2:]]
    width = abs(sides[0] - sides[1])
    if not LEAST_LINE_MM / 4 < width < length:
        raise InspectionError(
            "The clicks are not on the ends and sides of one slot.",
            "Click both round ends first, then both straight sides; a slot is longer than wide.",
        )
    middle = (places[0] + places[1]) / 2
    middle = middle + (float(np.mean(sides)) - float((middle - places[0]) @ across)) * across
    middle = middle + float(((places - middle) @ axis).mean()) * axis
    start = Feature(name, "slot", middle, along, width / 2, length_mm=length, normal=axis)
    off = points.points_mm - middle
    near = (np.abs(off @ axis) < HEIGHT_MM) & (np.abs(signed_distances(start, points.points_mm)) < max(LEAST_NEAR_MM, NEAR_WALL * width))
    near &= np.abs(_normals(points) @ axis) < UPRIGHT
    try:
        found = fit_contour(start, points.points_mm[near]) if np.count_nonzero(near) >= LEAST_POINTS else start
    except FitError:
        found = start
    inward = float(np.mean(np.einsum("nd,nd->n", places - middle, normals))) < 0
    return {**slot_entry(found, axis, name), "height_mm": HEIGHT_MM, **({"hole": True} if inward else {})}


def line_on_points(points: MeasuredPoints, places_mm: Sequence[FloatArray], name: str) -> Entry:
    """Return the line between two clicks on one face. Raises InspectionError where the surface between them is not straight."""
    first, second = (np.asarray(one, float) for one in places_mm)
    if float(np.linalg.norm(second - first)) < LEAST_LINE_MM:
        raise too_close()
    between = first + np.linspace(0.0, 1.0, SAMPLES)[1:-1, None] * (second - first)
    measured = [one for one in between if np.linalg.norm(points.points_mm - one, axis=1).min() < REACH_MM / 2]  # a line may cross a gap
    samples = np.array([first, *measured, second])
    normals, on_surface = _patches(points, samples)
    off = np.abs(np.einsum("nd,nd->n", samples - on_surface, normals))
    return line_entry(on_surface[0], on_surface[-1], normals, float(off.max()), name)


def edge_on_points(points: MeasuredPoints, places_mm: Sequence[FloatArray], name: str) -> Entry:
    """Return the edge of two faces, one click on each; its ends are those that both faces have. Raises InspectionError for parallel faces."""
    first, second = (_plane_at(points, place) for place in places_mm)
    one, other = first.feature.direction, second.feature.direction
    assert one is not None and other is not None
    direction = np.cross(one, other)
    if float(np.linalg.norm(direction)) < np.sin(np.radians(20.0)):
        raise InspectionError(
            "The two clicked faces are parallel, or the same one.", "Click one place on each of the two faces of the edge."
        )
    direction = direction / np.linalg.norm(direction)
    normals = np.stack([one, other])
    heights = np.array([one @ first.feature.point_mm, other @ second.feature.point_mm])
    middle = (np.asarray(places_mm[0], float) + np.asarray(places_mm[1], float)) / 2
    origin = middle + np.linalg.pinv(normals) @ (heights - normals @ middle)
    low, high = _common_extent(points, (first, second), origin, direction)
    inner = float((points.points_mm[second.indices].mean(axis=0) - first.feature.point_mm) @ one) > 0
    return {
        "name": name,
        "shape": "edge",
        "point_mm": listed(origin + (low + high) / 2 * direction),
        "direction": listed(direction),
        "normals": [listed(one), listed(other)],
        "length_mm": rounded(high - low),
        "strip_mm": STRIP_MM,
        "gap_mm": GAP_MM,
        **({"hole": True} if inner else {}),
    }


def _plane_at(points: MeasuredPoints, place_mm: FloatArray) -> Region:
    place = np.asarray(place_mm, float)
    seed = (float(place[0]), float(place[1]), float(place[2]))
    try:
        region = grow_region(points, np.ones(len(points), np.bool_), "plane", place, Grow(seed_mm=seed))
    except (InspectionError, FitError):
        raise InspectionError(
            "There is no flat face at a clicked place.", "Click one place on each of the two faces, a few millimetres beside the edge."
        ) from None
    feature, facing = region.feature, _normals(points)[region.indices].mean(axis=0)
    assert feature.direction is not None
    return region if facing @ feature.direction > 0 else replace(region, feature=replace(feature, direction=-feature.direction))


def _common_extent(points: MeasuredPoints, faces: Sequence[Region], origin: FloatArray, direction: FloatArray) -> tuple[float, float]:
    """Return from where to where along an edge both faces were measured beside it."""
    ends = []
    for face in faces:
        along, off, _ = along_and_off(points.points_mm[face.indices], origin, direction)
        beside = along[off < GAP_MM + STRIP_MM]
        if len(beside) < LEAST_POINTS:
            raise InspectionError("Too little was measured beside this edge.", "Scan the faces beside it, or click faces that meet.")
        ends.append((float(np.quantile(beside, 0.005)), float(np.quantile(beside, 0.995))))
    low, high = max(one for one, _ in ends), min(one for _, one in ends)
    if high - low < LEAST_LINE_MM:
        raise InspectionError("The two clicked faces do not meet in an edge.", "Click two faces that border on each other.")
    return low, high


def _patches(points: MeasuredPoints, places_mm: Sequence[FloatArray] | FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return normal and place (K, 3) of the local plane at each click. Raises InspectionError where nothing was measured."""
    normals, places = [], []
    for place in places_mm:
        away = np.linalg.norm(points.points_mm - place, axis=1)
        near = np.argpartition(away, min(PATCH, len(away) - 1))[:PATCH]
        near = near[away[near] < REACH_MM]
        if len(near) < 3:
            raise InspectionError("Nothing was measured at a clicked place.", "Click measured points.")
        centre = points.points_mm[near].mean(axis=0)
        facing = _normals(points)[near].mean(axis=0)
        normal = np.linalg.svd(points.points_mm[near] - centre, full_matrices=False)[2][-1]
        normal = normal if normal @ facing > 0 else -normal
        normals.append(normal)
        places.append(np.asarray(place, float) - float((np.asarray(place, float) - centre) @ normal) * normal)
    return np.array(normals), np.array(places)


def _normals(points: MeasuredPoints) -> FloatArray:
    if points.normals is None:
        raise InspectionError("These points have no normals, which show on which side the material is.", "Compute the surface again.")
    return np.asarray(points.normals, np.float64)


def _axis_of_wall(normals: FloatArray) -> FloatArray:
    """Return the axis at right angles to the normals of a wall."""
    sizes, axes = np.linalg.svd(normals, full_matrices=False)[1:]
    if sizes[1] < SPREAD:
        raise InspectionError("The clicks are on one flat face.", "Click the wall, at places spread around it.")
    axis = axes[-1] * (1.0 if axes[-1][int(np.abs(axes[-1]).argmax())] > 0 else -1.0)
    if float(np.abs(normals @ axis).max()) > UPRIGHT:
        raise _no_wall()
    return np.asarray(axis)


def _no_wall() -> InspectionError:
    return InspectionError("The clicks are not on one wall.", "Click the same wall each time, at places spread around it.")


def _across(axis: FloatArray) -> tuple[FloatArray, FloatArray]:
    u = np.cross(axis, np.eye(3)[int(np.abs(axis).argmin())])
    u = u / np.linalg.norm(u)
    return u, np.cross(axis, u)


def _centre(flat: FloatArray) -> FloatArray:
    """Return the centre of the circle through three points (3, 2)."""
    try:
        return np.linalg.solve(2 * (flat[1:] - flat[0]), np.sum(flat[1:] ** 2, axis=1) - np.sum(flat[0] ** 2))
    except np.linalg.LinAlgError:
        raise _no_wall() from None


def _fit_wall(points: MeasuredPoints, start: Feature, facing: float) -> Feature:
    """Fit the cylinder of a wall to the points near it; the clicks alone count where these are too few, or give another size."""
    assert start.direction is not None and start.radius_mm is not None
    along, off, outward = along_and_off(points.points_mm, start.point_mm, start.direction)
    near = (np.abs(along) < WALL_MM) & (np.abs(off - start.radius_mm) < max(LEAST_NEAR_MM, NEAR_WALL * start.radius_mm))
    near &= np.einsum("nd,nd->n", _normals(points), outward) * np.sign(facing) > 1 - UPRIGHT
    chosen = np.flatnonzero(near)
    if len(chosen) < LEAST_POINTS:
        return start
    try:
        found = fit("cylinder", points.points_mm[chosen[:: -(-len(chosen) // FIT_POINTS)]], start=start, robust=True)
    except FitError:
        return start
    assert found.direction is not None and found.radius_mm is not None
    is_other = abs(found.radius_mm / start.radius_mm - 1) > CHANGED or abs(found.direction @ start.direction) < 1 - CHANGED / 2
    if is_other:
        return start
    return found if found.direction @ start.direction > 0 else replace(found, direction=-found.direction)
