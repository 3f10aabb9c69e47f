"""Running of jobs for controllers, with reporting of their outcome."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.look.language.words import tr
from ui.messages import MOMENT, PROJECT
from ui.session import Session
from ui.workers.job import Job, Work
from ui.workers.rig_queue import RigQueue

CANCELLED = "Cancelled."


class JobRunner(QObject):
    """Submits jobs to a queue and reports their outcome to the session."""

    progressed = Signal(float, str)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self.queue = RigQueue(self)
        self.queue.started.connect(self._on_started)
        self.queue.ended.connect(self._on_ended)

    def run(
        self,
        title: str,
        work: Work,
        on_done: Callable[[Any], None],
        *,
        on_event: Callable[[Any], None] | None = None,
        on_stopped: Callable[[], None] | None = None,
        on_failed: Callable[[MeasureError], None] | None = None,
        quiet: bool = False,
        moves: bool = False,
    ) -> Job:
        """Run ``work`` in a thread; the callables must be methods of QObjects, so that they run in the window's thread.

        A ``quiet`` job is not shown as running; during one that ``moves`` axes, Stop is in sight.

        Of the returned job's signals only ``ended`` and ``cancelled`` come in time for those who connect then.
        """
        job = Job(title, work)
        job.quiet, job.moves, job.language = quiet, moves, self._session.report_language
        if on_event is not None:
            job.happened.connect(on_event)
        job.succeeded.connect(on_done)
        job.succeeded.connect(self._end_failure)
        if on_stopped is not None:
            job.cancelled.connect(on_stopped)
            job.failed.connect(on_stopped)
        if on_failed is not None:
            job.failed.connect(on_failed)
        job.failed.connect(self._on_failed)
        if not quiet:
            job.cancelled.connect(self._on_cancelled)
        self.queue.submit(job)
        return job

    @Slot()
    def cancel(self) -> None:
        """Cancel the running and all waiting jobs."""
        self.queue.cancel_all()

    def _on_started(self, job: Job) -> None:
        job.progressed.connect(self.progressed)
        if not job.quiet:
            self._session.set_busy(job.title)
        if job.moves:
            self._session.set_moving(True)

    def _on_ended(self, job: Job) -> None:
        if not job.quiet:
            self._session.set_busy("")
        if job.moves:
            self._session.set_moving(False)

    @Slot(object)
    def _on_failed(self, error: MeasureError) -> None:
        self._session.tell(error.message, error.hint, "error", cause=_failure_of(self.sender()))

    @Slot()
    def _end_failure(self) -> None:
        """A job that succeeds ends what an earlier one of its kind has told."""
        self._session.messages.end(_failure_of(self.sender()))

    @Slot()
    def _on_cancelled(self) -> None:
        self._session.tell(CANCELLED, "Data stored so far is kept.", "warning", cause=MOMENT)


def _failure_of(job: QObject | None) -> str:
    """Return the cause under which the failure of a job is told."""
    return tr("job: {title}", title=job.title) if isinstance(job, Job) else PROJECT
