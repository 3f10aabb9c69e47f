"""A long task in its own thread."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QThread, Signal

from measureapp.errors import MeasureError
from measureapp.language.languages import ENGLISH
from measureapp.progress import Cancelled
from ui.look.language.words import tr

REPORT_INTERVAL_S = 0.05
IMPORT_TRIALS, IMPORT_WAIT_S = 3, 0.2
LOG = "measureapp.log"
Work = Callable[["Job"], Any]
_log = logging.getLogger(__name__)


class Job(QThread):
    """Runs ``work(job)`` in its own thread; exactly one of succeeded, failed, cancelled is emitted.

    The job is the `Progress` of its work; `emit_event` sends other events to the window.
    After all of them the queue emits ``ended`` in the window's thread, so that it reaches those who connect to it where they submit the job;
    ``finished`` of the thread may be over by then.
    """

    progressed = Signal(float, str)  # fraction 0…1, note
    happened = Signal(object)  # event of `emit_event`
    succeeded = Signal(object)
    failed = Signal(object)  # MeasureError
    cancelled = Signal()
    ended = Signal()  # emitted by its queue

    def __init__(self, title: str, work: Work, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.title = title
        self.quiet = False
        self.moves = False  # axes of a rig
        self.language = ENGLISH  # of the reports that its work writes
        self._work = work
        self._stop = threading.Event()
        self._last_report = 0.0
        self._has_told = False  # an event of its work

    def run(self) -> None:
        """Execute the work; called in the thread."""
        try:
            self.check()
            result = self._result()
        except Cancelled:
            self.cancelled.emit()
        except MeasureError as error:
            self.failed.emit(error)
        except OSError as error:
            self.failed.emit(
                MeasureError(
                    tr("{value} cannot be used: {value_2}.", value=error.filename or "A file", value_2=error.strerror or error),
                    "Check the path, the free space and the permissions.",
                )
            )
        except Exception as error:
            _log.exception("%s ended by an error of the program", self.title)
            self.failed.emit(unexpected(error, self.title))
        else:
            self.succeeded.emit(result)

    def _result(self) -> Any:
        """Do the work; anew where a package was being imported by another thread, which then has parts of it only, and nothing was told yet."""
        for left in reversed(range(IMPORT_TRIALS)):
            try:
                return self._work(self)
            except ImportError as error:
                if not left or self.moves or self._has_told or "partially initialized module" not in str(error):
                    raise
                time.sleep(IMPORT_WAIT_S)
        return None

    def report(self, done: float, total: float, note: str = "") -> None:
        """Report progress. Raises Cancelled when the user has cancelled."""
        self.check()
        now = time.monotonic()
        if now - self._last_report < REPORT_INTERVAL_S and done < total:
            return
        self._last_report = now
        self.progressed.emit(min(1.0, max(0.0, done / total)) if total > 0 else 0.0, note)

    def check(self) -> None:
        """Raise Cancelled when the user has cancelled."""
        if self._stop.is_set():
            raise Cancelled

    def emit_event(self, event: object) -> None:
        """Send an event to the window."""
        self._has_told = True
        self.happened.emit(event)

    def cancel(self) -> None:
        """Cancel the work at its next report; may be called from any thread."""
        self._stop.set()


def unexpected(error: BaseException, doing: str) -> MeasureError:
    """Return an internal error as a message for the user."""
    return MeasureError(
        tr("{doing} stopped by an internal error ({name}: {error}).", doing=doing, name=type(error).__name__, error=error),
        tr(
            "Stored data is not affected; try again. If it happens again, send {log} in the folder MeasureApp of your home to support.",
            log=LOG,
        ),
    )
