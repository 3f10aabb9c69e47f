"""Edits of the inspection program: what they change is measured again at once, and every edit can be undone until it is saved."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QUndoCommand, QUndoStack

from measureapp.data.control_frame import control_frame, with_frames
from measureapp.data.datum_letters import letters_of
from measureapp.errors import MeasureError
from ui.controllers.jobs import JobRunner
from ui.controllers.program_jobs import (
    MeasuredProgram,
    ProgramState,
    read_state,
    save_copy,
    save_state,
)
from ui.controllers.program_measuring import ProgramMeasuring
from ui.controllers.program_rows import DimensionRow, ProgramEntries, Status, changed_names
from ui.look.language.words import tr
from ui.look.wording import dimension_words, sentence_case, several
from ui.messages import MOMENT
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.dimension import Dimension
    from measureapp.data.inspection_program import InspectionProgram
    from measureapp.pipeline.run import Outcome

    Edit = Callable[[InspectionProgram], InspectionProgram]


UNSAVED = "The inspection program has edits that are not saved."
BRINGS_BACK = "Undo (Ctrl+Z) brings it back."


class EditCommand(QUndoCommand):
    """One edit: the program before and after it."""

    def __init__(self, use: Callable[[ProgramState], None], before: ProgramState, after: ProgramState, words: str) -> None:
        super().__init__(words)
        self._use, self._before, self._after = use, before, after

    def redo(self) -> None:
        """Use the edited program."""
        self._use(self._after)

    def undo(self) -> None:
        """Use the program before the edit."""
        self._use(self._before)


class ProgrammingController(QObject):
    """Holds the edited program of the open project; views watch it through `changed`."""

    saved = Signal()
    changed = Signal()  # program, results or status

    def __init__(self, session: Session, runner: JobRunner, measuring: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self.stack = QUndoStack(self)
        self.state: ProgramState | None = None
        self._measured: MeasuredProgram | None = None
        self._is_own = False
        self._reader = measuring
        self._measuring = ProgramMeasuring(session, measuring, self)
        self._measuring.measured.connect(self._keep)
        self._measuring.stopped.connect(self.changed)
        session.projectChanged.connect(self._forget)
        session.inspectionChanged.connect(self._take)

    @property
    def folder(self) -> Path | None:
        """Folder of the measured project on disk, if there is one."""
        folder = self._session.folder
        measured = self._session.measurement is not None and folder is not None
        return folder if measured and folder is not None and (folder / "project.json").exists() else None

    @property
    def can_change(self) -> bool:
        """Whether the program of a measured project on disk is at hand, and no other job is running."""
        return self.state is not None and not self._session.busy_with and self.folder is not None

    @property
    def can_undo(self) -> bool:
        """Whether an edit can be undone."""
        return self.stack.canUndo() and self.can_change

    @property
    def is_modified(self) -> bool:
        """Whether the program has edits that are not saved."""
        return self.state is not None and not self.stack.isClean()

    @property
    def is_measuring(self) -> bool:
        """Whether edits are being measured."""
        return self._measuring.is_running

    @property
    def is_current(self) -> bool:
        """Whether all results belong to the edited program."""
        return self.state is None or (self._measured is not None and self._measured.state is self.state)

    def rows(self) -> tuple[DimensionRow, ...]:
        """Return the rows of the table, in the order of the program; without a program, the last results."""
        inspection, state = self._session.inspection, self.state
        if inspection is None:
            return ()
        if state is None:
            found = inspection.dimensions
            return tuple(
                DimensionRow(place, one.name, None, one, _current(one), one.frame, one.alignment or inspection.alignment.name)
                for place, one in enumerate(found)
            )
        measured = self._measured
        stale = changed_names(None if measured is None else measured.state.program, state.program)
        shapes, letters = {one.name: str(one.shape) for one in inspection.features}, letters_of(state.program)
        results = MeasuredProgram(state, inspection).results() if measured is None else measured.results()
        return tuple(
            DimensionRow(
                number,
                entry.name,
                entry,
                results.get(number),
                _status(entry.name in stale, results.get(number), self.is_measuring),
                control_frame(entry, shapes, letters),
                entry.alignment or inspection.alignment.name,
            )
            for number, entry in zip(state.ids, state.program.dimensions, strict=True)
        )

    def text(self) -> str:
        """Return the text of the edited program."""
        return "" if self.state is None else self.state.text()

    def add(self, lines: str, name: str) -> None:
        """Add a feature or dimension, given as the lines of its entry."""
        import tomllib

        from measureapp.inspection.programming import edits

        document = tomllib.loads(lines)
        kind = "feature" if "features" in document else "dimension"
        entries = document[f"{kind}s"]
        self.edit(lambda program: edits.add(program, kind, *entries), added_words(name))

    @Slot(str)
    def remove(self, entries: ProgramEntries) -> None:
        """Remove dimensions or features."""
        from measureapp.inspection.programming import edits
        from measureapp.inspection.session.graph import Node

        count = len(entries.names)
        name = dimension_words(entries.names[0]) if count == 1 else several(count, entries.kind)
        nodes = [Node(entries.kind, one) for one in entries.names]
        if nodes:
            words = tr("{name} removed from the inspection program.", name=name)
            self.edit(lambda program: edits.remove(program, nodes), words, BRINGS_BACK)

    def replace(self, text: str) -> None:
        """Use another text. Raises InputError if it is not valid."""
        if self.state is not None:
            self._push(ProgramState.of(text, self.state), "Inspection program changed.")

    def edit(self, change: Edit, words: str, hint: str = "") -> bool:
        """Edit the program; an edit that is not possible is refused with a message. Return whether it was made."""
        if self.state is None or not self.can_change:
            _tell_why_not(self._session)
            return False
        try:
            after = change(self.state.program)
        except MeasureError as error:
            self._session.tell(error.message, error.hint, "error", cause=MOMENT)
            return False
        if after != self.state.program:
            self._push(self.state.edited(after), words, hint)
        return True

    def _push(self, after: ProgramState, words: str, hint: str = "") -> None:
        assert self.state is not None
        self.stack.push(EditCommand(self._use, self.state, after, words))
        self._show_edit()
        self._session.tell(words, hint, "done")

    def _show_edit(self) -> None:
        """Show what the stack of edits says now; while an edit is made it is still that of before."""
        self._session.unsaved = UNSAVED if self.is_modified else ""
        self.changed.emit()

    def _use(self, state: ProgramState) -> None:
        self.state = state
        self.measure()

    @Slot()
    def measure(self) -> None:
        """Measure what the results lack."""
        if self.state is not None and self.folder is not None:
            self._measuring.measure(self.state, self._measured)
        self.changed.emit()

    @Slot()
    def measure_all(self) -> None:
        """Measure every dimension again, also those whose results belong to the program; the results can be saved."""
        if self.state is not None and self.can_change:
            self._measured = None
            self.stack.resetClean()
            self.measure()
            self._show_edit()

    @Slot()
    def undo(self) -> None:
        """Undo the last edit."""
        if self.can_undo:
            words = self.stack.undoText()
            self.stack.undo()
            self._show_edit()
            self._session.tell(tr("Undone: {words}", words=words), "Ctrl+Y makes the change again.", "done")

    @Slot()
    def redo(self) -> None:
        """Make the edit again that was undone last."""
        if self.stack.canRedo() and self.can_change:
            words = self.stack.redoText()
            self.stack.redo()
            self._show_edit()
            self._session.tell(tr("Made again: {words}", words=words), "", "done")

    @Slot()
    def save(self) -> None:
        """Save the edited program with the project, and the results with the report if they belong to it."""
        folder, measurement, state = self.folder, self._session.measurement, self.state
        if folder is None or measurement is None or state is None or not self.can_change:
            _tell_why_not(self._session)
            return
        current = self.is_current
        self._runner.run(
            "Saving the program",
            lambda job: (state, save_state(folder, measurement, state, is_measured=current, job=job)),
            self._show_saved,
        )

    @Slot()
    def discard(self) -> None:
        """Drop all edits since the program was saved."""
        while self.stack.canUndo() and not self.stack.isClean():
            self.stack.undo()
        self.stack.setClean()
        self._show_edit()

    @Slot(object)
    def save_as(self, path: Path) -> None:
        """Write the edited program to a file of its own."""
        state = self.state
        if state is not None:
            self._runner.run(tr("Saving {name}", name=path.name), lambda _job: save_copy(path, state), self._show_copied)

    @Slot(object)
    def _show_saved(self, found: tuple[ProgramState, Outcome | None]) -> None:
        state, outcome = found
        if state is self.state:
            self.stack.setClean()
            self._session.unsaved = ""
        if outcome is None:
            self._session.tell("Program saved.", "The stored results are those of the program before.", "warning")
        else:
            self._session.set_files(outcome.files)
            self._session.tell("Program and results saved.", "", "done")
        self.changed.emit()
        self.saved.emit()

    @Slot(object)
    def _show_copied(self, path: Path) -> None:
        self._session.tell(tr("Program saved as {name}.", name=path.name), "", "done")

    def take_outcome(self, outcome: Outcome, state: ProgramState) -> None:
        """Use a measurement of another nominal, which was stored with the program."""
        self.state = state
        self._measuring.forget()
        self._is_own = True
        self._session.set_measurement(outcome.measurement, outcome.files, outcome.filters)
        self._is_own = False
        if outcome.measurement.inspection is not None:
            self._measured = MeasuredProgram(state, outcome.measurement.inspection)
        self.stack.setClean()
        self._show_edit()

    @Slot(object)
    def _keep(self, found: MeasuredProgram) -> None:
        self._measured, self._is_own = found, True
        self._session.replace_inspection(found.inspection)
        self._is_own = False
        self.changed.emit()

    @Slot()
    def _forget(self) -> None:
        self._measuring.forget()
        self.state = self._measured = None
        self.stack.clear()
        self._show_edit()

    @Slot()
    def _take(self) -> None:
        """Read the program of a measurement that came from elsewhere."""
        folder = self.folder
        if self._is_own:
            return
        self._measuring.forget()
        if folder is None or self._session.inspection is None:
            return
        self._reader.run("Reading the program", lambda _job: read_state(folder), self._show_read, quiet=True)

    @Slot(object)
    def _show_read(self, read: ProgramState) -> None:
        inspection = self._session.inspection
        if inspection is None or self.folder is None:
            return
        inspection = replace(inspection, dimensions=with_frames(inspection.dimensions, read.program, inspection.features))
        names = {one.name for one in inspection.dimensions}
        is_same = names == {one.name for one in read.program.dimensions}
        if not self.is_modified or self.state is None:
            self.state = read
            self.stack.clear()
            self._session.unsaved = ""
        self._measured = MeasuredProgram(read, inspection) if is_same else None  # else the file was changed since it was measured
        if self.state is not read:
            self.measure()
        self.changed.emit()


def added_words(name: str) -> str:
    """Return what is told of a new entry, by its name as tables show it."""
    return tr("{name} added to the inspection program.", name=sentence_case(name))


def _tell_why_not(session: Session) -> None:
    """Say why nothing can be changed: another job runs, or the project's folder is gone; the edits are kept in the window."""
    if session.refuse_during_job():
        return
    folder = session.folder
    if folder is not None and session.measurement is not None and not (folder / "project.json").exists():
        words = tr("The project folder {folder} is gone.", folder=folder)
        session.tell(words, "Connect its disk again, or put the folder back where it was.", "error", cause=MOMENT)


def _status(is_stale: bool, found: Dimension | None, is_measuring: bool) -> Status:
    if is_stale or found is None:
        return "calculating" if is_measuring else "stale"
    return _current(found)


def _current(found: Dimension) -> Status:
    return "failed" if found.measured is None else "current"
