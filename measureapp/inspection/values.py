"""Values of sizes and between features: distance, thickness, step, diameter, radius, angles, each with its random uncertainty; the rest is sent on."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.blade_section import BLADE_KINDS
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import FORMS, ZONES, DimensionProgram
from measureapp.errors import InspectionError
from measureapp.inspection.blades.values import blade_value
from measureapp.inspection.features.found import Found
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.form import form_value
from measureapp.inspection.tolerances.zones import tolerance_value
from measureapp.inspection.value import AXES, CENTRES, Value, direction_of, feature_of, placement_of

OPPOSED_WITHIN_DEG = 15.0


def value_of(described: DimensionProgram, found: tuple[Found, ...], datums: tuple[Found, ...], settings: InspectionSettings) -> Value:
    """Return the value of one dimension from its features and datums.

    Raises
    ------
    InspectionError
        A feature was not found, or the value does not exist: planes that are not parallel have no distance.
    """
    for one in (*found, *datums):
        feature_of(one)
    kind = described.kind
    if kind in BLADE_KINDS:
        return blade_value(described, found, settings)
    if kind in ("diameter", "radius"):
        return _round(found[0], settings, 2.0 if kind == "diameter" else 1.0)
    if kind == "cone_angle":
        return _cone_angle(found[0])
    if kind in FORMS:
        return form_value(described, found[0], settings)
    if kind in ZONES:
        return tolerance_value(described, found[0], datums, settings)
    pair: dict[str, Callable[[Found, Found, InspectionSettings], Value]] = {
        "distance": _distance,
        "thickness": _thickness,
        "step": _step,
        "angle": _angle,
    }
    return pair[kind](found[0], found[1], settings)


def _round(found: Found, settings: InspectionSettings, factor: float) -> Value:
    feature = feature_of(found)
    if feature.radius_mm is None:
        raise InspectionError(f"{found.name} is a {feature.shape} and has no radius")
    return Value(factor * feature.radius_mm, factor * float(np.hypot(found.radius_sigma, placement_of(found, settings))))


def _cone_angle(found: Found) -> Value:
    """The angle between opposite lines of a cone (ISO 3040)."""
    feature = feature_of(found)
    if feature.half_angle_rad is None:
        raise InspectionError(f"{found.name} is a {feature.shape} and has no cone angle")
    return Value(float(np.degrees(2 * feature.half_angle_rad)), float(np.degrees(2 * found.half_angle_sigma)))


def _distance(one: Found, other: Found, settings: InspectionSettings) -> Value:
    first, second = feature_of(one), feature_of(other)
    if first.shape == "plane" and second.shape == "plane":
        return _between_planes(one, other, settings)
    if first.shape in CENTRES and second.shape in CENTRES:
        length = float(np.linalg.norm(first.point_mm - second.point_mm))
        return Value(length, _sigma(one, other, settings))
    if "plane" in (first.shape, second.shape):
        return _to_plane(one, other, settings) if second.shape == "plane" else _to_plane(other, one, settings)
    if first.shape in AXES and second.shape in AXES:
        _require_parallel(one, other, settings)
        length = (_off_axis(first.point_mm, second) + _off_axis(second.point_mm, first)) / 2
        return Value(length, _sigma(one, other, settings, _lever(first, second) / 2))
    axis, centre = (first, second) if first.shape in AXES else (second, first)
    lever = abs(float((centre.point_mm - axis.point_mm) @ direction_of(axis)))
    return Value(_off_axis(centre.point_mm, axis), _sigma(one, other, settings, lever))


def _between_planes(one: Found, other: Found, settings: InspectionSettings) -> Value:
    """From the centroid of each plane to the other along the mean normal."""
    _require_parallel(one, other, settings)
    first, second = feature_of(one), feature_of(other)
    normal = _mean_direction(first, second)
    offset = second.point_mm - first.point_mm
    length = abs(float(offset @ normal))
    lateral = float(np.linalg.norm(offset - (offset @ normal) * normal))
    return Value(length, _sigma(one, other, settings, lateral / 2))


def _to_plane(thing: Found, plane: Found, settings: InspectionSettings) -> Value:
    """From a centre, or from an axis that runs along the plane, to the plane."""
    feature, surface = feature_of(thing), feature_of(plane)
    normal = direction_of(surface)
    if feature.shape in AXES:
        lean = np.degrees(np.arcsin(min(1.0, abs(float(direction_of(feature) @ normal)))))
        if lean > settings.parallel_within_deg:
            raise InspectionError(f"{thing.name} is inclined by {lean:.1f}° to {plane.name}: they have no distance")
    offset = feature.point_mm - surface.point_mm
    lateral = float(np.linalg.norm(offset - (offset @ normal) * normal))
    return Value(abs(float(offset @ normal)), _sigma(thing, plane, settings, lateral))


def _thickness(one: Found, other: Found, settings: InspectionSettings) -> Value:
    """Between two opposite surface points or planes, along their mean normal."""
    first, second = feature_of(one), feature_of(other)
    if first.shape == second.shape == "plane":
        return _between_planes(one, other, settings)
    facing = np.degrees(np.arccos(np.clip(-float(direction_of(first) @ direction_of(second)), -1, 1)))
    if facing > OPPOSED_WITHIN_DEG:
        raise InspectionError(f"{one.name} and {other.name} do not lie opposite each other ({facing:.0f}° off): there is no thickness")
    normal = _mean_direction(first, second)
    return Value(abs(float((first.point_mm - second.point_mm) @ normal)), _sigma(one, other, settings))


def _step(one: Found, other: Found, settings: InspectionSettings) -> Value:
    """How much higher the second plane lies than the first, along the first's outward normal."""
    first, second = feature_of(one), feature_of(other)
    for found, feature in ((one, first), (other, second)):
        if feature.shape != "plane":
            raise InspectionError(f"{found.name} is a {feature.shape}: a step is defined between planes")
    length = _between_planes(one, other, settings)
    if direction_of(first) @ direction_of(second) < 0:
        raise InspectionError(f"{one.name} and {other.name} face away from each other: they have a distance, not a step")
    side = np.sign(direction_of(first) @ (second.point_mm - first.point_mm))
    return Value(float(side) * length.value, length.sigma)


