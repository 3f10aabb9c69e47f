"""Change of the nominal of a measured project: everything is measured again and stored; it can be undone."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, Signal, Slot
from PySide6.QtGui import QUndoCommand

from measureapp.data.length_unit import LengthUnit
from ui.controllers.jobs import JobRunner
from ui.controllers.program_jobs import ChangedNominal, NominalQuestion, measure_with_nominal
from ui.controllers.programming import ProgrammingController
from ui.look.language.words import tr
from ui.session import Session


class NominalCommand(QUndoCommand):
    """A change of the nominal, which was measured and stored already."""

    def __init__(self, use: Callable[[Path], None], before: Path, after: Path, words: str) -> None:
        super().__init__(words)
        self._use, self._before, self._after, self._is_new = use, before, after, True

    def redo(self) -> None:
        """Use the nominal again."""
        if not self._is_new:
            self._use(self._after)
        self._is_new = False

    def undo(self) -> None:
        """Use the former nominal."""
        self._use(self._before)


class NominalController(QObject):
    """Measures the open project with another nominal; if that fails, nothing is changed."""

    unitAsked = Signal(object)  # NominalQuestion

    def __init__(self, session: Session, runner: JobRunner, programming: ProgrammingController, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._runner, self._programming = session, runner, programming

    @Slot(object)
    def use(self, path: Path, unit: LengthUnit = LengthUnit.MM) -> None:
        """Use another nominal; its unit is asked for if it is doubtful."""
        self._measure(path, unit, self._show)

    def _use_again(self, path: Path) -> None:
        self._measure(path, LengthUnit.MM, self._show_again)

    def _measure(self, path: Path, unit: LengthUnit, done: Callable[[ChangedNominal | NominalQuestion], None]) -> None:
        programming, measurement = self._programming, self._session.measurement
        folder, state = programming.folder, programming.state
        if folder is not None and measurement is not None and state is not None and programming.can_change:
            self._runner.run("Changing the nominal", lambda job: measure_with_nominal(folder, measurement, state, path, unit, job), done)

    @Slot(object)
    def _show(self, found: ChangedNominal | NominalQuestion) -> None:
        if isinstance(found, NominalQuestion):
            self.unitAsked.emit(found)
            return
        words = tr("Nominal changed to {name}.", name=found.path.name)
        if found.former is None:
            self._programming.stack.clear()
        else:
            self._programming.stack.push(NominalCommand(self._use_again, found.former, found.path, words))
        self._keep(found, words)

    @Slot(object)
    def _show_again(self, found: ChangedNominal | NominalQuestion) -> None:
        if isinstance(found, ChangedNominal):
            self._keep(found, "Nominal changed back.")

    def _keep(self, found: ChangedNominal, words: str) -> None:
        self._programming.take_outcome(found.outcome, found.state)
        self._session.tell(words, "", "done")
