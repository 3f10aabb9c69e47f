"""Drives on Modbus as a client sees them: registers of a TOYO controller and of a simple axis, moved in time.

The registers are stated here again, not taken from the driver's maps: a mistake that both shared would prove nothing.
"""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass

from measureapp.peers.modbus_device import Kind, Refused
from measureapp.peers.moving_axes import MovingAxes, Now


@dataclass(frozen=True, slots=True)
class DriveFaults:
    """What goes wrong in the drive; may be replaced at any time."""

    frozen: bool = False  # the position register never changes
    early_in_position: bool = False  # "in position" and "not moving" are told while it still moves
    off_counts: int = 0  # it comes to rest beside its goal by this much
    alarm: int = 0  # code
    homed: bool = True


class Drive:
    """A drive with one axis, in counts. All methods may be called from any thread."""

    def __init__(
        self,
        counts: int = 0,
        speed: float = 10_000.0,
        acceleration: float = 50_000.0,
        now: Now = time.monotonic,
    ) -> None:
        self.faults = DriveFaults()
        self.on_rest: Callable[[float], None] = lambda _: None  # called with the position in counts whenever it comes to rest
        self.moves: list[int] = []  # goals of all moves that were started
        self.stops = 0
        self._lock = threading.RLock()
        self._axes = MovingAxes((counts,), (speed,), (acceleration,), now, lambda at: self.on_rest(float(at[0])))
        self._words: dict[int, int] = {}
        self._frozen_at = counts

    def counts(self) -> int:
        """Return the true position."""
        return round(float(self._axes.positions()[0]))

    def told_counts(self) -> int:
        """Return what the position register reads."""
        if self.faults.frozen:
            return self._frozen_at
        self._frozen_at = self.counts()
        return self._frozen_at

    def told_moving(self) -> bool:
        """Return whether the drive says that it moves."""
        return self._axes.is_moving and not self.faults.early_in_position

    def start(self, goal: int) -> None:
        """Start a move."""
        with self._lock:
            self.moves.append(goal)
            self._axes.move((goal + self.faults.off_counts,))

    def stop(self) -> None:
        """Stop where it is."""
        with self._lock:
            self.stops += 1
            self._axes.stop()

    def find_reference(self) -> None:
        """Find the reference position."""
        self.faults = DriveFaults()
        self.start(0)

    def word(self, address: int) -> int:
        """Return what was written to a register."""
        return self._words.get(address, 0)

    def keep(self, address: int, value: int) -> None:
        """Keep what is written to a register."""
        self._words[address] = value

    def long(self, address: int) -> int:
        """Return a signed number of two registers, high word first."""
        value = self.word(address) << 16 | self.word(address + 1)
        return value - (1 << 32) if value >> 31 else value


def high_and_low(value: int) -> tuple[int, int]:
    """Return the two words of a signed number."""
    return value >> 16 & 0xFFFF, value & 0xFFFF


class ToyoMemory:
    """Registers of a TOYO XC100."""

    def __init__(self, drive: Drive) -> None:
        self._drive = drive

    def read(self, kind: Kind, address: int) -> int:
        """Return a register."""
        drive = self._drive
        if kind != "holding":
            raise Refused(1)
        high, low = high_and_low(drive.told_counts())
        moving = drive.told_moving()
        known = {
            0x1000: 2 if drive.faults.alarm else int(moving),
            0x1001: int(not moving),
            0x1002: int(drive.faults.homed),
            0x1005: int(bool(drive.faults.alarm)),
            0x100A: high,
            0x100B: low,
            0x100D: drive.faults.alarm,
        }
        if address in known:
            return known[address]
        if address in (0x0802, 0x0803, 0x0804, 0x0805, 0x2002, 0x2003, 0x2011, 0x201E):
            return drive.word(address)
        raise Refused(2)

    def write(self, kind: Kind, address: int, value: int) -> None:
        """Write a register; 0x201E starts what its value says."""
        if kind != "holding" or address not in (0x0802, 0x0803, 0x0804, 0x0805, 0x2002, 0x2003, 0x2011, 0x201E):
            raise Refused(2)
        self._drive.keep(address, value)
        if address == 0x201E:
            if value == 1:
                self._drive.start(self._drive.long(0x2002))
            elif value in (8, 9):
                self._drive.stop()
            elif value == 3:
                self._drive.find_reference()
            elif value != 6:
                raise Refused(3)


class SimpleMemory:
    """Registers of the simple axis that the driver's README describes."""

    def __init__(self, drive: Drive) -> None:
        self._drive = drive
        self._enabled = False

    def read(self, kind: Kind, address: int) -> int:
        """Return a register."""
        drive = self._drive
        if kind == "holding" and address == 0:
            return 0x4D41
        if kind == "holding" and 0x20 <= address <= 0x24:
            return drive.word(address)
        if kind != "input":
            raise Refused(2)
        high, low = high_and_low(drive.told_counts())
        moving = drive.told_moving()
        state = int(moving) | (not moving) << 1 | drive.faults.homed << 2 | self._enabled << 3
        known = {0x10: high, 0x11: low, 0x12: state, 0x13: drive.faults.alarm}
        if address not in known:
            raise Refused(2)
        return known[address]

    def write(self, kind: Kind, address: int, value: int) -> None:
        """Write a register; 0x24 starts what its value says."""
        if kind != "holding" or not 0x20 <= address <= 0x24:
            raise Refused(2)
        self._drive.keep(address, value)
        if address == 0x24:
            actions = {1: self._enable, 2: lambda: self._drive.start(self._drive.long(0x20)), 3: self._drive.stop}
            actions |= {4: self._drive.find_reference, 5: lambda: None}
            if value not in actions:
                raise Refused(3)
            actions[value]()

    def _enable(self) -> None:
        self._enabled = True
