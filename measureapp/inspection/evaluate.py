"""Evaluation of dimensions: sizes and distances here, form, tolerances and blades in their own modules."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.blade_section import BLADE_KINDS
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import FORMS, ZONES, DimensionProgram
from measureapp.errors import InspectionError
from measureapp.inspection.blades.values import evaluate_blade
from measureapp.inspection.certified_lengths import CertifiedLengths, Measure
from measureapp.inspection.features.feature_errors import NOISE
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.form import evaluate_form
from measureapp.inspection.tolerances.zones import evaluate_tolerance
from measureapp.inspection.value import AXES, CENTRES, Value, require_direction, require_feature

OPPOSED_WITHIN_DEG = 15.0


def evaluate_dimension(
    described: DimensionProgram,
    found: tuple[FoundFeature, ...],
    datums: tuple[FoundFeature, ...],
    settings: InspectionSettings,
    certified: CertifiedLengths = CertifiedLengths(),  # noqa: B008 - frozen
) -> Value:
    """Evaluate one dimension from its features and datums; lengths are corrected by the certified ones.

    Raises
    ------
    InspectionError
        A feature was not found, or the value does not exist: planes that are not parallel have no distance.
    """
    for one in (*found, *datums):
        require_feature(one)
    kind = described.kind
    if kind in BLADE_KINDS:
        return evaluate_blade(described, found, settings)
    if kind in FORMS:
        return evaluate_form(described, found[0], settings)
    if kind in ZONES:
        return evaluate_tolerance(described, found[0], datums, settings)
    measure = measure_of(kind, found, settings)
    if kind in SIZES and found[0].draws:  # the simulated fits describe the size better than the covariance, by which lengths are corrected
        plain = CertifiedLengths().value(measure, found)
        return replace(plain, budget={**plain.budget, NOISE: _size_noise(kind, found[0])})
    return (certified if described.unit == "mm" else CertifiedLengths()).value(measure, found)


def evaluate_pattern_mean(
    described: DimensionProgram,
    sets: Sequence[tuple[FoundFeature, ...]],
    settings: InspectionSettings,
    certified: CertifiedLengths = CertifiedLengths(),  # noqa: B008 - frozen
) -> Value | None:
    """Return the mean over the copies of a pattern with correlated errors; None for kinds that are not a function of features alone."""
    if described.kind not in {*SIZES, *PAIRS} or any(one.draws for found in sets for one in found):
        return None
    measures = [measure_of(described.kind, found, settings) for found in sets]
    ends = np.cumsum([0, *map(len, sets)])

    def mean(features: Sequence[Feature]) -> float:
        return float(np.mean([measure(features[ends[i] : ends[i + 1]]) for i, measure in enumerate(measures)]))

    return (certified if described.unit == "mm" else CertifiedLengths()).value(mean, [one for found in sets for one in found])


def evaluate_nominal(described: DimensionProgram, nominals: Mapping[str, Feature], settings: InspectionSettings) -> float:
    """Return the value of a size on the nominal features, the mean over the copies of a pattern.

    Raises
    ------
    InspectionError
        The kind is not a function of nominal features, one of them has no nominal position, or the value does not exist.
    """
    if described.kind not in {*SIZES, *PAIRS}:
        raise InspectionError(f"the nominal of a {described.kind.replace('_', ' ')} does not follow from features")
    values = []
    for names in described.feature_sets:
        for name in names:
            if name not in nominals:
                raise InspectionError(f"{name} has no nominal position")
        found = [FoundFeature(name, nominals[name]) for name in names]
        values.append(measure_of(described.kind, found, settings)([nominals[name] for name in names]))
    return float(np.mean(values))


def measure_of(kind: str, found: Sequence[FoundFeature], settings: InspectionSettings) -> Measure:
    """Return the function from features to the value. Raises InspectionError if it is undefined for these features."""
    if kind in SIZES:
        return SIZES[kind](require_feature(found[0]))
    return PAIRS[kind](require_feature(found[0]), require_feature(found[1]), settings)


def _size_noise(kind: str, found: FoundFeature) -> float:
    if kind == "cone_angle":
        return float(np.degrees(2 * found.half_angle_sigma))
    return (2.0 if kind == "diameter" else 1.0) * found.radius_sigma


def _diameter(feature: Feature) -> Measure:
    _radius(feature)
    return lambda features: 2 * (features[0].radius_mm or 0.0)


def _radius(feature: Feature) -> Measure:
    if feature.radius_mm is None or feature.shape == "slot":
        raise InspectionError(f"{feature.name} is a {feature.shape} and has no radius")
    return lambda features: features[0].radius_mm or 0.0


def _cone_angle(feature: Feature) -> Measure:
    """The angle between opposite lines of a cone (ISO 3040)."""
    if feature.half_angle_rad is None:
        raise InspectionError(f"{feature.name} is a {feature.shape} and has no cone angle")
    return lambda features: float(np.degrees(2 * (features[0].half_angle_rad or 0.0)))


def _slot_size(name: str) -> Callable[[Feature], Measure]:
    def measure(feature: Feature) -> Measure:
        if feature.shape != "slot":
            raise InspectionError(f"{feature.name} is a {feature.shape} and has no slot {name}")
        if name == "width":
            return lambda features: 2 * (features[0].radius_mm or 0.0)
        return lambda features: features[0].length_mm or 0.0

    return measure


def _distance(first: Feature, second: Feature, settings: InspectionSettings) -> Measure:
    if first.shape == "plane" and second.shape == "plane":
        return _between_planes(first, second, settings)
    if first.shape in CENTRES and second.shape in CENTRES:
        return lambda of: float(np.linalg.norm(of[0].point_mm - of[1].point_mm))
    if "plane" in (first.shape, second.shape):
        return _to_plane(first, second, 1 if second.shape == "plane" else 0, settings)
    if first.shape in AXES and second.shape in AXES:
        _require_parallel(first, second, settings)
        return lambda of: (_off_axis(of[0].point_mm, of[1]) + _off_axis(of[1].point_mm, of[0])) / 2
    axis = 0 if first.shape in AXES else 1
    return lambda of: _off_axis(of[1 - axis].point_mm, of[axis])


def _between_planes(first: Feature, second: Feature, settings: InspectionSettings) -> Measure:
    """Distance of the centroids of two planes along their mean normal."""
    _require_parallel(first, second, settings)
    return lambda of: abs(float((of[1].point_mm - of[0].point_mm) @ _mean_direction(of[0], of[1])))


def _to_plane(first: Feature, second: Feature, plane: int, settings: InspectionSettings) -> Measure:
    """Distance of a centre, or of an axis parallel to the plane, from the plane."""
    thing, surface = (second, first) if plane == 0 else (first, second)
    normal = require_direction(surface)
    if thing.shape in AXES:
        lean = np.degrees(np.arcsin(min(1.0, abs(float(require_direction(thing) @ normal)))))
        if lean > settings.parallel_within_deg:
            raise InspectionError(f"{thing.name} is inclined by {lean:.1f}° to {surface.name}: their distance is undefined")
    return lambda of: abs(float((of[1 - plane].point_mm - of[plane].point_mm) @ require_direction(of[plane])))


def _thickness(first: Feature, second: Feature, settings: InspectionSettings) -> Measure:
    """Thickness between two opposite surface points or planes, along their mean normal."""
    if first.shape == second.shape == "plane":
        return _between_planes(first, second, settings)
    facing = np.degrees(np.arccos(np.clip(-float(require_direction(first) @ require_direction(second)), -1, 1)))
    if facing > OPPOSED_WITHIN_DEG:
        raise InspectionError(
            f"{first.name} and {second.name} do not face opposite directions ({facing:.0f}° off): their thickness is undefined"
        )
    return lambda of: abs(float((of[0].point_mm - of[1].point_mm) @ _mean_direction(of[0], of[1])))


def _step(first: Feature, second: Feature, settings: InspectionSettings) -> Measure:
    """Height of the second plane above the first, along the first's outward normal."""
    for feature in (first, second):
        if feature.shape != "plane":
            raise InspectionError(f"{feature.name} is a {feature.shape}: a step is defined between planes")
    _require_parallel(first, second, settings)
    if require_direction(first) @ require_direction(second) < 0:
        raise InspectionError(f"{first.name} and {second.name} face opposite directions: measure a distance, not a step")
    return lambda of: float((of[1].point_mm - of[0].point_mm) @ _mean_direction(of[0], of[1]))


