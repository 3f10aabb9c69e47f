"""New features and dimensions by clicking: faces of the nominal become features, selected features propose dimensions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.controllers.jobs import JobRunner
from ui.controllers.programming import ProgrammingController, added_words
from ui.look.language.words import for_name, later, tr
from ui.messages import MOMENT
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.feature import Feature
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.inspection.programming.proposals import Proposal
    from measureapp.inspection.surface.nominal import NominalSurface

NO_MODEL = "There is no CAD model whose faces could be picked."
CHOOSE_ONE = "Choose one by Nominal…, or click Feature above the picture and grow a shape from a measured point."
NAMES = {  # of constructed features, whose words no list has
    "midplane": later("midplane"),
    "projection": later("projection"),
    "common_datum": later("common datum"),
    "offset": later("offset plane"),
    "point_on_axis": later("point on axis"),
    "best_fit_line": later("best fit line"),
    "best_fit_plane": later("best fit plane"),
    "best_fit_circle": later("best fit circle"),
}
SAME_MM, SAME_DIRECTION = 0.01, 0.99999  # of a face that is a feature already


class CreatingController(QObject):
    """Adds to the program what is clicked and chosen."""

    picked = Signal(str)  # name of the feature of the clicked face

    def __init__(self, session: Session, runner: JobRunner, programming: ProgrammingController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner, self._programming = session, runner, programming

    @property
    def program(self) -> InspectionProgram | None:
        """The edited program."""
        return None if self._programming.state is None else self._programming.state.program

    def pick(self, place_mm: np.ndarray) -> None:
        """Find the face of the nominal at a place; it becomes a feature unless it is one."""
        comparison = self._session.comparison
        surface = None if comparison is None else comparison.surface
        if surface is None:
            self._session.tell(tr(NO_MODEL), tr(CHOOSE_ONE), "warning", cause=MOMENT)
        elif self._programming.can_change:
            self._runner.run("Finding the face", lambda _job: find_face(surface, place_mm), self._keep, quiet=True)

    @Slot(object)
    def _keep(self, entry: Mapping[str, Any]) -> None:
        from measureapp.inspection.programming import edits

        program = self.program
        if program is None:
            return
        known = same_feature(program, entry)
        if known:
            self.picked.emit(known)
            return
        name = edits.unique_name(program, "feature", f"{for_name(str(entry['shape']).replace('_', ' '))} 1")
        new = {**entry, "name": name}
        if self._programming.edit(lambda program: edits.add(program, "feature", new), added_words(name)):
            self.picked.emit(name)

    def proposals(self, names: Sequence[str]) -> tuple[Proposal, ...]:
        """Return the dimensions that fit features, the most usual first."""
        program = self.program
        if program is None or not names:
            return ()
        from measureapp.inspection.programming.proposals import propose_dimensions

        return propose_dimensions(program, names, self._features(program), for_name)

    def add(self, proposal: Proposal) -> str:
        """Add the entries of a proposal; return the name of its first dimension, empty if that was refused."""
        from measureapp.inspection.programming import edits

        name = str(proposal.dimensions[0]["name"])

        def change(program: InspectionProgram) -> InspectionProgram:
            if proposal.features:
                program = edits.add(program, "feature", *proposal.features)
            program = edits.add(program, "dimension", *proposal.dimensions)
            return _linked(program, [str(one["name"]) for one in proposal.dimensions])

        return name if self._programming.edit(change, added_words(name)) else ""

    def constructions(self, names: Sequence[str]) -> tuple[str, ...]:
        """Return the shapes that can be constructed from features."""
        program = self.program
        if program is None or not names:
            return ()
        from measureapp.data.feature_program import PARENTS, THROUGH_POINTS, WITH_DISTANCE

        features = self._features(program)
        return tuple(shape for shape in (*PARENTS, *WITH_DISTANCE, *THROUGH_POINTS) if _is_possible(shape, names, features))

    def has_distance(self, shape: str) -> bool:
        """Return whether a constructed shape has a distance from what it is constructed from."""
        from measureapp.data.feature_program import WITH_DISTANCE

        return shape in WITH_DISTANCE

    def preview(self, shape: str, names: Sequence[str], distance_mm: float) -> Feature | None:
        """Return what would be constructed from features, as they are measured now; None where one of them is not.

        ``distance_mm`` is that of an offset plane or a point on an axis; others have none.
        """
        from measureapp.data.feature_program import ConstructedFeature
        from measureapp.inspection.features.constructions import MAKERS

        inspection = self._session.inspection
        known = {} if inspection is None else {one.name: one for one in inspection.features}
        if not all(name in known for name in names):
            return None
        described = ConstructedFeature.model_validate(_construction("preview", shape, names, distance_mm))
        try:
            return MAKERS[described.shape](described.name, described.distance_mm or 0.0, [known[name] for name in names])
        except MeasureError:
            return None

    def construct(self, shape: str, names: Sequence[str], distance_mm: float) -> str:
        """Add a constructed feature, with its distance where it has one; return its name, empty if that was refused."""
        from measureapp.inspection.programming import edits

        if self.program is None:
            return ""
        name = edits.unique_name(self.program, "feature", f"{for_name(NAMES.get(shape, shape.replace('_', ' ')))} 1")
        entry = _construction(name, shape, names, distance_mm)
        added = self._programming.edit(lambda program: edits.add(program, "feature", entry), added_words(name))
        return name if added else ""

    def _features(self, program: InspectionProgram) -> dict[str, Feature]:
        """Return the nominal features, and the measured ones that have no nominal."""
        from measureapp.inspection.programming.nominals import nominals_of

        inspection = self._session.inspection
        measured = {} if inspection is None else {one.name: one for one in inspection.features}
        return {**measured, **nominals_of(program)}


def find_face(surface: NominalSurface, place_mm: np.ndarray) -> Mapping[str, Any]:
    """Return the entry of the face at a place; runs on a job's thread."""
    from measureapp.inspection.programming.picking import pick_on_nominal

    return pick_on_nominal(surface, place_mm, "face").entry


