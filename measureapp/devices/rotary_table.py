"""Rotary table interface."""

from __future__ import annotations

from typing import Protocol


class RotaryTable(Protocol):
    """A table turning about one axis, counter-clockwise positive seen from above.

    Every driver must pass ``tests/contracts/test_rotary_table.py``.
    """

    name: str
    limits_rad: tuple[float, float]

    def angle_rad(self) -> float:
        """Read the angle back."""

    def move_to(self, goal_rad: float, *, timeout_s: float) -> None:
        """Turn and wait until settled. Raises LimitError before moving, DeviceTimeout while moving."""

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `move_to` then raises Cancelled."""
