"""Features made from other features."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from measureapp.data.feature import Feature
from measureapp.data.inspection_program import ConstructedFeature, copy_names, indexed
from measureapp.inspection.features.found import Found

AXES = ("cylinder", "cone", "line")
LEAST_CROSSING_DEG = 5.0


def construct(described: ConstructedFeature, known: Mapping[str, Found]) -> Mapping[str, Found]:
    """Return the constructed feature, or each copy of its pattern, from features already found."""
    count = None if described.repeat is None else described.repeat.count
    names = copy_names(described.name, described.repeat)
    made = {}
    for k, name in enumerate(names, start=1):
        one, other = (known[needed] for needed in indexed(described.of, k, count))
        drawn = _construct_one(described.shape, name, _as_drawn(one), _as_drawn(other)).feature
        made[name] = replace(_construct_one(described.shape, name, one, other), nominal=drawn)
    return made


def _as_drawn(found: Found) -> Found:
    return Found(found.name, found.nominal, f"{found.name} has no place in the drawing")


def _construct_one(shape: str, name: str, one: Found, other: Found) -> Found:
    if one.feature is None or other.feature is None:
        return Found(name, None, one.reason or other.reason)
    if shape == "intersection":
        return _intersection(name, one, other)
    if shape == "projection":
        return _projection(name, one, other)
    first, second = one.feature, other.feature
    position = 0.5 * float(np.hypot(one.position_sigma, other.position_sigma))
    direction = first.direction
    if direction is not None and second.direction is not None:
        direction = direction + np.sign(direction @ second.direction or 1.0) * second.direction
        direction = direction / np.linalg.norm(direction)
    made = Feature(
        name,
        "plane" if shape == "midplane" else "point",
        (first.point_mm + second.point_mm) / 2,
        direction,
        points=first.points + second.points,
        standard_deviations={"position_mm": position, "direction_rad": 0.5 * float(np.hypot(one.direction_sigma, other.direction_sigma))},
    )
    if shape == "midplane" and direction is None:
        return Found(name, None, f"{name}: a mid-plane needs two planes, {one.name} and {other.name} are not")
    return Found(name, made, views=min(one.views, other.views))


def _intersection(name: str, one: Found, other: Found) -> Found:
    """Where an axis meets a plane (a point), or two planes meet (a line)."""
    first, second = one.feature, other.feature
    assert first is not None and second is not None
    if first.direction is None or second.direction is None or "plane" not in (first.shape, second.shape):
        return Found(name, None, f"{name}: an intersection needs a plane, and a plane or an axis")
    if first.shape == second.shape == "plane":
        return _line_of_planes(name, one, other)
    plane, axis = (first, second) if first.shape == "plane" else (second, first)
    assert plane.direction is not None and axis.direction is not None
    slope = float(plane.direction @ axis.direction)
    if abs(slope) < np.sin(np.radians(LEAST_CROSSING_DEG)):
        return Found(name, None, f"{name}: the axis runs parallel to the plane and does not meet it")
    point = axis.point_mm + float(plane.direction @ (plane.point_mm - axis.point_mm)) / slope * axis.direction
    sigma = float(np.hypot(one.position_sigma, other.position_sigma)) / abs(slope)
    return Found(
        name, Feature(name, "point", point, axis.direction, standard_deviations={"position_mm": sigma}), views=min(one.views, other.views)
    )


def _projection(name: str, one: Found, plane: Found) -> Found:
    """A centre or axis seen upright onto a plane: a point, or a line."""
    first, second = one.feature, plane.feature
    assert first is not None and second is not None
    if second.shape != "plane" or second.direction is None or first.shape == "plane":
        return Found(name, None, f"{name}: a projection needs a point or axis, and the plane it is projected onto")
    offset = first.point_mm - second.point_mm
    height = float(offset @ second.direction)
    lateral = float(np.linalg.norm(offset - height * second.direction))
    sigma = float(
        np.linalg.norm([one.position_sigma, plane.position_sigma, lateral * plane.direction_sigma, height * plane.direction_sigma])
    )
    deviations = {"position_mm": sigma}
    point, views = first.point_mm - height * second.direction, min(one.views, plane.views)
    if first.shape not in AXES or first.direction is None:
        return Found(name, Feature(name, "point", point, second.direction, standard_deviations=deviations), views=views)
    flat = first.direction - float(first.direction @ second.direction) * second.direction
    length = float(np.linalg.norm(flat))
    if length < np.sin(np.radians(LEAST_CROSSING_DEG)):
        return Found(
            name, None, f"{name}: the axis {one.name} stands upright on {plane.name}; its projection is a point, their intersection"
        )
    deviations["direction_rad"] = float(np.hypot(one.direction_sigma, plane.direction_sigma)) / length
    return Found(name, Feature(name, "line", point, flat / length, standard_deviations=deviations), views=views)


def _line_of_planes(name: str, one: Found, other: Found) -> Found:
    first, second = one.feature, other.feature
    assert first is not None and second is not None and first.direction is not None and second.direction is not None
    direction = np.cross(first.direction, second.direction)
    length = float(np.linalg.norm(direction))
    if length < np.sin(np.radians(LEAST_CROSSING_DEG)):
        return Found(name, None, f"{name}: the planes are parallel and do not meet")
    direction /= length
    middle = (first.point_mm + second.point_mm) / 2
    system = np.stack([first.direction, second.direction, direction])
    offsets = np.array([first.direction @ first.point_mm, second.direction @ second.point_mm, direction @ middle])
    sigma = float(np.hypot(one.position_sigma, other.position_sigma)) / length
    turn = float(np.hypot(one.direction_sigma, other.direction_sigma)) / length
    deviations = {"position_mm": sigma, "direction_rad": turn}
    made = Feature(name, "line", np.linalg.solve(system, offsets), direction, standard_deviations=deviations)
    return Found(name, made, views=min(one.views, other.views))