def _angle(one: Found, other: Found, _: InspectionSettings) -> Value:
    """Between the directions as drawn: outward normals of planes, axes of cylinders and cones."""
    cosine = float(direction_of(feature_of(one)) @ direction_of(feature_of(other)))
    sigma = float(np.degrees(np.hypot(one.direction_sigma, other.direction_sigma)))
    return Value(float(np.degrees(np.arccos(np.clip(cosine, -1, 1)))), sigma)


def _sigma(one: Found, other: Found, settings: InspectionSettings, lever_mm: float = 0.0) -> float:
    terms = [one.position_sigma, other.position_sigma, placement_of(one, settings), placement_of(other, settings)]
    terms += [lever_mm * one.direction_sigma, lever_mm * other.direction_sigma]
    return float(np.linalg.norm(terms))


def _require_parallel(one: Found, other: Found, settings: InspectionSettings) -> None:
    cosine = abs(float(direction_of(feature_of(one)) @ direction_of(feature_of(other))))
    angle = float(np.degrees(np.arccos(min(1.0, cosine))))
    if angle > settings.parallel_within_deg:
        limit = settings.parallel_within_deg
        raise InspectionError(f"{one.name} and {other.name} are {angle:.1f}° from parallel (limit {limit:g}°): they have no distance")


def _mean_direction(first: Feature, second: Feature) -> FloatArray:
    one, other = direction_of(first), direction_of(second)
    mean = one + (1.0 if one @ other >= 0 else -1.0) * other
    return mean / np.linalg.norm(mean)


def _off_axis(point_mm: FloatArray, axis: Feature) -> float:
    return float(np.linalg.norm(np.cross(point_mm - axis.point_mm, direction_of(axis))))


def _lever(first: Feature, second: Feature) -> float:
    return abs(float((second.point_mm - first.point_mm) @ direction_of(first)))
