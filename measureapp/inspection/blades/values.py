"""Dimensions of blade sections: of one blade, between two, and against the average blade or the nominal."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.inspection_program import DimensionProgram
from measureapp.errors import InspectionError
from measureapp.inspection.blades.find_blades import FoundBlade, profile_values
from measureapp.inspection.features.cells import LEAST_IN_CELL, greatest_noise_factor
from measureapp.inspection.features.feature_errors import NOISE, STITCHING
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.value import Budget, Value, assumed_placement_sigma, combine_budgets, scale_budget

LEAST_CELLS = 6
GAUSSIAN = 1.4826  # standard deviation over the median absolute deviation of normal errors
OF_A_MEDIAN = float(np.sqrt(np.pi / 2))  # standard deviation of a median over that of a mean
DEGREES = 180 / np.pi
MISSING = {
    "chord": ("leading", "trailing"),
    "camber": ("leading", "trailing"),
    "max_thickness_place": ("leading",),
    "leading_radius": ("leading",),
    "trailing_radius": ("trailing",),
}


def evaluate_blade(described: DimensionProgram, found: tuple[FoundFeature, ...], settings: InspectionSettings) -> Value:
    """Evaluate a blade dimension.

    Raises
    ------
    InspectionError
        The value is undefined: an edge was not measured, there is no nominal, or a pitch of a single blade.
    """
    blades = [one for one in found if isinstance(one, FoundBlade)]
    if described.kind == "pitch":
        return _pitch(blades[0], blades[1], settings)
    if described.kind == "twist":
        return _twist(blades[0], blades[1], settings)
    if described.kind == "blade_form":
        return _form(blades[0], settings)
    if described.kind == "blade_profile":
        return _profile(blades[0], settings)
    return _single(described.kind, blades[0], settings)


def _twist(one: FoundBlade, other: FoundBlade, settings: InspectionSettings) -> Value:
    """Difference of two stagger angles; a common motion of both sections cancels."""
    first, second = (_single("stagger", blade, settings) for blade in (one, other))
    budget = combine_budgets(first.budget, second.budget)
    if one.by_errors is not None and other.by_errors is not None:
        budget = {**budget, **_angle_difference(one.by_errors.stagger_rad, other.by_errors.stagger_rad)}
    return Value((second.value - first.value + 180) % 360 - 180, budget, "Monte Carlo")


def _angle_difference(one: Mapping[str, FloatArray], other: Mapping[str, FloatArray]) -> Budget:
    """Return the budget in degrees of the difference of two angles with correlated errors."""
    return {name: DEGREES * float(np.linalg.norm(other[name] - one[name])) for name in one}


def _deformation_budget(blade: FoundBlade, settings: InspectionSettings, factor: float) -> Budget:
    """Return the budget of a length in the section: ``factor`` times the deformation of the sides."""
    if blade.by_errors is None:
        return {STITCHING: factor * assumed_placement_sigma(blade, settings)}
    return scale_budget(blade.by_errors.deformation_mm, factor)


def _single(kind: str, blade: FoundBlade, settings: InspectionSettings) -> Value:
    made, frame, sigmas = blade.profile, blade.frame, blade.sigmas
    assert made is not None and frame is not None and sigmas is not None
    for name in MISSING.get(kind, ()):
        edge = getattr(made, name)
        if edge.apex_mm is None:
            raise InspectionError(f"{blade.name}: {kind.replace('_', ' ')} is undefined, as {edge.reason} ({name} end)")
    if kind not in sigmas:
        raise InspectionError(f"{blade.name}: the {kind.replace('_', ' ')} is not determined, most trials with simulated noise fail")
    value, sigma = profile_values(made, frame)[kind], sigmas[kind]
    how = f"Monte Carlo, {settings.blade_trials} trials"
    sides = 1.0 if kind.endswith("radius") else float(np.sqrt(2))  # two positions, measured by different views
    if kind != "stagger":
        return Value(value, {NOISE: sigma, **_deformation_budget(blade, settings, sides)}, how)
    lean = scale_budget(_deformation_budget(blade, settings, sides), 1 / float(np.linalg.norm(made.chord)))
    if blade.by_errors is not None:
        lean = {contribution: float(np.linalg.norm(columns)) for contribution, columns in blade.by_errors.stagger_rad.items()}
    return Value(float(np.degrees(value)), scale_budget({NOISE: sigma, **lean}, DEGREES), how)


def _pitch(one: FoundBlade, other: FoundBlade, settings: InspectionSettings) -> Value:
    """Rotation about the axis from one blade to the other."""
    for blade in (one, other):
        if blade.comparison is None:
            raise InspectionError(f"{blade.name}: a pitch needs at least two measured blades of one section")
    if one.frame is not other.frame:
        raise InspectionError(f"{one.name} and {other.name} are blades of different sections: their pitch is undefined")
    assert one.comparison is not None and other.comparison is not None and one.frame is not None
    count = one.frame.described.count
    steps = (other.number - one.number) % count or count
    turn = 2 * np.pi * steps / count + other.comparison.turn_rad - one.comparison.turn_rad
    budget = scale_budget(combine_budgets(_turn_budget(one, settings), _turn_budget(other, settings)), DEGREES)
    if one.by_errors is not None and other.by_errors is not None:
        budget = {**budget, **_angle_difference(one.by_errors.turn_rad, other.by_errors.turn_rad)}
    return Value(float(np.degrees(turn)), budget)


def _turn_budget(blade: FoundBlade, settings: InspectionSettings) -> Budget:
    """Return the budget (rad) of the rotation of a blade about the axis."""
    assert blade.comparison is not None and blade.frame is not None
    points = blade.frame.rotate_to_first(blade.points_mm[blade.comparison.on_side], blade.number)
    lever = float(np.sqrt(np.mean(np.sum(blade.frame.effect_of_turn(points) ** 2, axis=1))))
    return {NOISE: blade.correlation_factor * blade.comparison.turn_sigma_rad, STITCHING: assumed_placement_sigma(blade, settings) / lever}


def _form(blade: FoundBlade, settings: InspectionSettings) -> Value:
    """Width of the zone about the part's average blade, after rotation onto it about the axis."""
    if blade.comparison is None:
        raise InspectionError(f"{blade.name}: an average blade needs at least two measured blades of this section")
    against = blade.comparison
    where = np.floor(against.lengths_mm / settings.form_cell_mm).astype(int) * 2 + against.upper
    return _zone(
        blade,
        where,
        against.deviations_mm,
        settings,
        _deformation_budget(blade, settings, 2.0),
        "about the average blade, rotated onto it about the axis",
    )


