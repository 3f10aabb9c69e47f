"""The latch of a stop: once stopped, a rig does nothing until a person resets it."""

from __future__ import annotations

import threading

from measureapp.errors import DeviceError


class StopLatch:
    """Holds the reason of the last stop until `reset`. All methods may be called from any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._reason = ""

    @property
    def reason(self) -> str:
        """Why the rig was stopped; empty while it may run."""
        return self._reason

    def set(self, reason: str) -> None:
        """Latch a stop; the first reason is kept."""
        with self._lock:
            self._reason = self._reason or reason

    def reset(self) -> None:
        """Let the rig run again."""
        with self._lock:
            self._reason = ""

    def check(self) -> None:
        """Raise DeviceError while the rig is stopped."""
        if self._reason:
            raise DeviceError(
                f"The rig was stopped: {self._reason}", "Remove the cause, check that nothing is in the way, then reset the stop."
            )
