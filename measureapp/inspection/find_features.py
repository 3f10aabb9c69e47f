"""Evaluation of all features of an inspection program on the measured points."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from measureapp.data.blade_section import BladeSection
from measureapp.data.free_form import FreeForm
from measureapp.data.inspection_program import ConstructedFeature, FeatureProgram, InspectionProgram, copy_names, needed_names
from measureapp.inspection.blades.find_blades import find_blades
from measureapp.inspection.features.construct import construct
from measureapp.inspection.features.edge_effects import estimate_edge_effects
from measureapp.inspection.features.edges import find_edges
from measureapp.inspection.features.found_feature import FoundFeature, find_feature
from measureapp.inspection.features.free_form import find_free_forms
from measureapp.inspection.features.grow_features import grow_features
from measureapp.inspection.features.simulated_fits import simulate_uncertainties
from measureapp.inspection.measured_points import MeasuredPoints
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.progress import NoProgress, Progress


def find_features(
    points: MeasuredPoints,
    program: InspectionProgram,
    surface: NominalSurface | None,
    settings: InspectionSettings,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
    only: Collection[str] | None = None,
) -> dict[str, FoundFeature]:
    """Return every feature, or the reason why it was not found, by name; ``points`` are in the nominal's frame.

    Parameters
    ----------
    only : names of the required features (their dependencies are evaluated too); None: all
    """
    wanted = None if only is None else _with_dependencies(program, only)
    found: dict[str, FoundFeature] = {}
    for number, described in enumerate(program.features):
        if wanted is not None and wanted.isdisjoint(copy_names(described.name, described.repeat)):
            continue
        progress.report(1 + number / len(program.features), 3, described.name)
        found.update(find_entry(described, points, found, surface, settings))
    return found


def find_entry(
    described: FeatureProgram,
    points: MeasuredPoints,
    known: Mapping[str, FoundFeature],
    surface: NominalSurface | None,
    settings: InspectionSettings,
) -> Mapping[str, FoundFeature]:
    """Return the feature of one entry of the program, or its copies, by name; ``known`` has those it is constructed from."""
    edges = None if surface is None else surface.sharp_edges
    if isinstance(described, ConstructedFeature):
        return construct(described, known)
    if isinstance(described, BladeSection):
        return find_blades(described, points, surface, settings)
    if isinstance(described, FreeForm):
        return find_free_forms(described, points, surface, edges, settings)
    if described.shape == "edge":
        return find_edges(described, points, settings)
    if described.grow is not None:
        return simulate_uncertainties(grow_features(described, points, settings), settings)
    found = estimate_edge_effects(find_feature(described, points, edges, settings), described, edges)
    return simulate_uncertainties(found, settings)


def _with_dependencies(program: InspectionProgram, names: Collection[str]) -> set[str]:
    wanted = set(names)
    for described in reversed(program.features):  # a feature depends on earlier features only
        if isinstance(described, ConstructedFeature) and not wanted.isdisjoint(copy_names(described.name, described.repeat)):
            wanted.update(needed_names(described))
    return wanted