def _profile(blade: FoundBlade, settings: InspectionSettings) -> Value:
    """Width of the zone about the nominal, in the alignment of the part."""
    if blade.deviations_mm is None:
        raise InspectionError(f"{blade.name}: a blade profile needs a nominal mesh, and the program has none")
    assert blade.profile is not None and blade.frame is not None
    flat = blade.frame.flatten(blade.frame.rotate_to_first(blade.points_mm, blade.number))
    x, heights = blade.profile.line.feet(flat)
    where = np.floor(blade.profile.line.lengths(x) / settings.form_cell_mm).astype(int) * 2 + (heights > 0)
    line = blade.profile.line
    on_side = (x > line.first_mm) & (x < line.last_mm)
    moved = _deformation_budget(blade, settings, 2.0) if blade.by_errors is None else scale_budget(blade.by_errors.total_mm, 2.0)
    return _zone(blade, where[on_side], blade.deviations_mm[on_side], settings, moved, "about the nominal, located by the alignment")


def _zone(
    blade: FoundBlade, where: IntArray, deviations_mm: FloatArray, settings: InspectionSettings, by_views: Budget, what: str
) -> Value:
    """Twice the greatest median deviation over segments of both sides, robust against noise and single stray points.

    A true deviation is present in all points of a segment; no points are rejected for their distance.
    """
    order = np.argsort(where, kind="stable")
    pieces = np.split(deviations_mm[order], np.flatnonzero(np.diff(where[order])) + 1)
    counts = np.array([len(piece) for piece in pieces])
    full = counts >= max(LEAST_IN_CELL, 0.25 * float(np.median(counts)))
    if full.sum() < LEAST_CELLS:
        raise InspectionError(f"{blade.name}: only {full.sum()} segments of its sides have enough points, {LEAST_CELLS} are needed")
    chosen = [piece for piece, enough in zip(pieces, full, strict=True) if enough]
    medians = np.array([np.median(piece) for piece in chosen])
    scatter = [GAUSSIAN * np.median(np.abs(piece - median)) for piece, median in zip(chosen, medians, strict=True)]
    noise = OF_A_MEDIAN * float(np.median(scatter / np.sqrt(counts[full])))
    budget = {NOISE: greatest_noise_factor(int(full.sum())) * noise, **by_views}
    return Value(2 * float(np.abs(medians).max()), budget, f"medians over {settings.form_cell_mm:g} mm, {what}")
