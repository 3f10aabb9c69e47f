"""One long task on a thread of its own."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QThread, Signal

from measureapp.errors import MeasureError
from measureapp.progress import Cancelled

REPORT_INTERVAL_S = 0.05
LOG = "measureapp.log"
Work = Callable[["Job"], Any]
_log = logging.getLogger(__name__)


class Job(QThread):
    """Runs ``work(job)`` on its own thread; exactly one of succeeded, failed, cancelled fires.

    The job is itself the `Progress` its work reports to; `emit_event` sends anything else to the window.
    """

    progressed = Signal(float, str)  # share 0…1, note
    happened = Signal(object)  # whatever the work tells by `emit_event`
    succeeded = Signal(object)
    failed = Signal(object)  # MeasureError
    cancelled = Signal()

    def __init__(self, title: str, work: Work, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.title = title
        self.quiet = False
        self._work = work
        self._stop = threading.Event()
        self._last_report = 0.0

    def run(self) -> None:
        """Do the work; called by the thread itself."""
        try:
            self.check()
            result = self._work(self)
        except Cancelled:
            self.cancelled.emit()
        except MeasureError as error:
            self.failed.emit(error)
        except OSError as error:
            self.failed.emit(
                MeasureError(
                    f"{error.filename or 'A file'} cannot be used: {error.strerror or error}.",
                    "Check the path, the free space and the permissions.",
                )
            )
        except Exception as error:
            _log.exception("%s ended by an error of the program", self.title)
            self.failed.emit(unexpected(error, self.title))
        else:
            self.succeeded.emit(result)

    def report(self, done: float, total: float, note: str = "") -> None:
        """Say how far the work is. Raises Cancelled when the user asked to stop."""
        self.check()
        now = time.monotonic()
        if now - self._last_report < REPORT_INTERVAL_S and done < total:
            return
        self._last_report = now
        self.progressed.emit(min(1.0, max(0.0, done / total)) if total > 0 else 0.0, note)

    def check(self) -> None:
        """Raise Cancelled when the user asked to stop."""
        if self._stop.is_set():
            raise Cancelled

    def emit_event(self, event: object) -> None:
        """Send something that became known to the window."""
        self.happened.emit(event)

    def cancel(self) -> None:
        """Ask the work to stop at its next report; may be called from any thread."""
        self._stop.set()


def unexpected(error: BaseException, doing: str) -> MeasureError:
    """Return an error of the program itself as a sentence."""
    return MeasureError(
        f"{doing} stopped by an error in the program ({type(error).__name__}: {error}).",
        f"Nothing that was stored is lost; try again. If it happens twice, send {LOG} in the folder MeasureApp of your home to support.",
    )
