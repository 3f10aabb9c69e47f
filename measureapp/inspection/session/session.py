"""Inspection session: points, nominal and settings stay, programs change; results are kept by what they depend on."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from threading import Lock

import numpy as np

from measureapp.data.datum_letters import letters_of
from measureapp.data.dimension import Dimension
from measureapp.data.inspection_program import DimensionProgram, InspectionProgram, MeasuredFeature, copy_names
from measureapp.data.measurement import Alignment, Inspection
from measureapp.data.mesh import Mesh
from measureapp.errors import InspectionError
from measureapp.inspection.alignment.align import align
from measureapp.inspection.alignment.best_fit import best_fit
from measureapp.inspection.certified_lengths import CertifiedLengths
from measureapp.inspection.features.found_feature import FoundFeature
from measureapp.inspection.find_features import find_entry, find_features
from measureapp.inspection.measured_points import HasPoints, MeasuredPoints
from measureapp.inspection.session.graph import ALIGNMENT, Node
from measureapp.inspection.session.keys import ProgramKeys
from measureapp.inspection.session.rows import Row, copies_of, list_rows
from measureapp.inspection.session.store import Store
from measureapp.inspection.session.temperature import at_reference, length_statements
from measureapp.inspection.session.values import Evaluated, certified_lengths, certified_statements, decide, evaluate
from measureapp.inspection.settings import InspectionSettings
from measureapp.inspection.surface.nominal import NominalSurface
from measureapp.inspection.surface.units import check_unit, check_unit_against
from measureapp.progress import NoProgress, PartOf, Progress

PLACEMENTS, FEATURES, VALUES = 4, 2000, 5000  # most results kept
Found = Mapping[str, FoundFeature]


@dataclass(frozen=True, slots=True, eq=False)
class Placement:
    """The points in one alignment, or the reason why there is none."""

    alignment: Alignment | None
    points: MeasuredPoints | None
    failure: InspectionError | None = None


@dataclass(frozen=True, slots=True, eq=False)
class SessionResult:
    """Result of one measurement of a session."""

    inspection: Inspection
    rows: tuple[Row, ...]  # of all alignments, features and dimensions
    measured: frozenset[Node]  # what had to be measured; all else was known


class InspectionSession:
    """Measures changing programs on the same points; one measurement at a time, `rows` from any thread.

    Results are kept by the content of everything they depend on, and are identical to those of a new session.

    Parameters
    ----------
    measured : stitched cloud, cloud, plain points or mesh, in the part's frame
    nominal : mesh of the nominal; needed for a best fit, and to exclude points near its edges
    alignment : known alignment; None: the one the program defines
    """

    def __init__(
        self,
        measured: MeasuredPoints | HasPoints | Mesh,
        nominal: Mesh | NominalSurface | None = None,
        settings: InspectionSettings = InspectionSettings(),  # noqa: B008 - frozen
        alignment: Alignment | None = None,
    ) -> None:
        self._measured, self._nominal, self.settings, self._given = measured, nominal, settings, alignment
        self._points: MeasuredPoints | None = None
        self._surface: NominalSurface | None = None
        self._first_fit: Alignment | None = None
        self._placements: Store[Placement] = Store(PLACEMENTS)
        self._features: Store[Found] = Store(FEATURES)
        self._values: Store[Evaluated] = Store(VALUES)
        self._measuring = Lock()

    def measure(self, program: InspectionProgram, progress: Progress = NoProgress()) -> SessionResult:  # noqa: B008 - stateless
        """Evaluate the features and dimensions of ``program``; what an earlier call measured is not measured again.

        Raises
        ------
        InspectionError
            There are no points, the program's alignment fails, or the points are in another unit. A single feature, dimension or
            further alignment without a result does not raise: it keeps its place with its reason.
        """
        with self._measuring:
            return self._measure(program, progress)

    def rows(self, program: InspectionProgram) -> tuple[Row, ...]:
        """Return the status of every entry of ``program`` without measuring anything."""
        keys = ProgramKeys.of(program)
        copies = copies_of(program)
        dimensions = {one.name: one for one in program.dimensions}

        def result(node: Node) -> Placement | Found | Evaluated | None:
            if node.kind == "alignment":
                return self._placements.peek(keys.alignments[node.name or None])
            if node.kind == "feature":
                return self._features.peek(keys.feature(copies[node.name][0], None))
            return self._values.peek(keys.value(dimensions[node.name]))

        return list_rows(program, lambda node: result(node) is not None, lambda node: _failure(result(node)))

    def found(self, program: InspectionProgram, name: str) -> FoundFeature | None:
        """Return a feature (or one copy of a pattern) with its points, if it was measured for this definition."""
        keys = ProgramKeys.of(program)
        kept = self._features.peek(keys.feature(name, None)) if name in keys.definitions else None
        return None if kept is None else kept[name]

    def _measure(self, program: InspectionProgram, progress: Progress) -> SessionResult:
        keys, measured = ProgramKeys.of(program), set[Node]()
        progress.report(0, 3, "alignment")
        main = self._place(program, None, keys, measured, PartOf(progress, 0.0, 1 / 3))
        if main.failure is not None or main.alignment is None or main.points is None:
            raise main.failure or InspectionError("There is no alignment.", "Choose another alignment.")
        progress.report(1, 3, "features")
        found = self._find(program, None, main.points, keys, measured, progress)
        if self._surface is None:
            self._check_unit(main.points, found, program)
        progress.report(2, 3, "dimensions")
        others = {None: found, **self._find_in_other_alignments(program, keys, measured, PartOf(progress, 2 / 3, 0.8))}
        standards = {name: certified_lengths(program, one, self.settings) for name, one in others.items()}
        letters, dimensions = letters_of(program), []
        for number, described in enumerate(program.dimensions):
            progress.report(0.8 + 0.2 * number / len(program.dimensions), 1, described.name)
            alignment = described.alignment
            dimensions.append(self._dimension(described, others[alignment], standards[alignment], letters, keys, measured))
        features = tuple(one.feature for one in found.values() if one.feature is not None)
        further = {
            one.name: placed.alignment
            for one in program.alignments
            if (placed := self._placements.peek(keys.alignments[one.name])) is not None and placed.alignment is not None
        }
        progress.report(3, 3, "inspection complete")
        statements = (*length_statements(self.settings), *certified_statements(program, dimensions, standards[None].contradiction))
        inspection = Inspection(program.name, main.alignment, features, tuple(dimensions), further, statements)
        return SessionResult(inspection, self.rows(program), frozenset(measured))

    def _prepare(self) -> MeasuredPoints:
        if self._points is None:
            self._points = at_reference(MeasuredPoints.of(self._measured), self.settings.temperature)
            if self._nominal is not None:
                self._surface = self._nominal if isinstance(self._nominal, NominalSurface) else NominalSurface(self._nominal)
        return self._points

    def _place(self, program: InspectionProgram, name: str | None, keys: ProgramKeys, measured: set[Node], progress: Progress) -> Placement:
        placed, made = self._placements.get(keys.alignments[name], lambda: self._align(program, name, progress))
        if made:
            measured.add(Node("alignment", name or ALIGNMENT))
        return placed

    def _align(self, program: InspectionProgram, name: str | None, progress: Progress) -> Placement:
        points = self._prepare()
        chosen = next((one.alignment for one in program.alignments if one.name == name), program.alignment)
        frame = getattr(self._measured, "frame", "part")
        given = self._given if name is None else None
        try:
            if given is None and self._surface is not None and chosen.method != "none":
                self._first_fit = self._first_fit or best_fit(points, self._surface, self.settings.alignment, frame, progress)
            described = program.model_copy(update={"alignment": chosen})
            made = given or align(points, described, self._surface, self.settings, frame, progress, self._first_fit)
        except InspectionError as failure:
            return Placement(None, None, failure)
        heat = 0.0 if self.settings.temperature is None else self.settings.temperature.sigma
        placed = points.seen_from(made.nominal_from_part).with_scale_uncertainty(self.settings.uncertainty.scale_ppm, heat)
        if given is None and chosen.method != "none":
            placed = placed.remove_alignment_motion()
        if self._surface is not None and name is None:
            check_unit_against(placed, self._surface)
        return Placement(made, placed)

    def _find(
        self,
        program: InspectionProgram,
        alignment: str | None,
        points: MeasuredPoints,
        keys: ProgramKeys,
        measured: set[Node],
        progress: Progress = NoProgress(),  # noqa: B008 - stateless
        only: frozenset[str] | None = None,
    ) -> dict[str, FoundFeature]:
        """Find the entries of the program, or only those with these names, in one alignment."""
        found: dict[str, FoundFeature] = {}
        for number, described in enumerate(program.features):
            if only is not None and described.name not in only:
                continue
            progress.report(1 + number / len(program.features), 3, described.name)
            key = keys.feature(copy_names(described.name, described.repeat)[0], alignment)
            made = key not in self._features
            kept, _ = self._features.get(key, lambda one=described: find_entry(one, points, found, self._surface, self.settings))  # type: ignore[misc]
            found.update(kept)
            if made:
                measured.add(Node("feature", described.name))
        return found

    def _find_in_other_alignments(
        self, program: InspectionProgram, keys: ProgramKeys, measured: set[Node], progress: Progress
    ) -> dict[str | None, dict[str, FoundFeature]]:
        """Find what the dimensions with an alignment of their own need; where that fails, features without a result."""
        others: dict[str | None, dict[str, FoundFeature]] = {}
        for named in program.alignments:
            using = [one for one in program.dimensions if one.alignment == named.name]
            placed = self._place(program, named.name, keys, measured, progress)
            if not using:
                continue
            using += [one for one in program.dimensions if one.certificate is not None and one not in using]  # correct theirs
            names = {name for one in using for names in (*one.feature_sets, *one.datum_sets) for name in names}
            if placed.points is None:
                reason = f"the alignment {named.name} failed: {placed.failure.message if placed.failure else ''}"
                others[named.name] = {name: FoundFeature(name, None, reason) for name in names}
                continue
            entries = _with_ancestors(program, {keys.entries[name] for name in names})
            others[named.name] = self._find(program, named.name, placed.points, keys, measured, progress, entries)
        return others

    def _dimension(
        self,
        described: DimensionProgram,
        found: Found,
        certified: CertifiedLengths,
        letters: Mapping[str, str],
        keys: ProgramKeys,
        measured: set[Node],
    ) -> Dimension:
        evaluated, made = self._values.get(keys.value(described), lambda: evaluate(described, found, self.settings, certified))
        if made:
            measured.add(Node("dimension", described.name))
        return decide(described, evaluated, found, self.settings, letters)

    def _check_unit(self, points: MeasuredPoints, found: Found, program: InspectionProgram) -> None:
        """Without a nominal mesh, ask about the unit of points whose features are found in another unit only."""
        names = [name for one in program.features if isinstance(one, MeasuredFeature) for name in copy_names(one.name, one.repeat)]

        def agreeing(factor: float) -> float:
            if factor < 1.0:
                return 0.0  # strongly reduced, any points match a feature near the origin
            scaled = replace(points, points_mm=points.points_mm * factor)
            taken = found if factor == 1.0 else find_features(scaled, program, None, self.settings)
            return float(np.mean([taken[name].feature is not None for name in names])) if names else 1.0

        check_unit(agreeing, "of the features are found")


def _failure(result: Placement | Found | Evaluated | None) -> str | None:
    if isinstance(result, Placement):
        return None if result.failure is None else result.failure.message
    if isinstance(result, Evaluated):
        return None if result.value is not None else result.reason
    if result is None or all(one.feature is not None for one in result.values()):
        return None
    return next(one.reason for one in result.values() if one.feature is None)


def _with_ancestors(program: InspectionProgram, entries: set[str]) -> frozenset[str]:
    from measureapp.inspection.session.graph import Graph

    graph = Graph.of(program)
    above = {parent.name for name in entries for parent in graph.ancestors(Node("feature", name))}
    return frozenset(entries | above)
