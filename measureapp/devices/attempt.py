"""One call of a driver that another thread may stop, and that must end in time."""

from __future__ import annotations

import threading
import time

from measureapp.errors import DeviceTimeout
from measureapp.progress import Cancelled


class Stops:
    """Counts the stops of a device, so that calls which began before one notice it. All methods may be called from any thread."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self._count = 0

    @property
    def count(self) -> int:
        """Number of stops so far; a call remembers it at its beginning."""
        return self._count

    def stop(self) -> None:
        """Cancel every call that has begun."""
        with self._changed:
            self._count += 1
            self._changed.notify_all()

    def check(self, count: int) -> None:
        """Raise Cancelled if there was a stop since ``count``."""
        if self._count != count:
            raise Cancelled

    def wait(self, seconds: float, count: int) -> None:
        """Wait, at most until a stop since ``count``, which raises Cancelled."""
        with self._changed:
            self._changed.wait_for(lambda: self._count != count, seconds)
        self.check(count)

    def begin(self, what: str, timeout_s: float) -> Attempt:
        """Begin an attempt; ``what`` completes the sentence "… did not end in time"."""
        return Attempt(self, what, timeout_s)


class Attempt:
    """Waits and checks of one call that has one time limit."""

    def __init__(self, stops: Stops, what: str, timeout_s: float) -> None:
        self._stops, self._began = stops, stops.count
        self._what, self._timeout_s = what, timeout_s
        self._end = time.monotonic() + timeout_s

    def check(self) -> None:
        """Raise Cancelled after a stop, DeviceTimeout when time is up."""
        self._stops.check(self._began)
        if time.monotonic() > self._end:
            raise DeviceTimeout(
                f"{self._what} did not end within {self._timeout_s:g} s.", "Check the device; allow more time if it is sound."
            )

    def wait(self, seconds: float) -> None:
        """Wait, at most until a stop or the end of the time; raises as `check`."""
        self._stops.wait(min(seconds, self._end - time.monotonic()), self._began)
        self.check()
