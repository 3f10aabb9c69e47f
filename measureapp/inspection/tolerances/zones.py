"""Orientation, location, run-out and profile (ISO 1101): the width of the zone about a feature, oriented and placed by its datums."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import PROFILES, DimensionProgram
from measureapp.errors import InspectionError
from measureapp.inspection.features.errors import NOISE, STITCHING
from measureapp.inspection.features.found import Found
from measureapp.inspection.propagation import propagated, propagated_on
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.datums import datum_system, nominals_of
from measureapp.inspection.tolerances.form import across_views, extracted, filter_words
from measureapp.inspection.tolerances.location import common_centre, ends_of, position
from measureapp.inspection.tolerances.profiles import profile_value
from measureapp.inspection.tolerances.run_out import run_out
from measureapp.inspection.value import AXES, Value, direction_of, feature_of, nominal_of, summed

GREATEST_LEAN_DEG = 30.0
TINY = 1e-12


def tolerance_value(described: DimensionProgram, found: Found, datums: tuple[Found, ...], settings: InspectionSettings) -> Value:
    """Return the width of the zone that one feature needs.

    Raises
    ------
    InspectionError
        The datums do not fix the zone, the feature has not this kind of tolerance, or too little of it was measured.
    """
    kind = described.kind
    if kind in ("parallelism", "perpendicularity", "angularity"):
        return _orientation(kind, found, datums, settings)
    if kind == "position":
        return position(described, found, datums, settings)
    if kind in ("concentricity", "coaxiality"):
        return common_centre(kind, found, datums[0])
    if kind in PROFILES:
        return profile_value(described, found, datums, settings)
    return run_out(kind, found, datums[0], settings)


def _orientation(kind: str, found: Found, datums: tuple[Found, ...], settings: InspectionSettings) -> Value:
    """Of a plane the distance of two planes about its means, of an axis the zone about its associated axis, both as the datums turn them."""
    feature = feature_of(found)
    if feature.shape not in ("plane", *AXES):
        raise InspectionError(f"{found.name} is a {feature.shape}: {kind} is defined for planes and axes")
    toward = _exact_direction(kind, found, datums)
    apart = {STITCHING: across_views(found, settings)}
    if feature.shape == "plane":
        cells = extracted(found, settings)
        width, budget = propagated_on(lambda features, points_mm: float(np.ptp(points_mm @ toward(features))), (found, *datums), cells)
        return Value(width, summed(budget, {NOISE: cells.form_sigma_mm}, apart), filter_words(settings))
    length = float(np.ptp(ends_of(found, feature)))
    if length <= 0:
        raise InspectionError(f"{found.name} was made from other features and has no length over which its {kind} could be taken")

    def lean(features: Sequence[Feature]) -> float:
        return length * float(np.linalg.norm(np.cross(direction_of(features[0]), toward(features))))

    value, budget = propagated(lean, (found, *datums))
    return Value(value, summed(budget, apart), f"associated axis over {length:.1f} mm")


def _exact_direction(kind: str, found: Found, datums: tuple[Found, ...]) -> Callable[[Sequence[Feature]], FloatArray]:
    """Return what gives the exact direction of the zone, in the frame of the points, from the feature and its datums."""
    drawn = nominals_of(datums)
    measured = [feature_of(one) for one in datums]
    if len(datums) > 1:
        nominal = nominal_of(found)
        datum_system(drawn, measured).require_direction(nominal, found.name)
        return lambda features: datum_system(drawn, features[1:]).nominal_from_measured[:3, :3].T @ direction_of(nominal)
    angle = _exact_angle(kind, found, datums[0])

    def toward(features: Sequence[Feature]) -> FloatArray:
        """Of all directions at the exact angle to the datum the one nearest the feature: the datum leaves the others open."""
        own, datum = direction_of(features[0]), direction_of(features[1])
        across = own - (own @ datum) * datum
        side = across / max(float(np.linalg.norm(across)), TINY)
        nearest = np.cos(angle) * (np.sign(own @ datum) or 1.0) * datum if kind != "angularity" else np.cos(angle) * datum
        return np.asarray(nearest + np.sin(angle) * side)

    own = direction_of(feature_of(found))
    off = float(np.degrees(np.arccos(min(1.0, abs(float(own @ toward((feature_of(found), *measured))))))))
    if off > GREATEST_LEAN_DEG:
        raise InspectionError(f"{found.name} is {off:.0f}° from where {kind} to {datums[0].name} would have it: it is not meant so")
    return toward


def _exact_angle(kind: str, found: Found, datum: Found) -> float:
    """Angle in rad between the direction of the zone and that of the datum: normals of planes, axes of what is round."""
    if kind == "angularity":
        cosine = direction_of(nominal_of(found)) @ direction_of(nominal_of(datum))
        return float(np.arccos(np.clip(cosine, -1, 1)))
    alike = (feature_of(found).shape == "plane") == (feature_of(datum).shape == "plane")
    return 0.0 if alike == (kind == "parallelism") else np.pi / 2
