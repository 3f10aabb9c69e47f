"""Measuring of an edited inspection program in the background; an edit during the measurement makes it start again."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.controllers.program_bench import Bench
from ui.controllers.program_jobs import MeasuredProgram, ProgramState
from ui.session import Session

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from measureapp.data.measurement import Measurement
    from ui.workers.job import Job


class ProgramMeasuring(QObject):
    """Measures the latest program; results of former ones are dropped."""

    measured = Signal(object)  # MeasuredProgram
    stopped = Signal()  # without a result

    def __init__(self, session: Session, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner = session, runner
        self._wanted: ProgramState | None = None
        self._running: ProgramState | None = None
        self._former: MeasuredProgram | None = None
        self._job: Job | None = None
        self._bench: Bench | None = None

    @property
    def is_running(self) -> bool:
        """Whether a program is being measured."""
        return self._running is not None

    def measure(self, state: ProgramState, former: MeasuredProgram | None) -> None:
        """Measure ``state``; ``former`` holds what need not be measured again."""
        self._wanted, self._former = state, former
        if self._running is None:
            self._start()
        elif self._job is not None:
            self._job.cancel()

    def forget(self) -> None:
        """Stop, and drop what was measured: on other clouds, or with another nominal."""
        self._wanted = self._former = self._bench = None
        if self._job is not None:
            self._job.cancel()

    def _start(self) -> None:
        state, former, measurement, folder = self._wanted, self._former, self._session.measurement, self._session.folder
        if state is None or measurement is None or folder is None:
            return
        self._running = state
        self._job = self._runner.run(
            "Measuring again", _work(folder, measurement, state, former, self._bench), self._show, on_stopped=self._stop, quiet=True
        )

    @Slot(object)
    def _show(self, found: tuple[Bench, MeasuredProgram]) -> None:
        bench, measured = found
        is_latest = measured.state is self._wanted
        self._running = self._job = None
        if is_latest:
            self._wanted, self._bench = None, bench
            self.measured.emit(measured)
        elif self._wanted is not None:
            self._start()

    @Slot()
    def _stop(self) -> None:
        was, self._running, self._job = self._running, None, None
        if self._wanted is not None and self._wanted is not was:
            self._start()
        else:
            self._wanted = None
            self.stopped.emit()


def _work(
    folder: Path, measurement: Measurement, state: ProgramState, former: MeasuredProgram | None, bench: Bench | None
) -> Callable[[Job], tuple[Bench, MeasuredProgram]]:
    def work(job: Job) -> tuple[Bench, MeasuredProgram]:
        used = bench or Bench.of(folder, measurement)
        return used, used.measure(state, former, job)

    return work
