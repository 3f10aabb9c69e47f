"""Orientation, location, run-out and profile (ISO 1101): the width of the zone about a feature, oriented and placed by its datums."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import PROFILES, DimensionProgram, Section
from measureapp.errors import InspectionError
from measureapp.inspection.features.cells import Cells, cell_means, surface_keys
from measureapp.inspection.features.errors import NOISE, STITCHING
from measureapp.inspection.features.found import Found
from measureapp.inspection.features.shapes import signed_distances
from measureapp.inspection.propagation import propagated, propagated_on
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.datums import DatumSystem, datum_system, nominals_of
from measureapp.inspection.tolerances.form import across_views, extracted, filter_words
from measureapp.inspection.tolerances.material import WORDS, bonus_of
from measureapp.inspection.tolerances.run_out import run_out
from measureapp.inspection.value import AXES, CENTRES, Value, direction_of, feature_of, nominal_of, placement_of, summed

GREATEST_LEAN_DEG = 30.0
TINY = 1e-12
NO_DATUM = DatumSystem((), np.eye(4), np.empty((6, 0)))


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
        return _position(described, found, datums, settings)
    if kind in ("concentricity", "coaxiality"):
        return _common_centre(kind, found, datums[0])
    if kind in PROFILES:
        return _profile(described, found, datums, settings)
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
    length = float(np.ptp(_ends(found, feature)))
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


def _position(described: DimensionProgram, found: Found, datums: tuple[Found, ...], settings: InspectionSettings) -> Value:
    """Width of the zone about the exact place: of a sphere for a centre, a cylinder for an axis, two planes for a plane."""
    feature, nominal, drawn = feature_of(found), nominal_of(found), nominals_of(datums)
    datum_system(drawn, [feature_of(one) for one in datums]).require_place(nominal, found.name)
    if feature.shape == "plane":
        return _surface_value(found, datums, extracted(found, settings), settings)
    if feature.shape not in (*AXES, *CENTRES):
        raise InspectionError(f"{found.name} is a {feature.shape}: position is defined for planes, axes and centres")
    ends = _ends(found, feature)

    def width(features: Sequence[Feature]) -> float:
        placed = datum_system(drawn, features[1:]).apply(_points_of(features[0], ends))
        away = placed - nominal.point_mm
        if feature.shape in AXES:
            axis = direction_of(nominal)
            away = away - np.outer(away @ axis, axis)
        return 2 * float(np.linalg.norm(away, axis=1).max())

    how = "associated centre" if feature.shape in CENTRES else f"associated axis over {float(np.ptp(ends)):.1f} mm"
    if described.material_condition == "regardless":
        return _placed_value(width, found, datums, how)
    bonus, noise = bonus_of(described, found, settings)
    left = _placed_value(lambda features: width(features) - bonus(features[0]), found, datums, how)
    gained = bonus(feature)
    words = f"{how}; {WORDS[described.material_condition]}: {gained:.4f} mm more than {described.upper_tolerance:g} mm"
    return Value(left.value + gained, summed(left.budget, {NOISE: noise}), words, gained)


def _common_centre(kind: str, found: Found, datum: Found) -> Value:
    """Twice the greatest distance of an axis (coaxiality) or a centre (concentricity) from the datum's axis or centre."""
    feature, base = feature_of(found), feature_of(datum)
    wanted = AXES if kind == "coaxiality" else CENTRES
    if feature.shape not in wanted:
        raise InspectionError(f"{found.name} is a {feature.shape}: {kind} is defined for {'axes' if kind == 'coaxiality' else 'centres'}")
    if base.shape not in (*AXES, *(CENTRES if kind == "concentricity" else ())):
        raise InspectionError(f"{datum.name} is a {base.shape} and no datum for {kind}")
    ends = _ends(found, feature)

    def width(features: Sequence[Feature]) -> float:
        away = _points_of(features[0], ends) - features[1].point_mm
        if base.shape in AXES:
            axis = direction_of(features[1])
            away = away - np.outer(away @ axis, axis)
        return 2 * float(np.linalg.norm(away, axis=1).max())

    how = "associated centre" if kind == "concentricity" else f"associated axis over {float(np.ptp(ends)):.1f} mm"
    return _placed_value(width, found, (datum,), how)


def _profile(described: DimensionProgram, found: Found, datums: tuple[Found, ...], settings: InspectionSettings) -> Value:
    """Twice the greatest distance of the means from the drawing's surface: all of it, or where a plane cuts it."""
    if datums:
        datum_system(nominals_of(datums), [feature_of(one) for one in datums]).require_place(nominal_of(found), found.name)
    cells = extracted(found, settings) if described.section is None else _cut(found, described.section, settings)
    made = _surface_value(found, datums, cells, settings)
    return made if datums else Value(made.value, made.budget, f"{made.how}, placed by the alignment")


def _surface_value(found: Found, datums: tuple[Found, ...], cells: Cells, settings: InspectionSettings) -> Value:
    nominal = nominal_of(found)
    if feature_of(found).shape not in ("plane", "cylinder", "cone", "sphere"):
        raise InspectionError(f"{found.name} is a {feature_of(found).shape}: it has no surface that the drawing places")
    drawn = nominals_of(datums)

    def width(features: Sequence[Feature], points_mm: FloatArray) -> float:
        system = datum_system(drawn, features) if datums else NO_DATUM
        return 2 * float(np.abs(signed_distances(nominal, system.apply(points_mm))).max())

    value, budget = propagated_on(width, datums, cells)
    # the greatest distance is off by no more than the greatest noise, the width by twice that
    own = {NOISE: 2 * cells.form_sigma_mm, STITCHING: 2 * placement_of(found, settings)}
    return Value(value, summed(budget, own), filter_words(settings))


def _cut(found: Found, section: Section, settings: InspectionSettings) -> Cells:
    """Return the means of the points within half a cell of a section plane."""
    feature = feature_of(found)
    normal = np.asarray(section.normal, float)
    off = (found.points_mm - np.asarray(section.point_mm, float)) @ (normal / np.linalg.norm(normal))
    near = np.abs(off) < settings.form_cell_mm / 2
    if not near.any():
        raise InspectionError(f"{found.name} was not measured where the section cuts it")
    return cell_means(found, feature, surface_keys(found.points_mm[near], feature, settings.form_cell_mm), near)


def _placed_value(width: Callable[[Sequence[Feature]], float], found: Found, datums: tuple[Found, ...], how: str) -> Value:
    return Value(*propagated(width, (found, *datums)), how)


def _ends(found: Found, feature: Feature) -> FloatArray:
    """Where the measured part of an axis begins and ends along it (2,); a centre and a constructed axis are their point alone."""
    if feature.shape in CENTRES or feature.direction is None or len(found.points_mm) == 0:
        return np.zeros(1)
    along = (found.points_mm - feature.point_mm) @ feature.direction
    return np.array([along.min(), along.max()])


def _points_of(feature: Feature, ends: FloatArray) -> FloatArray:
    if feature.direction is None:
        return np.asarray(feature.point_mm)[None]
    return feature.point_mm + ends[:, None] * feature.direction
