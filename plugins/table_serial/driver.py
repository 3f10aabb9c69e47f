"""Rotary tables whose controllers take ASCII commands over a serial line."""

from __future__ import annotations

from math import degrees, isfinite, radians

from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import InputError, LimitError, MeasureError

from .command_table import read_table
from .controller import TableController
from .line import SerialLine, open_line
from .settings import TableSettings

INSIDE_DEG = 1e-6  # rounding tolerance of the limits


def connect(request: DeviceRequest) -> SerialTable:
    """Connect a rotary table.

    Raises
    ------
    InputError
        A command table, line or range of angles that does not fit.
    DeviceError
        The controller does not answer, is another one, or reports an alarm.
    """
    settings = request.settings
    assert isinstance(settings, TableSettings)
    commands, name, limits_deg = read_table(settings.controller), request.rig.table.model, request.rig.table.limits_deg
    if commands.turns == "modulo" and limits_deg[1] - limits_deg[0] >= 360.0:
        raise InputError(
            f"{name}: its controller counts modulo one turn, and the limits {limits_deg[0]:g}…{limits_deg[1]:g}° do not determine the turn.",
            "Choose limits less than 360° apart in the rig description.",
        )
    line = request.links.open(settings.link, SerialLine, lambda table: open_line(table, commands), SerialLine.close)
    return SerialTable(TableController(name, line, commands, settings), settings, limits_deg)


class SerialTable:
    """A rotary table."""

    def __init__(self, controller: TableController, settings: TableSettings, limits_deg: tuple[float, float]) -> None:
        self.name = controller.name
        self.limits_rad = (radians(limits_deg[0]), radians(limits_deg[1]))
        self._controller, self._settings, self._limits_deg = controller, settings, limits_deg

    def angle_rad(self) -> float:
        """Read the angle back."""
        return radians(self._angle_deg())

    def move_to(self, goal_rad: float, *, timeout_s: float) -> None:
        """Turn to an absolute angle and wait until settled."""
        low, high = self._limits_deg
        goal_deg = degrees(goal_rad)
        if not (isfinite(goal_deg) and low - INSIDE_DEG <= goal_deg <= high + INSIDE_DEG):
            raise LimitError(
                f"{self.name}: the goal {goal_deg:g}° is outside {low:g}…{high:g}°.", "Choose a goal inside the limits; nothing was moved."
            )
        settings, controller = self._settings, self._controller
        counts = controller.sendable(controller.sense * goal_deg * controller.counts_per_unit + settings.zero_counts)
        way_deg = abs(goal_deg - self._angle_deg())
        controller.move(counts, way_deg / settings.speed + settings.speed / settings.acceleration, timeout_s)

    def home(self, *, timeout_s: float) -> None:
        """Find the reference position."""
        self._controller.home(timeout_s)

    def stop(self) -> None:
        """Stop now, from any thread."""
        self._controller.stop()

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        try:
            ready, text, remedy = self._controller.state_words()
            where = f"at {self._angle_deg():.3f}°, " if ready else ""
        except MeasureError as error:
            return DeviceStatus(False, error.message, error.hint)
        return DeviceStatus(ready, where + text, remedy)

    def close(self) -> None:
        """Nothing of its own to release: the line is closed with the rig."""

    def _angle_deg(self) -> float:
        """Return the angle; where the controller counts modulo one turn, the one nearest to the middle of the limits."""
        controller, (low, high) = self._controller, self._limits_deg
        angle_deg = controller.sense * (controller.counts() - self._settings.zero_counts) / controller.counts_per_unit
        turns = round((angle_deg - (low + high) / 2) / 360.0) if controller.is_modulo else 0
        return angle_deg - 360.0 * turns
