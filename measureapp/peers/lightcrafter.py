"""Virtual LightCrafter 4500: answers the HID reports of a DLPC350 in process, as a device of the package hidapi would."""

from __future__ import annotations

import struct
import threading
import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field

REPORT = 64
NACK = 0x20
RUNS, PARKED = 0x02, 0x01
TICKS_PER_S = 18_667_000
SHORTEST_US = (235, 700, 1570, 1700, 2000, 2500, 4500, 8333)
TIMES, SEQUENCE, VALIDATE, ACTION, LED_ENABLE = 0x1A29, 0x1A31, 0x1A1A, 0x1A24, 0x1A07
BOX, BOX_ADDRESS, BOX_DATA, LOAD_TIMING = 0x1A33, 0x1A32, 0x1A34, 0x1A3A
PLAIN_SETTINGS = {
    0x0200: b"\x00", 0x0B01: b"\x97\x78\x7d", LED_ENABLE: b"\x08", 0x1A1B: b"\x00", 0x1A1D: b"\x00\xbb\xbb", 0x1A1E: b"\x00\xbb",
    0x1A22: b"\x00", 0x1A23: b"\x00", ACTION: b"\x00", TIMES: bytes(8), SEQUENCE: bytes(4), BOX: b"\x00", BOX_ADDRESS: b"\x00",
}  # fmt: skip


@dataclass
class LightCrafterFaults:
    """What goes wrong; each may be changed while the peer is in use. Sets name commands, CMD2 in the high byte."""

    refuses: set[int] = field(default_factory=set)  # answers with the error bit
    ignores: set[int] = field(default_factory=set)  # acknowledges a setting and keeps the old one
    drops: set[int] = field(default_factory=set)  # never answers
    late: set[int] = field(default_factory=set)  # answers before the answer to the next command
    other_sequence: set[int] = field(default_factory=set)  # answers with another sequence number
    longer: set[int] = field(default_factory=set)  # states and sends one byte too many
    absurd_length: set[int] = field(default_factory=set)  # states a length of 65535 bytes
    truncated: set[int] = field(default_factory=set)  # sends three bytes
    validation: int = 0  # further bits of the validation
    hardware: int = 0  # further bits of the hardware status
    memory_test_fails: bool = False
    repeats_always: bool = False  # takes the number for one run as the one for repetition
    never_starts: bool = False
    unplugged: bool = False


@dataclass(frozen=True, slots=True)
class Light:
    """What the mirrors show while the LEDs are on."""

    image: int | None  # flash image; None: the white field, or video
    pattern: int
    bits: int
    leds: int


