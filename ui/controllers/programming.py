"""Changes of the inspection program or the nominal: the part is measured again immediately, and every change can be undone."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.data.length_unit import LengthUnit
from measureapp.errors import InputError, UnitQuestion
from ui.controllers.jobs import JobRunner
from ui.session import Session

if TYPE_CHECKING:
    from collections.abc import Callable

    from measureapp.data.measurement import Measurement
    from measureapp.pipeline import Outcome
    from ui.workers.job import Job

TITLE = "Measuring again"


@dataclass(frozen=True)
class FormerProgram:
    """A former program, and the former nominal if it was changed."""

    program: str
    former_nominal: Path | None = None


@dataclass(frozen=True, eq=False)
class ChangedMeasurement:
    """Result with a changed program or nominal, and the former ones."""

    former: FormerProgram | None  # None: no undo, as there was no nominal
    outcome: Outcome
    words: str


@dataclass(frozen=True, eq=False)
class NominalQuestion:
    """A nominal whose unit is doubtful."""

    path: Path
    question: UnitQuestion


class ProgrammingController(QObject):
    """Measures the open project again after a change; if that fails, nothing is changed."""

    changed = Signal()
    unitAsked = Signal(object)  # Asked

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._former: list[FormerProgram] = []
        session.projectChanged.connect(self._forget)

    @property
    def can_change(self) -> bool:
        """Whether there is a measured project on disk, and no other job is running."""
        folder = self._session.folder
        measured = self._session.measurement is not None and folder is not None
        return measured and not self._session.busy_with and folder is not None and (folder / "project.json").exists()

    @property
    def can_undo(self) -> bool:
        """Whether a change of program or nominal can be undone."""
        return bool(self._former) and self.can_change

    @Slot(str, str)
    def add(self, lines: str, name: str) -> None:
        """Add a feature or dimension to the program."""
        from measureapp.project.program_text import add_entry

        self._change(lambda text: add_entry(text, lines), f"{name} added to the inspection program.")

    @Slot(str)
    def remove(self, name: str) -> None:
        """Remove a feature or dimension from the program."""
        from measureapp.project.program_text import remove_entry

        self._change(lambda text: remove_entry(text, name), f"{name} removed from the inspection program.")

    def text(self) -> str:
        """Return the program of the open project. Raises StorageError if it cannot be read."""
        from measureapp.project.folder import ProjectFolder

        if self._session.folder is None:
            return ""
        project = ProjectFolder.open(self._session.folder)
        return project.program_text(has_nominal=project.nominal is not None)

    def replace(self, text: str) -> None:
        """Measure with another program. Raises InputError if it is invalid."""
        from measureapp.project.program_file import parse_program

        parse_program(text)
        self._change(lambda _text: text, "Inspection program changed.")

    @Slot()
    def undo(self) -> None:
        """Undo the last change."""
        folder, measurement = self._session.folder, self._session.measurement
        if folder is not None and measurement is not None and self.can_undo:
            former = self._former[-1]
            self._runner.run(TITLE, lambda job: measure_former(folder, measurement, former, job), self._undo_finished)

    @Slot(object)
    def set_nominal(self, path: Path, unit: LengthUnit = LengthUnit.MM) -> None:
        """Use another nominal; its unit is asked for if it is doubtful."""
        folder, measurement = self._session.folder, self._session.measurement
        if folder is not None and measurement is not None and self.can_change:
            self._runner.run(
                "Changing the nominal", lambda job: measure_with_nominal(folder, measurement, path, unit, job), self._show_nominal
            )

    def _change(self, edit: Callable[[str], str], words: str) -> None:
        folder, measurement = self._session.folder, self._session.measurement
        if folder is not None and measurement is not None and self.can_change:
            self._runner.run(TITLE, lambda job: measure_changed(folder, measurement, edit, words, job), self._keep)

    @Slot(object)
    def _keep(self, found: ChangedMeasurement) -> None:
        if found.former is not None:
            self._former.append(found.former)
        self._show(found.outcome, found.words)

    @Slot(object)
    def _undo_finished(self, outcome: Outcome) -> None:
        self._former.pop()
        self._show(outcome, "Last change undone.")

    @Slot(object)
    def _show_nominal(self, found: ChangedMeasurement | NominalQuestion) -> None:
        if isinstance(found, NominalQuestion):
            self.unitAsked.emit(found)
        else:
            self._keep(found)

    def _show(self, outcome: Outcome, words: str) -> None:
        self._session.set_measurement(outcome.measurement, outcome.files, outcome.filters)
        self._session.tell(words, "", "done")
        self.changed.emit()

    @Slot()
    def _forget(self) -> None:
        self._former.clear()
        self.changed.emit()


def measure_changed(folder: Path, measurement: Measurement, edit: Callable[[str], str], words: str, job: Job) -> ChangedMeasurement:
    """Measure with a changed program; runs on a job's thread."""
    from measureapp.pipeline.measure_again import measure_again
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    former = project.program_text(has_nominal=project.nominal is not None)
    return ChangedMeasurement(FormerProgram(former), measure_again(project, measurement, job, program=edit(former)), words)


def measure_former(folder: Path, measurement: Measurement, former: FormerProgram, job: Job) -> Outcome:
    """Measure with the program and nominal before a change; runs on a job's thread."""
    from measureapp.pipeline.measure_again import NominalFile, measure_again
    from measureapp.project.folder import ProjectFolder

    nominal = None if former.former_nominal is None else NominalFile(former.former_nominal)
    return measure_again(ProjectFolder.open(folder), measurement, job, program=former.program, nominal_file=nominal)


def measure_with_nominal(
    folder: Path, measurement: Measurement, path: Path, unit: LengthUnit, job: Job
) -> ChangedMeasurement | NominalQuestion:
    """Measure with another nominal, or return the question for its unit; runs on a job's thread."""
    from measureapp.pipeline.measure_again import NominalFile, measure_again
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    had_one, former = project.nominal is not None, project.program_text(has_nominal=True)
    try:
        outcome = measure_again(project, measurement, job, nominal_file=NominalFile(path, unit))
    except UnitQuestion as question:
        if question.what == "nominal" and unit is LengthUnit.MM:
            return NominalQuestion(path, question)
        raise InputError(question.message, "Choose the nominal of this part, or export it in millimetres.") from question
    return ChangedMeasurement(
        FormerProgram(former, project.former_nominals()[-1]) if had_one else None, outcome, f"Nominal changed to {path.name}."
    )
