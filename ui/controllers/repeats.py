"""Repeated measurements of one part: several projects are compared, or the open one is measured again."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.controllers.scan_choices import ScanChoices, documents_of, request_maker
from ui.controllers.scanning import ScanController
from ui.controllers.stored_sessions import project_on_disk
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.repeats import RepeatStudy
    from ui.workers.job import Job

MOST_FOLDERS = 1000
NOTHING_OPEN = ("There is no measurement to repeat.", "Open a calibrated project with a plan, or scan the part first.")


@dataclass(frozen=True)
class Series:
    """Measurements that are made one after the other."""

    source: Path  # the project that is repeated
    part: str
    count: int
    reclamp: bool  # a person clamps the part again before each
    done: tuple[Path, ...] = ()

    @property
    def number(self) -> int:
        """Number of the next measurement, from 1."""
        return len(self.done) + 1


class RepeatsController(QObject):
    """Compares measurements of one part, and measures the part of the open project again."""

    compared = Signal(object)  # RepeatStudy
    refused = Signal(object)  # MeasureError
    written = Signal(object)  # Path of the PDF
    measured = Signal(object)  # Path of a project
    changed = Signal()

    def __init__(self, session: Session, runner: JobRunner, scanning: ScanController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner, self._scanning = session, runner, scanning
        self._series: Series | None = None
        self._next: Path | None = None  # folder of the measurement that runs
        self.is_waiting = False  # for the part to be clamped
        scanning.completed.connect(self._keep)
        scanning.ended.connect(self._go_on)

    @property
    def series(self) -> Series | None:
        """The series under way."""
        return self._series

    @property
    def source(self) -> Path | None:
        """The open project, if it can be measured again."""
        session = self._session
        folder = project_on_disk(session)
        return folder if session.rig is not None and session.plan is not None and session.calibration is not None else None

    # comparison

    def compare(self, folders: tuple[Path, ...], one_part: bool = False) -> None:
        """Evaluate mean and spread of every dimension; ``one_part``: the projects name one part differently."""

        def work(job: Job) -> RepeatStudy:
            from measureapp.pipeline.repeats import compare_repeats

            job.report(0, 1, "Reading the measurements")
            return compare_repeats(folders, one_part=one_part)

        self._runner.run("Comparing the measurements", work, self.compared.emit, on_failed=self.refused.emit)

    def write(self, study: RepeatStudy, folder: Path) -> None:
        """Write the report of repeats as PDF, CSV and JSON."""

        def work(job: Job) -> Path:
            from measureapp.report.repeats.documents import write_repeats

            job.report(0, 1, "Writing the report of repeats")
            return write_repeats(study, folder, job.language)["pdf"]

        self._runner.run("Writing the report of repeats", work, self._tell_written)

    @Slot(object)
    def _tell_written(self, path: Path) -> None:
        self._session.tell(
            tr("The report of repeats is saved as {name}, with a table (CSV) and JSON beside it.", name=path.name), str(path.parent), "done"
        )
        self.written.emit(path)

    # measurement

    def measure_again(self, count: int, *, reclamp: bool) -> None:
        """Measure the part of the open project ``count`` times, each into a new project beside it."""
        source = self.source
        if source is None:
            self._session.tell(*NOTHING_OPEN, "warning")
        elif not self._session.busy_with and self._series is None:
            self._series = Series(source, self._session.part, count, reclamp)
            self._prepare()

    @Slot()
    def clamped(self) -> None:
        """Go on after the part was clamped again."""
        if self.is_waiting:
            self._measure()

    @Slot()
    def stop(self) -> None:
        """End a series that waits; what was measured is kept."""
        self._series, self._next, self.is_waiting = None, None, False
        self.changed.emit()

    def _prepare(self) -> None:
        series = self._series
        self.is_waiting = series is not None and series.reclamp
        if series is not None and not series.reclamp:
            self._measure()
        self.changed.emit()

    def _measure(self) -> None:
        series, self.is_waiting = self._series, False
        if series is None:
            return
        nominal, program = documents_of(series.source)
        self._next = free_folder(series.source)
        choices = ScanChoices(self._next, series.part, nominal, program, series.source)
        self._scanning.run(
            tr("Repeat {number} of {count}", number=series.number, count=series.count), request_maker(choices, self._session), "repeat"
        )
        self.changed.emit()

    @Slot(object)
    def _keep(self, _outcome: object) -> None:
        """Count a measurement that was completed."""
        if self._series is not None and self._next is not None:
            self._series = replace(self._series, done=(*self._series.done, self._next))
            self.measured.emit(self._next)
            self._next = None

    @Slot()
    def _go_on(self) -> None:
        """Begin the next measurement when one has ended; a failed or cancelled one ends the series."""
        series = self._series
        if series is None:
            return
        if self._next is not None or len(series.done) >= series.count:
            self.stop()
        else:
            QTimer.singleShot(0, self, self._prepare)


def free_folder(source: Path) -> Path:
    """Return a folder beside a project that does not exist yet."""
    return next(path for number in range(2, MOST_FOLDERS) if not (path := source.with_name(f"{source.name}-repeat-{number}")).exists())
