"""The flag that ends a waiting move."""

from __future__ import annotations

import threading

from measureapp.progress import Cancelled


class StopFlag:
    """Ends waits of a move that began before the last stop."""

    def __init__(self) -> None:
        self._condition = threading.Condition()
        self._stops = 0

    @property
    def count(self) -> int:
        """Number of stops so far; a move remembers it at its beginning."""
        return self._stops

    def set(self) -> None:
        """Stop now."""
        with self._condition:
            self._stops += 1
            self._condition.notify_all()

    def wait(self, seconds: float, count: int) -> None:
        """Wait; raises Cancelled at a stop since ``count``."""
        with self._condition:
            if self._condition.wait_for(lambda: self._stops != count, seconds):
                raise Cancelled
