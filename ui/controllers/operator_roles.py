"""The role: operators need no login; the engineer's role asks for the PIN where one is set, and ends without input."""

from __future__ import annotations

import time
from contextlib import suppress
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer, Signal, Slot

from measureapp.errors import MeasureError, StorageError
from ui.controllers.jobs import JobRunner
from ui.look.wording import with_hint
from ui.session import Session

if TYPE_CHECKING:
    from ui.workers.job import Job

OPEN = (
    "No PIN is set: anyone can leave operator mode.",
    "Set one by the button beside the role.",
)
NO_PIN = "pin"  # cause of the warning above
MINUTE_MS = 60_000


class RoleController(QObject):
    """Changes the role."""

    pinAsked = Signal()
    pinRefused = Signal(str)
    pinStored = Signal()
    pinNotStored = Signal(str)

    def __init__(self, session: Session, reading: JobRunner, jobs: JobRunner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session, self._reading, self._jobs = session, reading, jobs
        self._warned = False
        self._idle = QTimer(self)
        self._idle.setSingleShot(True)
        self._idle.setInterval(10 * MINUTE_MS)
        self._idle.timeout.connect(self._end_engineer)
        session.appearanceChanged.connect(self._watch)

    @property
    def has_pin(self) -> bool:
        """Whether the engineer's role asks for a PIN."""
        from measureapp.project.engineer_pin import has_pin, pin_file

        return has_pin(pin_file())

    def begin(self, *, in_operator_mode: bool = False) -> None:
        """Begin in operator mode where it is wanted or a PIN is set, so that a restart opens nothing."""
        from measureapp.project.operator_settings import operator_file, read_operator_settings

        with suppress(StorageError):  # damaged settings are told where operator mode reads them
            self.set_idle_minutes(read_operator_settings(operator_file()).idle_minutes)
        if in_operator_mode or self.has_pin:
            self._session.set_role("operator")

    def set_idle_minutes(self, minutes: float) -> None:
        """Set after how long without input the engineer's role ends."""
        self._idle.setInterval(round(minutes * MINUTE_MS))
        self._watch()

    @Slot()
    def become_operator(self) -> None:
        """Change to operator mode; once it is said that anyone can leave it, where no PIN is set."""
        self._session.set_role("operator")
        if not self.has_pin and not self._warned:
            self._warned = True
            self._session.tell(*OPEN, "warning", cause=NO_PIN)

    @Slot()
    def ask_engineer(self) -> None:
        """Change to the engineer's role, or ask for the PIN."""
        if self.has_pin:
            self.pinAsked.emit()
        else:
            self._session.set_role("engineer")

    def give_pin(self, pin: str) -> None:
        """Change to the engineer's role if the PIN is right."""

        def check(job: Job) -> bool:
            from measureapp.project.engineer_pin import check_pin, pin_file

            job.check()
            return check_pin(pin_file(), pin, time.time())

        self._reading.run("Checking the PIN", check, self._checked, on_failed=self._refuse, quiet=True)

    @Slot(object)
    def _checked(self, right: bool) -> None:
        if right:
            self._session.set_role("engineer")
        else:
            self.pinRefused.emit("Wrong PIN.")

    @Slot(object)
    def _refuse(self, error: MeasureError) -> None:
        from measureapp.project.engineer_pin import RESET

        is_there = error.hint == RESET  # on the screen, always
        self.pinRefused.emit(error.message if is_there else with_hint(error.message, error.hint))

    def set_pin(self, pin: str) -> None:
        """Store another PIN; only the engineer can."""
        if self._session.role != "engineer":
            return

        def store(job: Job) -> None:
            from measureapp.project.engineer_pin import pin_file, set_pin

            job.check()
            set_pin(pin_file(), pin)

        self._reading.run("Storing the PIN", store, self._stored, on_failed=self._not_stored, quiet=True)

    @Slot(object)
    def _stored(self, _nothing: object) -> None:
        self._session.messages.end(NO_PIN)
        self._watch()
        self.pinStored.emit()

    @Slot(object)
    def _not_stored(self, error: MeasureError) -> None:
        self.pinNotStored.emit(with_hint(error.message, error.hint))

    # without input

    @Slot()
    def _watch(self) -> None:
        """Start to wait for input, or stop waiting for it."""
        if self._session.role == "engineer" and self.has_pin:
            self._idle.start()
        else:
            self._idle.stop()

    @Slot()
    def note_input(self) -> None:
        """Wait again from the beginning: someone is working."""
        if self._idle.isActive():
            self._idle.start()

    @Slot()
    def _end_engineer(self) -> None:
        """End the engineer's role, but not while one of his jobs runs."""
        running = self._jobs.queue.running
        if running is not None and not running.quiet:
            self._idle.start()
            return
        self._session.set_role("operator")
        self._session.tell("Operator mode again: there was no input for a while.", "", "info")

    def end(self) -> None:
        """Stop waiting; the window is closed."""
        self._idle.stop()
