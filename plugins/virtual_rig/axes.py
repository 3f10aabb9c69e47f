"""Robot, guide and table of the virtual rig; limits are checked before anything moves."""

from __future__ import annotations

import numpy as np

from measureapp.devices.status import DeviceStatus
from measureapp.errors import LimitError
from measureapp.geometry.transform import RigidTransform
from measureapp.simulate.world import World

from .waiting import Clock, Stopping

ROBOT_MM_PER_S, ROBOT_RAD_PER_S = 250.0, 1.0
GUIDE_MM_PER_S = 300.0
TABLE_RAD_PER_S = 0.5
SETTLING_S = 0.3
NO_MOVE = 1e-9
INSIDE = 1e-6  # rounding tolerance of the limits, in mm or degrees
GO_BACK = "Choose a goal inside the limits; nothing was moved."


class VirtualRobot:
    """The robot of the world."""

    def __init__(self, world: World, clock: Clock) -> None:
        self.name = world.description.robot.model
        self._world = world
        self._stopping = Stopping(clock)

    def pose(self) -> RigidTransform:
        """Read base_from_flange back."""
        return self._world.readback().base_from_flange

    def move_to(self, base_from_flange: RigidTransform, *, timeout_s: float) -> None:
        """Move and wait until settled. Raises LimitError before moving, DeviceTimeout while moving."""
        self._check_reach(base_from_flange)
        way = self.pose().inverse() @ base_from_flange
        seconds = max(float(np.linalg.norm(way.translation_mm)) / ROBOT_MM_PER_S, way.angle_rad / ROBOT_RAD_PER_S)
        self._stopping.wait(self.name, _with_settling(seconds), timeout_s)
        self._world.move_robot(base_from_flange)

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        return DeviceStatus(True, "flange at {:.1f} {:.1f} {:.1f} mm".format(*self.pose().translation_mm))

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `move_to` then raises Cancelled."""
        self._stopping.stop()

    def close(self) -> None:
        """Nothing to release."""

    def _check_reach(self, goal: RigidTransform) -> None:
        robot = self._world.description.robot
        reach = float(np.linalg.norm(goal.translation_mm - np.array(robot.shoulder_mm)))
        if not robot.min_reach_mm - INSIDE <= reach <= robot.max_reach_mm + INSIDE:
            raise LimitError(
                f"{self.name}: a flange position {reach:.0f} mm from the shoulder is outside {robot.min_reach_mm:g}…{robot.max_reach_mm:g} mm.",
                GO_BACK,
            )


class VirtualGuide:
    """The linear guide of the world."""

    def __init__(self, world: World, clock: Clock) -> None:
        self.name = world.description.guide.model
        self.limits_mm = world.description.guide.limits_mm
        self._world = world
        self._stopping = Stopping(clock)

    def position_mm(self) -> float:
        """Read the position back."""
        return self._world.readback().guide_mm

    def move_to(self, goal_mm: float, *, timeout_s: float) -> None:
        """Move and wait until settled. Raises LimitError before moving, DeviceTimeout while moving."""
        low, high = self.limits_mm
        if not low - INSIDE <= goal_mm <= high + INSIDE:
            raise LimitError(f"{self.name}: the position {goal_mm:g} mm is outside {low:g}…{high:g} mm.", GO_BACK)
        self._stopping.wait(self.name, _with_settling(abs(goal_mm - self.position_mm()) / GUIDE_MM_PER_S), timeout_s)
        self._world.move_guide(float(goal_mm))

    def home(self, *, timeout_s: float) -> None:
        """Nothing to find: its position is always known."""

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        return DeviceStatus(True, f"at {self.position_mm():.2f} mm")

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `move_to` then raises Cancelled."""
        self._stopping.stop()

    def close(self) -> None:
        """Nothing to release."""


class VirtualTable:
    """The rotary table of the world."""

    def __init__(self, world: World, clock: Clock) -> None:
        self.name = world.description.table.model
        low, high = np.deg2rad(world.description.table.limits_deg)
        self.limits_rad = (float(low), float(high))
        self._world = world
        self._stopping = Stopping(clock)

    def angle_rad(self) -> float:
        """Read the angle back."""
        return self._world.readback().table_rad

    def move_to(self, goal_rad: float, *, timeout_s: float) -> None:
        """Turn and wait until settled. Raises LimitError before moving, DeviceTimeout while moving."""
        low, high = self.limits_rad
        if not low - INSIDE <= goal_rad <= high + INSIDE:
            limits = f"{np.degrees(low):g}…{np.degrees(high):g}°"
            raise LimitError(f"{self.name}: the angle {np.degrees(goal_rad):g}° is outside {limits}.", GO_BACK)
        self._stopping.wait(self.name, _with_settling(abs(goal_rad - self.angle_rad()) / TABLE_RAD_PER_S), timeout_s)
        self._world.turn_table(float(goal_rad))

    def home(self, *, timeout_s: float) -> None:
        """Nothing to find: its angle is always known."""

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        return DeviceStatus(True, f"at {np.degrees(self.angle_rad()):.4f}°")

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `move_to` then raises Cancelled."""
        self._stopping.stop()

    def close(self) -> None:
        """Nothing to release."""


def _with_settling(seconds: float) -> float:
    return 0.0 if seconds < NO_MOVE else seconds + SETTLING_S
