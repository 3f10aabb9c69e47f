"""Linear guides and rotary tables on Modbus."""

from __future__ import annotations

from math import degrees, isfinite, radians

from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import LimitError, MeasureError

from .axis import ModbusAxis
from .drive_map import read_map
from .line import ModbusLine, open_line
from .settings import AxisSettings

INSIDE = 1e-6  # rounding tolerance of the limits
GO_BACK = "Choose a goal inside the limits; nothing was moved."


def connect_guide(request: DeviceRequest) -> ModbusGuide:
    """Connect a linear guide. Raises InputError for a map or line that does not fit, DeviceError when the drive does not answer."""
    return ModbusGuide(request.rig.guide.model, _axis(request, request.rig.guide.model), request.settings, request.rig.guide.limits_mm)


def connect_table(request: DeviceRequest) -> ModbusTable:
    """Connect a rotary table. Raises as `connect_guide`."""
    low, high = request.rig.table.limits_deg
    return ModbusTable(request.rig.table.model, _axis(request, request.rig.table.model), request.settings, (radians(low), radians(high)))


def _axis(request: DeviceRequest, name: str) -> ModbusAxis:
    settings = request.settings
    assert isinstance(settings, AxisSettings)
    drive = read_map(settings.drive)
    line = request.links.open(settings.link, ModbusLine, lambda table: open_line(table, drive), ModbusLine.close)
    return ModbusAxis(name, line, drive, settings)


class _Scaled:
    """An axis in its own unit, mm or degrees."""

    def __init__(self, name: str, axis: ModbusAxis, settings: object) -> None:
        assert isinstance(settings, AxisSettings)
        self.name = name
        self._axis, self._settings = axis, settings

    def home(self, *, timeout_s: float) -> None:
        """Find the reference position."""
        self._axis.home(timeout_s)

    def stop(self) -> None:
        """Stop now, from any thread."""
        self._axis.stop()

    def close(self) -> None:
        """Nothing of its own to release: the line is closed with the rig."""

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        try:
            ready, text, remedy = self._axis.state_words()
            where = f"at {self._position():.3f}{self._unit}, " if ready else ""
        except MeasureError as error:
            return DeviceStatus(False, error.message, error.hint)
        return DeviceStatus(ready, where + text, remedy)

    _unit = ""

    def _position(self) -> float:
        return self._settings.sense * (self._axis.counts() - self._settings.zero_counts) / self._axis.counts_per_unit

    def _move(self, goal: float, low: float, high: float, timeout_s: float) -> None:
        if not (isfinite(goal) and low - INSIDE <= goal <= high + INSIDE):
            raise LimitError(f"{self.name}: the goal {goal:g}{self._unit} is outside {low:g}…{high:g}{self._unit}.", GO_BACK)
        settings = self._settings
        counts = round(settings.sense * goal * self._axis.counts_per_unit) + settings.zero_counts
        way = abs(goal - self._position())
        self._axis.move(counts, way / settings.speed + settings.speed / settings.acceleration, timeout_s)


class ModbusGuide(_Scaled):
    """A linear guide."""

    _unit = " mm"

    def __init__(self, name: str, axis: ModbusAxis, settings: object, limits_mm: tuple[float, float]) -> None:
        super().__init__(name, axis, settings)
        self.limits_mm = limits_mm

    def position_mm(self) -> float:
        """Read the position back."""
        return self._position()

    def move_to(self, goal_mm: float, *, timeout_s: float) -> None:
        """Move to an absolute position and wait until settled."""
        self._move(goal_mm, *self.limits_mm, timeout_s)


class ModbusTable(_Scaled):
    """A rotary table."""

    _unit = "°"

    def __init__(self, name: str, axis: ModbusAxis, settings: object, limits_rad: tuple[float, float]) -> None:
        super().__init__(name, axis, settings)
        self.limits_rad = limits_rad

    def angle_rad(self) -> float:
        """Read the angle back."""
        return radians(self._position())

    def move_to(self, goal_rad: float, *, timeout_s: float) -> None:
        """Turn to an absolute angle and wait until settled."""
        low, high = self.limits_rad
        self._move(degrees(goal_rad), degrees(low), degrees(high), timeout_s)
