"""Robot interface."""

from __future__ import annotations

from typing import Protocol, runtime_checkable

from measureapp.arrays import FloatArray
from measureapp.devices.status import DeviceStatus
from measureapp.geometry.transform import RigidTransform


class Robot(Protocol):
    """A six-axis robot commanded by its flange pose. Every driver must pass ``tests/contracts/test_robot.py``."""

    name: str

    def pose(self) -> RigidTransform:
        """Read base_from_flange back from the controller. Raises DeviceError, never returns an old or commanded value."""

    def move_to(self, base_from_flange: RigidTransform, *, timeout_s: float) -> None:
        """Move and wait until settled.

        Raises
        ------
        LimitError
            Before anything moves.
        DeviceTimeout
            It did not settle in time.
        MotionError
            The controller stopped, refused, or left its operating mode; the pose is unknown until it is read back.
        DeviceLost
            The controller does not answer any more.
        """

    def status(self) -> DeviceStatus:
        """Read the state, for display."""

    def stop(self) -> None:
        """Stop now, from any thread, also while another call waits; a waiting `move_to` then raises Cancelled."""

    def close(self) -> None:
        """Log out and release what the driver holds at the controller. Harmless when repeated."""


@runtime_checkable
class JointRobot(Protocol):
    """A robot whose joint angles can be read and commanded, so that it drives exactly the path that was checked."""

    def joints_rad(self) -> FloatArray:
        """Read the joint angles back, (6,). Raises DeviceError."""

    def move_joints(self, goal_rad: FloatArray, *, timeout_s: float) -> None:
        """Move all joints to their angles (6,), in proportion, and wait until settled; raises as `Robot.move_to`."""
