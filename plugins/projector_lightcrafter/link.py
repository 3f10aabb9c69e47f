"""One transaction after the other with the controller, and commands that wait for nobody."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from typing import Protocol

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout

from .registers import Command
from .wire import REPORT_BYTES, Header, check_length, excerpt, message, missing_bytes, parse_header, payload

HINT_LOST = "Check its power and its USB cable, then connect again."
EARLIER_REPLIES = 8  # replies of requests that timed out, skipped before the line counts as confused


class HidDevice(Protocol):
    """What the link uses of a device of the package hidapi."""

    def write(self, report: Sequence[int], /) -> int:
        """Send one report, its id first; returns the number of bytes, negative on failure."""

    def read(self, length: int, timeout_ms: int, /) -> Sequence[int]:
        """Wait for a report without its id; empty when none arrived in time. Raises OSError."""

    def close(self) -> None:
        """Release the device."""


class Link:
    """Questions and commands to one controller. All methods may be called from any thread.

    A transaction holds one lock from its first report to its reply. `write_at_once` takes only the lock on sending, which is held
    while reports leave: it never waits for a reply to another thread.
    """

    def __init__(self, device: HidDevice, name: str, reply_timeout_s: float) -> None:
        self.name = name
        self._device = device
        self._timeout_s = reply_timeout_s
        self._transaction, self._sending = threading.Lock(), threading.Lock()
        self._sequence = 0
        self._abandoned: set[int] = set()  # numbers of requests whose reply did not come in time
        self._lost = ""

    def read(self, command: Command, length: int | None = None, data: bytes = b"") -> bytes:
        """Ask, and return the data of the reply.

        Parameters
        ----------
        length : expected number of bytes; None: any

        Raises
        ------
        DeviceTimeout, DeviceLost
            No reply, or no projector.
        DeviceError
            The controller refused, or the reply is malformed.
        """
        reply = self._transact(command, data, read=True)
        return reply if length is None else check_length(reply, length, self.name, _words(command))

    def write(self, command: Command, data: bytes, allowed: Callable[[], None] = lambda: None) -> None:
        """Command, and wait for the acknowledgement; raises as `read`.

        Parameters
        ----------
        allowed : called when nothing else can be sent any more before the command; raises to prevent it
        """
        self._transact(command, data, read=False, allowed=allowed)

    def write_at_once(self, command: Command, data: bytes) -> None:
        """Command without waiting for any reply. Raises DeviceLost."""
        with self._sending:
            self._send(message(command, data, sequence=self._next_number(), reply=False))

    def close(self) -> None:
        """Release the device, after the transaction under way. Harmless when repeated."""
        with self._transaction, self._sending:
            if self._lost != "closed":
                self._lost = "closed"
                self._device.close()

    def _transact(self, command: Command, data: bytes, *, read: bool, allowed: Callable[[], None] = lambda: None) -> bytes:
        with self._transaction:
            with self._sending:
                allowed()
                number = self._next_number()
                self._send(message(command, data, sequence=number, read=read))
            header, reports = self._first_report(number, command)
            while missing_bytes(header, reports):
                reports += self._receive(command, number)
            if header.refused:
                raise DeviceError(
                    f"{self.name} refused {_words(command)} ({data.hex(' ') or 'no data'}; reply {excerpt(reports)}).",
                    "Stop other programs that use the projector; if it stays so, switch it off and on again.",
                )
            return payload(header, reports)

    def _first_report(self, number: int, command: Command) -> tuple[Header, bytes]:
        for _ in range(EARLIER_REPLIES):
            report = self._receive(command, number)
            header = parse_header(report, self.name)
            if header.sequence == number:
                self._abandoned.discard(number)
                return header, report
            if header.sequence not in self._abandoned:
                raise DeviceError(
                    f"{self.name}: a reply to {_words(command)} has the sequence number {header.sequence} instead of {number} "
                    f"({excerpt(report)}).",
                    "Close other programs that use the projector.",
                )
            for _rest in range(-(-missing_bytes(header, report) // REPORT_BYTES)):
                self._receive(command, number)  # further reports of the late reply
            self._abandoned.discard(header.sequence)
        raise DeviceTimeout(f"{self.name} answers earlier requests only, not {_words(command)}.", HINT_LOST)

    def _next_number(self) -> int:
        self._sequence = self._sequence % 255 + 1
        return self._sequence

    def _send(self, reports: Sequence[bytes]) -> None:
        self._check_open()
        for report in reports:
            try:
                written = self._device.write(bytes([0]) + report)
            except (OSError, ValueError) as error:
                raise self._gone(str(error)) from error
            if written < 0:
                raise self._gone("a report could not be sent")

    def _receive(self, command: Command, number: int) -> bytes:
        self._check_open()
        end = time.monotonic() + self._timeout_s
        try:
            report = bytes(self._device.read(REPORT_BYTES, max(1, round(self._timeout_s * 1e3))))
        except (OSError, ValueError) as error:
            raise self._gone(str(error)) from error
        if not report:
            self._abandoned.add(number)
            waited = self._timeout_s + max(0.0, time.monotonic() - end)
            raise DeviceTimeout(f"{self.name} did not answer {_words(command)} within {waited:.2f} s.", HINT_LOST)
        return report

    def _check_open(self) -> None:
        if self._lost == "closed":
            raise DeviceLost(f"{self.name} was released.", "Connect the rig again.")
        if self._lost:
            raise DeviceLost(f"{self.name} does not answer any more: {self._lost}.", HINT_LOST)

    def _gone(self, reason: str) -> DeviceLost:
        if not self._lost:
            self._lost = reason.rstrip(".") or "its USB connection broke"
        return DeviceLost(f"{self.name} does not answer any more: {self._lost}.", HINT_LOST)


def _words(command: Command) -> str:
    return f"the command {command.name.lower().replace('_', ' ')} ({command >> 8:02X}:{command & 0xFF:02X})"
