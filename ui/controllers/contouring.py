"""Circles, slots, lines, edges and hole patterns by clicking: clicks become an entry, which is tried on the points before it is added."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.controllers.jobs import JobRunner
from ui.controllers.programming import ProgrammingController, added_words
from ui.look.language.words import for_name, later, tr
from ui.look.wording import sentence, with_hint
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.cloud import StitchedCloud
    from measureapp.data.feature import Feature
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.data.measurement import Alignment
    from measureapp.inspection.features.found_feature import FoundFeature
    from measureapp.inspection.programming.clicking.describe import Clickable
    from measureapp.inspection.surface.nominal import NominalSurface
    from ui.workers.job import Job

    Entry = dict[str, Any]

WALL = later("Click the wall of the hole or pin, or the face beside it.")
STEPS: Mapping[str, tuple[str, ...]] = {  # what to click, on a CAD model
    "circle": (WALL,),
    "slot": (later("Click the wall of the slot, or the face beside it."),),
    "line": (later("Click where the line begins."), later("Click where the line ends, on the same face.")),
    "edge": (later("Click the edge."),),
    "pattern": (later("Click one of the holes, or the face beside it; all equal ones are found."),),
}
STEPS_ON_POINTS: Mapping[str, tuple[str, ...]] = {  # without a CAD model
    "circle": (
        later("Click the wall of the hole or pin: the first of three places around it."),
        later("Click the second place, on the same wall."),
        later("Click the third place, on the same wall."),
    ),
    "slot": (
        later("Click the wall of the slot at one of its round ends."),
        later("Click its wall at the other end."),
        later("Click the wall of one straight side."),
        later("Click the wall of the other side."),
    ),
    "line": STEPS["line"],
    "edge": (later("Click one face of the edge, beside it."), later("Click the other face of the edge.")),
    "pattern": (),
}
NAMES = {"pattern": later("hole pattern")}  # of new features, where it is not the kind
NO_MODEL = "Without a CAD model a hole pattern is made from circles: create two or more, select them in the list, then choose Hole pattern."
PROVE = "Check the values, then choose Create."
NOTHING = "There is nothing at the clicked place: click the part."


@dataclass(frozen=True)
class Contour:
    """A feature in the making."""

    kind: Clickable
    name: str
    surface: NominalSurface | None  # None: no CAD model
    places: tuple[np.ndarray, ...] = ()  # clicked
    entry: Entry | None = None
    tried: tuple[FoundFeature, ...] = ()  # the entry on the measured points, each copy of it
    problem: str = ""  # why it cannot be used, and what to do
    is_working: bool = False

    @property
    def steps(self) -> tuple[str, ...]:
        """What to click, in this order."""
        return (STEPS_ON_POINTS if self.surface is None else STEPS)[self.kind]

    @property
    def found(self) -> tuple[Feature, ...]:
        """The features that the trial found."""
        return tuple(one.feature for one in self.tried if one.feature is not None)

    @property
    def can_create(self) -> bool:
        """Whether it is described, and found on the part."""
        return self.entry is not None and bool(self.found) and not self.is_working


class ContouringController(QObject):
    """Holds the feature in the making; None while there is none."""

    changed = Signal()
    created = Signal(object)  # names of the new feature, or of its copies

    def __init__(self, session: Session, runner: JobRunner, programming: ProgrammingController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner, self._programming = session, runner, programming
        self.contour: Contour | None = None
        self._creates = False  # as soon as the trial of changed values succeeds
        session.projectChanged.connect(self.cancel)
        session.cloudsChanged.connect(self.cancel)

    @property
    def is_on(self) -> bool:
        """Whether clicks are meant for a feature in the making."""
        return self.contour is not None

    @property
    def can_undo(self) -> bool:
        """Whether a click can be undone."""
        return self.contour is not None and bool(self.contour.places)

    @Slot(str, object)
    def begin(self, kind: Clickable, selected: Sequence[str] = ()) -> None:
        """Begin a feature; a hole pattern may be made from selected features."""
        from measureapp.inspection.programming import edits

        state, comparison = self._programming.state, self._session.comparison
        if state is None or not self._programming.can_change:
            return
        name = edits.unique_name(state.program, "feature", f"{for_name(NAMES.get(kind, kind))} 1")
        contour = Contour(kind, name, None if comparison is None else comparison.surface)
        if kind == "pattern" and len(selected) > 1:
            try:
                entry = self._pattern(state.program, selected, name)
            except MeasureError as error:
                self._show(replace(contour, problem=with_hint(error.message, error.hint)))
            else:
                self._try(replace(contour, entry=entry))
            return
        self._show(replace(contour, problem="" if contour.steps else tr(NO_MODEL)))

    def click(self, place_mm: np.ndarray | None) -> None:
        """Take a click at a place in the nominal's frame; the last one that is needed describes the feature. None: the background."""
        contour = self.contour
        if contour is None or contour.is_working or not contour.steps:
            return
        if place_mm is None:
            self._show(replace(contour, problem=tr(NOTHING)))
            return
        if contour.entry is not None:  # another place in place of the last
            contour = replace(contour, entry=None, tried=(), places=contour.places[:-1])
        contour = replace(contour, places=(*contour.places, np.asarray(place_mm, float)), problem="")
        if len(contour.places) < len(contour.steps):
            self._show(contour)
        else:
            self._try(contour)

    @Slot()
    def undo(self) -> None:
        """Undo the last click."""
        if self.contour is not None and self.contour.places:
            self._show(replace(self.contour, places=self.contour.places[:-1], entry=None, tried=(), problem="", is_working=False))

    @Slot()
    def cancel(self) -> None:
        """Leave the program as it is."""
        if self.contour is not None:
            self._show(None)

    def change(self, entry: Entry) -> None:
        """Use other values, and try them on the points."""
        if self.contour is not None and entry != self.contour.entry:
            self._try(replace(self.contour, entry=entry, tried=(), problem=""))

    def create(self, entry: Entry) -> None:
        """Add the feature with these values to the program, once they are found on the part."""
        contour = self.contour
        if contour is None:
            return
        if entry != contour.entry:
            self._creates = True
            self.change(entry)
        elif contour.can_create:
            self._add(contour)

    def _add(self, contour: Contour) -> None:
        from measureapp.inspection.programming import edits
        from measureapp.inspection.programming.clicking.patterns import copies_of

        entry = contour.entry
        assert entry is not None
        if self._programming.edit(lambda program: edits.add(program, "feature", entry), added_words(contour.name)):
            self._show(None)
            self.created.emit(copies_of(entry))

    def _pattern(self, program: InspectionProgram, selected: Sequence[str], name: str) -> Entry:
        from measureapp.inspection.programming.clicking.patterns import pattern_of_selected
        from measureapp.inspection.programming.nominals import nominals_of

        return pattern_of_selected(program, selected, dict(nominals_of(program)), name)

    def _try(self, contour: Contour) -> None:
        """Describe the feature from its clicks, if that was not done yet, and try it on the points."""
        stitched, inspection = self._session.stitched, self._session.inspection
        if stitched is None or inspection is None:
            return
        self._show(replace(contour, is_working=True))
        working, alignment = self.contour, inspection.alignment
        assert working is not None
        self._runner.run("Finding the feature", lambda job: try_contour(working, stitched, alignment, job), self._keep, quiet=True)

    @Slot(object)
    def _keep(self, found: tuple[Contour, Contour]) -> None:
        asked, contour = found
        if asked is not self.contour:  # cancelled, or clicked again
            return
        creates, self._creates = self._creates, False
        self._show(contour)
        if creates and contour.can_create:
            self._add(contour)

    def _show(self, contour: Contour | None) -> None:
        self.contour = contour
        if contour is None:
            self._creates = False
        self.changed.emit()


