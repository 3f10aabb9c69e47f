"""Changing the inspection program or the drawing by clicking: the part is measured again at once, and every change can be undone."""

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
class Former:
    """A program, and the drawing, where that was another one."""

    program: str
    drawing: Path | None = None


@dataclass(frozen=True, eq=False)
class Changed:
    """What measuring with another program or drawing gave, and what there was before."""

    former: Former | None  # None: what cannot be gone back to, as there was no drawing
    outcome: Outcome
    words: str


@dataclass(frozen=True, eq=False)
class Asked:
    """A drawing whose unit is asked for."""

    path: Path
    question: UnitQuestion


class ProgrammingController(QObject):
    """Measures the open project again after a change; where that fails, everything stays as it was."""

    changed = Signal()
    unitAsked = Signal(object)  # Asked

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._former: list[Former] = []
        session.projectChanged.connect(self._forget)

    @property
    def can_change(self) -> bool:
        """Whether there is a measured project on disk, and nothing else runs."""
        folder = self._session.folder
        measured = self._session.measurement is not None and folder is not None
        return measured and not self._session.busy_with and folder is not None and (folder / "project.json").exists()

    @property
    def can_undo(self) -> bool:
        """Whether a change of program or drawing can be taken back."""
        return bool(self._former) and self.can_change

    @Slot(str, str)
    def add(self, lines: str, name: str) -> None:
        """Add a feature or dimension to the program."""
        from measureapp.project.program_text import add_entry

        self._change(lambda text: add_entry(text, lines), f"{name} is added to the inspection program.")

    @Slot(str)
    def remove(self, name: str) -> None:
        """Take a feature or dimension out of the program."""
        from measureapp.project.program_text import remove_entry

        self._change(lambda text: remove_entry(text, name), f"{name} is taken out of the inspection program.")

    def text(self) -> str:
        """Return the program of the open project. Raises StorageError where it cannot be read."""
        from measureapp.project.folder import ProjectFolder

        if self._session.folder is None:
            return ""
        project = ProjectFolder.open(self._session.folder)
        return project.program_text(has_nominal=project.nominal is not None)

    def replace(self, text: str) -> None:
        """Measure with another program. Raises InputError where that is none."""
        from measureapp.project.program_file import parse_program

        parse_program(text)
        self._change(lambda _text: text, "The inspection program is changed.")

    @Slot()
    def undo(self) -> None:
        """Take the last change of the program back."""
        folder, measurement = self._session.folder, self._session.measurement
        if folder is not None and measurement is not None and self.can_undo:
            former = self._former[-1]
            self._runner.run(TITLE, lambda job: taken_back(folder, measurement, former, job), self._take_back)

    @Slot(object)
    def take_drawing(self, path: Path, unit: LengthUnit = LengthUnit.MM) -> None:
        """Compare with another drawing from now on; where its unit is doubtful, it is asked for."""
        folder, measurement = self._session.folder, self._session.measurement
        if folder is not None and measurement is not None and self.can_change:
            self._runner.run("Taking the drawing", lambda job: drawn(folder, measurement, path, unit, job), self._draw)

    def _change(self, edit: Callable[[str], str], words: str) -> None:
        folder, measurement = self._session.folder, self._session.measurement
        if folder is not None and measurement is not None and self.can_change:
            self._runner.run(TITLE, lambda job: changed(folder, measurement, edit, words, job), self._keep)

    @Slot(object)
    def _keep(self, found: Changed) -> None:
        if found.former is not None:
            self._former.append(found.former)
        self._show(found.outcome, found.words)

    @Slot(object)
    def _take_back(self, outcome: Outcome) -> None:
        self._former.pop()
        self._show(outcome, "The last change is taken back.")

    @Slot(object)
    def _draw(self, found: Changed | Asked) -> None:
        if isinstance(found, Asked):
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


def changed(folder: Path, measurement: Measurement, edit: Callable[[str], str], words: str, job: Job) -> Changed:
    """Return what measuring with a changed program gives; runs on a job's thread."""
    from measureapp.pipeline.measure_again import measure_again
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    former = project.program_text(has_nominal=project.nominal is not None)
    return Changed(Former(former), measure_again(project, measurement, job, program=edit(former)), words)


def taken_back(folder: Path, measurement: Measurement, former: Former, job: Job) -> Outcome:
    """Return what measuring as before a change gives; runs on a job's thread."""
    from measureapp.pipeline.measure_again import NominalFile, measure_again
    from measureapp.project.folder import ProjectFolder

    drawing = None if former.drawing is None else NominalFile(former.drawing)
    return measure_again(ProjectFolder.open(folder), measurement, job, program=former.program, nominal_file=drawing)


def drawn(folder: Path, measurement: Measurement, path: Path, unit: LengthUnit, job: Job) -> Changed | Asked:
    """Return what measuring with another drawing gives, or the question for its unit; runs on a job's thread."""
    from measureapp.pipeline.measure_again import NominalFile, measure_again
    from measureapp.project.folder import ProjectFolder

    project = ProjectFolder.open(folder)
    had_one, former = project.nominal is not None, project.program_text(has_nominal=True)
    try:
        outcome = measure_again(project, measurement, job, nominal_file=NominalFile(path, unit))
    except UnitQuestion as question:
        if question.what == "nominal" and unit is LengthUnit.MM:
            return Asked(path, question)
        raise InputError(question.message, "Choose the drawing of this part, or export it in millimetres.") from question
    return Changed(
        Former(former, project.former_nominals()[-1]) if had_one else None, outcome, f"The part is compared with {path.name} from now on."
    )
