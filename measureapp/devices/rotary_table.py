"""Rotary table interface."""

from __future__ import annotations

from typing import Protocol

from measureapp.devices.status import DeviceStatus


class RotaryTable(Protocol):
    """A table turning about one axis, counter-clockwise positive seen from above.

    Every driver must pass ``tests/contracts/test_rotary_table.py``.
    """

    name: str
    limits_rad: tuple[float, float]

    def angle_rad(self) -> float:
        """Read the angle back from the controller. Raises DeviceError, never returns an old or commanded value."""

    def move_to(self, goal_rad: float, *, timeout_s: float) -> None:
        """Turn to an absolute angle and wait until settled.

        Raises
        ------
        LimitError
            Before anything moves.
        DeviceTimeout
            It did not settle in time.
        MotionError
            The controller reports an alarm, is not referenced, or stopped elsewhere.
        DeviceLost
            The controller does not answer any more.
        """

    def home(self, *, timeout_s: float) -> None:
        """Find the reference position. Raises as `move_to`; harmless for a table that is referenced already."""

    def status(self) -> DeviceStatus:
        """Read the state, for display."""

    def stop(self) -> None:
        """Stop now, from any thread, also while another call waits; a waiting `move_to` then raises Cancelled."""

    def close(self) -> None:
        """Release the line. Harmless when repeated."""
