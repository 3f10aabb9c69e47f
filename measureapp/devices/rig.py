"""The connected rig: all devices of one cell."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from statistics import median
from typing import Protocol

from measureapp.data.conditions import Conditions, LensSetting
from measureapp.data.fringe import AxisReadback
from measureapp.data.rig import RigDescription
from measureapp.devices.camera import Camera
from measureapp.devices.linear_guide import LinearGuideAxis
from measureapp.devices.projector import Projector
from measureapp.devices.robot import Robot
from measureapp.devices.rotary_table import RotaryTable
from measureapp.errors import DeviceError


class Device(Protocol):
    """Interface common to all devices."""

    name: str

    def stop(self) -> None:
        """Stop now, from any thread."""


@dataclass(frozen=True, slots=True, eq=False)
class Rig:
    """All connected devices. `place_on_table` requests an object by name ("board", "part") and returns when it is on the table."""

    description: RigDescription
    cameras: Mapping[str, Camera]
    projector: Projector
    robot: Robot
    guide: LinearGuideAxis
    table: RotaryTable
    place_on_table: Callable[[str], None]
    close: Callable[[], None] = field(default=lambda: None)

    def readback(self) -> AxisReadback:
        """Read every axis back."""
        return AxisReadback(self.robot.pose(), self.guide.position_mm(), self.table.angle_rad())

    def conditions(self, taken_at: str) -> Conditions:
        """Read the conditions of images taken at ``taken_at`` (ISO 8601); the head's temperature is the median of its cameras."""
        temperatures = [value for camera in self.cameras.values() if (value := camera.temperature_c()) is not None]
        lenses = {name: setting for name, camera in self.cameras.items() if (setting := camera.lens()) != LensSetting()}
        return Conditions(
            taken_at,
            median(temperatures) if temperatures else None,
            {name: camera.serial for name, camera in self.cameras.items()},
            lenses,
        )

    def stop_all(self) -> None:
        """Stop every device now, from any thread; failures are collected and raised as one DeviceError."""
        devices: tuple[Device, ...] = (self.robot, self.guide, self.table, *self.cameras.values(), self.projector)
        failures = []
        for device in devices:
            try:
                device.stop()
            except DeviceError as error:
                failures.append(f"{device.name}: {error.message}")
        if failures:
            raise DeviceError(
                "Not every device confirmed the stop: " + "; ".join(failures) + ".", "Use the emergency stop and check these devices."
            )
