"""Location (ISO 1101): position, coaxiality and concentricity."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import DimensionProgram
from measureapp.errors import InspectionError
from measureapp.inspection.features.feature_errors import NOISE
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.propagation import propagate
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.datum_shift import Play, find_plays, perpendicular_part, shift_datum_system
from measureapp.inspection.tolerances.datums import DatumSystem, datum_system, require_nominals
from measureapp.inspection.tolerances.form import extract_cells
from measureapp.inspection.tolerances.material import WORDS, compute_bonus
from measureapp.inspection.tolerances.profiles import evaluate_surface_zone
from measureapp.inspection.value import AXES, CENTRES, Value, combine_budgets, require_direction, require_feature, require_nominal

FLAT = ("circle", "slot")  # located in their plane only
Width = Callable[[Sequence[Feature]], float]


def evaluate_position(
    described: DimensionProgram, found: FoundFeature, datums: tuple[FoundFeature, ...], settings: InspectionSettings
) -> Value:
    """Evaluate position: width of the zone about the nominal location (sphere for a centre, cylinder for an axis, slab for a plane).

    Raises
    ------
    InspectionError
        The datums do not fix the location, the feature has no position, or a material condition is required of a feature without size.
    """
    feature, nominal, nominals = require_feature(found), require_nominal(found), require_nominals(datums)
    datum_system(nominals, [require_feature(one) for one in datums]).require_location(nominal, found.name)
    if feature.shape == "plane" and not described.datum_material:
        return evaluate_surface_zone(found, datums, extract_cells(found, settings), settings)
    if feature.shape not in (*AXES, *CENTRES):
        shapes = "axes and centres where a datum has a material condition" if described.datum_material else "planes, axes and centres"
        raise InspectionError(f"{found.name} is a {feature.shape}: position is defined for {shapes}")
    zone = _Zone(
        nominal, nominals, ends_of(found, feature), find_plays(described.datum_material, described.datums, datums, nominals, settings)
    )
    made = _add_material_bonus(described, zone.width, found, datums, settings, _describe(feature, zone.ends_mm))
    return zone.with_shift(made, [feature, *(require_feature(one) for one in datums)])


class _Zone:
    """Zone of an axis or a centre about its nominal location, relative to datums with shift."""

    def __init__(self, nominal: Feature, nominals: Sequence[Feature], ends_mm: FloatArray, plays: tuple[Play, ...]) -> None:
        self.nominal, self.nominals, self.ends_mm, self.plays = nominal, nominals, ends_mm, plays

    def width(self, features: Sequence[Feature], more_mm: float = 0.0) -> float:
        """Return the width of the required zone at the best datum shift."""
        points = points_of(features[0], self.ends_mm)
        system = shift_datum_system(self.nominals, features[1:], self.plays, lambda made: self._offsets(made, points), more_mm)
        return self._width(system, points)

    def with_shift(self, made: Value, features: Sequence[Feature]) -> Value:
        """Return the value with the datum shift described, and its uncertainty by noise added."""
        if not self.plays:
            return made
        noise = float(np.linalg.norm([play.noise_mm for play in self.plays]))
        best = self.width(features)
        change = max(abs(self.width(features, sign * noise) - best) for sign in (1.0, -1.0))
        unshifted = self._width(datum_system(self.nominals, features[1:]), points_of(features[0], self.ends_mm))
        sizes = ", ".join(f"{play.nominal.name} play {2 * play.radius_mm(features[1 + play.number]):.4f} mm" for play in self.plays)
        words = (made.how, f"datum shift: {sizes}, {unshifted:.4f} mm without shift")
        return Value(made.value, combine_budgets(made.budget, {NOISE: change}), "; ".join(words), made.bonus)

    def _width(self, system: DatumSystem, points_mm: FloatArray) -> float:
        return 2 * float(np.linalg.norm(self._offsets(system, points_mm), axis=1).max())

    def _offsets(self, system: DatumSystem, points_mm: FloatArray) -> FloatArray:
        away = system.apply(points_mm) - self.nominal.point_mm
        return perpendicular_part(away, _plane_normal(self.nominal)) if self.nominal.shape in (*AXES, *FLAT) else away


def _plane_normal(feature: Feature) -> FloatArray:
    """Return the direction across which a feature is located: its axis, or the normal of the plane of a circle or slot."""
    normal = feature.normal if feature.shape == "slot" else None
    return require_direction(feature) if normal is None else normal


def _add_material_bonus(
    described: DimensionProgram, width: Width, found: FoundFeature, datums: tuple[FoundFeature, ...], settings: InspectionSettings, how: str
) -> Value:
    """Return the width with the bonus tolerance of the feature's own size."""
    if described.size_limits_mm is None or described.material_condition == "regardless":
        return evaluate_width(width, found, datums, how)
    bonus, noise = compute_bonus(described.material_condition, described.size_limits_mm, found, settings)
    left = evaluate_width(lambda features: width(features) - bonus(features[0]), found, datums, how)
    gained = bonus(require_feature(found))
    words = (how, f"{WORDS[described.material_condition]}: {gained:.4f} mm bonus on {described.upper_tolerance:g} mm")
    return Value(left.value + gained, combine_budgets(left.budget, {NOISE: noise}), "; ".join(words), gained)


def _describe(feature: Feature, ends_mm: FloatArray) -> str:
    return "associated centre" if feature.shape in CENTRES else f"associated axis over {float(np.ptp(ends_mm)):.1f} mm"


def evaluate_coaxiality(kind: str, found: FoundFeature, datum: FoundFeature) -> Value:
    """Evaluate coaxiality or concentricity: twice the greatest distance of an axis or a centre from the datum's axis or centre.

    Raises
    ------
    InspectionError
        The feature or its datum has no axis or centre.
    """
    feature, base = require_feature(found), require_feature(datum)
    wanted = AXES if kind == "coaxiality" else CENTRES
    if feature.shape not in wanted:
        raise InspectionError(f"{found.name} is a {feature.shape}: {kind} is defined for {'axes' if kind == 'coaxiality' else 'centres'}")
    if base.shape not in (*AXES, *(CENTRES if kind == "concentricity" else ())):
        raise InspectionError(f"{datum.name} is a {base.shape}, which cannot be a datum for {kind}")
    ends = ends_of(found, feature)

    def width(features: Sequence[Feature]) -> float:
        away: FloatArray = points_of(features[0], ends) - features[1].point_mm
        if base.shape in AXES:
            away = perpendicular_part(away, require_direction(features[1]))
        elif feature.shape in FLAT:
            away = perpendicular_part(away, _plane_normal(feature))
        return 2 * float(np.linalg.norm(away, axis=1).max())

    return evaluate_width(width, found, (datum,), _describe(feature, ends))


def evaluate_width(width: Width, found: FoundFeature, datums: tuple[FoundFeature, ...], how: str) -> Value:
    """Return the width with its uncertainty from the errors of the feature and its datums."""
    return Value(*propagate(width, (found, *datums)), how)


def ends_of(found: FoundFeature, feature: Feature) -> FloatArray:
    """Return the axial range (2,) of the measured part of an axis; zero (1,) for a centre or a constructed axis."""
    if feature.shape in CENTRES or feature.direction is None or len(found.points_mm) == 0:
        return np.zeros(1)
    along = (found.points_mm - feature.point_mm) @ feature.direction
    return np.array([along.min(), along.max()])


def points_of(feature: Feature, ends: FloatArray) -> FloatArray:
    """Return the end points (N, 3) of an axis, or the centre."""
    if feature.direction is None:
        return np.asarray(feature.point_mm)[None]
    return feature.point_mm + ends[:, None] * feature.direction
