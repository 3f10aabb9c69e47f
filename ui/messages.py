"""Messages of the program: what happened, what to do about it, and whether its cause has ended."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from datetime import datetime
from typing import Final, Literal

from PySide6.QtCore import QObject, Signal

Level = Literal["info", "done", "warning", "error"]
OPEN_LEVELS: Final = ("warning", "error")
PROJECT = "project"  # cause of what concerns the open project: it ends when another one is opened
MOMENT = "moment"  # cause of what is over as soon as it is told
BUSY = "busy"  # a job runs; it ends with the job
DEVICES = "devices"  # some are not ready
STOPPED = "stopped"  # the rig was stopped and not reset
CALIBRATION = "calibration"  # of the rig; it ends with a new one
SHOW_RIG, SHOW_CALIBRATION, OPEN_PROJECT, RECOMPUTE = "page.rig", "page.calibration", "project.open", "project.compute"  # actions that help
CANCEL = "job.cancel"  # action that ends the running job
MOST = 1000  # messages kept


@dataclass(frozen=True)
class Message:
    """A message: what happened, and what to do about it."""

    text: str
    hint: str = ""
    level: Level = "info"
    at: datetime = field(default_factory=datetime.now)
    cause: str = PROJECT  # what ends it
    remedy: str = ""  # action that helps
    id: int = 0


class Messages(QObject):
    """All messages of this start of the program; those whose cause has ended are kept, but no longer open."""

    added = Signal(object)  # Message
    changed = Signal()  # open ones

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._all: list[Message] = []
        self._open: dict[int, Message] = {}
        self._next = 1

    def __iter__(self) -> Iterator[Message]:
        return iter(self._all)

    def __len__(self) -> int:
        return len(self._all)

    def __getitem__(self, place: int) -> Message:
        return self._all[place]

    @property
    def open(self) -> tuple[Message, ...]:
        """Warnings and errors whose cause has not ended, the newest last."""
        return tuple(self._open.values())

    def is_open(self, message: Message) -> bool:
        """Return whether the cause of a message has not ended."""
        return message.id in self._open

    def add(self, text: str, hint: str = "", level: Level = "info", *, cause: str = PROJECT, remedy: str = "") -> Message:
        """Add a message. An open one with the same words ends, because this one takes its place."""
        message = Message(text, hint, level, cause=cause, remedy=remedy, id=self._next)
        self._next += 1
        same = [old.id for old in self._open.values() if (old.text, old.hint) == (text, hint)]
        for number in same:
            del self._open[number]
        self._all.append(message)
        if len(self._all) > MOST:
            self._open.pop(self._all.pop(0).id, None)
        is_open = level in OPEN_LEVELS and cause != MOMENT
        if is_open:
            self._open[message.id] = message
        self.added.emit(message)
        if is_open or same:
            self.changed.emit()
        return message

    def end(self, cause: str) -> None:
        """Close the messages of a cause that has ended."""
        self._close([number for number, message in self._open.items() if message.cause == cause])

    def dismiss(self, number: int) -> None:
        """Close one message, because the user has seen to it."""
        self._close([number] if number in self._open else [])

    def _close(self, numbers: list[int]) -> None:
        for number in numbers:
            del self._open[number]
        if numbers:
            self.changed.emit()
