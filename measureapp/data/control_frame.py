"""Feature control frames (ISO 1101): the characteristic, the width of the zone with its modifiers, and the datums."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import asdict, dataclass, replace
from typing import TYPE_CHECKING, Any

from measureapp.data.datum_letters import common_datums, letters_of, relettered

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.dimension_program import DimensionProgram
    from measureapp.data.feature import Feature
    from measureapp.data.inspection_program import InspectionProgram

CHARACTERISTICS = (
    *("straightness", "flatness", "roundness", "cylindricity", "line_profile", "surface_profile", "parallelism", "perpendicularity"),
    *("angularity", "position", "concentricity", "coaxiality", "circular_runout", "total_runout"),
)
LOCATIONS = ("position", "concentricity", "coaxiality")
ROUND = ("cylinder", "cone", "circle", "line")  # shapes with an axis or a centre
CONDITION_SIGNS = {"maximum": "\u24c2", "least": "\u24c1", "regardless": ""}  # ISO 2692
TOGETHER = "\u00a0"
DIGITS = 3


@dataclass(frozen=True, slots=True)
class ControlFrame:
    """What the cells of a frame state, from left to right; window, documents and files draw the same."""

    characteristic: str  # one of `CHARACTERISTICS`
    width_mm: float  # of the zone, without the bonus of a material condition
    diameter: str = ""  # "Ø": a cylindrical zone, "SØ": a spherical one
    modifiers: tuple[str, ...] = ()  # behind the width: "Ⓜ", "UZ +0.020"
    datums: tuple[str, ...] = ()  # letters with their modifiers, in their order

    def zone(self) -> str:
        """Return the cell of the width.

        >>> ControlFrame("position", 0.1, "Ø", ("Ⓜ",)).zone().replace(TOGETHER, " ")
        'Ø 0.100 Ⓜ'
        """
        return TOGETHER.join(word for word in (self.diameter, f"{self.width_mm:.{DIGITS}f}", *self.modifiers) if word)

    def words(self) -> tuple[str, ...]:
        """Return the texts of the cells behind the symbol."""
        return (self.zone(), *self.datums)


def control_frame(entry: DimensionProgram, shapes: Mapping[str, str], letters: Mapping[str, str]) -> ControlFrame | None:
    """Return the frame of a geometrical tolerance; None for other dimensions and without a tolerance.

    The width is the one that the program states: a bonus of the material condition is not added to it. Of several copies in a
    pattern, each with datums of its own, the datums have no common letters and are left out.

    Parameters
    ----------
    shapes : shape of each feature by its name, which decides whether the zone is round
    letters : letter of each datum by its feature (`letters_of` the program)
    """
    if entry.kind not in CHARACTERISTICS or not entry.is_toleranced:
        return None
    conditions = {one.datum: CONDITION_SIGNS[one.condition] for one in entry.datum_material}
    offset = f"UZ{TOGETHER}{entry.zone_offset_mm:+.{DIGITS}f}".replace("-", "\u2212") if entry.zone_offset_mm else ""  # ISO 1660
    feature, first = entry.feature_sets[0][0], (entry.datum_sets[0] or ("",))[0]
    return ControlFrame(
        entry.kind,
        entry.upper_tolerance,
        zone_sign(entry.kind, shapes.get(feature, ""), shapes.get(first, "")),
        tuple(sign for sign in (CONDITION_SIGNS[entry.material_condition], offset) if sign),
        tuple(f"{letters[name]}{conditions.get(name, '')}" for name in common_datums(entry)),
    )


def zone_sign(kind: str, shape: str, datum_shape: str) -> str:
    """Return the sign of a zone that is round: that of an axis or centre, or of an axis whose direction the first datum fixes.

    >>> zone_sign("position", "sphere", "plane"), zone_sign("perpendicularity", "cylinder", "plane"), zone_sign("flatness", "plane", "")
    ('SØ', 'Ø', '')
    """
    if kind in LOCATIONS:
        return "SØ" if shape == "sphere" else "Ø" if shape in ROUND else ""
    if shape not in ROUND:
        return ""
    square_to_plane = kind == "perpendicularity" and datum_shape == "plane"
    along_axis = kind == "parallelism" and datum_shape in ROUND
    return "Ø" if square_to_plane or along_axis else ""


def with_frames(dimensions: Iterable[Dimension], program: InspectionProgram, features: Iterable[Feature]) -> tuple[Dimension, ...]:
    """Return results with the letters of the program's datums, and with frames where an earlier version stored none.

    A result whose datums are no longer those of the program keeps what it was stored with.
    """
    stated, shapes = {one.name: one for one in program.dimensions}, {one.name: str(one.shape) for one in features}
    letters = letters_of(program)
    return tuple(_completed(one, stated.get(one.name), shapes, letters) for one in dimensions)


def _completed(dimension: Dimension, entry: DimensionProgram | None, shapes: Mapping[str, str], letters: Mapping[str, str]) -> Dimension:
    if dimension.datum_letters or entry is None:
        return relettered(dimension, letters)
    datums = common_datums(entry)
    if datums and dimension.datums != datums:
        return dimension
    made = control_frame(entry, shapes, letters)
    frame = made if dimension.frame is None or made is None else replace(dimension.frame, datums=made.datums)
    return replace(dimension, datum_letters=tuple(letters[name] for name in datums), frame=frame)


def frame_document(frame: ControlFrame | None) -> dict[str, Any] | None:
    """Return a frame as JSON."""
    return None if frame is None else {name: list(value) if isinstance(value, tuple) else value for name, value in asdict(frame).items()}


def frame_from(document: Mapping[str, Any] | None) -> ControlFrame | None:
    """Return the frame of a document; the inverse of `frame_document`."""
    return None if document is None else ControlFrame(**{**document, **{name: tuple(document[name]) for name in ("modifiers", "datums")}})
