"""Values between features: distance, thickness, diameter, radius, angle, flatness, each with its random uncertainty."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import DimensionKind
from measureapp.errors import InspectionError
from measureapp.inspection.features import Found
from measureapp.inspection.settings import InspectionSettings

AXES = ("cylinder", "cone", "line")
CENTRES = ("point", "sphere", "circle", "torus")
OPPOSED_WITHIN_DEG = 15.0
LEAST_CELLS = 12


@dataclass(frozen=True, slots=True)
class Value:
    """A value in mm (angles: degrees) and the standard uncertainty of its random part."""

    value: float
    sigma: float


def value_of(kind: DimensionKind, found: tuple[Found, ...], settings: InspectionSettings) -> Value:
    """Return the value of one dimension from its features.

    Raises
    ------
    InspectionError
        A feature was not found, or the value does not exist: planes that are not parallel have no distance.
    """
    for one in found:
        if one.feature is None:
            raise InspectionError(one.reason)
    if kind in ("diameter", "radius"):
        return _round(found[0], settings, 2.0 if kind == "diameter" else 1.0)
    if kind == "flatness":
        return _flatness(found[0], settings)
    pair: dict[str, Callable[[Found, Found, InspectionSettings], Value]] = {
        "distance": _distance,
        "thickness": _thickness,
        "angle": _angle,
    }
    return pair[kind](found[0], found[1], settings)


def _round(found: Found, settings: InspectionSettings, factor: float) -> Value:
    feature = _feature(found)
    if feature.radius_mm is None:
        raise InspectionError(f"{found.name} is a {feature.shape} and has no radius")
    return Value(factor * feature.radius_mm, factor * float(np.hypot(found.radius_sigma, _placement(found, settings))))


def _distance(one: Found, other: Found, settings: InspectionSettings) -> Value:
    first, second = _feature(one), _feature(other)
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
    lever = abs(float((centre.point_mm - axis.point_mm) @ _direction(axis)))
    return Value(_off_axis(centre.point_mm, axis), _sigma(one, other, settings, lever))


def _between_planes(one: Found, other: Found, settings: InspectionSettings) -> Value:
    """From the centroid of each plane to the other along the mean normal."""
    _require_parallel(one, other, settings)
    first, second = _feature(one), _feature(other)
    normal = _mean_direction(first, second)
    offset = second.point_mm - first.point_mm
    length = abs(float(offset @ normal))
    lateral = float(np.linalg.norm(offset - (offset @ normal) * normal))
    return Value(length, _sigma(one, other, settings, lateral / 2))


def _to_plane(thing: Found, plane: Found, settings: InspectionSettings) -> Value:
    """From a centre, or from an axis that runs along the plane, to the plane."""
    feature, surface = _feature(thing), _feature(plane)
    normal = _direction(surface)
    if feature.shape in AXES:
        lean = np.degrees(np.arcsin(min(1.0, abs(float(_direction(feature) @ normal)))))
        if lean > settings.parallel_within_deg:
            raise InspectionError(f"{thing.name} is inclined by {lean:.1f}° to {plane.name}: they have no distance")
    offset = feature.point_mm - surface.point_mm
    lateral = float(np.linalg.norm(offset - (offset @ normal) * normal))
    return Value(abs(float(offset @ normal)), _sigma(thing, plane, settings, lateral))


def _thickness(one: Found, other: Found, settings: InspectionSettings) -> Value:
    """Between two opposite surface points or planes, along their mean normal."""
    first, second = _feature(one), _feature(other)
    if first.shape == second.shape == "plane":
        return _between_planes(one, other, settings)
    facing = np.degrees(np.arccos(np.clip(-float(_direction(first) @ _direction(second)), -1, 1)))
    if facing > OPPOSED_WITHIN_DEG:
        raise InspectionError(f"{one.name} and {other.name} do not lie opposite each other ({facing:.0f}° off): there is no thickness")
    normal = _mean_direction(first, second)
    return Value(abs(float((first.point_mm - second.point_mm) @ normal)), _sigma(one, other, settings))


def _angle(one: Found, other: Found, _: InspectionSettings) -> Value:
    """Between the directions as drawn: outward normals of planes, axes of cylinders and cones."""
    cosine = float(_direction(_feature(one)) @ _direction(_feature(other)))
    sigma = float(np.degrees(np.hypot(one.direction_sigma, other.direction_sigma)))
    return Value(float(np.degrees(np.arccos(np.clip(cosine, -1, 1)))), sigma)


def _flatness(found: Found, settings: InspectionSettings) -> Value:
    """Range of the means of cells about their plane; cells with few points do not count.

    Means of cells, because the range of single noisy points grows with their number and says nothing of the part.
    """
    feature = _feature(found)
    if feature.shape != "plane":
        raise InspectionError(f"{found.name} is a {feature.shape}: flatness is defined for planes")
    means, spread = _cell_means(found.points_mm, feature, settings.flatness_cell_mm)
    if len(means) < LEAST_CELLS:
        raise InspectionError(f"{found.name}: its points fill only {len(means)} cells of {settings.flatness_cell_mm:g} mm")
    return Value(float(np.ptp(means)), float(np.sqrt(2.0) * spread))


def _cell_means(points_mm: FloatArray, plane: Feature, cell_mm: float) -> tuple[FloatArray, float]:
    """Mean distance of each well-filled cell from the cells' own plane, and the typical standard deviation of such a mean."""
    normal = _direction(plane)
    first = np.cross(normal, np.eye(3)[np.abs(normal).argmin()])
    first /= np.linalg.norm(first)
    offset = points_mm - plane.point_mm
    uv = np.column_stack([offset @ first, offset @ np.cross(normal, first)])
    height = offset @ normal
    index = np.floor(uv / cell_mm).astype(np.int64)
    _, cell = np.unique(index - index.min(axis=0), axis=0, return_inverse=True)
    cell = cell.ravel()
    counts = np.bincount(cell)
    full = counts >= max(5, 0.25 * float(np.median(counts)))
    mean = np.bincount(cell, weights=height)[full] / counts[full]
    design = np.column_stack([np.bincount(cell, weights=uv[:, k])[full] / counts[full] for k in (0, 1)] + [np.ones(full.sum())])
    mean = mean - design @ np.linalg.lstsq(design, mean, rcond=None)[0]
    return mean, float(plane.rms_mm / np.sqrt(np.median(counts[full]))) if full.any() else 0.0


