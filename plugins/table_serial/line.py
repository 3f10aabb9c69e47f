"""One serial line: one transaction after the other, writes that a stop can always interrupt, and no reply believed after a late one."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError

from measureapp.data.model import first_problem
from measureapp.devices.serial_ports import find_port
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, InputError

from .command_table import CommandTable
from .settings import LineSettings

LOST_AFTER = 2  # transactions without a reply
QUIET_S = 0.2  # without a byte, after which a late reply is not expected any more
LONGEST_REPLY = 256  # bytes
EXCERPT_BYTES = 24
LOOK_S = 0.01  # set once: changing the time-out of an open port configures it anew, while a stop may be sent
CHECK_LINE = "Check power, cable, address and baud rate."


@dataclass(frozen=True, slots=True)
class LineFormat:
    """How lines end, and whether the controller repeats commands."""

    terminator: bytes
    reply_end: bytes
    echo: bool
    pause_s: float  # after a command that has no answer


class SerialLine:
    """A serial line that several controllers may share. All methods may be called from any thread.

    A transaction waits for its turn; `shout` does not, so that a stop is sent while another thread waits for a reply.
    """

    def __init__(self, port: Any, place: str, form: LineFormat, reply_timeout_s: float) -> None:
        self._port, self._place, self._form, self._reply_timeout_s = port, place, form, reply_timeout_s
        self._turn, self._writing = threading.Lock(), threading.Lock()
        self._silent = 0  # transactions in a row without a reply
        self._lost = ""  # why
        self._proven = False  # whether a controller ever identified itself
        self.doubtful = True  # a reply that belongs to no question may arrive: nothing is believed before `trust`

    def ask(self, who: str, text: str) -> str:
        """Send a question and return its answer. Raises DeviceTimeout, DeviceLost, DeviceError."""
        return self._transact(who, text, lambda: None, answered=True)

    def command(self, who: str, text: str, check: Callable[[], None], *, answered: bool) -> str:
        """Send a command, never twice; ``check`` is called before, while nothing else can be sent, and may raise. Returns the answer, if any."""
        return self._transact(who, text, check, answered=answered)

    def shout(self, who: str, text: str) -> None:
        """Send a command at once, without waiting for a reply to another thread's question. Raises DeviceLost."""
        self._send(who, text, lambda: None)

    def drain(self, who: str) -> None:
        """Discard what arrives late, until the line is silent."""
        with self._turn:
            self._refuse_if_lost(who)
            quiet_since = time.monotonic()
            while time.monotonic() - quiet_since < QUIET_S:
                if self._take(who):
                    quiet_since = time.monotonic()

    def trust(self) -> None:
        """Believe replies again, after one was proven to be the controller's own."""
        self.doubtful, self._proven = False, True

    def close(self) -> None:
        """Close the line; harmless when repeated."""
        self._lost = self._lost or "the line was closed"
        with self._turn, self._writing:
            self._port.close()

    def excerpt(self, received: bytes) -> str:
        """Return the beginning of what was received, for messages."""
        if not received:
            return "received nothing"
        return f"received {received[:EXCERPT_BYTES].hex(' ')}{' …' if len(received) > EXCERPT_BYTES else ''}"

    def _transact(self, who: str, text: str, check: Callable[[], None], *, answered: bool) -> str:
        form = self._form
        with self._turn:
            self._refuse_if_lost(who)
            self._take(who, wait=False)
            self._send(who, text, check)
            received = b""
            if form.echo:
                sent = text.encode("ascii") + form.terminator
                received = self._receive(who, b"", lambda heard: len(heard) >= len(sent))
                if not received.startswith(sent):
                    self.doubtful = True
                    raise DeviceError(f"{who} at {self._place} did not repeat {text!r} ({self.excerpt(received)}).", CHECK_LINE)
                received = received[len(sent) :]
            if not answered:
                time.sleep(form.pause_s)
                return ""
            return self._decode(who, self._receive(who, received, lambda heard: form.reply_end in heard))

    def _decode(self, who: str, received: bytes) -> str:
        line, end, rest = received.partition(self._form.reply_end)
        if end and not rest.strip() and line.isascii() and line.decode("ascii").isprintable():
            return line.decode("ascii")
        self.doubtful = True
        raise DeviceError(f"{who} at {self._place} sent no valid reply ({self.excerpt(received)}).", CHECK_LINE)

    def _receive(self, who: str, received: bytes, complete: Callable[[bytes], bool]) -> bytes:
        end = time.monotonic() + self._reply_timeout_s
        while not complete(received) and len(received) <= LONGEST_REPLY:
            if time.monotonic() > end:
                raise self._miss(who, received)
            received += self._take(who)
        self._silent = 0
        return received

    def _miss(self, who: str, received: bytes) -> DeviceError:
        self._silent += 1
        self.doubtful = True
        if self._silent >= LOST_AFTER:
            return self._lose(who, f"no reply ({self.excerpt(received)})")
        return DeviceTimeout(f"{who} at {self._place} did not reply ({self.excerpt(received)}).", CHECK_LINE)

    def _take(self, who: str, *, wait: bool = True) -> bytes:
        """Return what has arrived; if nothing has, wait for it no longer than `LOOK_S`."""
        try:
            waiting = self._port.in_waiting
            return bytes(self._port.read(waiting or 1)) if waiting or wait else b""
        except (OSError, TypeError) as error:  # pyserial's errors are OSErrors; TypeError: its port was closed meanwhile
            raise self._lose(who, str(error)) from error

    def _send(self, who: str, text: str, check: Callable[[], None]) -> None:
        with self._writing:
            check()
            try:
                self._port.write(text.encode("ascii") + self._form.terminator)
            except (OSError, TypeError) as error:
                raise self._lose(who, str(error)) from error

    def _refuse_if_lost(self, who: str) -> None:
        if self._lost:
            raise self._lose(who, self._lost)

    def _lose(self, who: str, reason: str) -> DeviceLost:
        self._lost = self._lost or reason
        return DeviceLost(
            f"{who} at {self._place} does not answer{' any more' if self._proven else ''}: {self._lost}.",
            f"{CHECK_LINE} Connect again, and find the reference anew if the controller lost it.",
        )


def open_line(table: Mapping[str, object], commands: CommandTable) -> SerialLine:
    """Open the line that a table ``[links.NAME]`` describes, in the format of the first controller on it.

    Raises
    ------
    InputError
        A setting is invalid.
    DeviceError
        No such adapter, or its port cannot be opened.
    """
    try:
        chosen = LineSettings.model_validate(dict(table))
    except ValidationError as error:
        raise InputError(f"[links]: {first_problem(error, 'the line')}.", "Correct it in the rig description.") from error
    from serial import Serial, SerialException  # type: ignore[import-untyped]

    place = chosen.port or find_port(chosen.usb_serial)
    try:
        port = Serial(place, chosen.baudrate or commands.baudrate, timeout=LOOK_S, write_timeout=chosen.reply_timeout_s, exclusive=True)
    except (SerialException, OSError, ValueError) as error:
        raise DeviceError(f"{place} cannot be opened: {error}.", "Check the port, and that no other program uses it.") from error
    form = LineFormat(commands.terminator.encode("ascii"), commands.reply_end.encode("ascii"), commands.echo, commands.pause_s)
    return SerialLine(port, place, form, chosen.reply_timeout_s)
