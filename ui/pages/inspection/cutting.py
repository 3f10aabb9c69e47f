"""Interactive section of the part, on a thread; only the latest request waits while one is running."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal, Slot

from ui.controllers.jobs import JobRunner
from ui.pages.inspection.section_bar import SectionBar, cut_lines
from ui.session import Session
from ui.viewport.layers import LineLayer


class Cutting(QObject):
    """Holds the lines of the displayed section; none without a section."""

    changed = Signal()

    def __init__(self, session: Session, bar: SectionBar, runner: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._bar, self._runner = session, bar, runner
        self.lines: list[LineLayer] = []
        self._is_cutting = self._again = False
        bar.changed.connect(self.cut)

    @Slot()
    def cut(self) -> None:
        """Cut the nominal and the measured points."""
        comparison, plane = self._session.comparison, self._bar.value()
        self._again = self._is_cutting
        if comparison is None or comparison.surface is None or plane is None:
            self.lines = []
            self.changed.emit()
        elif not self._is_cutting:
            self._is_cutting = True
            self._runner.run("Cutting", lambda _job: cut_lines(comparison, plane), self._show, on_stopped=self._stop, quiet=True)

    @Slot(object)
    def _show(self, found: tuple[list[LineLayer], str]) -> None:
        if self._session.comparison is not None and self._bar.value() is not None:
            self.lines, words = found
            self._bar.say(words)
            self.changed.emit()
        self._stop()

    @Slot()
    def _stop(self) -> None:
        self._is_cutting = False
        if self._again:
            self.cut()
