"""One axis of a drive in counts: reads, conditions, sequences, and moves that are believed only when they are read back."""

from __future__ import annotations

import threading
import time

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, MotionError
from measureapp.progress import Cancelled

from .drive_map import DriveMap
from .line import ModbusLine, Target
from .settings import AxisSettings

MARGIN, MARGIN_S = 1.5, 2.0  # of the predicted duration of a move
IDENTITY_TRIES = 3  # after late replies


class ModbusAxis:
    """Moves one drive. `move` and `home` are for one thread, `stop` for any."""

    def __init__(self, name: str, line: ModbusLine, drive: DriveMap, settings: AxisSettings) -> None:
        self.name = name
        self.counts_per_unit = settings.counts_per_unit or drive.counts_per_unit
        self._line, self._drive, self._settings = line, drive, settings
        self._target = Target(name, drive.unit_id if settings.unit_id is None else settings.unit_id)
        self._stops, self._asked_to_stop = 0, threading.Event()
        self._confirm_identity()
        if self._holds("alarm"):
            raise DeviceError(
                f"{name} reports an alarm: {self._alarm_words()}.", "Remove the cause and reset the drive, then connect again."
            )
        if not self._holds("enabled", default=True):
            self._run("enable", 0)

    # reading

    def counts(self) -> int:
        """Read the position in counts."""
        return self._read("position")

    def is_homed(self) -> bool:
        """Tell whether the drive knows its position; a drive that cannot tell is believed."""
        return self._holds("homed", default=True)

    def state_words(self) -> tuple[bool, str, str]:
        """Return whether the axis is ready, its state in words, and the remedy."""
        if self._holds("alarm"):
            return False, f"alarm: {self._alarm_words()}.", "Remove the cause and reset the drive."
        if not self.is_homed():
            return False, "not referenced.", "Find the reference."
        uncertain = self._drive.uncertain
        note = f"; compare with the manual: {', '.join(uncertain)}" if uncertain else ""
        return True, f"{self._drive.name}, station {self._target.unit_id}{note}", ""

    # moving

    def move(self, goal: int, duration_s: float, timeout_s: float) -> None:
        """Move to ``goal`` counts and wait until two reads agree with it and each other.

        Raises
        ------
        MotionError
            Not referenced, an alarm, or it came to rest elsewhere.
        DeviceTimeout
            It did not come to rest at the goal in time.
        Cancelled
            `stop` was called.
        """
        if not self.is_homed():
            raise MotionError(f"{self.name} is not referenced.", "Find its reference before it is moved.")
        stops = self._begin()
        within_s = min(timeout_s, MARGIN * duration_s + MARGIN_S)
        self._command(goal)
        self._wait_at(goal, stops, time.monotonic() + within_s, within_s)

    def home(self, timeout_s: float) -> None:
        """Find the reference, if the drive does not know its position. Raises as `move`."""
        if self.is_homed():
            return
        stops = self._begin()
        self._run("home", 0)
        end = time.monotonic() + timeout_s
        while not self.is_homed() or self._moves():
            self._check(stops, end, timeout_s, "did not find its reference")

    def stop(self) -> None:
        """Stop the drive now."""
        self._stops += 1
        self._asked_to_stop.set()
        self._run("stop", 0, urgent=True)

    def _begin(self) -> int:
        self._asked_to_stop.clear()
        return self._stops

    def _command(self, goal: int) -> None:
        """Write goal and command; after a lost reply look whether the drive took it, and never write a second time blindly."""
        try:
            self._run("move", goal)
        except DeviceTimeout:
            self._confirm_identity()
            if self._read("goal") != self._wrapped("goal", goal) or not (self._moves() or self._is_at(goal)):
                raise
        if self._read("goal") != self._wrapped("goal", goal):
            self._run("stop", 0)
            raise MotionError(
                f"{self.name} holds another goal than it was sent.", "Check the map of the drive, and that nobody else commands it."
            )

    def _wait_at(self, goal: int, stops: int, end: float, within_s: float) -> None:
        resting_since, last = 0.0, None
        tolerance = self._settings.tolerance * self.counts_per_unit
        while True:
            self._check(stops, end, within_s, "did not come to rest at its goal")
            now, here = time.monotonic(), self.counts()
            if self._holds("alarm"):
                raise MotionError(f"{self.name} reports an alarm: {self._alarm_words()}.", "Remove the cause, then reset the drive.")
            if last is None or abs(here - last) > tolerance or self._moves():
                resting_since, last = now, here
                continue
            if now - resting_since < self._settings.settled_s:
                continue
            if abs(here - goal) <= tolerance:
                return
            if self._drive.conditions.get("moving") is not None and now - resting_since > 1.0:
                raise MotionError(
                    f"{self.name} came to rest {abs(here - goal) / self.counts_per_unit:.3f} away from its goal.",
                    "Check for an obstacle, a limit switch, and the scale of the drive.",
                )

    def _check(self, stops: int, end: float, within_s: float, what: str) -> None:
        if self._asked_to_stop.wait(self._settings.poll_s) or self._stops != stops:
            raise Cancelled
        if time.monotonic() > end:
            self._run("stop", 0)
            raise DeviceTimeout(f"{self.name} {what} within {within_s:.1f} s.", "Check the drive, its load and its brake.")

    def _is_at(self, goal: int) -> bool:
        return abs(self.counts() - goal) <= self._settings.tolerance * self.counts_per_unit

    def _moves(self) -> bool:
        """Whether the drive says that it moves; one that only tells "in position" moves while that is not set."""
        if "moving" in self._drive.conditions:
            return self._holds("moving")
        return not self._holds("in_position")

    # registers

    def _confirm_identity(self) -> None:
        """Drain the line after a late reply, and believe the drive again when its identity register reads as it must."""
        for attempt in range(IDENTITY_TRIES):
            if self._line.doubtful:
                self._line.drain()
            try:
                self._check_identity()
            except DeviceLost:
                raise
            except DeviceError:
                if not self._line.doubtful or attempt + 1 == IDENTITY_TRIES:
                    raise
            else:
                self._line.trust()
                return

    def _check_identity(self) -> None:
        identity = self._drive.identity
        if identity is None:
            return
        value = self._raw(identity.register_name)
        if not identity.holds(value):
            raise DeviceError(
                f"{self.name}: register {identity.register_name} reads {value:#x}, which is not a {self._drive.name}.",
                "Check station number, port and drive map.",
            )

    def _holds(self, condition: str, *, default: bool = False) -> bool:
        stated = self._drive.conditions.get(condition)  # type: ignore[call-overload]
        return default if stated is None else stated.holds(self._read(stated.register_name))

    def _read(self, name: str) -> int:
        """Read a register; after a late reply the identity is confirmed first, and a read without reply is asked once more."""
        if self._line.doubtful:
            self._confirm_identity()
        try:
            return self._raw(name)
        except DeviceTimeout:  # reading again does no harm
            self._confirm_identity()
            return self._raw(name)

    def _raw(self, name: str) -> int:
        register = self._drive.registers[name]
        words = self._line.read(self._target, register.kind, register.address, register.words)
        if self._drive.word_order == "low-first":
            words = words[::-1]
        value = 0
        for word in words:
            value = value << 16 | word
        bits = 16 * register.words
        return value - (1 << bits) if register.signed and value >> (bits - 1) else value

    def _run(self, sequence: str, goal: int, *, urgent: bool = False) -> None:
        for step in self._drive.sequences.get(sequence, ()):  # type: ignore[call-overload]
            speed = max(1, round(self._settings.speed * self.counts_per_unit))
            value = goal if step.value == "goal" else speed if step.value == "speed" else int(step.value)
            if step.bits is not None:
                value |= self._raw(step.write) & ~step.bits
            self._write(step.write, value, urgent)

    def _write(self, name: str, value: int, urgent: bool) -> None:
        register = self._drive.registers[name]
        masked = value & ((1 << 16 * register.words) - 1)
        words = [masked >> 16 * place & 0xFFFF for place in reversed(range(register.words))]
        ordered = words[::-1] if self._drive.word_order == "low-first" else words
        self._line.write(self._target, register.kind, register.address, ordered, urgent=urgent)

    def _wrapped(self, name: str, value: int) -> int:
        """Return a value as the register can hold it."""
        register = self._drive.registers[name]
        bits = 16 * register.words
        masked = value & ((1 << bits) - 1)
        return masked - (1 << bits) if register.signed and masked >> (bits - 1) else masked

    def _alarm_words(self) -> str:
        if "alarm_code" not in self._drive.registers:
            return "see the drive"
        code = self._read("alarm_code")
        return self._drive.alarms.get(str(code), f"code {code:#x}")
