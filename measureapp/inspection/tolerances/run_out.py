"""Circular and total run-out (ISO 1101) of a cylinder or a face about a datum axis."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.feature import Feature
from measureapp.errors import InspectionError
from measureapp.inspection.features.cells import LEAST_AROUND, Cells, angles, around_count, cell_means, round_keys
from measureapp.inspection.features.feature_errors import NOISE, STITCHING
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.features.shapes import along_and_off
from measureapp.inspection.propagation import propagate_with_surface
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.form import assumed_view_spread, filter_words, find_full_sections
from measureapp.inspection.value import AXES, Value, combine_budgets, require_direction, require_feature

GREATEST_LEAN_DEG = 10.0


def evaluate_run_out(kind: str, found: FoundFeature, datum: FoundFeature, settings: InspectionSettings) -> Value:
    """Evaluate run-out: range of a dial gauge reading over a rotation about the datum axis.

    Radial for a cylinder, axial for a plane; circular: the worst section or ring, total: over the whole surface.

    Raises
    ------
    InspectionError
        The datum has no axis, the surface is not aligned to it, or no section is sufficiently complete.
    """
    feature, base = require_feature(found), require_feature(datum)
    _require(found, feature, datum, base)
    axial = feature.shape == "plane"
    cells, around = _extract_cells(found, base, axial, settings)
    whole = find_full_sections(cells, around, settings, found.name)
    parts = whole if kind == "circular_runout" else [np.any(whole, axis=0)]

    def width(features: Sequence[Feature], points_mm: FloatArray) -> float:
        along, off, _ = along_and_off(points_mm, features[0].point_mm, require_direction(features[0]))
        read = along if axial else off
        return max(float(np.ptp(read[part])) for part in parts)

    value, budget = propagate_with_surface(width, (datum,), cells)
    cleaned = filter_words(settings)
    how = f"{cleaned}, axial, {len(whole)} rings" if axial else f"{cleaned}, radial, {len(whole)} sections"
    return Value(value, combine_budgets(budget, {NOISE: cells.form_sigma_mm, STITCHING: assumed_view_spread(found, settings)}), how)


def _require(found: FoundFeature, feature: Feature, datum: FoundFeature, base: Feature) -> None:
    if base.shape not in AXES:
        raise InspectionError(f"{datum.name} is a {base.shape}: run-out requires an axis as its datum")
    if feature.shape not in ("cylinder", "plane") or len(found.points_mm) == 0:
        raise InspectionError(f"{found.name} is a {feature.shape}: run-out requires a measured cylinder or plane")
    lean = float(np.degrees(np.arccos(min(1.0, abs(float(require_direction(feature) @ require_direction(base)))))))
    if lean > GREATEST_LEAN_DEG:
        raise InspectionError(f"{found.name} is {lean:.0f}° from the axis of {datum.name}: its run-out is undefined")


def _extract_cells(found: FoundFeature, base: Feature, axial: bool, settings: InspectionSettings) -> tuple[Cells, int]:
    feature, points, axis = require_feature(found), found.points_mm, require_direction(base)
    if not axial:
        radius = feature.radius_mm or settings.form_cell_mm
        keys = round_keys(points, base.point_mm, axis, settings.form_cell_mm, radius)
        return cell_means(found, feature, keys), around_count(radius, settings.form_cell_mm)
    keys = _ring_keys(points, base.point_mm, axis, settings.form_cell_mm)
    return cell_means(found, feature, keys), LEAST_AROUND


def _ring_keys(points_mm: FloatArray, point_mm: FloatArray, axis: FloatArray, cell_mm: float) -> IntArray:
    """Return cells (N, 2) of a face: ring and sector."""
    _, off, _ = along_and_off(points_mm, point_mm, axis)
    turn = angles(points_mm, point_mm, axis)
    return np.column_stack([off / cell_mm, turn / (2 * np.pi) * LEAST_AROUND % LEAST_AROUND]).astype(np.int64)
