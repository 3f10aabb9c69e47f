"""Robot interface."""

from __future__ import annotations

from typing import Protocol

from measureapp.geometry.transform import RigidTransform


class Robot(Protocol):
    """A six-axis robot commanded by its flange pose. Every driver must pass ``tests/contracts/test_robot.py``."""

    name: str

    def pose(self) -> RigidTransform:
        """Read base_from_flange back."""

    def move_to(self, base_from_flange: RigidTransform, *, timeout_s: float) -> None:
        """Move and wait until settled. Raises LimitError before moving, DeviceTimeout while moving."""

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `move_to` then raises Cancelled."""
