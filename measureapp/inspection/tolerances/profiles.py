"""Profile of a surface or line (ISO 1660): zone about the nominal, a basic shape or a region of the nominal mesh."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import DimensionProgram, Section
from measureapp.errors import InspectionError
from measureapp.inspection.features.cells import Cells, cell_means, grid_keys, surface_keys, surface_means
from measureapp.inspection.features.feature_errors import NOISE, STITCHING
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.features.free_form import FoundSurface
from measureapp.inspection.features.shapes import signed_distances
from measureapp.inspection.propagation import propagate_with_surface
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.datums import DatumSystem, datum_system, require_nominals
from measureapp.inspection.tolerances.form import extract_cells, filter_words
from measureapp.inspection.value import Value, assumed_placement_sigma, combine_budgets, require_feature, require_nominal

NO_DATUM = DatumSystem((), np.eye(4), np.empty((6, 0)))


def evaluate_profile(
    described: DimensionProgram, found: FoundFeature, datums: tuple[FoundFeature, ...], settings: InspectionSettings
) -> Value:
    """Evaluate a profile: twice the greatest distance of the cell means from the centre of the zone, over the surface or a section.

    Raises
    ------
    InspectionError
        The datums do not fix the zone, there is no nominal surface, or too little of it was measured.
    """
    if datums:
        system = datum_system(require_nominals(datums), [require_feature(one) for one in datums])
        if isinstance(found, FoundSurface):
            system.require_all_fixed(found.name)
        else:
            system.require_location(require_nominal(found), found.name)
    cells = _cells(found, described.section, settings)
    made = evaluate_surface_zone(found, datums, cells, settings, described.zone_offset_mm)
    words = [made.how]
    if described.zone_offset_mm:
        away = f"{abs(described.zone_offset_mm):g} mm"
        outwards = described.zone_offset_mm > 0
        words.append(
            f"centre of the zone offset {away} out of the material" if outwards else f"centre of the zone offset {away} into the material"
        )
    if not datums:
        words.append("located by the alignment")
    return Value(made.value, made.budget, ", ".join(words))


def evaluate_surface_zone(
    found: FoundFeature, datums: tuple[FoundFeature, ...], cells: Cells, settings: InspectionSettings, zone_offset_mm: float = 0.0
) -> Value:
    """Return twice the greatest distance of cell means from the nominal surface in the datum system, with offset out of the material."""
    distances = _distances(found)
    nominals = require_nominals(datums)

    def width(features: Sequence[Feature], points_mm: FloatArray) -> float:
        system = datum_system(nominals, features) if datums else NO_DATUM
        return 2 * float(np.abs(distances(system.apply(points_mm)) - zone_offset_mm).max())

    value, budget = propagate_with_surface(width, datums, cells)
    # the error of the greatest distance is at most the greatest noise, that of the width twice as much
    own = {NOISE: cells.form_sigma_mm, STITCHING: 2 * assumed_placement_sigma(found, settings)}
    return Value(value, combine_budgets(budget, own), filter_words(settings))


def _distances(found: FoundFeature) -> Callable[[FloatArray], FloatArray]:
    """Return the function of signed distances of points (N, 3) from the nominal surface, positive out of the material."""
    if isinstance(found, FoundSurface):
        return lambda points: found.distances_and_normals(points)[0]
    if require_feature(found).shape not in ("plane", "cylinder", "cone", "sphere"):
        raise InspectionError(f"{found.name} is a {require_feature(found).shape}: it has no nominal surface")
    nominal, side = require_nominal(found), -1.0 if found.hole else 1.0
    return lambda points: side * signed_distances(nominal, points)


def _cells(found: FoundFeature, section: Section | None, settings: InspectionSettings) -> Cells:
    """Return the cell means, with a section those within half a cell of its plane."""
    if section is None and not isinstance(found, FoundSurface):
        return extract_cells(found, settings)
    near = np.ones(len(found.points_mm), bool)
    if section is not None:
        normal = np.asarray(section.normal, float)
        off = (found.points_mm - np.asarray(section.point_mm, float)) @ (normal / np.linalg.norm(normal))
        near = np.abs(off) < settings.form_cell_mm / 2
        if not near.any():
            raise InspectionError(f"{found.name} was not measured at its section")
    if isinstance(found, FoundSurface):
        return surface_means(found, found.distances_and_normals, grid_keys(found.closest_points()[near], settings.form_cell_mm), near)
    feature = require_feature(found)
    return cell_means(found, feature, surface_keys(found.points_mm[near], feature, settings.form_cell_mm), near)
