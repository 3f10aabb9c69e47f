"""Section curves of an inspection program for display: blade sections and line profiles."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray
from measureapp.data.blade_section import BladeSection
from measureapp.data.inspection_program import InspectionProgram, copy_names
from measureapp.errors import FitError, InspectionError
from measureapp.inspection.blades.curves import BladeCurves, trace_blade_curves
from measureapp.inspection.blades.profile import fit_profile
from measureapp.inspection.blades.section_frame import SectionFrame
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.cutting_surface import CuttingPlane
from measureapp.inspection.surface.deviation import Deviation
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.surface.section import Section, cut_section, intersect_mesh
from measureapp.progress import NoProgress, Progress

LEAST_RUN = 2  # points of a curve


@dataclass(frozen=True, slots=True, eq=False)
class SectionCurves:
    """Sections by name, in the nominal's frame; missing ones were not found."""

    blades: Mapping[str, BladeCurves]  # by feature: "middle.3"
    nominal_blades: Mapping[str, tuple[FloatArray, ...]]  # by feature: curves (K, 3) in which the section cuts the nominal blade
    profiles: Mapping[str, Section]  # by dimension: line profiles


def find_section_curves(
    found: Deviation,
    surface: NominalSurface,
    program: InspectionProgram,
    settings: InspectionSettings = InspectionSettings(),  # noqa: B008 - frozen
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> SectionCurves:
    """Find the curves of every section of ``program`` on aligned measured points."""
    blades: dict[str, BladeCurves] = {}
    nominal: dict[str, tuple[FloatArray, ...]] = {}
    described = [feature for feature in program.features if isinstance(feature, BladeSection)]
    for place, one in enumerate(described):
        progress.report(place, len(described), one.name)
        _add_blades(one, found, surface, settings, blades, nominal)
    profiles = {}
    for dimension in program.dimensions:
        if dimension.section is not None:
            cut = CuttingPlane.through(np.asarray(dimension.section.point_mm, float), np.asarray(dimension.section.normal, float))
            try:
                profiles[dimension.name] = cut_section(dimension.name, found, surface, cut, settings.form_cell_mm / 2)
            except InspectionError:  # the dimension itself is "not measured" with its reason
                continue
    return SectionCurves(blades, nominal, profiles)


def _add_blades(
    described: BladeSection,
    found: Deviation,
    surface: NominalSurface,
    settings: InspectionSettings,
    blades: dict[str, BladeCurves],
    nominal: dict[str, tuple[FloatArray, ...]],
) -> None:
    frame = SectionFrame.of(described)
    for number, name in enumerate(copy_names(described.name, described.repeat)):
        curves = intersect_mesh(frame.rotate_to_first(surface.vertices_mm, number), surface.triangles, frame.surface)
        turn = 2 * np.pi * number / described.count
        nominal[name] = tuple(frame.rotate(run, turn) for curve in curves for run in _runs(curve, _inside(curve, frame)))
        chosen = frame.select_points(found.points_mm, number, settings.blade_points)
        if len(chosen) < 4 * settings.least_points:
            continue
        try:
            made = fit_profile(frame.flatten(frame.rotate_to_first(found.points_mm[chosen], number)), frame.shape)
        except FitError:  # its dimensions are "not measured" with their reason
            continue
        blades[name] = trace_blade_curves(made, frame, number)


def _inside(curve_mm: FloatArray, frame: SectionFrame) -> BoolArray:
    """Return which points of a curve belong to the first blade."""
    inside = np.zeros(len(curve_mm), bool)
    inside[frame.chosen(curve_mm)] = True
    return inside


def _runs(curve_mm: FloatArray, inside: BoolArray) -> list[FloatArray]:
    """Return the connected parts of a curve whose points are inside; a closed curve may be connected across its end."""
    if inside.all():
        return [curve_mm]
    closed = len(curve_mm) > LEAST_RUN and np.allclose(curve_mm[0], curve_mm[-1])
    if closed:
        start = int(np.flatnonzero(~inside)[0])
        curve_mm, inside = np.roll(curve_mm[:-1], -start, axis=0), np.roll(inside[:-1], -start)
    breaks = np.flatnonzero(np.diff(inside.astype(int))) + 1
    parts = zip(np.split(curve_mm, breaks), np.split(inside, breaks), strict=True)
    return [part for part, kept in parts if kept[0] and len(part) >= LEAST_RUN]