def _angle(first: Feature, second: Feature, _: InspectionSettings) -> Measure:
    """Angle between nominal senses of direction: outward normals of planes, axes of cylinders and cones."""
    for feature in (first, second):
        require_direction(feature)
    return lambda of: float(np.degrees(np.arccos(np.clip(require_direction(of[0]) @ require_direction(of[1]), -1, 1))))


def _require_parallel(first: Feature, second: Feature, settings: InspectionSettings) -> None:
    cosine = abs(float(require_direction(first) @ require_direction(second)))
    angle = float(np.degrees(np.arccos(min(1.0, cosine))))
    if angle > settings.parallel_within_deg:
        limit = settings.parallel_within_deg
        raise InspectionError(
            f"{first.name} and {second.name} are {angle:.1f}° from parallel (limit {limit:g}°): their distance is undefined"
        )


def _mean_direction(first: Feature, second: Feature) -> FloatArray:
    one, other = require_direction(first), require_direction(second)
    mean = one + (1.0 if one @ other >= 0 else -1.0) * other
    return mean / np.linalg.norm(mean)


def _off_axis(point_mm: FloatArray, axis: Feature) -> float:
    return float(np.linalg.norm(np.cross(point_mm - axis.point_mm, require_direction(axis))))


SIZES: dict[str, Callable[[Feature], Measure]] = {
    "diameter": _diameter,
    "radius": _radius,
    "cone_angle": _cone_angle,
    "slot_width": _slot_size("width"),
    "slot_length": _slot_size("length"),
}
PAIRS: dict[str, Callable[[Feature, Feature, InspectionSettings], Measure]] = {
    "distance": _distance,
    "thickness": _thickness,
    "step": _step,
    "angle": _angle,
}
