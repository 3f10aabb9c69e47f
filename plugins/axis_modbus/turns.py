"""Turns on a line that several threads use: one after the other, a stop before all others."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager


class Turns:
    """A lock for which urgent callers wait at most until the present holder is done."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._held = False
        self._urgent = 0  # callers that wait

    @contextmanager
    def turn(self, *, urgent: bool = False) -> Iterator[None]:
        """Hold the line."""
        with self._changed:
            self._urgent += urgent
            try:
                self._changed.wait_for(lambda: not self._held and (urgent or not self._urgent))
            finally:
                self._urgent -= urgent
            self._held = True
        try:
            yield
        finally:
            with self._changed:
                self._held = False
                self._changed.notify_all()
