"""Simulated time, and cancellation from any thread."""

from __future__ import annotations

import threading
from typing import Protocol

from measureapp.errors import DeviceTimeout
from measureapp.progress import Cancelled


class Clock(Protocol):
    """Lets time pass for a device."""

    def wait(self, seconds: float, stopped: threading.Event) -> None:
        """Return after ``seconds`` of the rig's time, or at once when ``stopped`` is set."""


class ScaledClock:
    """Waits for the rig's time multiplied by a scale; with scale 0 never waits."""

    def __init__(self, scale: float) -> None:
        self._scale = scale

    def wait(self, seconds: float, stopped: threading.Event) -> None:
        """Wait, but not longer than until ``stopped``."""
        if self._scale > 0.0:
            stopped.wait(seconds * self._scale)


class Stopping:
    """Cancels calls that are waiting when `stop` is called; later calls are not affected."""

    def __init__(self, clock: Clock) -> None:
        self._clock = clock
        self._lock = threading.Lock()
        self._waiting: set[threading.Event] = set()

    def stop(self) -> None:
        """Cancel every call that is waiting."""
        with self._lock:
            for stopped in self._waiting:
                stopped.set()

    def wait(self, device: str, seconds: float, timeout_s: float) -> None:
        """Let ``seconds`` of the rig's time pass.

        Raises
        ------
        DeviceTimeout
            It would take longer than ``timeout_s``; raised after that time.
        Cancelled
            `stop` was called while waiting.
        """
        stopped = threading.Event()
        with self._lock:
            self._waiting.add(stopped)
        try:
            self._clock.wait(min(seconds, timeout_s), stopped)
        finally:
            with self._lock:
                self._waiting.discard(stopped)
        if stopped.is_set():
            raise Cancelled
        if seconds > timeout_s:
            raise DeviceTimeout(f"{device} did not finish within {timeout_s:g} s.", "Check the device for obstructions, then try again.")
