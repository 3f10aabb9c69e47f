"""Manual use or exclusion of views, with undo."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.data.view_choices import ViewChoice, ViewChoices
    from measureapp.pipeline.run import Outcome
    from ui.workers.job import Job

TITLE = "Stitching again"


class ViewChoicesController(QObject):
    """Stitches the open project again after a choice; if that fails, nothing is changed."""

    undoChanged = Signal()

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._former: list[ViewChoices] = []
        session.projectChanged.connect(self._forget)

    @property
    def can_choose(self) -> bool:
        """Whether there are stitched views in a project on disk, and no other job is running."""
        folder = self._session.folder
        measured = self._session.measurement is not None and folder is not None
        return measured and not self._session.busy_with and folder is not None and (folder / "project.json").exists()

    @property
    def can_undo(self) -> bool:
        """Whether a choice can be undone."""
        return bool(self._former) and self.can_choose

    @Slot(str, str)
    def choose(self, viewpoint_id: str, choice: ViewChoice) -> None:
        """Use or exclude a view."""
        folder = self._session.folder
        if folder is not None and self.can_choose:
            self._runner.run(TITLE, lambda job: restitch_with_choice(folder, viewpoint_id, choice, job), self._keep)

    @Slot(bool)
    def keep_surroundings(self, keep: bool) -> None:
        """Keep the points of table, fixtures and background in the clouds, or exclude them."""
        folder = self._session.folder
        if folder is not None and self.can_choose:
            self._runner.run(TITLE, lambda job: restitch_with_surroundings(folder, job, keep=keep), self._keep)

    @Slot()
    def undo(self) -> None:
        """Undo the last choice."""
        folder = self._session.folder
        if folder is not None and self.can_undo:
            former = self._former[-1]
            self._runner.run(TITLE, lambda job: restitch_with_choices(folder, former, job), self._undo_finished)

    @Slot(object)
    def _keep(self, found: tuple[ViewChoices, Outcome]) -> None:
        self._former.append(found[0])
        self._show(found[1], "Views stitched again. The choice is saved with the project.")

    @Slot(object)
    def _undo_finished(self, outcome: Outcome) -> None:
        self._former.pop()
        self._show(outcome, "Choice undone. Views stitched again.")

    def _show(self, outcome: Outcome, words: str) -> None:
        self._session.set_measurement(outcome.measurement, outcome.files, outcome.filters)
        self._session.tell(words, "", "done")
        self.undoChanged.emit()

    @Slot()
    def _forget(self) -> None:
        self._former.clear()
        self.undoChanged.emit()


def restitch_with_choice(folder: Path, viewpoint_id: str, choice: ViewChoice, job: Job) -> tuple[ViewChoices, Outcome]:
    """Stitch with another choice for one view; return the former choices and the result. Runs on a job's thread."""
    from measureapp.project.folder import ProjectFolder

    former = ProjectFolder.open(folder).view_choices()
    return former, restitch_with_choices(folder, former.with_choice(viewpoint_id, choice), job)


def restitch_with_surroundings(folder: Path, job: Job, *, keep: bool) -> tuple[ViewChoices, Outcome]:
    """Stitch with the surroundings of the part, or without; return the former choices and the result. Runs on a job's thread."""
    from measureapp.project.folder import ProjectFolder

    former = ProjectFolder.open(folder).view_choices()
    return former, restitch_with_choices(folder, former.model_copy(update={"keep_surroundings": keep}), job)


def restitch_with_choices(folder: Path, choices: ViewChoices, job: Job) -> Outcome:
    """Stitch with these choices; runs on a job's thread."""
    from measureapp.pipeline.restitch import restitch
    from measureapp.project.folder import ProjectFolder

    return restitch(ProjectFolder.open(folder), choices, lambda _event: None, job, job.language)
