"""What is computed of one view from its stored images, on a separate thread."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Generic, Protocol, TypeVar

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from pathlib import Path

    from measureapp.errors import MeasureError
    from ui.workers.job import Job


class OfView(Protocol):
    """A result that knows its view."""

    @property
    def viewpoint_id(self) -> str:
        """Viewpoint of the images."""


Found = TypeVar("Found", bound=OfView)


class ViewWorkController(QObject, Generic[Found]):
    """Computes one kind of result of views of the open project; the last one is kept until another project is opened."""

    progressed = Signal(float, str)
    found = Signal(object)  # the result
    stopped = Signal(str)  # reason of the failure; empty when cancelled
    forgotten = Signal()

    def __init__(
        self, session: Session, runner: JobRunner, words: str, work: Callable[[Path, str, Job], Found], parent: QObject | None = None
    ) -> None:
        """``words`` name the job with its ``{viewpoint_id}``; ``work(folder, viewpoint_id, job)`` runs on the job's thread."""
        super().__init__(parent)
        self._session, self._runner, self._words, self._work = session, runner, words, work
        self._last: Found | None = None
        self._job: Job | None = None
        runner.progressed.connect(self.progressed)
        session.projectChanged.connect(self._forget)

    @property
    def can_find(self) -> bool:
        """Whether there is a project with images on disk."""
        folder = self._session.folder
        return folder is not None and (folder / "project.json").exists()

    @Slot(str)
    def find(self, viewpoint_id: str) -> None:
        """Compute the result of a view, or return it at once if it was the last one."""
        folder = self._session.folder
        self.cancel()
        if self._last is not None and self._last.viewpoint_id == viewpoint_id:
            self.found.emit(self._last)
        elif folder is not None and self.can_find:
            self._job = self._runner.run(
                tr(self._words, viewpoint_id=viewpoint_id),
                lambda job: self._work(folder, viewpoint_id, job),
                self._keep,
                on_failed=self._tell_failure,
                quiet=True,
            )
            self._job.cancelled.connect(self._tell_cancelled)
        else:
            self.stopped.emit("The images of this view are not on disk. Open the project that contains them.")

    @Slot()
    def cancel(self) -> None:
        """Cancel what is being computed."""
        self._runner.cancel()

    @Slot()
    def _forget(self) -> None:
        self.cancel()
        self._last = None
        self.forgotten.emit()

    @Slot(object)
    def _keep(self, found: Found) -> None:
        self._last, self._job = found, None
        self.found.emit(found)

    @Slot(object)
    def _tell_failure(self, error: MeasureError) -> None:
        if self.sender() is self._job:
            self.stopped.emit(str(error))

    @Slot()
    def _tell_cancelled(self) -> None:
        if self.sender() is self._job:  # another view may be requested already
            self.stopped.emit("")
