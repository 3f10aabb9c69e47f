"""Solver of snapshots in the background while collecting: one solution at a time, the newest state next."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers import collecting_work as work
from ui.controllers.jobs import JobRunner
from ui.workers.job import Job

if TYPE_CHECKING:
    from measureapp.calibration_session.snapshot import Snapshot
    from measureapp.data.rig import RigDescription


class BackgroundSolver(QObject):
    """Solves snapshots on a background thread. A snapshot that arrives while one is being solved waits; only the newest is kept."""

    solved = Signal()  # `interim` is new, or solving was stopped

    def __init__(self, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._runner = runner
        self._job: Job | None = None
        self._discarding = False  # the result of the running job
        self._waiting: tuple[Snapshot, RigDescription | None] | None = None
        self.interim: work.InterimResult | None = None  # the last solution with verdict and guidance

    @property
    def is_running(self) -> bool:
        """Whether a solution is being computed."""
        return self._job is not None

    @property
    def is_solved(self) -> bool:
        """Whether the views of the last solution determine the result."""
        return self.interim is not None and self.interim.solved is not None

    @property
    def has_enough(self) -> bool:
        """Whether nothing is missing."""
        return self.is_solved and self.interim is not None and self.interim.advice.enough

    @property
    def is_good(self) -> bool:
        """Whether the views collected so far make a good calibration."""
        return self.interim is not None and self.interim.verdict is not None and self.interim.verdict.level == "good"

    def solve(self, snapshot: Snapshot, rig: RigDescription | None) -> None:
        """Solve a snapshot, with ``rig`` also suggest its next viewpoint; at once or after the one that is being solved."""
        self._waiting = (snapshot, rig)
        if self._job is None:
            self._start()

    def stop(self) -> None:
        """Stop solving and discard the result."""
        self._waiting = self.interim = None
        if self._job is not None:
            self._discarding = True
            self._job.cancel()

    def _start(self) -> None:
        if self._waiting is not None:
            (snapshot, rig), self._waiting = self._waiting, None
            self._job = self._runner.run(
                "Solving", lambda job: work.evaluate_snapshot(job, snapshot, rig), self._keep, on_stopped=self._end_job, quiet=True
            )

    @Slot(object)
    def _keep(self, found: work.InterimResult) -> None:
        self.interim = None if self._discarding else found
        self._end_job()

    @Slot()
    def _end_job(self) -> None:
        self._job, self._discarding = None, False
        self._start()
        self.solved.emit()
