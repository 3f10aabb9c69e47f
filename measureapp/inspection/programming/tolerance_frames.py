"""Geometrical tolerances as their frames are chosen: what ISO 1101 and the evaluation allow, and the edit that a choice means."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import zip_longest
from typing import Any

from measureapp.data.control_frame import ControlFrame, control_frame
from measureapp.data.datum_letters import features_of_commons, letters_of
from measureapp.data.dimension_program import FORMS, ONE_DATUM, PROFILES, DimensionProgram
from measureapp.data.feature import Feature
from measureapp.data.feature_program import substitute_index
from measureapp.data.inspection_program import InspectionProgram
from measureapp.data.material import MaterialCondition
from measureapp.errors import InputError, InspectionError
from measureapp.inspection.features.constructions import MAKERS
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.programming import edits
from measureapp.inspection.programming.names import Word, compound, english
from measureapp.inspection.session.graph import Node
from measureapp.inspection.tolerances.datums import datum_system
from measureapp.inspection.tolerances.zones import exact_direction
from measureapp.inspection.value import AXES, CENTRES

ORIENTATIONS = ("parallelism", "perpendicularity", "angularity")
FREE_FORM = "free_form"
DIRECTED = ("plane", *AXES)
TOLERANCED: Mapping[str, tuple[str, ...]] = {  # shapes for which each characteristic is evaluated
    "straightness": DIRECTED,
    "flatness": ("plane",),
    "roundness": ("cylinder", "cone", "circle"),
    "cylindricity": ("cylinder",),
    **dict.fromkeys(ORIENTATIONS, DIRECTED),
    "position": (*DIRECTED, *CENTRES),
    "concentricity": CENTRES,
    "coaxiality": AXES,
    "circular_runout": ("cylinder", "plane"),
    "total_runout": ("cylinder", "plane"),
    **dict.fromkeys(PROFILES, ("plane", "cylinder", "cone", "sphere", FREE_FORM)),
}
DATUMS: Mapping[str, tuple[str, ...]] = {
    "concentricity": (*AXES, *CENTRES),
    **dict.fromkeys(("coaxiality", "circular_runout", "total_runout"), AXES),
}
USUAL: Mapping[str, tuple[str, ...]] = {  # characteristics of each shape, the most usual first
    "plane": ("flatness", "perpendicularity", "parallelism", "surface_profile"),
    "cylinder": ("position", "coaxiality", "perpendicularity", "cylindricity"),
    "cone": ("coaxiality", "roundness"),
    "circle": ("position", "roundness"),
    "slot": ("position",),
    "sphere": ("position", "surface_profile"),
    "point": ("position",),
    "line": ("perpendicularity", "parallelism", "straightness"),
    FREE_FORM: ("surface_profile",),
}
MOST_DATUMS = 3
HINT = "Choose another characteristic, feature or datum."


@dataclass(frozen=True, slots=True)
class ToleranceChoice:
    """A frame as it is chosen; a feature may be a copy of a pattern, or all copies as in ``hole.{k}``."""

    kind: str  # a characteristic
    feature: str
    width_mm: float
    datums: tuple[str, ...] = ()  # features, in their order
    condition: MaterialCondition = "regardless"
    size_limits_mm: tuple[float, float] | None = None  # of the feature's diameter, for its material condition
    zone_offset_mm: float = 0.0  # of a profile
    partners: tuple[str, ...] = ()  # of each datum the feature with which it is one common datum (A-B); empty: it is one alone

    @classmethod
    def of(cls, entry: DimensionProgram) -> ToleranceChoice:
        """Return the choice that an entry of the program states."""
        return cls(
            entry.kind,
            entry.features[0],
            entry.upper_tolerance,
            entry.datums,
            entry.material_condition,
            entry.size_limits_mm,
            entry.zone_offset_mm,
        )


def takes_datums(kind: str) -> int:
    """Return how many datums a characteristic can have."""
    return 0 if kind in FORMS else 1 if kind in ONE_DATUM else MOST_DATUMS


def takes_material(kind: str, shape: str) -> bool:
    """Return whether a material condition of the toleranced feature is evaluated: for the position of a hole or shaft."""
    return kind == "position" and shape == "cylinder"


def refusal(program: InspectionProgram, choice: ToleranceChoice, features: Mapping[str, Feature], former: str = "") -> str:
    """Return why a choice is not allowed, in one sentence; empty: it is. Parameters are those of `require_allowed`."""
    try:
        require_allowed(program, choice, features, former)
    except (InputError, InspectionError) as error:
        return error.message if error.message.endswith(".") else f"{error.message}."
    return ""


def require_allowed(program: InspectionProgram, choice: ToleranceChoice, features: Mapping[str, Feature], former: str = "") -> None:
    """Require that ISO 1101, the program and the evaluation allow a choice.

    Parameters
    ----------
    features : by name, as designed where the program says so, else as measured
    former : name of the dimension that the choice replaces; empty: it is a new one

    Raises
    ------
    InputError
        The characteristic does not suit the feature, its datums or its modifiers; says why.
    InspectionError
        The datums do not fix the zone.
    """
    words = choice.kind.replace("_", " ")
    if any(partner == datum for datum, partner in zip(choice.datums, choice.partners, strict=False)):
        raise InputError("Two datums are the same feature.", HINT)
    program, choice = with_common_datums(program, choice)
    commons = features_of_commons(program)
    features = {**features, **_made_commons(commons, features)}
    if choice.feature in {one for name in choice.datums for one in commons.get(name, ())}:
        raise InputError(f"{choice.feature} cannot be the datum of its own tolerance.", HINT)
    named = {name: _one(name) for name in (choice.feature, *choice.datums)}
    shapes = {name: _shape(program, one, features) for name, one in named.items()}
    if not choice.feature:
        raise InputError("Choose the toleranced feature.", HINT)
    if choice.width_mm <= 0:
        raise InputError("The width of the zone must be greater than 0.", HINT)
    shape = shapes[choice.feature]
    if shape and shape not in TOLERANCED[choice.kind]:
        raise InputError(f"{choice.feature} is a {_said(shape)}: {words} is defined for a {_either(TOLERANCED[choice.kind])}.", HINT)
    _require_datums(choice, words, shapes)
    _require_system(choice, named, features)
    if choice.condition != "regardless" and (choice.size_limits_mm is None or choice.size_limits_mm[0] >= choice.size_limits_mm[1]):
        raise InputError("A material condition needs the limits of the diameter, the smaller one first.", HINT)
    changed, name = with_tolerance(program, choice, former)
    along = next(one for one in changed.dimensions if one.name == name).along
    if choice.kind == "straightness" and shape == "plane" and along is None:
        raise InputError("Straightness of a plane needs the direction of its lines: state `along` in the text of the program.", HINT)


def with_tolerance(
    program: InspectionProgram, choice: ToleranceChoice, former: str = "", word: Word = english
) -> tuple[InspectionProgram, str]:
    """Add a tolerance, or change the one named ``former``; return the program and its name, whose words ``word`` says.

    Raises
    ------
    InputError
        The program does not allow it; says why.
    """
    program, choice = with_common_datums(program, choice, word)
    entry = next((one for one in program.dimensions if one.name == former), None)
    values: dict[str, Any] = {
        "kind": choice.kind,
        "features": [choice.feature],
        "datums": list(choice.datums) or None,
        "upper_tolerance": choice.width_mm,
        "material_condition": choice.condition if choice.condition != "regardless" else None,
        "size_limits_mm": choice.size_limits_mm if choice.condition != "regardless" else None,
        "zone_offset_mm": choice.zone_offset_mm or None,
    }
    if choice.kind == "line_profile" and (entry is None or entry.section is None):
        raise InputError("A line profile needs a section plane: state `section` in the text of the program.", HINT)
    if entry is not None:
        kept = [one.model_dump() for one in entry.datum_material if choice.kind == "position" and one.datum in choice.datums]
        values |= {"tolerance": None, "lower_tolerance": None, "nominal": None, "datum_material": kept or None}
        return edits.change(program, Node("dimension", former), values), former
    name = edits.unique_name(program, "dimension", compound(choice.feature, word(choice.kind.replace("_", " "))))
    stated = {key: value for key, value in values.items() if value is not None}
    return edits.add(program, "dimension", {"name": name, **stated}), name


def frame_of(program: InspectionProgram, choice: ToleranceChoice, shapes: Mapping[str, str], former: str = "") -> ControlFrame:
    """Return the frame of a choice, also of one that is not allowed; a datum without a letter has the one it would be given."""
    program, choice = with_common_datums(program, choice)
    letters, commons = letters_of(program, choice.datums), features_of_commons(program)
    round_or_flat = {name: "plane" if all(shapes.get(one) == "plane" for one in of) else "line" for name, of in commons.items()}
    shapes = {**round_or_flat, **shapes}
    materials = next((one.datum_material for one in program.dimensions if one.name == former), ())
    given = DimensionProgram.model_construct(
        **{
            **{name: field.default for name, field in DimensionProgram.model_fields.items()},
            "kind": choice.kind,
            "features": (choice.feature,),
            "datums": choice.datums,
            "upper_tolerance": choice.width_mm,
            "material_condition": choice.condition,
            "zone_offset_mm": choice.zone_offset_mm,
            "datum_material": materials if choice.kind == "position" else (),
            "count": 2 if any("{" in name for name in (choice.feature, *choice.datums)) else None,
        }
    )
    frame = control_frame(given, {name: shapes.get(_one(name), "") for name in (choice.feature, *choice.datums)}, letters)
    assert frame is not None  # its kind is a characteristic, and it has a tolerance
    return frame


def with_common_datums(
    program: InspectionProgram, choice: ToleranceChoice, word: Word = english
) -> tuple[InspectionProgram, ToleranceChoice]:
    """Construct the common datums of a choice that the program does not have yet; the choice then names them as its datums."""
    names = []
    for datum, partner in zip_longest(choice.datums, choice.partners[: len(choice.datums)], fillvalue=""):
        known = features_of_commons(program)
        name = next((name for name, of in known.items() if set(of) == {datum, partner}), "") if partner else datum
        if not name:
            name = edits.unique_name(program, "feature", f"{datum}{word(' and ')}{partner}")
            program = edits.add(program, "feature", {"name": name, "shape": "common_datum", "of": [datum, partner]})
        names.append(name)
    return program, replace(choice, datums=tuple(names), partners=())


def _made_commons(commons: Mapping[str, Sequence[str]], features: Mapping[str, Feature]) -> dict[str, Feature]:
    """Return the common datums that are not among the features yet. Raises InspectionError where two features cannot be one datum."""
    made: dict[str, Feature] = {}
    for name, of in commons.items():
        parents = [features[one] for one in of if one in features]
        if name not in features and len(parents) == 2:
            made[name] = MAKERS["common_datum"](name, 0.0, parents)
    return made


def _require_datums(choice: ToleranceChoice, words: str, shapes: Mapping[str, str]) -> None:
    most = takes_datums(choice.kind)
    if choice.datums and not most:
        raise InputError(f"A {words} has no datums: it compares the feature with itself.", HINT)
    if len(choice.datums) > most == 1:
        raise InputError(f"A {words} has one datum.", HINT)
    if most and not choice.datums and choice.kind not in PROFILES:
        raise InputError(f"A {words} needs a datum.", HINT)
    if len(set(choice.datums)) < len(choice.datums):
        raise InputError("Two datums are the same feature.", HINT)
    if choice.feature in choice.datums:
        raise InputError(f"{choice.feature} cannot be the datum of its own tolerance.", HINT)
    allowed = DATUMS.get(choice.kind, (*DIRECTED, *CENTRES))
    for name in choice.datums:
        if shapes[name] and shapes[name] not in allowed:
            shape = _said(shapes[name])
            raise InputError(f"{name} is a {shape}, which cannot be a datum for {words}: it must be a {_either(allowed)}.", HINT)


def _require_system(choice: ToleranceChoice, named: Mapping[str, str], features: Mapping[str, Feature]) -> None:
    """Require that the datums as designed fix the zone as designed, where the design is stated."""
    known = [features[one] for name in (choice.feature, *choice.datums) if (one := named[name]) in features]
    if len(known) < 1 + len(choice.datums) or not choice.datums:
        return
    nominal, *datums = known
    system = datum_system(datums, datums)
    if choice.kind == "position" or choice.kind in PROFILES:
        system.require_location(nominal, choice.feature)
    elif choice.kind in ORIENTATIONS:
        exact_direction(choice.kind, _designed(nominal), tuple(_designed(one) for one in datums))


def _designed(feature: Feature) -> FoundFeature:
    return FoundFeature(feature.name, feature, nominal=feature)


def _one(name: str) -> str:
    """Return the first copy of a reference to all copies of a pattern."""
    return substitute_index((name,), 1, None)[0] if "{" in name else name


def _shape(program: InspectionProgram, name: str, features: Mapping[str, Feature]) -> str:
    if name in features:
        return str(features[name].shape)
    return next((str(one.shape) for one in program.features if one.name == name), "")


def _said(shape: str) -> str:
    return shape.replace("_", "-")


def _either(shapes: Sequence[str]) -> str:
    *first, last = (_said(one) for one in shapes)
    return f"{', '.join(first)} or {last}" if first else last


def first_choice(
    program: InspectionProgram, feature: str, datums: Sequence[str], width_mm: float, features: Mapping[str, Feature]
) -> ToleranceChoice:
    """Return the tolerance that a feature most usually gets and does not have yet, as far as it is allowed.

    Parameters
    ----------
    datums : those chosen; none: the datums of the program
    features : by name, as designed where the program says so, else as measured
    """
    shape = _shape(program, _one(feature), features)
    usual = USUAL.get(shape, ())
    letters = letters_of(program)
    offered = tuple(datums) or tuple(sorted((one for one in letters if one != feature and one in features), key=letters.__getitem__))
    had = {one.kind for one in program.dimensions if feature in one.features}
    possible = [kind for kind in usual if kind not in had and not (datums and takes_datums(kind) == 0)]
    for kind in possible:
        for count in range(min(takes_datums(kind), len(offered)), -1, -1):
            choice = ToleranceChoice(kind, feature, width_mm, offered[:count])
            if not refusal(program, choice, features):
                return choice
    kind = "position" if datums else (usual or ("flatness",))[-1]
    return ToleranceChoice(kind, feature, width_mm, tuple(datums))
