"""Orientation, location, run-out and profile (ISO 1101): zone widths relative to datums."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import PROFILES, DimensionProgram
from measureapp.errors import InspectionError
from measureapp.inspection.features.feature_errors import NOISE, STITCHING
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.propagation import propagate, propagate_with_surface
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.datums import datum_system, require_nominals
from measureapp.inspection.tolerances.form import assumed_view_spread, extract_cells, filter_words
from measureapp.inspection.tolerances.location import ends_of, evaluate_coaxiality, evaluate_position
from measureapp.inspection.tolerances.profiles import evaluate_profile
from measureapp.inspection.tolerances.run_out import evaluate_run_out
from measureapp.inspection.value import AXES, Value, combine_budgets, require_direction, require_feature, require_nominal

GREATEST_LEAN_DEG = 30.0
TINY = 1e-12


def evaluate_tolerance(
    described: DimensionProgram, found: FoundFeature, datums: tuple[FoundFeature, ...], settings: InspectionSettings
) -> Value:
    """Evaluate a geometrical tolerance: width of the zone that the feature requires.

    Raises
    ------
    InspectionError
        The datums do not fix the zone, the tolerance is not defined for the feature, or too little of it was measured.
    """
    kind = described.kind
    if kind in ("parallelism", "perpendicularity", "angularity"):
        return _orientation(kind, found, datums, settings)
    if kind == "position":
        return evaluate_position(described, found, datums, settings)
    if kind in ("concentricity", "coaxiality"):
        return evaluate_coaxiality(kind, found, datums[0])
    if kind in PROFILES:
        return evaluate_profile(described, found, datums, settings)
    return evaluate_run_out(kind, found, datums[0], settings)


def _orientation(kind: str, found: FoundFeature, datums: tuple[FoundFeature, ...], settings: InspectionSettings) -> Value:
    """Evaluate parallelism, perpendicularity or angularity: slab about the means of a plane, or zone of an associated axis."""
    feature = require_feature(found)
    if feature.shape not in ("plane", *AXES):
        raise InspectionError(f"{found.name} is a {feature.shape}: {kind} is defined for planes and axes")
    toward = exact_direction(kind, found, datums)
    apart = {STITCHING: assumed_view_spread(found, settings)}
    if feature.shape == "plane":
        cells = extract_cells(found, settings)
        width, budget = propagate_with_surface(
            lambda features, points_mm: float(np.ptp(points_mm @ toward(features))), (found, *datums), cells
        )
        return Value(width, combine_budgets(budget, {NOISE: cells.form_sigma_mm}, apart), filter_words(settings))
    length = float(np.ptp(ends_of(found, feature)))
    if length <= 0:
        raise InspectionError(f"{found.name} is a constructed feature without a length for its {kind}")

    def lean(features: Sequence[Feature]) -> float:
        return length * float(np.linalg.norm(np.cross(require_direction(features[0]), toward(features))))

    value, budget = propagate(lean, (found, *datums))
    return Value(value, combine_budgets(budget, apart), f"associated axis over {length:.1f} mm")


def exact_direction(kind: str, found: FoundFeature, datums: tuple[FoundFeature, ...]) -> Callable[[Sequence[Feature]], FloatArray]:
    """Return the function from feature and datums to the exact direction of the zone, in the frame of the points."""
    nominals = require_nominals(datums)
    measured = [require_feature(one) for one in datums]
    if len(datums) > 1:
        nominal = require_nominal(found)
        datum_system(nominals, measured).require_direction(nominal, found.name)
        return lambda features: datum_system(nominals, features[1:]).nominal_from_measured[:3, :3].T @ require_direction(nominal)
    angle = _exact_angle(kind, found, datums[0])

    def toward(features: Sequence[Feature]) -> FloatArray:
        """Return the direction at the exact angle to the datum that is closest to the feature."""
        own, datum = require_direction(features[0]), require_direction(features[1])
        across = own - (own @ datum) * datum
        side = across / max(float(np.linalg.norm(across)), TINY)
        nearest = np.cos(angle) * (np.sign(own @ datum) or 1.0) * datum if kind != "angularity" else np.cos(angle) * datum
        return np.asarray(nearest + np.sin(angle) * side)

    own = require_direction(require_feature(found))
    off = float(np.degrees(np.arccos(min(1.0, abs(float(own @ toward((require_feature(found), *measured))))))))
    if off > GREATEST_LEAN_DEG:
        raise InspectionError(f"{found.name} is {off:.0f}° from {kind} to {datums[0].name}: check the feature and its datum")
    return toward


def _exact_angle(kind: str, found: FoundFeature, datum: FoundFeature) -> float:
    """Return the angle (rad) between the directions of zone and datum: normals of planes, axes of round features."""
    if kind == "angularity":
        cosine = require_direction(require_nominal(found)) @ require_direction(require_nominal(datum))
        return float(np.arccos(np.clip(cosine, -1, 1)))
    same_kind = (require_feature(found).shape == "plane") == (require_feature(datum).shape == "plane")
    return 0.0 if same_kind == (kind == "parallelism") else np.pi / 2
