"""Feature control frames of the dimensions that are widths of tolerance zones."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from ui.look.wording import quantity
from ui.pages.inspection.dimension_rows import DATUM_LETTERS
from ui.viewport.overlay.control_frame import CHARACTERISTICS, ControlFrame

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.dimension_program import DimensionProgram
    from measureapp.data.feature import Feature

LOCATIONS = ("position", "concentricity", "coaxiality")
ROUND = ("cylinder", "cone", "circle", "line")  # shapes with an axis or a centre
LETTERS = {"maximum": "\u24c2", "least": "\u24c1", "regardless": ""}  # ISO 2692


def control_frame(dimension: Dimension, entry: DimensionProgram | None, known: Mapping[str, Feature]) -> ControlFrame | None:
    """Return the frame of a geometrical tolerance; None for other dimensions and without a tolerance.

    The width is the one that the program states: a bonus of the material condition is not added to it. Of several copies in a
    pattern, each with datums of its own, the datums have no common letters and are left out.
    """
    stated = dimension.upper_tolerance if entry is None else (entry.upper_tolerance if entry.is_toleranced else None)
    if dimension.kind not in CHARACTERISTICS or stated is None:
        return None
    names = dimension.datums if len(dimension.datums) <= len(DATUM_LETTERS) else ()
    materials = {} if entry is None else {one.datum: LETTERS[one.condition] for one in entry.datum_material}
    material = "" if entry is None else LETTERS[entry.material_condition]
    offset = 0.0 if entry is None else entry.zone_offset_mm
    unequal = f"UZ\u00a0{quantity(offset, '', signed=True)}" if offset else ""  # ISO 1660
    width = f"{zone_sign(dimension, known)}{quantity(stated, '')}"
    datums = tuple(f"{letter}{materials.get(name, '')}" for letter, name in zip(DATUM_LETTERS, names, strict=False))
    return ControlFrame(dimension.kind, stated, "\u00a0".join(part for part in (width, material, unequal) if part), datums)


def zone_sign(dimension: Dimension, known: Mapping[str, Feature]) -> str:
    """Return the sign of a zone that is round: that of an axis or centre, or of an axis whose direction the datums fix."""
    feature = known.get(dimension.features[0]) if dimension.features else None
    if feature is None:
        return ""
    if dimension.kind in LOCATIONS:
        return "SØ\u00a0" if feature.shape == "sphere" else "Ø\u00a0" if feature.shape in ROUND else ""
    datum = known.get(dimension.datums[0]) if dimension.datums else None
    if datum is None or feature.shape not in ROUND:
        return ""
    square_to_plane = dimension.kind == "perpendicularity" and datum.shape == "plane"
    along_axis = dimension.kind == "parallelism" and datum.shape in ROUND
    return "Ø\u00a0" if square_to_plane or along_axis else ""