def try_contour(contour: Contour, stitched: StitchedCloud, alignment: Alignment, job: Job) -> tuple[Contour, Contour]:
    """Return a contour as it was and with its entry and trial, or with the reason why its clicks give none; runs on a job's thread.

    The reason is no failure of the job: it is said where the clicks are guided, and ends with the next one.
    """
    from measureapp.inspection.measured_points import MeasuredPoints
    from measureapp.inspection.programming.clicking.describe import describe_on_nominal, describe_on_points, try_feature

    points = MeasuredPoints.of(stitched).seen_from(alignment.nominal_from_part)
    entry = contour.entry
    try:
        if entry is None and contour.surface is None:
            entry = describe_on_points(contour.kind, points, contour.places, contour.name)
        elif entry is None and contour.surface is not None:
            entry = describe_on_nominal(contour.kind, contour.surface, contour.places, contour.name)
        assert entry is not None
        tried = try_feature(entry, points, contour.surface, job)
    except MeasureError as error:
        kept = contour.places if contour.entry is not None else contour.places[:-1]  # the last click is needed again
        return contour, replace(contour, places=kept, problem=with_hint(error.message, error.hint), is_working=False)
    reason = "" if any(one.feature is not None for one in tried) else _reason(tried[0])
    return contour, replace(contour, entry=entry, tried=tried, problem=reason, is_working=False)


def _reason(found: FoundFeature) -> str:
    """Return why a feature was not found, with a remedy."""
    why = sentence(found.reason.removeprefix(f"{found.name}: ").rstrip("."))
    return tr("{why} Click where more was measured, or change the values.", why=why)
