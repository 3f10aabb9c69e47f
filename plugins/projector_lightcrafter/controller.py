"""What the DLPC350 can be told, each setting read back."""

from __future__ import annotations

import struct
from collections.abc import Callable
from dataclasses import dataclass

from measureapp.devices.attempt import Attempt
from measureapp.errors import DeviceError, DeviceTimeout

from . import registers
from .link import Link
from .registers import Command, Mailbox, sentences
from .sequence import PatternSequence

NO_PATTERNS_PER_TRIGGER_2 = 0  # stated minus one: trigger output 2 with every pattern
Check = Callable[[], None]


@dataclass(frozen=True, slots=True)
class ControllerStatus:
    """The three status bytes."""

    hardware: int
    system: int
    main: int

    @property
    def runs(self) -> bool:
        """Whether the sequencer runs."""
        return bool(self.main & registers.SEQUENCER_RUNS)

    @property
    def problem(self) -> str:
        """What is wrong, as part of a sentence; empty when nothing is."""
        found = [] if self.hardware & registers.INITIALISED else ["it has not initialised itself"]
        found += [] if self.system & registers.MEMORY_TEST_PASSED else ["its memory test failed"]
        found += ["the mirrors are parked"] if self.main & registers.PARKED else []
        faults = self.hardware & sum(registers.HARDWARE_FAULTS)
        return "; ".join([*found, *([sentences(faults, registers.HARDWARE_FAULTS)] if faults else [])])


@dataclass(frozen=True, slots=True)
class TriggerEdge:
    """Trigger output 1."""

    delay_us: float = 0.0
    inverted: bool = False

    def encode(self) -> bytes:
        """Return polarity and both edges; the falling edge stays where the exposure ends."""
        count = registers.EDGE_ZERO + round(self.delay_us * 1e3 / registers.EDGE_STEP_NS)
        return bytes([self.inverted, min(max(count, 0), registers.EDGE_LAST), registers.EDGE_ZERO])


