"""One axis of a drive in counts: reads, conditions, sequences, and moves that are believed only when they are read back."""

from __future__ import annotations

from measureapp.devices.arrival import Arrival, within_s
from measureapp.devices.attempt import Attempt, Stops
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, MotionError

from .drive_map import DriveMap
from .line import ModbusLine, Target
from .settings import AxisSettings

IDENTITY_TRIES = 3  # after late replies


class ModbusAxis:
    """Moves one drive. `move` and `home` are for one thread, `stop` for any."""

    def __init__(self, name: str, unit: str, line: ModbusLine, drive: DriveMap, settings: AxisSettings) -> None:
        self.name = name
        self.counts_per_unit = settings.counts_per_unit or drive.counts_per_unit
        self._line, self._drive, self._settings = line, drive, settings
        self._target = Target(name, drive.unit_id if settings.unit_id is None else settings.unit_id)
        self._stops = Stops()
        self._arrival = Arrival(name, unit, settings.tolerance, settings.settled_s, settings.poll_s)
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
        attempt = self._stops.begin(f"{self.name}: the move", within_s(duration_s, timeout_s))
        self._command(goal)
        try:
            scale = self.counts_per_unit
            self._arrival.wait(goal / scale, lambda: self._counts_without_alarm() / scale, self._moves, attempt)
        except DeviceTimeout:
            self._run("stop", 0)
            raise

    def home(self, timeout_s: float) -> None:
        """Find the reference, if the drive does not know its position. Raises as `move`."""
        if self.is_homed():
            return
        attempt = self._stops.begin(f"{self.name}: finding the reference", timeout_s)
        self._run("home", 0)
        try:
            self._wait_homed(attempt)
        except DeviceTimeout:
            self._run("stop", 0)
            raise

    def stop(self) -> None:
        """Stop the drive now."""
        self._stops.stop()
        self._run("stop", 0)

    def _wait_homed(self, attempt: Attempt) -> None:
        while not self.is_homed() or self._moves():
            attempt.wait(self._settings.poll_s)
            self._counts_without_alarm()

    def _counts_without_alarm(self) -> int:
        """Read the position; raises MotionError when the drive reports an alarm."""
        here = self.counts()
        if self._holds("alarm"):
            raise MotionError(f"{self.name} reports an alarm: {self._alarm_words()}.", "Remove the cause, then reset the drive.")
        return here

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

    def _run(self, sequence: str, goal: int) -> None:
        for step in self._drive.sequences.get(sequence, ()):  # type: ignore[call-overload]
            speed = max(1, round(self._settings.speed * self.counts_per_unit))
            value = goal if step.value == "goal" else speed if step.value == "speed" else int(step.value)
            if step.bits is not None:
                value |= self._raw(step.write) & ~step.bits
            self._write(step.write, value)

    def _write(self, name: str, value: int) -> None:
        register = self._drive.registers[name]
        masked = value & ((1 << 16 * register.words) - 1)
        words = [masked >> 16 * place & 0xFFFF for place in reversed(range(register.words))]
        self._line.write(self._target, register.kind, register.address, words[::-1] if self._drive.word_order == "low-first" else words)

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
