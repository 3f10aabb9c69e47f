"""Progress reports and cancellation."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol


class Cancelled(BaseException):
    """The user cancelled; raised at the next progress report."""


class Progress(Protocol):
    """Receiver of the progress of a long task; reporting is also the cancellation point."""

    def report(self, done: float, total: float, note: str = "") -> None:
        """Report ``done`` of ``total``. Raises Cancelled when the user has cancelled."""

    def check(self) -> None:
        """Raise Cancelled when the user has cancelled; for loops that wait and have nothing to report."""


class NoProgress:
    """Ignores reports and is never cancelled."""

    def report(self, done: float, total: float, note: str = "") -> None:
        """Do nothing."""

    def check(self) -> None:
        """Do nothing."""


@dataclass(frozen=True)
class PartOf:
    """Progress of a subtask that extends from ``start`` to ``end`` (0…1) of a larger task."""

    whole: Progress
    start: float
    end: float
    prefix: str = ""

    def report(self, done: float, total: float, note: str = "") -> None:
        """Report to the larger task."""
        share = min(1.0, max(0.0, done / total)) if total > 0 else 1.0
        self.whole.report(self.start + (self.end - self.start) * share, 1.0, self.prefix + note)

    def check(self) -> None:
        """Ask the larger task."""
        self.whole.check()


@dataclass(frozen=True)
class CallbackProgress:
    """Calls ``listener(done, total, note)``; the listener raises Cancelled to stop."""

    listener: Callable[[float, float, str], None]

    def report(self, done: float, total: float, note: str = "") -> None:
        """Pass the report on."""
        self.listener(done, total, note)

    def check(self) -> None:
        """Do nothing: the listener is only asked at reports."""
