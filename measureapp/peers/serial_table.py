"""A rotary table on a pair of pseudo-terminals that answers as a Newport ESP301 or SMC100 does."""

from __future__ import annotations

import os
import re
import select
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Literal

from measureapp.peers.modbus_axis import Drive
from measureapp.peers.pseudo_terminal import serial_line

Dialect = Literal["esp301", "smc100"]
LOOK_S = 0.02
PER_DEGREE = 1_000_000.0  # steps of the drive behind it


@dataclass(frozen=True, slots=True)
class TableFaults:
    """What goes wrong; may be replaced at any time."""

    silent: bool = False
    late_s: float = 0.0  # replies arrive this much later
    late_once: bool = False  # only the next one
    sliced: bool = False  # replies arrive byte by byte
    garbage: bytes = b""  # sent in place of replies
    error: str = ""  # reply to the question for errors
    early_rest: bool = False  # "at rest" is told while it still moves
    referenced: bool = True


class SerialTablePeer:
    """Carries commands out for a `Drive`, whose counts are millionths of a degree. All methods may be called from any thread."""

    def __init__(self, drive: Drive, dialect: Dialect) -> None:
        self.faults = TableFaults()
        self.heard: list[str] = []
        self._drive, self._dialect = drive, dialect
        self._ends = threading.Event()

    def answer(self, line: str) -> str | None:
        """Carry a command out; return the reply, or None for a command that has none."""
        self.heard.append(line)
        matched = re.fullmatch(r"(1?)([A-Z]{2})(\??)([-+.\deE]*)", line)
        if matched is None:
            return None
        _, name, _, number = matched.groups()
        if name == "PA":
            self._drive.start(round(float(number) * PER_DEGREE))
        elif name == "ST":
            self._drive.stop()
        elif name == "OR":
            self._find_reference()
        elif name == "TP":
            return self._named("1TP", f"{self._drive.told_counts() / PER_DEGREE:.5f}")
        elif name in ("MD", "TS"):
            return self._state()
        elif name == "TE":
            return self.faults.error or ("0" if self._dialect == "esp301" else "1TE@")
        return None

    def _find_reference(self) -> None:
        self.faults = TableFaults()
        self._drive.start(0)

    def _state(self) -> str:
        moving = self._drive.told_moving() and not self.faults.early_rest
        if self._dialect == "esp301":
            return "0" if moving else "1"
        if not self.faults.referenced:
            return "1TS00000A"
        return "1TS000028" if moving else "1TS000033"

    def _named(self, name: str, value: str) -> str:
        return value if self._dialect == "esp301" else f"{name}{value}"

    def serve(self, handle: int) -> None:
        """Answer on a terminal until `end`."""
        heard = b""
        while not self._ends.is_set():
            if not select.select([handle], [], [], LOOK_S)[0]:
                continue
            try:
                heard += os.read(handle, 4096)
            except OSError:
                return
            *lines, heard = re.split(rb"\r\n?", heard)
            for line in lines:
                reply = None if self.faults.silent else self.answer(line.decode("ascii", "replace"))
                if reply is not None:
                    self._send(handle, reply.encode("ascii") + b"\r\n")

    def _send(self, handle: int, reply: bytes) -> None:
        faults = self.faults
        if faults.late_s:
            if faults.late_once:
                self.faults = TableFaults()
            self._ends.wait(faults.late_s)
        data = faults.garbage or reply
        for piece in [data[place : place + 1] for place in range(len(data))] if faults.sliced else [data]:
            os.write(handle, piece)
            time.sleep(0.0005 if faults.sliced else 0.0)

    def end(self) -> None:
        """Let the serving thread return."""
        self._ends.set()


@contextmanager
def serial_table(drive: Drive, dialect: Dialect = "esp301") -> Iterator[tuple[SerialTablePeer, str]]:
    """Serve on a pair of pseudo-terminals; yields the peer and the port for the client."""
    peer = SerialTablePeer(drive, dialect)
    with serial_line() as (handle, port):
        thread = threading.Thread(target=peer.serve, args=(handle,), name="serial table")
        thread.start()
        try:
            yield peer, port
        finally:
            peer.end()
            thread.join()
