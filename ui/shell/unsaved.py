"""Question about edits that would be lost with the open project: save, discard, or stay."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Slot

from ui.controllers.programming import ProgrammingController
from ui.look.look import Look
from ui.session import Session
from ui.widgets.question_bar import QuestionBar


class UnsavedQuestion(QObject):
    """Asks below the header; what was asked for goes on when the edits are saved or discarded."""

    def __init__(self, look: Look, session: Session, programming: ProgrammingController, parent: QObject) -> None:
        super().__init__(parent)
        self.bar = QuestionBar(look)
        self._session, self._programming = session, programming
        self._go_on: Callable[[], object] | None = None
        session.unsavedAsked.connect(self._ask)
        self._is_saved = False
        programming.saved.connect(self._note_saved)
        session.busyChanged.connect(self._continue)

    @Slot(object)
    def _ask(self, go_on: Callable[[], object]) -> None:
        self._go_on, self._is_saved = None, False

        def save() -> None:
            self._go_on = go_on
            self._programming.save()

        def discard() -> None:
            self._programming.discard()
            go_on()

        self.bar.ask(self._session.unsaved, {"Save": save, "Discard the edits": discard}, back="Stay here")

    @Slot()
    def _note_saved(self) -> None:
        self._is_saved = True

    @Slot()
    def _continue(self) -> None:
        """Go on when the job that saved has ended."""
        if self._is_saved and not self._session.busy_with and self._go_on is not None:
            go_on, self._go_on = self._go_on, None
            go_on()
