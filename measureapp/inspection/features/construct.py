"""Constructed features: midpoint, mid-plane, intersection and projection."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from measureapp.data.feature import Feature
from measureapp.data.inspection_program import ConstructedFeature, copy_names, substitute_index
from measureapp.errors import InspectionError
from measureapp.inspection.features.feature_errors import Errors, propagate_construction
from measureapp.inspection.features.found_feature import FoundFeature

AXES = ("cylinder", "cone", "line")
LEAST_CROSSING_DEG = 5.0


def construct(described: ConstructedFeature, known: Mapping[str, FoundFeature]) -> Mapping[str, FoundFeature]:
    """Construct a feature, or each copy of its pattern, from features already found."""
    count = None if described.repeat is None else described.repeat.count
    names = copy_names(described.name, described.repeat)
    made = {}
    for k, name in enumerate(names, start=1):
        one, other = (known[needed] for needed in substitute_index(described.of, k, count))
        nominal = _construct_one(described.shape, name, _as_nominal(one), _as_nominal(other)).feature
        made[name] = replace(_construct_one(described.shape, name, one, other), nominal=nominal)
    return made


def _as_nominal(found: FoundFeature) -> FoundFeature:
    return FoundFeature(found.name, found.nominal, f"{found.name} has no nominal position")


def _construct_one(shape: str, name: str, one: FoundFeature, other: FoundFeature) -> FoundFeature:
    if one.feature is None or other.feature is None:
        return FoundFeature(name, None, one.reason or other.reason)
    parents = (one.feature, other.feature)
    make = partial(MAKERS[shape], name)
    try:
        made = make(parents)
    except InspectionError as error:
        return FoundFeature(name, None, error.message)
    errors = propagate_construction(make, parents, (one.errors, other.errors))
    known = replace(made, points=sum(parent.points for parent in parents), standard_deviations=_deviations(made, errors))
    return FoundFeature(
        name, known, views=min(one.views, other.views), view_contributions=errors, view_errors=one.view_errors or other.view_errors
    )


def _deviations(made: Feature, errors: Errors) -> dict[str, float]:
    """Return the standard deviations of position and direction, each in its worst direction."""
    columns = np.hstack(list(errors.values())) if errors else np.zeros((6, 1))
    position, direction = (float(np.linalg.norm(columns[rows], 2)) for rows in (slice(0, 3), slice(3, 6)))
    return {"position_mm": position} | ({} if made.direction is None else {"direction_rad": direction})


def _midpoint(name: str, of: Sequence[Feature]) -> Feature:
    first, second = of
    direction = first.direction
    if direction is not None and second.direction is not None:
        direction = direction + np.sign(direction @ second.direction or 1.0) * second.direction
        direction = direction / np.linalg.norm(direction)
    return Feature(name, "point", (first.point_mm + second.point_mm) / 2, direction)


def _midplane(name: str, of: Sequence[Feature]) -> Feature:
    made = _midpoint(name, of)
    if made.direction is None:
        raise InspectionError(f"{name}: a mid-plane needs two planes, {of[0].name} and {of[1].name} are not")
    return replace(made, shape="plane")


def _intersection(name: str, of: Sequence[Feature]) -> Feature:
    """Intersection of an axis and a plane (a point), or of two planes (a line)."""
    first, second = of
    if first.direction is None or second.direction is None or "plane" not in (first.shape, second.shape):
        raise InspectionError(f"{name}: an intersection needs a plane, and a plane or an axis")
    if first.shape == second.shape == "plane":
        return _line_of_planes(name, first, second)
    plane, axis = (first, second) if first.shape == "plane" else (second, first)
    assert plane.direction is not None and axis.direction is not None
    slope = float(plane.direction @ axis.direction)
    if abs(slope) < np.sin(np.radians(LEAST_CROSSING_DEG)):
        raise InspectionError(f"{name}: the axis runs parallel to the plane and does not meet it")
    point = axis.point_mm + float(plane.direction @ (plane.point_mm - axis.point_mm)) / slope * axis.direction
    return Feature(name, "point", point, axis.direction)


def _projection(name: str, of: Sequence[Feature]) -> Feature:
    """Orthogonal projection of a centre or axis onto a plane: a point, or a line."""
    first, second = of
    if second.shape != "plane" or second.direction is None or first.shape == "plane":
        raise InspectionError(f"{name}: a projection needs a point or axis, and the plane it is projected onto")
    point = first.point_mm - float((first.point_mm - second.point_mm) @ second.direction) * second.direction
    if first.shape not in AXES or first.direction is None:
        return Feature(name, "point", point, second.direction)
    flat = first.direction - float(first.direction @ second.direction) * second.direction
    length = float(np.linalg.norm(flat))
    if length < np.sin(np.radians(LEAST_CROSSING_DEG)):
        raise InspectionError(
            f"{name}: the axis {first.name} is perpendicular to {second.name}; its projection is a point: use their intersection"
        )
    return Feature(name, "line", point, flat / length)


def _line_of_planes(name: str, first: Feature, second: Feature) -> Feature:
    assert first.direction is not None and second.direction is not None
    direction = np.cross(first.direction, second.direction)
    length = float(np.linalg.norm(direction))
    if length < np.sin(np.radians(LEAST_CROSSING_DEG)):
        raise InspectionError(f"{name}: the planes are parallel and do not meet")
    direction /= length
    middle = (first.point_mm + second.point_mm) / 2
    system = np.stack([first.direction, second.direction, direction])
    offsets = np.array([first.direction @ first.point_mm, second.direction @ second.point_mm, direction @ middle])
    return Feature(name, "line", np.linalg.solve(system, offsets), direction)


MAKERS = {"midpoint": _midpoint, "midplane": _midplane, "intersection": _intersection, "projection": _projection}
