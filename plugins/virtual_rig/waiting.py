"""The rig's time, and cancellation from any thread."""

from __future__ import annotations

import threading
import time
from typing import Protocol

from measureapp.errors import DeviceTimeout
from measureapp.progress import Cancelled


class Clock(Protocol):
    """The rig's time, in seconds from some origin."""

    def now(self) -> float:
        """Return the present time; it never runs back."""

    def wait_until(self, moment: float, stopped: threading.Event) -> None:
        """Return at ``moment``, or at once when ``stopped`` is set."""


class ScaledClock:
    """The time of a rig that runs ``1 / scale`` times as fast as the computer's clock."""

    def __init__(self, scale: float) -> None:
        self._scale = scale

    def now(self) -> float:
        """Return the present time."""
        return time.monotonic() / self._scale

    def wait_until(self, moment: float, stopped: threading.Event) -> None:
        """Wait, but not longer than until ``stopped``."""
        stopped.wait(max(0.0, (moment - self.now()) * self._scale))


class SteppingClock:
    """A time that passes only where a device waits, and then at once: nothing is waited for, and durations are known exactly."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._now = 0.0

    def now(self) -> float:
        """Return the present time."""
        with self._lock:
            return self._now

    def wait_until(self, moment: float, stopped: threading.Event) -> None:
        """Let the time be ``moment``, unless it is later already."""
        with self._lock:
            if not stopped.is_set():
                self._now = max(self._now, moment)


def clock_of(time_scale: float) -> Clock:
    """Return a clock for the setting ``time_scale``."""
    return ScaledClock(time_scale) if time_scale > 0.0 else SteppingClock()


class Stopping:
    """Cancels calls that are waiting when `stop` is called; later calls are not affected."""

    def __init__(self, clock: Clock) -> None:
        self.clock = clock
        self._lock = threading.Lock()
        self._waiting: set[threading.Event] = set()

    def stop(self) -> None:
        """Cancel every call that is waiting."""
        with self._lock:
            for stopped in self._waiting:
                stopped.set()

    def wait(self, device: str, seconds: float, timeout_s: float) -> None:
        """Let ``seconds`` of the rig's time pass; raises as `wait_until`."""
        self.wait_until(device, self.clock.now() + seconds, timeout_s)

    def wait_until(self, device: str, moment: float, timeout_s: float) -> None:
        """Wait until a moment of the rig's time.

        Raises
        ------
        DeviceTimeout
            It is later than ``timeout_s`` from now; raised after that time.
        Cancelled
            `stop` was called while waiting.
        """
        stopped = threading.Event()
        latest = self.clock.now() + timeout_s
        with self._lock:
            self._waiting.add(stopped)
        try:
            self.clock.wait_until(min(moment, latest), stopped)
        finally:
            with self._lock:
                self._waiting.discard(stopped)
        if stopped.is_set():
            raise Cancelled
        if moment > latest:
            raise DeviceTimeout(f"{device} did not finish within {timeout_s:g} s.", "Check the device for obstructions, then try again.")
