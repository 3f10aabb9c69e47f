"""The connected rig: all devices of one cell."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from statistics import median
from typing import Protocol

from measureapp.data.calibration import RigCalibration
from measureapp.data.conditions import Conditions, LensSetting
from measureapp.data.fringe import AxisReadback
from measureapp.data.rig import RigDescription
from measureapp.devices.camera import Camera
from measureapp.devices.linear_guide import LinearGuideAxis
from measureapp.devices.paths import Paths
from measureapp.devices.projector import Projector
from measureapp.devices.robot import Robot
from measureapp.devices.rotary_table import RotaryTable
from measureapp.devices.status import DeviceStatus
from measureapp.devices.stop_latch import StopLatch

_log = logging.getLogger(__name__)


class Device(Protocol):
    """Interface common to all devices."""

    name: str

    def status(self) -> DeviceStatus:
        """Read the state, for display."""

    def stop(self) -> None:
        """Stop now, from any thread."""

    def close(self) -> None:
        """Release the device. Harmless when repeated."""


@dataclass(frozen=True, slots=True, eq=False)
class Rig:
    """All connected devices; only `measureapp/acquire` moves or triggers them.

    `place_on_table` requests an object by name ("board", "part") and returns when it is on the table. `latch` holds the rig after a stop.
    """

    description: RigDescription
    cameras: Mapping[str, Camera]
    projector: Projector
    robot: Robot
    guide: LinearGuideAxis
    table: RotaryTable
    place_on_table: Callable[[str], None]
    release: Callable[[], None] = field(default=lambda: None)  # of what the drivers share
    latch: StopLatch = field(default_factory=StopLatch)
    paths: Paths | None = None  # of checked moves; None: every viewpoint is approached directly, unchecked
    in_use: threading.Lock = field(default_factory=threading.Lock)  # held by the session that moves and triggers
    truth: Callable[[], RigCalibration | None] = field(default=lambda: None)  # of a simulated rig, only to be shown beside results

    @property
    def axes(self) -> tuple[Device, ...]:
        """What moves."""
        return (self.robot, self.guide, self.table)

    @property
    def devices(self) -> tuple[Device, ...]:
        """Every device, what moves first."""
        return (*self.axes, *self.cameras.values(), self.projector)

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

    def close(self) -> None:
        """Release every device, then what they share; one that fails does not keep the others."""
        for device in self.devices:
            try:
                device.close()
            except Exception:  # foreign code may raise anything, and the program is leaving
                _log.exception("%s could not be closed", device.name)
        self.release()
