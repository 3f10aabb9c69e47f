"""One axis of a drive in counts: reads, conditions, sequences, and moves that are believed only when they are read back."""

from __future__ import annotations

import time
from collections.abc import Callable
from contextlib import suppress

from measureapp.devices.attempt import Attempt, Stops
from measureapp.devices.settling import ELSEWHERE_S, Settling, allowed_s
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, LimitError, MeasureError, MotionError
from measureapp.progress import Cancelled

from .drive_map import DriveMap, Step
from .line import ModbusLine, Target, Urgency
from .settings import AxisSettings

IDENTITY_TRIES = 3  # after late replies
STOP_TRIES = 2  # writing a stop again does no harm
ENABLE_S = 2.0


class ModbusAxis:
    """Moves one drive. `move` and `home` are for one thread, `stop` for any."""

    def __init__(self, name: str, line: ModbusLine, drive: DriveMap, settings: AxisSettings) -> None:
        self.name = name
        self.counts_per_unit = settings.counts_per_unit or drive.counts_per_unit
        self._line, self._drive, self._settings = line, drive, settings
        self._target = Target(name, drive.unit_id if settings.unit_id is None else settings.unit_id)
        self._stops = Stops()
        self._referenced = settings.absolute_encoder
        self._written: dict[str, int] = {}  # registers of which only some bits are changed
        self._confirm_identity()
        self._refuse_alarm(DeviceError, "connect again")
        self._enable()

    # reading

    def counts(self) -> int:
        """Read the position in counts."""
        return self._read("position")

    def is_homed(self) -> bool:
        """Return whether the position is known; a drive that cannot report it must have been referenced since it was connected."""
        return self._holds("homed") if "homed" in self._drive.conditions else self._referenced

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
        attempt = self._stops.begin(f"The move of {self.name}", allowed_s(duration_s, timeout_s))
        self._refuse_unrepresentable(goal)
        if not self.is_homed():
            raise MotionError(f"{self.name} is not referenced.", "Find its reference before it is moved.")
        self._guarded(attempt, lambda: self._move(goal, attempt))

    def home(self, timeout_s: float) -> None:
        """Find the reference, if the position is not known. Raises as `move`."""
        attempt = self._stops.begin(f"The search of {self.name} for its reference", timeout_s)
        if not self.is_homed():
            self._guarded(attempt, lambda: self._home(attempt))

    def stop(self) -> None:
        """Stop the drive now; the request goes before all others that wait for the line."""
        self._stops.stop()
        for left in reversed(range(STOP_TRIES)):
            try:
                self._run("stop", 0, Urgency(is_stop=True))
                return
            except DeviceTimeout:
                if not left:
                    raise

    def _guarded(self, attempt: Attempt, motion: Callable[[], None]) -> None:
        """Run a motion; whatever ends it early also stops the axis. What fails after a stop has the stop as its cause."""
        try:
            motion()
        except Cancelled:
            raise  # by `stop`, which writes it itself
        except BaseException:
            with suppress(MeasureError):
                self._run("stop", 0, Urgency(is_stop=True))
            with suppress(DeviceTimeout):
                attempt.check()
            raise

    def _move(self, goal: int, attempt: Attempt) -> None:
        self._command(goal, Urgency(attempt.check))
        settling = Settling(goal, self._settings.tolerance * self.counts_per_unit, self._settings.settled_s)
        while True:
            here, moving = self.counts(), self._moves()
            self._refuse_alarm(MotionError)
            verdict = settling.observe(time.monotonic(), here, moving)
            if verdict == "arrived":
                return
            if verdict == "elsewhere":
                raise MotionError(
                    f"{self.name} came to rest {settling.distance(here) / self.counts_per_unit:.3f} away from its goal.",
                    "Check for an obstacle, a limit switch, and the scale of the drive.",
                )
            attempt.wait(self._settings.poll_s)

    def _home(self, attempt: Attempt) -> None:
        self._run("home", 0, Urgency(attempt.check))
        began, seen_moving = time.monotonic(), False
        while True:
            attempt.wait(self._settings.settled_s)
            self._refuse_alarm(MotionError)
            if self._moves():
                seen_moving = True
            elif "homed" in self._drive.conditions:
                if self._holds("homed"):
                    return
            elif seen_moving or time.monotonic() - began > ELSEWHERE_S:
                self._referenced = True
                return

    def _enable(self) -> None:
        """Switch the servo on where it is off, and confirm it."""
        if self._holds("enabled", default=True):
            return
        self._run("enable", 0, Urgency())
        end = time.monotonic() + ENABLE_S
        while not self._holds("enabled"):
            if time.monotonic() > end:
                raise DeviceError(f"{self.name} does not switch its servo on.", "Check its emergency stop, its supply and its interlocks.")
            time.sleep(self._settings.poll_s)

    def _command(self, goal: int, urgency: Urgency) -> None:
        """Write goal and command; after a lost reply read whether the drive took it, and never write a second time blindly."""
        try:
            self._run("move", goal, urgency)
        except DeviceTimeout:
            urgency.check()  # its time-out is no lost reply
            self._confirm_identity()
            if self._read("goal") != goal or not (self._moves() or self._is_at(goal)):
                raise
        if self._read("goal") != goal:
            raise MotionError(
                f"{self.name} has another goal than was sent.", "Check the map of the drive, and that no other program commands it."
            )

    def _refuse_alarm(self, kind: type[DeviceError], then: str = "try again") -> None:
        if self._holds("alarm"):
            raise kind(f"{self.name} reports an alarm: {self._alarm_words()}.", f"Remove the cause and reset the drive, then {then}.")

    def _refuse_unrepresentable(self, goal: int) -> None:
        """Refuse a goal or speed that the registers of the drive cannot hold: what is cut off would be another goal."""
        for step in self._drive.sequences["move"]:
            value = self._value(step, goal)
            register = self._drive.registers[step.write]
            bits = 16 * register.words
            low, high = (-(1 << bits - 1), (1 << bits - 1) - 1) if register.signed else (0, (1 << bits) - 1)
            if not low <= value <= high and register.kind == "holding":
                raise LimitError(
                    f"{self.name}: {value} does not fit the register {step.write} ({low}…{high}).",
                    "Check speed, counts_per_unit, zero_counts and the map of the drive; nothing was moved.",
                )

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

    def _run(self, sequence: str, goal: int, urgency: Urgency) -> None:
        for step in self._drive.sequences.get(sequence, ()):  # type: ignore[call-overload]
            value = self._value(step, goal)
            if step.bits is not None:
                value = (value & step.bits) | (self._kept(step.write, urgency) & ~step.bits)
                self._written[step.write] = value
            self._write(step.write, value, urgency)

    def _value(self, step: Step, goal: int) -> int:
        if step.value == "goal":
            return goal
        if step.value == "speed":
            return max(1, round(self._settings.speed * (self._drive.speed_per_unit or self.counts_per_unit)))
        return int(step.value)

    def _kept(self, name: str, urgency: Urgency) -> int:
        """Return a register of which some bits are kept; for a stop as it was written last, which takes no time and cannot fail."""
        if urgency.is_stop and name in self._written:
            return self._written[name]
        return self._read(name)

    def _write(self, name: str, value: int, urgency: Urgency) -> None:
        register = self._drive.registers[name]
        words = [value >> 16 * place & 0xFFFF for place in reversed(range(register.words))]
        ordered = words[::-1] if self._drive.word_order == "low-first" else words
        self._line.write(self._target, register.kind, register.address, ordered, urgency)

    def _alarm_words(self) -> str:
        if "alarm_code" not in self._drive.registers:
            return "see the drive"
        code = self._read("alarm_code")
        return self._drive.alarms.get(str(code), f"code {code:#x}")