class VirtualLightCrafter:
    """State of the controller, and the two calls of a HID device. Methods may be called from any thread.

    Parameters
    ----------
    images : number of images in flash
    load_s : how long an image takes to be loaded from flash
    now : clock in seconds
    """

    def __init__(self, images: int = 8, load_s: float = 0.2, now: Callable[[], float] = time.monotonic) -> None:
        self.faults = LightCrafterFaults()
        self.commands: list[tuple[int, bytes]] = []  # every command received that was no question, in order
        self.patterns = self.images = b""  # the tables
        self.closed = False
        self._images_in_flash, self._load_s, self._now = images, load_s, now
        self._settings = dict(PLAIN_SETTINGS)
        self._lock = threading.Condition()
        self._replies: deque[bytes] = deque()
        self._held_back: list[bytes] = []
        self._partial, self._missing = b"", 0
        self._busy_polls = self._load_ticks = 0
        self._began: float | None = None
        self._pulses = self._earlier_pulses = 0

    def write(self, report: bytes, /) -> int:
        """Take one report, id first, as `hid.device.write`."""
        with self._lock:
            if self.faults.unplugged or self.closed:
                return -1
            report = bytes(report)
            if len(report) != 1 + REPORT or report[0] != 0:
                return -1
            self._take(report[1:])
            self._lock.notify_all()
            return len(report)

    def read(self, length: int, timeout_ms: int = 0, /) -> list[int]:
        """Deliver the next report, or nothing after the time, as `hid.device.read`."""
        with self._lock:
            self._lock.wait_for(lambda: self._replies or self.faults.unplugged or self.closed, timeout_ms * 1e-3)
            if self.faults.unplugged or self.closed:
                raise OSError("read error")
            return list(self._replies.popleft()[:length]) if self._replies else []

    def close(self) -> None:
        """Release the device."""
        with self._lock:
            self.closed = True
            self._lock.notify_all()

    def unplug(self) -> None:
        """Pull the cable; a waiting read ends at once. The light goes out with the power."""
        with self._lock:
            self.faults.unplugged = True
            self._halt()
            self._lock.notify_all()

    def standby(self) -> None:
        """Fall asleep."""
        self._settings[0x0200] = b"\x01"

    def lit(self) -> Light | None:
        """Return what leaves the lens now; None: no light."""
        with self._lock:
            place = self._place()
            if place is None or self._settings[LED_ENABLE] != b"\x08":
                return None
            entry, within_us = place
            number, leds_bits, switches = self.patterns[3 * entry : 3 * entry + 3]
            exposure_us, _ = self._times()
            if within_us >= exposure_us and switches & 0x02:
                return None
            swaps = sum(bool(self.patterns[3 * one + 2] & 0x04) for one in range(entry + 1))
            video, white = self._settings[0x1A22] == b"\x00", number >> 2 == 24
            image = None if video or white else self._order()[max(swaps - 1, 0)]
            return Light(image, number >> 2, leds_bits & 0x0F, leds_bits >> 4)

    def pulses(self) -> int:
        """Return the number of pulses of trigger output 1 since the last start."""
        with self._lock:
            self._settle()
            if self._began is None:
                return self._pulses
            return self._pulses_by_now()

    def all_pulses(self) -> int:
        """Return the number of pulses of trigger output 1 since the peer was made, as a camera counts them."""
        with self._lock:
            return self._earlier_pulses + self.pulses()

    def _order(self) -> list[int]:
        """Flash images in the order of buffer swaps: two images are both loaded, and the second entry is shown first."""
        used = self.images[: self._settings[SEQUENCE][3] + 1]
        return list(used[::-1] if len(used) == 2 else used)

    def _take(self, report: bytes) -> None:
        if self._missing:
            self._partial += report[: self._missing]
            self._missing -= min(self._missing, REPORT)
        else:
            length = int.from_bytes(report[2:4], "little")
            self._partial = report[: 4 + length]
            self._missing = max(0, 4 + length - REPORT)
        if not self._missing:
            self._carry_out(self._partial)

    def _carry_out(self, whole: bytes) -> None:
        flags, sequence = whole[0], whole[1]
        command, data = whole[4] | whole[5] << 8, whole[6:]
        answer: bytes | None = b""
        if flags & 0x80:
            answer = self._answer(command)
        else:
            self.commands.append((command, data))
            if command not in self.faults.refuses:
                answer = b"" if self._obey(command, data) else None
        if flags & 0x40:
            refused = answer is None or command in self.faults.refuses
            self._reply(command, sequence, flags & 0x80 | (NACK if refused else 0), answer or b"")

    def _reply(self, command: int, sequence: int, flags: int, data: bytes) -> None:
        faults = self.faults
        if command in faults.drops:
            return
        data += b"\x00" if command in faults.longer else b""
        length = 0xFFFF if command in faults.absurd_length else len(data)
        sequence = (sequence + 7) % 256 if command in faults.other_sequence else sequence
        whole = bytes([flags, sequence]) + struct.pack("<H", length) + data
        whole = whole[:3] if command in faults.truncated else whole.ljust(-(-len(whole) // REPORT) * REPORT, b"\0")
        reports = [whole[start : start + REPORT] for start in range(0, len(whole), REPORT)]
        if command in faults.late:
            self._held_back += reports
        else:
            self._replies.extend([*self._held_back, *reports])
            self._held_back = []

    def _answer(self, command: int) -> bytes | None:
        self._settle()
        if command == VALIDATE:
            self._busy_polls -= 1
            return bytes([0x80 if self._busy_polls > 0 else self._validity()])
        if command == BOX_DATA:
            return {1: self.images, 2: self.patterns}.get(self._settings[BOX][0])
        runs = RUNS if self._began is not None else 0
        told = {
            0x0205: struct.pack("<HBB", 0, 2, 4) + bytes(12),
            0x1A0A: bytes([0x01 | self.faults.hardware]),
            0x1A0B: bytes([0x00 if self.faults.memory_test_fails else 0x01]),
            0x1A0C: bytes([runs | (PARKED if self._settings[0x0200] == b"\x01" else 0)]),
            0x1A42: bytes([self._images_in_flash]),
            LOAD_TIMING: struct.pack("<I", self._load_ticks),
        }
        return told.get(command, self._settings.get(command))

    def _obey(self, command: int, data: bytes) -> bool:
        if command in self.faults.ignores:
            return True
        if command == VALIDATE:
            self._busy_polls = 2
        elif command == LOAD_TIMING:
            self._load_ticks = max(1, round(self._load_s * TICKS_PER_S)) if data[0] < self._images_in_flash else 0
        elif command == BOX_DATA:
            return self._fill(data)
        elif command == ACTION:
            return self._act(data)
        elif command in self._settings and len(data) == len(self._settings[command]):
            self._settings[command] = data
        else:
            return False
        return True

    def _fill(self, data: bytes) -> bool:
        box, address = self._settings[BOX][0], self._settings[BOX_ADDRESS][0]
        if box == 1:
            self.images = _over(self.images, data, address)
        elif box == 2:
            self.patterns = _over(self.patterns, data, 3 * address)
        return box in (1, 2)

    def _act(self, data: bytes) -> bool:
        if data == b"\x02":
            if self._settings[0x1A1B] != b"\x01":
                return False
            if not self.faults.never_starts:
                self._halt()
                self._earlier_pulses += self._pulses
                self._began, self._pulses = self._now() + self._load_s, 0
                self._settings[ACTION] = data
        else:
            self._halt()
        return True

    def _halt(self) -> None:
        self._settle()
        if self._began is not None:
            self._pulses = self._pulses_by_now()
        self._began = None
        self._settings[ACTION] = b"\x00"

    def _settle(self) -> None:
        """End a sequence whose time is over."""
        if self._began is None or self._repeats():
            return
        _, period_us = self._times()
        if self._now() >= self._began + self._count() * period_us * 1e-6:
            self._began, self._pulses = None, self._count()
            self._settings[ACTION] = b"\x00"

    def _pulses_by_now(self) -> int:
        elapsed_s = self._now() - (self._began or 0.0)
        return 0 if elapsed_s < 0 else 1 + int(elapsed_s / (self._times()[1] * 1e-6))

    def _place(self) -> tuple[int, float] | None:
        """Return the entry of the table that plays now, and the time since it began in µs."""
        self._settle()
        if self._began is None or self._now() < self._began:
            return None
        _, period_us = self._times()
        elapsed_us = (self._now() - self._began) * 1e6
        return int(elapsed_us / period_us) % self._count(), elapsed_us % period_us

    def _times(self) -> tuple[int, int]:
        exposure_us, period_us = struct.unpack("<II", self._settings[TIMES])
        return exposure_us, period_us

    def _count(self) -> int:
        return self._settings[SEQUENCE][0] + 1

    def _repeats(self) -> bool:
        return bool(self._settings[SEQUENCE][1]) or self.faults.repeats_always

    def _validity(self) -> int:
        exposure_us, period_us = self._times()
        entries = [self.patterns[3 * one : 3 * one + 3] for one in range(self._count())]
        if any(len(entry) < 3 or not 1 <= entry[1] & 0x0F <= 8 for entry in entries):
            return 0x02 | self.faults.validation
        shortest = max(SHORTEST_US[(entry[1] & 0x0F) - 1] for entry in entries)
        numbers_wrong = any(entry[0] >> 2 > 24 or (entry[0] >> 2 != 24 and (entry[0] >> 2) * (entry[1] & 0x0F) >= 24) for entry in entries)
        gap_small = exposure_us != period_us and period_us - exposure_us < 230
        return (exposure_us < shortest or exposure_us > period_us) | numbers_wrong << 1 | gap_small << 4 | self.faults.validation


def _over(table: bytes, data: bytes, start: int) -> bytes:
    """Return the table with ``data`` written over it from ``start`` on."""
    return table[:start].ljust(start, b"\0") + data + table[start + len(data) :]
