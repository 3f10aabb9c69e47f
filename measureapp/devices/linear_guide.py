"""Linear guide interface."""

from __future__ import annotations

from typing import Protocol

from measureapp.devices.status import DeviceStatus


class LinearGuideAxis(Protocol):
    """The linear guide that moves the robot. Every driver must pass ``tests/contracts/test_linear_guide.py``."""

    name: str
    limits_mm: tuple[float, float]

    def position_mm(self) -> float:
        """Read the position back from the drive. Raises DeviceError, never returns an old or commanded value."""

    def move_to(self, goal_mm: float, *, timeout_s: float) -> None:
        """Move to an absolute position and wait until settled.

        Raises
        ------
        LimitError
            Before anything moves.
        DeviceTimeout
            It did not settle in time.
        MotionError
            The drive reports an alarm, is not referenced, or stopped elsewhere.
        DeviceLost
            The drive does not answer any more.
        """

    def home(self, *, timeout_s: float) -> None:
        """Find the reference position. Raises as `move_to`; harmless for a drive that is referenced already."""

    def status(self) -> DeviceStatus:
        """Read the state, for display."""

    def stop(self) -> None:
        """Stop now, from any thread, also while another call waits; a waiting `move_to` then raises Cancelled."""

    def close(self) -> None:
        """Release the line. Harmless when repeated."""
