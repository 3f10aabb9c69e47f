"""Jumps of the computer's clock during a scan: noted in the journal, because its times then do not follow each other; nothing else changes."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path

from measureapp.project.journal import publish
from measureapp.project.journal.entries import Entry

JUMP = "clock of the computer jumped"
LEAST_S = 2.0  # less is how a clock is corrected all the time


class ClockWatch:
    """Compares the clock that can be set with one that cannot.

    Parameters
    ----------
    settable, steady : clocks, in seconds
    """

    def __init__(self, settable: Callable[[], float] = time.time, steady: Callable[[], float] = time.monotonic) -> None:
        self._settable, self._steady = settable, steady
        self._offset_s = settable() - steady()

    def jump_s(self) -> float:
        """Return by how much the clock was set forward (positive) or back since the last call; 0 for less than 2 s."""
        now_s = self._settable() - self._steady()
        jump_s = now_s - self._offset_s
        if abs(jump_s) < LEAST_S:
            return 0.0
        self._offset_s = now_s
        return jump_s

    def note(self, project: Path) -> None:
        """Enter a jump in the journal of a project. Raises StorageError."""
        jump_s = self.jump_s()
        if jump_s:
            publish.record(project, Entry(JUMP, note={"seconds": round(jump_s, 3)}))
