"""Series of parts: what was measured by one program, its trend and capability."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.look.language.words import tr
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.series import SeriesRun
    from measureapp.report.series.capability import Trend
    from ui.workers.job import Job


@dataclass(frozen=True, eq=False)
class ReadSeries:
    """The runs of one program, and the trend of every dimension."""

    program: str
    runs: tuple[SeriesRun, ...]
    trends: tuple[Trend, ...]


class SeriesController(QObject):
    """Reads the series of a program, files the open measurement, and writes the report of a series."""

    listed = Signal(object)  # tuple[str, ...], the programs
    read = Signal(object)  # ReadSeries
    refused = Signal(object)  # MeasureError

    def __init__(self, session: Session, runner: JobRunner, reader: JobRunner, parent: QObject | None = None) -> None:
        """``reader``: reads what is stored, also while another job runs."""
        super().__init__(parent)
        self._session, self._runner, self._reader = session, runner, reader

    @Slot()
    def find(self) -> None:
        """List the programs that have a series."""
        self._reader.run("Reading the series", _programs, self.listed.emit, on_failed=self.refused.emit, quiet=True)

    def choose(self, program: str) -> None:
        """Read the series of a program."""
        self._reader.run(
            "Reading the series", lambda job: read_series(program, job), self.read.emit, on_failed=self.refused.emit, quiet=True
        )

    def file(self, reason: str = "") -> None:
        """Add the open measurement to the series of its program; ``reason``: why a part is measured once more."""
        folder = self._session.folder
        if folder is None:
            return

        def work(job: Job) -> ReadSeries:
            from measureapp.project.folder import ProjectFolder
            from measureapp.project.series.filing import file_run

            return read_series(file_run(ProjectFolder.open(folder), repeat_reason=reason).run.program, job)

        self._runner.run("Adding to the series", work, self._show_filed, on_failed=self.refused.emit)

    @Slot(object)
    def _show_filed(self, found: ReadSeries) -> None:
        self.find()
        self.read.emit(found)

    def write(self, found: ReadSeries, folder: Path) -> None:
        """Write the report of a series as PDF, CSV and JSON."""

        def work(job: Job) -> Path:
            from measureapp.report.series.documents import write_series

            job.report(0, 1, "Writing the report of the series")
            return write_series(found.program, found.runs, folder, job.language)["pdf"]

        self._runner.run("Writing the report of the series", work, self._tell_written, on_failed=self.refused.emit)

    @Slot(object)
    def _tell_written(self, path: Path) -> None:
        self._session.tell(
            tr("The report of the series is saved as {name}, with a table (CSV) and JSON beside it.", name=path.name),
            str(path.parent),
            "done",
        )


def _programs(_job: Job) -> tuple[str, ...]:
    from measureapp.project.series.store import list_programs

    return list_programs()


def read_series(program: str, job: Job) -> ReadSeries:
    """Read a series and compute its trends; runs on a job's thread. Raises StorageError where the store is damaged."""
    from measureapp.project.series.store import SeriesStore
    from measureapp.report.series.capability import trends

    job.report(0, 1, program)
    runs = SeriesStore(program).runs()
    return ReadSeries(program, runs, trends(runs) if runs else ())
