"""Evaluation of blade sections on the measured points, with Monte Carlo uncertainty."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.blade_section import BladeSection
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import copy_names
from measureapp.errors import FitError
from measureapp.inspection.blades.average_blade import AverageComparison, compare_with_average
from measureapp.inspection.blades.blade_errors import BladeErrors, estimate_blade_errors
from measureapp.inspection.blades.profile import Profile, fit_profile
from measureapp.inspection.blades.section_frame import SectionFrame
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.deviation import distances_and_normals
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.uncertainty import correlation_factor, effective_views

SEED = 6
TRIAL_ROUNDS = 3
LEAST_TRIALS = 0.8  # least share of successful trials of a determined value


@dataclass(frozen=True, slots=True, eq=False)
class FoundBlade(FoundFeature):
    """One blade section: profile, uncertainty of its values, and comparison with the average blade."""

    profile: Profile | None = None
    frame: SectionFrame | None = None
    sigmas: Mapping[str, float] | None = None  # standard uncertainty of each value of `profile_values`
    comparison: AverageComparison | None = None
    number: int = 0  # from 0
    deviations_mm: FloatArray | None = None  # (K,) signed, of the points from the nominal; None without a nominal mesh
    by_errors: BladeErrors | None = None  # errors by its views; None without an error model


def find_blades(
    described: BladeSection, points: MeasuredPoints, surface: NominalSurface | None, settings: InspectionSettings
) -> Mapping[str, FoundFeature]:
    """Find a section on every blade; ``points`` are in the nominal's frame."""
    frame = SectionFrame.of(described)
    names = copy_names(described.name, described.repeat)
    found: dict[str, FoundFeature] = {}
    blades: dict[str, FloatArray] = {}
    for number, name in enumerate(names):
        chosen = frame.select_points(points.points_mm, number, settings.blade_points)
        if len(chosen) < 4 * settings.least_points:
            reason = f"{name}: only {len(chosen)} points were measured there, {4 * settings.least_points} are needed"
            found[name] = FoundFeature(name, None, reason)
            continue
        turned = frame.rotate_to_first(points.points_mm[chosen], number)
        try:
            found[name] = _evaluate_blade(name, number, points.where(chosen), turned, frame, surface, settings)
        except FitError as error:
            found[name] = FoundFeature(name, None, f"{name}: {error.message}")
            continue
        blades[name] = turned
    return found if len(blades) < 2 else _compare_blades(found, blades, frame)


def _compare_blades(found: dict[str, FoundFeature], blades: dict[str, FloatArray], frame: SectionFrame) -> dict[str, FoundFeature]:
    for name, against in zip(blades, compare_with_average(list(blades.values()), frame), strict=True):
        one = found[name]
        if isinstance(one, FoundBlade):
            found[name] = replace(one, comparison=against)
    return found


def _evaluate_blade(
    name: str,
    number: int,
    own: MeasuredPoints,
    turned_mm: FloatArray,
    frame: SectionFrame,
    surface: NominalSurface | None,
    settings: InspectionSettings,
) -> FoundBlade:
    flat = frame.flatten(turned_mm)
    made = fit_profile(flat, frame.shape)
    factor = correlation_factor(turned_mm[made.on_side], made.residuals_mm, settings.uncertainty.correlation_mm)
    middle = own.points_mm.mean(axis=0)
    left_out = len(flat) - int(made.on_side.sum()) - made.leading.points - made.trailing.points
    feature = Feature(name, "point", middle, None, points=len(flat), left_out=max(left_out, 0), rms_mm=made.scatter_mm)
    sigmas = {key: factor * sigma for key, sigma in _simulate_scatter(flat, made, frame, settings.blade_trials).items()}
    away = None if surface is None else distances_and_normals(own.points_mm, own.normals, surface)[0]
    by_errors = estimate_blade_errors(own, number, frame)
    return FoundBlade(
        name,
        feature,
        "",
        factor,
        effective_views(own.view),
        own.points_mm,
        view_errors=None if by_errors is None else own.errors,
        profile=made,
        frame=frame,
        sigmas=sigmas,
        number=number,
        deviations_mm=away,
        by_errors=by_errors,
    )


def profile_values(made: Profile, frame: SectionFrame) -> dict[str, float]:
    """Return the values of a single profile as far as they are defined; angles in rad."""
    values = {"max_thickness": made.thickness_mm, "stagger": frame.stagger_rad(made.chord, made.ends_mm[0])}
    if made.leading.apex_mm is not None:
        values["leading_radius"] = made.leading.radius_mm
        values["max_thickness_place"] = made.thickness_at_mm
    if made.trailing.apex_mm is not None:
        values["trailing_radius"] = made.trailing.radius_mm
    if made.leading.apex_mm is not None and made.trailing.apex_mm is not None:
        values["chord"], values["camber"] = float(np.linalg.norm(made.chord)), made.camber_mm
    return values


def _simulate_scatter(flat_mm: FloatArray, made: Profile, frame: SectionFrame, trials: int) -> dict[str, float]:
    """Monte Carlo evaluation with added noise of the points' own scatter (JCGM 101); values that fail too often are omitted.

    An extreme grows with the noise. The trials show its growth from the noise of the points to √2 of it; the growth already contained in
    the value is 1 / (√2 - 1) of that, and counts as uncertainty.
    """
    rng = np.random.default_rng(SEED)
    kept: dict[str, list[float]] = {}
    for _ in range(trials):
        noisy = flat_mm + made.scatter_mm * rng.standard_normal(flat_mm.shape)
        try:
            again = fit_profile(noisy, frame.shape, made, TRIAL_ROUNDS)
        except FitError:
            continue
        for key, value in profile_values(again, frame).items():
            kept.setdefault(key, []).append(value)
    base = profile_values(made, frame)
    return {
        key: float(np.hypot(np.std(values, ddof=1), (np.mean(values) - base[key]) / (np.sqrt(2) - 1)))
        for key, values in kept.items()
        if key in base and len(values) >= LEAST_TRIALS * trials
    }
