"""What operator mode knows: part programs, runs, settings; read and stored by jobs."""

from __future__ import annotations

from dataclasses import replace
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal, Slot

from measureapp.errors import MeasureError
from ui.controllers import operator_work as work
from ui.controllers.jobs import JobRunner
from ui.controllers.operator_nouns import ProgramCard, ShiftCount, count_shift
from ui.look.wording import with_hint
from ui.session import Session

if TYPE_CHECKING:
    from measureapp.data.series import SeriesRun
    from measureapp.project.operator_settings import OperatorSettings
    from ui.workers.job import Job


class ShelfController(QObject):
    """Holds the shelf: the part programs in the folder, all runs, and the settings."""

    changed = Signal()
    said = Signal(str, str)  # words, level

    def __init__(self, session: Session, reading: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._reading = session, reading
        self.shelf: work.Shelf | None = None
        self._offered: Path | None = None  # project with the calibration that the engineer left open

    @Slot()
    def reload(self) -> None:
        """Read the part programs and the runs again."""
        from measureapp.project.operator_settings import operator_file

        file, rig = operator_file(), self._session.rig
        self._reading.run(
            "Reading the part programs", lambda job: work.read_shelf(job, file, rig), self._show, on_failed=self._fail, quiet=True
        )

    @Slot(object)
    def _show(self, shelf: work.Shelf) -> None:
        self.shelf = shelf
        if self._offered is not None and str(self._offered) != shelf.settings.calibrated:
            self.store_settings(shelf.settings.model_copy(update={"calibrated": str(self._offered)}))
        self._offered = None
        self.changed.emit()
        for problem in shelf.problems:
            self.said.emit(problem, "error")

    @Slot(object)
    def _fail(self, error: MeasureError) -> None:
        self.said.emit(with_hint(error.message, error.hint), "error")

    @property
    def runs(self) -> tuple[SeriesRun, ...]:
        """All runs, in order of measurement."""
        return () if self.shelf is None else self.shelf.runs

    def shift(self) -> ShiftCount:
        """Return the numbers of this shift."""
        if self.shelf is None:
            return ShiftCount()
        return count_shift(self.shelf.runs, self.shelf.settings.shift_start(datetime.now().astimezone()))

    @Slot(object, str)
    def release(self, cards: tuple[ProgramCard, ...], by: str) -> None:
        """Release part programs for operators, then read them again."""
        paths = [card.path for card in cards]
        self._reading.run(
            "Releasing the part programs", lambda job: work.release_programs(job, paths, by), self._released, on_failed=self._refuse
        )

    @Slot(object)
    def _released(self, _names: tuple[str, ...]) -> None:
        self.reload()

    @Slot(object)
    def _refuse(self, error: MeasureError) -> None:
        self._fail(error)
        self.reload()

    @Slot()
    def take_calibration(self) -> None:
        """Let the calibration of the project that is open now be the one in use from here on, if it has one."""
        self._offered = self._session.folder if self._session.calibration is not None else None

    def store_settings(self, settings: OperatorSettings, card: ProgramCard | None = None, calibrated: Path | None = None) -> None:
        """Store settings; ``calibrated``: a project whose calibration is used unless the present one fits the rig of ``card``."""
        from measureapp.project.operator_settings import operator_file

        file, rig = operator_file(), self._session.rig
        program = None if card is None else card.program

        def store(job: Job) -> OperatorSettings:
            return work.store_settings(job, file, settings, rig, program, calibrated)

        self._reading.run("Storing the settings", store, self._take, on_failed=self._fail, quiet=True)

    @Slot(object)
    def _take(self, settings: OperatorSettings) -> None:
        if self.shelf is not None:
            self.shelf = replace(self.shelf, settings=settings)