def _sigma(one: Found, other: Found, settings: InspectionSettings, lever_mm: float = 0.0) -> float:
    terms = [one.position_sigma, other.position_sigma, _placement(one, settings), _placement(other, settings)]
    terms += [lever_mm * one.direction_sigma, lever_mm * other.direction_sigma]
    return float(np.linalg.norm(terms))


def _placement(found: Found, settings: InspectionSettings) -> float:
    return float(settings.uncertainty.placement_mm / np.sqrt(max(found.views, 1.0)))


def _require_parallel(one: Found, other: Found, settings: InspectionSettings) -> None:
    cosine = abs(float(_direction(_feature(one)) @ _direction(_feature(other))))
    angle = float(np.degrees(np.arccos(min(1.0, cosine))))
    if angle > settings.parallel_within_deg:
        limit = settings.parallel_within_deg
        raise InspectionError(f"{one.name} and {other.name} are {angle:.1f}° from parallel (limit {limit:g}°): they have no distance")


def _mean_direction(first: Feature, second: Feature) -> FloatArray:
    one, other = _direction(first), _direction(second)
    mean = one + (1.0 if one @ other >= 0 else -1.0) * other
    return mean / np.linalg.norm(mean)


def _off_axis(point_mm: FloatArray, axis: Feature) -> float:
    return float(np.linalg.norm(np.cross(point_mm - axis.point_mm, _direction(axis))))


def _lever(first: Feature, second: Feature) -> float:
    return abs(float((second.point_mm - first.point_mm) @ _direction(first)))


def _feature(found: Found) -> Feature:
    if found.feature is None:
        raise InspectionError(found.reason)
    return found.feature


def _direction(feature: Feature) -> FloatArray:
    if feature.direction is None:
        raise InspectionError(f"{feature.name} is a {feature.shape} and has no direction")
    return feature.direction
