"""Using a view that was left out, or leaving one out that was used, and taking that back."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.data.view_choices import ViewChoice, ViewChoices
    from measureapp.pipeline import Outcome
    from ui.workers.job import Job

TITLE = "Stitching again"


class ViewChoicesController(QObject):
    """Stitches the open project again after a choice; the session changes when that is complete, and not at all where it fails."""

    undoChanged = Signal()

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._former: list[ViewChoices] = []
        session.projectChanged.connect(self._forget)

    @property
    def can_choose(self) -> bool:
        """Whether there are stitched views in a project on disk, and nothing else runs."""
        folder = self._session.folder
        measured = self._session.measurement is not None and folder is not None
        return measured and not self._session.busy_with and folder is not None and (folder / "project.json").exists()

    @property
    def can_undo(self) -> bool:
        """Whether a choice can be taken back."""
        return bool(self._former) and self.can_choose

    @Slot(str, str)
    def choose(self, viewpoint_id: str, choice: ViewChoice) -> None:
        """Use a view, or refuse it, from now on."""
        folder = self._session.folder
        if folder is not None and self.can_choose:
            self._runner.run(TITLE, lambda job: restitched(folder, viewpoint_id, choice, job), self._keep)

    @Slot()
    def undo(self) -> None:
        """Take the last choice back."""
        folder = self._session.folder
        if folder is not None and self.can_undo:
            former = self._former[-1]
            self._runner.run(TITLE, lambda job: restitched_with(folder, former, job), self._take_back)

    @Slot(object)
    def _keep(self, found: tuple[ViewChoices, Outcome]) -> None:
        self._former.append(found[0])
        self._show(found[1], "The views are stitched again. The choice is kept with the project.")

    @Slot(object)
    def _take_back(self, outcome: Outcome) -> None:
        self._former.pop()
        self._show(outcome, "The choice is taken back, and the views are stitched again.")

    def _show(self, outcome: Outcome, words: str) -> None:
        self._session.set_measurement(outcome.measurement, outcome.files, outcome.filters)
        self._session.tell(words, "", "done")
        self.undoChanged.emit()

    @Slot()
    def _forget(self) -> None:
        self._former.clear()
        self.undoChanged.emit()


def restitched(folder: Path, viewpoint_id: str, choice: ViewChoice, job: Job) -> tuple[ViewChoices, Outcome]:
    """Return the former choices, and what stitching with another one gives; runs on a job's thread."""
    from measureapp.project.folder import ProjectFolder

    former = ProjectFolder.open(folder).view_choices()
    return former, restitched_with(folder, former.with_choice(viewpoint_id, choice), job)


def restitched_with(folder: Path, choices: ViewChoices, job: Job) -> Outcome:
    """Return what stitching with these choices gives; runs on a job's thread."""
    from measureapp.pipeline.restitch import restitch
    from measureapp.project.folder import ProjectFolder

    return restitch(ProjectFolder.open(folder), choices, lambda _event: None, job)
