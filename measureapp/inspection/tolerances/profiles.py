"""Profile of a surface or line (ISO 1660): the zone about what the drawing has, be it a basic shape or a region of the nominal mesh."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import DimensionProgram, Section
from measureapp.errors import InspectionError
from measureapp.inspection.features.cells import Cells, cell_means, grid_keys, means_over, surface_keys
from measureapp.inspection.features.errors import NOISE, STITCHING
from measureapp.inspection.features.found import Found
from measureapp.inspection.features.free_form import FoundSurface
from measureapp.inspection.features.shapes import signed_distances
from measureapp.inspection.propagation import propagated_on
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.tolerances.datums import DatumSystem, datum_system, nominals_of
from measureapp.inspection.tolerances.form import extracted, filter_words
from measureapp.inspection.value import Value, feature_of, nominal_of, placement_of, summed

NO_DATUM = DatumSystem((), np.eye(4), np.empty((6, 0)))


def profile_value(described: DimensionProgram, found: Found, datums: tuple[Found, ...], settings: InspectionSettings) -> Value:
    """Return twice the greatest distance of the means from the middle of the zone: of all of them, or where a plane cuts the surface.

    Raises
    ------
    InspectionError
        The datums do not fix the zone, the drawing has no such surface, or too little of it was measured.
    """
    if datums:
        system = datum_system(nominals_of(datums), [feature_of(one) for one in datums])
        if isinstance(found, FoundSurface):
            system.require_nothing_open(found.name)
        else:
            system.require_place(nominal_of(found), found.name)
    cells = _cells(found, described.section, settings)
    made = surface_value(found, datums, cells, settings, described.zone_offset_mm)
    words = [made.how]
    if described.zone_offset_mm:
        side = "out of" if described.zone_offset_mm > 0 else "into"
        words.append(f"middle of the zone {abs(described.zone_offset_mm):g} mm {side} the material")
    if not datums:
        words.append("placed by the alignment")
    return Value(made.value, made.budget, ", ".join(words))


def surface_value(
    found: Found, datums: tuple[Found, ...], cells: Cells, settings: InspectionSettings, zone_offset_mm: float = 0.0
) -> Value:
    """Return twice the greatest distance of means from the drawn surface as the datums place it, moved out of the material."""
    distances = _distances(found)
    drawn = nominals_of(datums)

    def width(features: Sequence[Feature], points_mm: FloatArray) -> float:
        system = datum_system(drawn, features) if datums else NO_DATUM
        return 2 * float(np.abs(distances(system.apply(points_mm)) - zone_offset_mm).max())

    value, budget = propagated_on(width, datums, cells)
    # the greatest distance is off by no more than the greatest noise, the width by twice that: the range of the noise
    own = {NOISE: cells.form_sigma_mm, STITCHING: 2 * placement_of(found, settings)}
    return Value(value, summed(budget, own), filter_words(settings))


def _distances(found: Found) -> Callable[[FloatArray], FloatArray]:
    """Return what gives the distances of points (N, 3) from the drawn surface, positive out of the material."""
    if isinstance(found, FoundSurface):
        return lambda points: found.beside(points)[0]
    if feature_of(found).shape not in ("plane", "cylinder", "cone", "sphere"):
        raise InspectionError(f"{found.name} is a {feature_of(found).shape}: it has no surface that the drawing places")
    nominal, side = nominal_of(found), -1.0 if found.hole else 1.0
    return lambda points: side * signed_distances(nominal, points)


def _cells(found: Found, section: Section | None, settings: InspectionSettings) -> Cells:
    """Return the means of the points, with a section of those within half a cell of its plane."""
    if section is None and not isinstance(found, FoundSurface):
        return extracted(found, settings)
    near = np.ones(len(found.points_mm), bool)
    if section is not None:
        normal = np.asarray(section.normal, float)
        off = (found.points_mm - np.asarray(section.point_mm, float)) @ (normal / np.linalg.norm(normal))
        near = np.abs(off) < settings.form_cell_mm / 2
        if not near.any():
            raise InspectionError(f"{found.name} was not measured where the section cuts it")
    if isinstance(found, FoundSurface):
        return means_over(found, found.beside, grid_keys(found.feet()[near], settings.form_cell_mm), near)
    feature = feature_of(found)
    return cell_means(found, feature, surface_keys(found.points_mm[near], feature, settings.form_cell_mm), near)