class Controller:
    """Commands of the controller in the order in which they are valid."""

    def __init__(self, link: Link, poll_s: float) -> None:
        self._link, self._poll_s = link, poll_s
        self.name = link.name

    def version(self) -> str:
        """Read the version of the application software."""
        patch, minor, major = struct.unpack("<HBB", self._link.read(Command.VERSION)[:4].ljust(4, b"\0"))
        return f"{major}.{minor}.{patch}"

    def flash_images(self) -> int:
        """Read the number of images in flash."""
        return self._link.read(Command.FLASH_IMAGES)[0]

    def status(self) -> ControllerStatus:
        """Read the status bytes."""
        hardware, system, main = (
            self._link.read(command, 1)[0] for command in (Command.HARDWARE_STATUS, Command.SYSTEM_STATUS, Command.MAIN_STATUS)
        )
        return ControllerStatus(hardware, system, main)

    def is_playing(self) -> bool:
        """Read whether a sequence plays: the sequencer runs and was not stopped."""
        return self._link.read(Command.START_STOP, 1)[0] == registers.START and self.status().runs

    def wake(self, attempt: Attempt) -> None:
        """Leave standby, and wait until the mirrors are free."""
        if self._link.read(Command.STANDBY, 1)[0]:
            self._link.write(Command.STANDBY, b"\0")
        while self._link.read(Command.STANDBY, 1)[0] or self.status().main & registers.PARKED:
            attempt.wait(self._poll_s)

    def prepare(self, attempt: Attempt) -> None:
        """Switch the LEDs off, leave the video mode that projectors start in, and stop whatever plays."""
        self._set(Command.LED_ENABLE, bytes([registers.LEDS_OFF]), attempt.check)
        self._enter_pattern_mode(attempt)
        self._stop(attempt)

    def set_led_current(self, current: int) -> None:
        """Set the current of all LEDs, 1…255; the controller counts down from 255."""
        self._set(Command.LED_CURRENTS, bytes([255 - current] * 3), lambda: None)

    def load_time_s(self, image: int, attempt: Attempt) -> float:
        """Measure how long a flash image takes to be loaded; nothing may be playing."""
        self._link.write(Command.LOAD_TIME, bytes([image, 1]), attempt.check)
        while not (ticks := int.from_bytes(self._link.read(Command.LOAD_TIME)[:4], "little")):
            attempt.wait(self._poll_s)
        return ticks / registers.LOAD_TICKS_PER_MS * 1e-3

    def darken_at_once(self) -> None:
        """Stop the sequence and switch the LEDs off without waiting for any reply."""
        self._link.write_at_once(Command.START_STOP, bytes([registers.STOP]))
        self._link.write_at_once(Command.LED_ENABLE, bytes([registers.LEDS_OFF]))

    def darken(self) -> None:
        """Stop the sequence and switch the LEDs off; read back. Raises DeviceError."""
        self._link.write(Command.START_STOP, bytes([registers.STOP]))
        self._link.write(Command.LED_ENABLE, bytes([registers.LEDS_OFF]))
        self.check_dark()

    def check_dark(self) -> None:
        """Raise DeviceError unless the LEDs read back as off."""
        if self._link.read(Command.LED_ENABLE, 1)[0] != registers.LEDS_OFF:
            raise DeviceError(f"{self.name} did not switch its light off.", "Switch it off at its power supply.")

    def configure(self, sequence: PatternSequence, source: int, trigger_mode: int, edge: TriggerEdge, attempt: Attempt) -> None:
        """Stop, write everything a sequence needs in the order of the manual, read it back, and let the controller validate it.

        Raises
        ------
        DeviceError
            A setting reads back different, or the controller finds the sequence invalid.
        Cancelled, DeviceTimeout
            From the attempt.
        """
        check = attempt.check
        self._stop(attempt)
        self._enter_pattern_mode(attempt)
        self._set(Command.PATTERN_SOURCE, bytes([source]), check)
        self._set(Command.TRIGGER_MODE, bytes([trigger_mode]), check)
        self._set(Command.TIMES, struct.pack("<II", sequence.exposure_us, sequence.period_us), check)
        images = max(len(sequence.images), 1)
        counts = [len(sequence.entries) - 1, sequence.repeat, NO_PATTERNS_PER_TRIGGER_2, images - 1]
        self._set(Command.SEQUENCE, bytes(counts), check)
        self._fill(Mailbox.PATTERNS, sequence.pattern_table(), check)
        if sequence.images:
            self._fill(Mailbox.IMAGES, sequence.image_table(), check)
        self._set(Command.TRIGGER_OUT_1, edge.encode(), check)
        self._set(Command.TRIGGER_OUT_2, bytes([False, registers.EDGE_ZERO]), check)
        self._validate(attempt)

    def start(self, attempt: Attempt) -> None:
        """Give the LEDs to the sequencer and start the sequence."""
        self._set(Command.LED_ENABLE, bytes([registers.LEDS_BY_SEQUENCER]), attempt.check)
        self._link.write(Command.START_STOP, bytes([registers.START]), attempt.check)

    def _stop(self, attempt: Attempt) -> None:
        self._link.write(Command.START_STOP, bytes([registers.STOP]), attempt.check)
        while self._link.read(Command.START_STOP, 1)[0] != registers.STOP:
            attempt.wait(self._poll_s)

    def _enter_pattern_mode(self, attempt: Attempt) -> None:
        """Enter the mode of patterns, which takes the controller a moment."""
        mode = bytes([registers.PATTERN_MODE])
        if self._link.read(Command.DISPLAY_MODE, 1) == mode:
            return
        self._link.write(Command.DISPLAY_MODE, mode, attempt.check)
        while self._link.read(Command.DISPLAY_MODE, 1) != mode:
            attempt.wait(self._poll_s)

    def _set(self, command: Command, data: bytes, check: Check) -> None:
        self._link.write(command, data, check)
        self._compare(command.name, data, self._link.read(command, len(data)))

    def _fill(self, mailbox: Mailbox, table: bytes, check: Check) -> None:
        """Write a table through the mailbox and read it back; early firmware returns its beginning only."""
        self._link.write(Command.MAILBOX, bytes([mailbox]), check)
        self._link.write(Command.MAILBOX_ADDRESS, b"\0", check)
        self._link.write(Command.MAILBOX_DATA, table, check)
        self._link.write(Command.MAILBOX_ADDRESS, b"\0", check)
        found = self._link.read(Command.MAILBOX_DATA)[: len(table)]
        self._link.write(Command.MAILBOX, bytes([Mailbox.CLOSED]), check)
        if not found:
            raise DeviceError(f"{self.name} returned an empty table of {mailbox.name.lower()}.", "Update its firmware.")
        self._compare(f"table of {mailbox.name}", table[: len(found)], found)

    def _compare(self, what: str, written: bytes, found: bytes) -> None:
        if written != found:
            raise DeviceError(
                f"{self.name} did not take over the setting {what.lower().replace('_', ' ')}: {written.hex(' ')} was written, "
                f"{found.hex(' ')} was read back.",
                "Close other programs that use the projector, and check the limits in its manual.",
            )

    def _validate(self, attempt: Attempt) -> None:
        self._link.write(Command.VALIDATE, b"\0", attempt.check)
        while (found := self._link.read(Command.VALIDATE, 1)[0]) & registers.BUSY:
            try:
                attempt.wait(self._poll_s)
            except DeviceTimeout as error:
                raise DeviceTimeout(f"{self.name} did not finish checking the sequence.", error.hint) from error
        if found:
            raise DeviceError(
                f"{self.name} does not accept the sequence: {sentences(found, registers.VALIDATION)}.",
                "Check exposure, period and trigger settings against its manual.",
            )
