"""One TCP connection of the line protocol: numbered requests, replies with the same number, and what counts as lost."""

from __future__ import annotations

import json
import logging
import math
import socket
import threading
import time
from typing import Any

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, LimitError, MotionError

LONGEST_LINE = 4096
EXCERPT = 32
Message = dict[str, Any]
_log = logging.getLogger(__name__)


class Unanswered(DeviceTimeout):
    """A request got no reply: whether it was carried out is unknown until the state is read back."""


class LineLink:
    """A connection that is opened again after every failure; calls may come from any thread, one at a time is sent.

    Parameters
    ----------
    reply_timeout_s : longest wait for one reply
    loss_s : a robot that does not answer for so long is lost
    """

    def __init__(self, host: str, port: int, reply_timeout_s: float, loss_s: float) -> None:
        self.place = f"{host}:{port}"
        self._address = host, port
        self._reply_timeout_s, self._loss_s = reply_timeout_s, loss_s
        self._lock = threading.Lock()
        self._socket: socket.socket | None = None
        self._received = b""
        self._number = 0
        self._is_closed = False

    def read(self, do: str, **values: object) -> Message:
        """Request something that changes nothing; it is repeated until the robot counts as lost.

        Raises
        ------
        DeviceLost
            The robot does not answer.
        DeviceError
            It refuses, or its reply makes no sense.
        """
        end = time.monotonic() + self._loss_s
        while True:
            try:
                return self.send(do, **values)
            except Unanswered as error:
                _log.warning("%s", error.message)
                if time.monotonic() >= end - 0.05:
                    raise DeviceLost(
                        f"The robot at {self.place} does not answer any more.",
                        "Check that it is on, its network cable is plugged in and its server runs, then connect again. Its state is unknown.",
                    ) from error
                time.sleep(0.05)

    def send(self, do: str, **values: object) -> Message:
        """Send a request once and return its reply.

        Raises
        ------
        Unanswered
            No reply in time.
        LimitError, MotionError, DeviceError
            The robot refuses.
        """
        with self._lock:
            if self._is_closed:
                raise DeviceLost(f"The connection to the robot at {self.place} was closed.", "Connect again.")
            self._number += 1
            try:
                reply = self._exchange({"id": self._number, "do": do, **values})
            except OSError as error:
                self._close()
                raise Unanswered(f"The robot at {self.place} did not answer to {do!r}: {error or type(error).__name__}.") from error
            except DeviceError:
                self._close()  # nothing that follows on this line can be trusted
                raise
        if reply["ok"] is not True:
            raise self._refusal(do, reply)
        return reply

    def close(self) -> None:
        """Close the connection for good. Harmless when repeated."""
        with self._lock:
            self._is_closed = True
            self._close()

    def nonsense(self, line: bytes, reason: str) -> DeviceError:
        """Return the error for a reply that makes no sense, with the bytes it begins with."""
        return DeviceError(
            f"A reply of the robot at {self.place} is invalid ({reason}): {line[:EXCERPT].hex(' ') or 'nothing'}.",
            "Check address and port, and the robot's program against the README of the driver robot_generic_tcp.",
        )

    def _exchange(self, request: Message) -> Message:
        end = time.monotonic() + self._reply_timeout_s
        if self._socket is None:
            self._socket = socket.create_connection(self._address, self._reply_timeout_s)
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self._received = b""
        self._socket.settimeout(self._reply_timeout_s)
        self._socket.sendall(json.dumps(request, allow_nan=False).encode() + b"\n")
        while True:
            line = self._line(end)
            reply = self._parsed(line)
            if reply["id"] == request["id"]:
                return reply
            if reply["id"] > request["id"]:
                raise self.nonsense(line, f"reply {reply['id']} to request {request['id']}")
            _log.warning("%s: a late reply was discarded: %s", self.place, line[:80])

    def _line(self, end: float) -> bytes:
        assert self._socket is not None
        while b"\n" not in self._received:
            left = end - time.monotonic()
            if left <= 0:
                raise TimeoutError("timed out")
            self._socket.settimeout(left)
            part = self._socket.recv(LONGEST_LINE)
            if not part:
                raise ConnectionResetError("the connection was closed")
            self._received += part
            if len(self._received) > LONGEST_LINE:
                raise self.nonsense(self._received, f"a line of more than {LONGEST_LINE} bytes")
        line, _, self._received = self._received.partition(b"\n")
        return line

    def _parsed(self, line: bytes) -> Message:
        try:
            reply = json.loads(line)
        except (ValueError, RecursionError):
            raise self.nonsense(line, "no JSON") from None
        if not isinstance(reply, dict) or type(reply.get("id")) is not int or type(reply.get("ok")) is not bool:
            raise self.nonsense(line, "no object with id and ok")
        return reply

    def _refusal(self, do: str, reply: Message) -> DeviceError:
        kinds: dict[str, tuple[type[DeviceError], str]] = {
            "limit": (LimitError, "Choose a goal inside the robot's limits; nothing was moved."),
            "state": (MotionError, "Remove the cause at the robot, then connect again."),
        }
        kind, hint = kinds.get(str(reply.get("error")), (DeviceError, "Check the robot's program against the driver's README."))
        return kind(f"The robot at {self.place} refused {do!r}: {reply.get('text') or reply.get('error') or 'no reason given'}.", hint)

    def _close(self) -> None:
        if self._socket is not None:
            self._socket.close()
            self._socket = None


def numbers(link: LineLink, reply: Message, name: str, count: int) -> list[float]:
    """Return ``count`` finite numbers of a reply; raises DeviceError."""
    values = reply.get(name)
    sound = (
        isinstance(values, list) and len(values) == count and all(type(value) in (int, float) and math.isfinite(value) for value in values)
    )
    if not sound or not isinstance(values, list):
        raise link.nonsense(json.dumps(reply).encode(), f"{name} is not {count} numbers")
    return [float(value) for value in values]


def whole(link: LineLink, reply: Message, name: str) -> int:
    """Return a whole number of a reply; raises DeviceError."""
    value = reply.get(name)
    if type(value) is not int:
        raise link.nonsense(json.dumps(reply).encode(), f"{name} is no whole number")
    return value
