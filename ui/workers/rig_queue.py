"""Sequential queue of jobs, so that no two of them move the rig."""

from __future__ import annotations

from collections import deque

from PySide6.QtCore import QObject, Signal

from ui.workers.job import Job


class RigQueue(QObject):
    """Starts a job when the previous one has ended, and keeps every job alive until its thread has ended."""

    started = Signal(object)  # Job
    ended = Signal(object)  # Job
    emptied = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._waiting: deque[Job] = deque()
        self._running: Job | None = None
        self._closed = False

    @property
    def running(self) -> Job | None:
        """The running job."""
        return self._running

    @property
    def busy(self) -> bool:
        """Whether a job runs or waits."""
        return self._running is not None or bool(self._waiting)

    def submit(self, job: Job) -> None:
        """Run ``job`` as soon as the previous ones have ended; never, once the queue is closed."""
        job.setParent(self)
        if self._closed:
            return
        job.finished.connect(self._on_finished)
        self._waiting.append(job)
        self._start_next()

    def cancel_all(self) -> None:
        """Cancel the running job and all waiting ones."""
        for job in self._waiting:
            job.cancel()
        if self._running is not None:
            self._running.cancel()

    def close(self) -> None:
        """Cancel all jobs and start no other: one that ends may ask for the next."""
        self._closed = True
        self.cancel_all()

    def wait(self, timeout_ms: int) -> bool:
        """Wait for the running job's thread; return whether it ended in time."""
        return self._running is None or self._running.wait(timeout_ms)

    def _start_next(self) -> None:
        if self._running is None and self._waiting:
            self._running = self._waiting.popleft()
            self.started.emit(self._running)
            self._running.start()

    def _on_finished(self) -> None:
        job, self._running = self._running, None
        if job is not None:
            self.ended.emit(job)
            job.ended.emit()
            job.deleteLater()
        self._start_next()
        if not self.busy:
            self.emptied.emit()
