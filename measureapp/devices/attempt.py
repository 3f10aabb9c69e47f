"""One call of a driver that another thread may stop, and that must end in time."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

from measureapp.errors import DeviceTimeout
from measureapp.progress import Cancelled


class Stops:
    """Counts the stops of a device, so that calls which began before one notice it."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._count = 0

    def stop(self) -> None:
        """Cancel every attempt that has begun."""
        with self._changed:
            self._count += 1
            self._changed.notify_all()

    def begin(self, what: str, timeout_s: float) -> Attempt:
        """Begin an attempt; ``what`` completes the sentence "… did not end in time"."""
        return Attempt(self._changed, lambda: self._count, what, timeout_s)


class Attempt:
    """Waits and checks of one call."""

    def __init__(self, changed: threading.Condition, count: Callable[[], int], what: str, timeout_s: float) -> None:
        self._changed, self._count = changed, count
        self._began = count()
        self._what, self._timeout_s = what, timeout_s
        self._end = time.monotonic() + timeout_s

    def check(self) -> None:
        """Raise Cancelled after a stop, DeviceTimeout when time is up."""
        if self._count() != self._began:
            raise Cancelled
        if time.monotonic() > self._end:
            raise DeviceTimeout(
                f"{self._what} did not end within {self._timeout_s:g} s.", "Check the device; allow more time if it is sound."
            )

    def wait(self, seconds: float) -> None:
        """Wait, at most until a stop or the end of the time; raises as `check`."""
        until = min(time.monotonic() + seconds, self._end)
        with self._changed:
            while self._count() == self._began and time.monotonic() < until:
                self._changed.wait(until - time.monotonic())
        self.check()
