"""Proposals: the dimensions that fit the selected features, ready to be added to the program."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from measureapp.data.dimension_program import FORMS
from measureapp.data.feature import Feature
from measureapp.data.inspection_program import ConstructedFeature, DimensionProgram, InspectionProgram, copy_names
from measureapp.errors import InspectionError
from measureapp.inspection.evaluate import evaluate_nominal
from measureapp.inspection.features.constructions import MAKERS
from measureapp.inspection.programming.edits import unique_name
from measureapp.inspection.programming.names import Word, compound, english
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.value import AXES, CENTRES

Entry = Mapping[str, Any]
PARALLEL_DEG, PERPENDICULAR_DEG = 3.0, 3.0
COAXIAL_MM = 0.5
DIGITS = 4  # of a proposed nominal
PATTERN_COPY = re.compile(r"(.+)\.(\d+)")
ZONE_MM = 0.1  # proposed width of a zone
ONE: Mapping[str, tuple[str, ...]] = {
    "cylinder": ("diameter", "cylindricity"),
    "circle": ("diameter",),
    "sphere": ("diameter",),
    "cone": ("cone_angle",),
    "plane": ("flatness",),
    "slot": ("slot_width", "slot_length"),
    "line": ("straightness",),
}
ZONES = ("flatness", "cylindricity", "straightness", "coaxiality", "perpendicularity")


@dataclass(frozen=True, slots=True)
class Proposal:
    """Entries to add with `edits.add`: features first, then dimensions."""

    kind: str  # of its first dimension, or "pitch_circle"
    features: tuple[Entry, ...]
    dimensions: tuple[Entry, ...]


def propose_dimensions(
    program: InspectionProgram, names: Sequence[str], features: Mapping[str, Feature], word: Word = english
) -> tuple[Proposal, ...]:
    """Return the dimensions that fit the selected features, the most usual first; nothing where none does.

    Parameters
    ----------
    names : selected features in the order of their selection; the name of a pattern stands for all its copies
    features : nominal features of the program (`nominals_of`), or the measured ones where there is no nominal
    word : says the words of the new names
    """
    expanded = _expand(program, names)
    chosen = [features[name] for name in expanded if name in features]
    if not chosen or len(chosen) < len(expanded):
        return ()
    constructed = _constructed(program)
    if len(chosen) == 1:
        kinds = [kind for kind in ONE.get(chosen[0].shape, ()) if not (kind in FORMS and chosen[0].name in constructed)]
        return tuple(_single(program, kind, chosen[0], features, word) for kind in kinds)
    if len(chosen) == 2:
        return tuple(one for one in _pair(program, chosen[0], chosen[1], features, word) if not _lacks_surface(one, constructed))
    return _pattern(program, expanded, chosen, features, word)


def _constructed(program: InspectionProgram) -> frozenset[str]:
    """Return the names of the constructed features: they have no measured surface, and so neither form nor length."""
    made = [one for one in program.features if isinstance(one, ConstructedFeature)]
    return frozenset(name for one in made for name in copy_names(one.name, one.repeat))


def _lacks_surface(proposal: Proposal, constructed: frozenset[str]) -> bool:
    """Return whether a zone is proposed that needs the surface or the length of a constructed feature."""
    entry = proposal.dimensions[0]
    return proposal.kind == "perpendicularity" and entry["features"][0] in constructed


def _expand(program: InspectionProgram, names: Sequence[str]) -> list[str]:
    copies = {one.name: copy_names(one.name, one.repeat) for one in program.features}
    return list(dict.fromkeys(name for given in names for name in copies.get(given, (given,))))


def _single(program: InspectionProgram, kind: str, feature: Feature, features: Mapping[str, Feature], word: Word) -> Proposal:
    return _proposal(program, kind, compound(feature.name, word(kind.replace("_", " "))), (feature.name,), features)


def _pair(program: InspectionProgram, first: Feature, second: Feature, features: Mapping[str, Feature], word: Word) -> tuple[Proposal, ...]:
    kinds = _kinds_of_pair(first, second)
    found = []
    for kind in kinds:
        if kind in ZONES:
            axis, datum = (first, second) if first.shape in AXES else (second, first)
            found.append(_proposal(program, kind, compound(axis.name, word(kind)), (axis.name,), features, (datum.name,)))
        else:
            found.append(_proposal(program, kind, f"{first.name} – {second.name}", (first.name, second.name), features))
    return tuple(found)


def _kinds_of_pair(first: Feature, second: Feature) -> tuple[str, ...]:
    shapes = {first.shape, second.shape}
    if first.shape in CENTRES or second.shape in CENTRES:
        return ("distance",)
    angle = _angle_deg(first, second)
    if shapes == {"plane"}:
        return ("distance",) if angle < PARALLEL_DEG else ("angle",)
    if "plane" in shapes:  # the direction of the plane is its normal
        if angle > 90 - PARALLEL_DEG:
            return ("distance",)
        return ("perpendicularity", "angle") if angle < PERPENDICULAR_DEG else ("angle",)
    if angle > PARALLEL_DEG:
        return ("angle",)
    apart = np.linalg.norm(np.cross(second.point_mm - first.point_mm, first.direction)) if first.direction is not None else 0.0
    return ("coaxiality",) if apart < COAXIAL_MM else ("distance",)


def _angle_deg(first: Feature, second: Feature) -> float:
    if first.direction is None or second.direction is None:
        return 0.0
    return float(np.degrees(np.arccos(np.clip(abs(float(first.direction @ second.direction)), 0, 1))))


def _pattern(
    program: InspectionProgram, names: Sequence[str], chosen: Sequence[Feature], features: Mapping[str, Feature], word: Word
) -> tuple[Proposal, ...]:
    """Propose the pitch circle of three or more holes or centres, and, for all copies of a pattern, their spacing.

    Nothing where they determine no circle, as coaxial cylinders do not.
    """
    if any(one.shape not in (*AXES, *CENTRES) for one in chosen) or (radius := _mean_radius(chosen)) is None:
        return ()
    stem = _whole_pattern(program, names)
    of: Entry = {"of": [f"{stem}.{{k}}"], "count": len(names)} if stem else {"of": list(names)}
    circle = unique_name(program, "feature", compound(stem or names[0], word("pitch circle")))
    feature = {"name": circle, "shape": "pitch_circle", **of}
    wanted = unique_name(program, "dimension", compound(circle, word("diameter")))
    dimensions: list[Entry] = [{"name": wanted, "kind": "diameter", "features": [circle], "nominal": round(2 * radius, DIGITS)}]
    if stem:
        pair = [f"{stem}.{{k}}", f"{stem}.{{k+1}}"]
        spacing = unique_name(program, "dimension", compound(stem, word("spacing")))
        entry = {"name": spacing, "kind": "distance", "features": pair, "nominal": 0.0, "count": len(names)}
        dimensions.append({**entry, "nominal": _nominal(entry, features)})
    return (Proposal("pitch_circle", (feature,), tuple(dimensions)),)


def _whole_pattern(program: InspectionProgram, names: Sequence[str]) -> str:
    """Return the name of the pattern whose copies are all selected, and nothing else; empty for none."""
    match = PATTERN_COPY.fullmatch(names[0])
    for one in program.features:
        if match and one.name == match[1] and one.repeat is not None and set(names) == set(copy_names(one.name, one.repeat)):
            return one.name
    return ""


def _mean_radius(chosen: Sequence[Feature]) -> float | None:
    try:
        return MAKERS["pitch_circle"]("pitch circle", 0.0, chosen).radius_mm
    except InspectionError:  # their axes or centres are on one line
        return None


def _proposal(
    program: InspectionProgram,
    kind: str,
    wanted: str,
    names: tuple[str, ...],
    features: Mapping[str, Feature],
    datums: tuple[str, ...] = (),
) -> Proposal:
    entry: dict[str, Any] = {"name": unique_name(program, "dimension", wanted), "kind": kind, "features": list(names)}
    if kind in ZONES:
        entry |= {"upper_tolerance": ZONE_MM} | ({"datums": list(datums)} if datums else {})
    else:
        entry["nominal"] = 0.0
        entry["nominal"] = _nominal(entry, features)
    return Proposal(kind, (), (entry,))


def _nominal(entry: Entry, features: Mapping[str, Feature]) -> float:
    try:
        return round(evaluate_nominal(DimensionProgram.model_validate(entry), features, InspectionSettings()), DIGITS) + 0.0
    except InspectionError:
        return 0.0