def same_feature(program: InspectionProgram, entry: Mapping[str, Any]) -> str:
    """Return the name of a measured feature with the shape and position of ``entry``; empty: there is none."""
    from measureapp.data.inspection_program import MeasuredFeature

    place = np.asarray(entry["point_mm"], float)
    axis = None if entry.get("direction") is None else _unit(entry["direction"])
    for one in program.features:
        if not isinstance(one, MeasuredFeature) or one.shape != entry["shape"] or one.point_mm is None:
            continue
        away = np.asarray(one.point_mm, float) - place
        if axis is not None and one.direction is not None:
            if abs(float(axis @ _unit(one.direction))) < SAME_DIRECTION:
                continue
            along = float(away @ axis) * axis
            away = along if one.shape == "plane" else away - along if one.shape == "cylinder" else away
        radii = entry.get("radius_mm"), one.radius_mm
        if np.linalg.norm(away) < SAME_MM and (radii[0] is None or radii[1] is None or abs(radii[0] - radii[1]) < SAME_MM):
            return one.name
    return ""


def _unit(direction: Sequence[float]) -> np.ndarray:
    made = np.asarray(direction, float)
    return made / np.linalg.norm(made)


def _linked(program: InspectionProgram, names: Sequence[str]) -> InspectionProgram:
    """Link the nominals that follow from nominal features."""
    from measureapp.inspection.programming import edits

    for name in names:
        try:
            program = edits.link_nominal(program, name)
        except MeasureError:  # a zone, or a feature without a nominal position
            continue
    return program


def _construction(name: str, shape: str, names: Sequence[str], distance_mm: float = 0.0) -> dict[str, Any]:
    from measureapp.data.feature_program import WITH_DISTANCE

    entry: dict[str, Any] = {"name": name, "shape": shape, "of": list(names)}
    return {**entry, "distance_mm": distance_mm} if shape in WITH_DISTANCE else entry


def _is_possible(shape: str, names: Sequence[str], features: Mapping[str, Feature]) -> bool:
    from pydantic import ValidationError

    from measureapp.data.feature_program import ConstructedFeature
    from measureapp.inspection.features.constructions import MAKERS

    parents = [features[name] for name in names if name in features]
    if len(parents) < len(names):
        return False
    try:
        described = ConstructedFeature.model_validate(_construction("one", shape, names))
        MAKERS[described.shape]("one", described.distance_mm or 0.0, parents)
    except (ValidationError, MeasureError, ValueError, TypeError):
        return False
    return True
