"""Linear guide interface."""

from __future__ import annotations

from typing import Protocol


class LinearGuideAxis(Protocol):
    """The linear guide that moves the robot. Every driver must pass ``tests/contracts/test_linear_guide.py``."""

    name: str
    limits_mm: tuple[float, float]

    def position_mm(self) -> float:
        """Read the position back."""

    def move_to(self, goal_mm: float, *, timeout_s: float) -> None:
        """Move and wait until settled. Raises LimitError before moving, DeviceTimeout while moving."""

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `move_to` then raises Cancelled."""
