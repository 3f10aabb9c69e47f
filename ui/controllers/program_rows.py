"""Rows of the table of dimensions: entries of the edited program with their last results and their status."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from measureapp.data.datum_letters import letters_of

if TYPE_CHECKING:
    from measureapp.data.control_frame import ControlFrame
    from measureapp.data.dimension import Dimension
    from measureapp.data.inspection_program import DimensionProgram, FeatureProgram, InspectionProgram
    from measureapp.data.measurement import Inspection

Status = Literal["current", "calculating", "stale", "failed"]
STATUS_WORDS: Mapping[str, str] = {
    "current": "Current",
    "calculating": "Being measured again",
    "stale": "Stale: the program has changed since this was measured",
    "failed": "Could not be measured",
}


@dataclass(frozen=True)
class ProgramEntries:
    """Entries of a program; dimensions and features may have the same names."""

    kind: Literal["dimension", "feature"]
    names: tuple[str, ...]  # that of a pattern once
    is_pattern: bool = False  # one entry that stands for several features


@dataclass(frozen=True, eq=False)
class DimensionRow:
    """One dimension: what the program asks for, and what was measured last."""

    id: int
    name: str
    entry: DimensionProgram | None  # None: the program is not at hand, so the row cannot be edited
    found: Dimension | None  # None: not measured yet
    status: Status
    frame: ControlFrame | None = None  # of a geometrical tolerance, as the program states it
    aligned_by: str = ""  # name of the alignment that its result refers to; empty: there is no result

    @property
    def nominal(self) -> float:
        """The nominal, in mm or degrees."""
        if self.entry is not None:
            return self.entry.nominal
        return 0.0 if self.found is None else self.found.nominal

    @property
    def limits(self) -> tuple[float, float] | None:
        """Lower and upper tolerance; of a result that is current, with the bonus of its material condition. None: no tolerance."""
        if self.entry is not None and (self.status != "current" or self.found is None):
            return self.entry.limits if self.entry.is_toleranced else None
        if self.found is None or self.found.lower_tolerance is None or self.found.upper_tolerance is None:
            return None
        return self.found.lower_tolerance, self.found.upper_tolerance

    @property
    def source(self) -> str:
        """The text that the tolerance follows from, where it is more than the limits: H7, 2768-m."""
        text = "" if self.entry is None else self.entry.tolerance or ""
        return text if (text[:1].isalpha() and not text.lower().startswith("max")) or text.startswith("2768") else ""

    @property
    def unit(self) -> str:
        """The unit: mm or °."""
        words = self.entry.unit if self.entry is not None else "mm" if self.found is None else self.found.unit
        return "°" if words == "deg" else words

    @property
    def kind(self) -> str:
        """The kind of dimension."""
        return self.entry.kind if self.entry is not None else "" if self.found is None else self.found.kind

    @property
    def is_zone(self) -> bool:
        """Whether the value is the width of a tolerance zone, which has no nominal."""
        from measureapp.data.inspection_program import ZONES

        return self.kind in ZONES

    @property
    def verdict(self) -> str:
        """The verdict of the last result; none while there is no result."""
        return "" if self.found is None else str(self.found.verdict)

    @property
    def is_outdated(self) -> bool:
        """Whether the last result is that of another program, so that its verdict no longer holds."""
        return self.status in ("calculating", "stale")

    @property
    def is_linked(self) -> bool:
        """Whether the nominal follows the nominal features."""
        return self.entry is not None and self.entry.nominal_linked


def letters_shown(program: InspectionProgram | None, inspection: Inspection | None) -> dict[str, str]:
    """Return the letter of each datum by its feature; without a program, those of the last results."""
    if program is not None:
        return letters_of(program)
    found = () if inspection is None else inspection.dimensions
    return {name: letter for one in found for name, letter in zip(one.datums, one.datum_letters, strict=False)}


@dataclass(frozen=True)
class Construction:
    """What a constructed feature is made from."""

    of: tuple[str, ...]  # names of its features
    distance_mm: float | None = None  # of an offset plane or a point on an axis


def entries_by_name(entries: Sequence[FeatureProgram]) -> dict[str, FeatureProgram]:
    """Return the entry of each feature by its name; all copies of a pattern have one."""
    from measureapp.data.inspection_program import copy_names

    return {name: one for one in entries for name in copy_names(one.name, one.repeat)}


def constructions_by_name(entries: Sequence[FeatureProgram]) -> dict[str, Construction]:
    """Return what each constructed feature is made from, by its name; measured ones are not among them."""
    from measureapp.data.feature_program import ConstructedFeature, copy_names, parent_sets

    return {
        name: Construction(of, one.distance_mm)
        for one in entries
        if isinstance(one, ConstructedFeature)
        for name, of in zip(copy_names(one.name, one.repeat), parent_sets(one), strict=True)
    }


def carry_ids(names_before: Sequence[str], ids_before: Sequence[int], names: Sequence[str]) -> tuple[int, ...]:
    """Return numbers for ``names`` that outlive edits: a new name at the place of one that is gone is that one, renamed.

    >>> carry_ids(["a", "b"], [0, 1], ["a", "c"]), carry_ids(["a", "b"], [0, 1], ["b"]), carry_ids(["a"], [0], ["a", "b"])
    ((0, 1), (1,), (0, 1))
    """
    known = dict(zip(names_before, ids_before, strict=True))
    renamed = {}
    if len(names) == len(names_before):
        renamed = {place: number for place, number in enumerate(ids_before) if names_before[place] not in names}
    unused = max(ids_before, default=-1) + 1
    ids = []
    for place, name in enumerate(names):
        number = known.get(name, renamed.get(place, -1))
        if number < 0:
            number, unused = unused, unused + 1
        ids.append(number)
    return tuple(ids)


def changed_names(before: InspectionProgram | None, after: InspectionProgram) -> set[str]:
    """Return the dimensions of ``after`` that differ from ``before``, or depend on features or an alignment that do."""
    if before is None or before.alignment != after.alignment or before.features != after.features:
        changed = _affected(before, after)
    else:
        known = {one.name: one for one in before.dimensions}
        changed = {one.name for one in after.dimensions if known.get(one.name) != one}
    certified = [{one.name: one for one in program.dimensions if one.certificate is not None} for program in (before, after) if program]
    if certified[0] != certified[-1] or not changed.isdisjoint(certified[-1]):
        return {one.name for one in after.dimensions}  # they correct all lengths
    return changed


def _affected(before: InspectionProgram | None, after: InspectionProgram) -> set[str]:
    from measureapp.data.alignment_program import alignment_features
    from measureapp.data.inspection_program import copy_names

    everything = {one.name for one in after.dimensions}
    if before is None or before.alignment != after.alignment:
        return everything
    known = {one.name: one for one in before.features}
    differing = {name for one in after.features if known.get(one.name) != one for name in copy_names(one.name, one.repeat)}
    for one in after.features:  # a feature depends on earlier ones only
        if not differing.isdisjoint(getattr(one, "of", ())):
            differing.update(copy_names(one.name, one.repeat))
    if not differing.isdisjoint(alignment_features(after.alignment)):
        return everything
    measured = {one.name: one for one in before.dimensions}
    return {one.name for one in after.dimensions if measured.get(one.name) != one or not differing.isdisjoint(_needs(one))}


def _needs(dimension: DimensionProgram) -> Iterable[str]:
    return {name for names in (*dimension.feature_sets, *dimension.datum_sets) for name in names}
