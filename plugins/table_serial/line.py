"""One serial line: a question and its reply at a time."""

from __future__ import annotations

import threading
import time
from typing import Any

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout

LOST_AFTER = 2  # questions without a reply
LONGEST = 256  # bytes of a reply
EXCERPT_BYTES = 24


class SerialLine:
    """All methods may be called from any thread."""

    def __init__(self, table: str, port: str, baudrate: int, ends: tuple[bytes, bytes], timeout_s: float) -> None:
        import serial  # type: ignore[import-untyped]

        self._table, self._port_name, self._timeout_s = table, port, timeout_s
        self._sent_end, self._reply_end = ends
        self._lock = threading.Lock()
        self._silent = 0
        try:
            self._port: Any = serial.Serial(port, baudrate, timeout=0.01, write_timeout=timeout_s)
        except (OSError, ValueError) as error:
            raise DeviceError(
                f"{table}: the port {port} cannot be opened: {error}.", "Check its name and its cable, and that no other program uses it."
            ) from error

    def ask(self, question: str) -> str:
        """Send a question and return its reply without its end. Raises DeviceTimeout, DeviceLost, DeviceError."""
        with self._lock:
            self._discard_late_replies()
            self._write(question)
            return self._reply(question)

    def tell(self, command: str) -> None:
        """Send a command that is not answered. Raises DeviceLost."""
        with self._lock:
            self._write(command)

    def close(self) -> None:
        """Close the port."""
        self._port.close()

    def _discard_late_replies(self) -> None:
        """After a question without a reply, its late reply must not be taken for the next one."""
        if self._silent:
            time.sleep(self._timeout_s)
        self._guard(self._port.reset_input_buffer)

    def _write(self, text: str) -> None:
        self._guard(lambda: self._port.write(text.encode("ascii") + self._sent_end))

    def _reply(self, question: str) -> str:
        heard, end = b"", time.monotonic() + self._timeout_s
        while not heard.endswith(self._reply_end):
            heard += self._guard(lambda: self._port.read(max(1, self._port.in_waiting)))
            if len(heard) > LONGEST:
                raise self._refused(question, heard)
            if time.monotonic() > end:
                raise self._no_reply(question, heard)
        self._silent = 0
        try:
            return heard[: -len(self._reply_end)].decode("ascii")
        except UnicodeDecodeError:
            raise self._refused(question, heard) from None

    def _guard(self, call: Any) -> Any:
        try:
            return call()
        except OSError as error:  # also serial.SerialException
            raise DeviceLost(
                f"{self._table} at {self._port_name} does not answer any more: {error}.",
                "Check power and cable, connect again, and find the reference anew if the controller lost it.",
            ) from error

    def _no_reply(self, question: str, heard: bytes) -> DeviceError:
        self._silent += 1
        words = f"{self._table} at {self._port_name} did not reply to {question!r} ({_excerpt(heard)})."
        hint = "Check power, cable, baud rate and the command table."
        return DeviceLost(words, hint) if self._silent >= LOST_AFTER else DeviceTimeout(words, hint)

    def _refused(self, question: str, heard: bytes) -> DeviceError:
        return DeviceError(
            f"{self._table} replied to {question!r} with what is no reply ({_excerpt(heard)}).", "Check baud rate and command table."
        )


def _excerpt(heard: bytes) -> str:
    shown = heard[:EXCERPT_BYTES].hex(" ")
    return f"received {shown}{' …' if len(heard) > EXCERPT_BYTES else ''}" if heard else "received nothing"
