"""Rotary tables on a serial line."""

from __future__ import annotations

import re
from math import degrees, isfinite, radians

from measureapp.devices.arrival import Arrival, within_s
from measureapp.devices.attempt import Stops
from measureapp.devices.request import DeviceRequest
from measureapp.devices.serial_port import find_port
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, DeviceTimeout, LimitError, MeasureError, MotionError

from .command_table import CommandTable, read_table
from .line import SerialLine
from .settings import TableSettings

INSIDE = 1e-6  # rounding tolerance of the limits, in degrees


def connect(request: DeviceRequest) -> SerialTable:
    """Connect a rotary table. Raises InputError for a table of commands that does not fit, DeviceError when it does not answer."""
    settings = request.settings
    assert isinstance(settings, TableSettings)
    table, name = read_table(settings.controller), request.rig.table.model
    port = settings.port or find_port(settings.usb_serial)
    ends = (table.sent_end.encode("ascii"), table.reply_end.encode("ascii"))
    line = SerialLine(name, port, settings.baudrate or table.baudrate, ends, settings.reply_timeout_s)
    low, high = request.rig.table.limits_deg
    try:
        connected = SerialTable(name, line, table, settings, (radians(low), radians(high)))
        connected.angle_rad()
    except BaseException:
        line.close()
        raise
    return connected


class SerialTable:
    """A table turned through a command table; `move_to` and `home` are for one thread, `stop` for any."""

    def __init__(self, name: str, line: SerialLine, table: CommandTable, settings: TableSettings, limits_rad: tuple[float, float]) -> None:
        self.name, self.limits_rad = name, limits_rad
        self._line, self._table, self._settings = line, table, settings
        self._scale = settings.counts_per_unit or table.counts_per_degree
        self._stops = Stops()
        self._arrival = Arrival(name, "°", settings.tolerance_deg, settings.settled_s, settings.poll_s)

    def angle_rad(self) -> float:
        """Read the angle back."""
        return radians(self._angle_deg())

    def move_to(self, goal_rad: float, *, timeout_s: float) -> None:
        """Turn to an absolute angle and wait until settled."""
        goal, (low, high) = degrees(goal_rad), (degrees(limit) for limit in self.limits_rad)
        if not (isfinite(goal) and low - INSIDE <= goal <= high + INSIDE):
            raise LimitError(
                f"{self.name}: the angle {goal:g}° is outside {low:g}…{high:g}°.", "Choose an angle inside; nothing was moved."
            )
        if not self._is_referenced():
            raise MotionError(f"{self.name} is not referenced.", "Find its reference before it is moved.")
        settings = self._settings
        way = abs(goal - self._angle_deg())
        predicted_s = way / settings.speed_deg_per_s + settings.speed_deg_per_s / settings.acceleration_deg_per_s2
        attempt = self._stops.begin(f"{self.name}: the move", within_s(predicted_s, timeout_s))
        counts = round((settings.sense * goal + settings.zero_deg) * self._scale, self._table.digits)
        for command in self._table.commands.move:
            self._command(command.format(goal=int(counts) if self._table.digits == 0 else counts))
        self._wait(lambda: self._arrival.wait(goal, self._angle_deg, self._moves, attempt))

    def home(self, *, timeout_s: float) -> None:
        """Find the reference position, where the controller tells that it is not known."""
        if self._is_referenced():
            return
        attempt = self._stops.begin(f"{self.name}: finding the reference", timeout_s)
        for command in self._table.commands.home:
            self._command(command)

        def referenced() -> None:
            while self._moves() or not self._is_referenced():
                attempt.wait(self._settings.poll_s)

        self._wait(referenced)

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        try:
            if not self._is_referenced():
                return DeviceStatus(False, "not referenced.", "Find the reference.")
            note = "" if self._table.certain else "; compare its commands with the manual"
            return DeviceStatus(True, f"at {self._angle_deg():.4f}°, {self._table.name}{note}")
        except MeasureError as error:
            return DeviceStatus(False, error.message, error.hint)

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `move_to` then raises Cancelled."""
        self._stops.stop()
        self._say(self._table.commands.stop)

    def close(self) -> None:
        """Release the port."""
        self._line.close()

    def _wait(self, wait: object) -> None:
        """Wait as told, and stop the table where the time is over."""
        assert callable(wait)
        try:
            wait()
        except DeviceTimeout:
            self.stop()
            raise

    def _angle_deg(self) -> float:
        question = self._table.commands.position
        reply = self._ask(question)
        found = re.search(self._table.replies.position, reply)
        if found is None:
            raise DeviceError(f"{self.name} replied to {question!r} with {reply!r}, which is no position.", "Check the command table.")
        value = float(found["value"].replace(" ", ""))
        return self._settings.sense * (value / self._scale - self._settings.zero_deg)

    def _moves(self) -> bool:
        return re.search(self._table.replies.at_rest, self._ask(self._table.commands.state)) is None

    def _is_referenced(self) -> bool:
        pattern = self._table.replies.referenced
        return not pattern or re.search(pattern, self._ask(self._table.commands.state)) is not None

    def _ask(self, question: str) -> str:
        """Ask, and once more where no reply came: reading again does no harm."""
        try:
            return self._line.ask(question)
        except DeviceTimeout:
            return self._line.ask(question)

    def _command(self, command: str) -> None:
        """Send a command once, and ask whether the controller took it."""
        reply = self._say(command)
        pattern = self._table.replies.no_error
        if self._table.commands.error:
            reply = self._ask(self._table.commands.error)
        if pattern and (self._table.commands.error or self._table.answers_commands) and re.search(pattern, reply) is None:
            raise MotionError(f"{self.name} refused {command!r}: {reply!r}.", "Look the code up in the controller's manual.")

    def _say(self, command: str) -> str:
        if self._table.answers_commands:
            return self._line.ask(command)
        self._line.tell(command)
        return ""
