"""Pose stream by Externally Guided Motion: `EgmRobot` messages (protobuf) on UDP, only ever received."""

from __future__ import annotations

import logging
import socket
import struct
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import DeviceError, DeviceLost

STALE_S = 0.5
LONGEST_MESSAGE = 4096
EXCERPT = 32
DATA = 2  # of mtype
VARINT, FIXED64, BYTES, FIXED32 = 0, 1, 2, 5
Field = tuple[int, int | bytes]
_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True, eq=False)
class StreamedPose:
    """What one message tells."""

    counter: int
    joints_deg: FloatArray  # (6,)
    position_mm: FloatArray  # (3,)
    quaternion_wxyz: FloatArray  # (4,)


def read_message(message: bytes) -> StreamedPose:
    """Read one `EgmRobot` message.

    Raises
    ------
    DeviceError
        It is no such message, or has no joints; with the bytes it begins with.
    """
    try:
        return _read(message)
    except (ValueError, IndexError, struct.error) as error:
        raise DeviceError(
            f"A message of the pose stream is invalid ({error}): {message[:EXCERPT].hex(' ') or 'nothing'}.",
            "Check that the robot alone sends to this port.",
        ) from error


def _read(message: bytes) -> StreamedPose:
    robot = dict(_fields(message))
    header, feedback = dict(_fields(_bytes(robot.get(1)))), dict(_fields(_bytes(robot.get(2))))
    if header.get(3, DATA) != DATA:
        raise ValueError(f"type {header.get(3)!r}")
    joints = _doubles(_bytes(feedback.get(1)))
    pose = dict(_fields(_bytes(feedback.get(2))))
    position, rotation = _doubles(_bytes(pose.get(1))), _doubles(_bytes(pose.get(2)))
    if joints.shape != (6,) or position.shape != (3,) or rotation.shape != (4,):
        raise ValueError(f"{joints.size} joints, {position.size} coordinates, {rotation.size} parts of a quaternion")
    if not np.isfinite(np.concatenate([joints, position, rotation])).all():
        raise ValueError("a number is not finite")
    counter = header.get(1)
    if not isinstance(counter, int):
        raise ValueError("no counter")
    return StreamedPose(counter, joints, position, rotation)


def _fields(message: bytes) -> Iterator[Field]:
    """Yield number and content of every field of a protobuf message, in their order."""
    position = 0
    while position < len(message):
        key, position = _varint(message, position)
        kind = key & 7
        if kind == VARINT:
            value, position = _varint(message, position)
            yield key >> 3, value
            continue
        if kind == BYTES:
            length, position = _varint(message, position)
        elif kind in (FIXED64, FIXED32):
            length = 8 if kind == FIXED64 else 4
        else:
            raise ValueError(f"wire type {kind}")
        if position + length > len(message):
            raise ValueError("cut off")
        yield key >> 3, message[position : position + length]
        position += length


def _varint(message: bytes, position: int) -> tuple[int, int]:
    value = 0
    for shift in range(0, 70, 7):
        byte = message[position]
        position += 1
        value |= (byte & 0x7F) << shift
        if byte < 0x80:
            return value, position
    raise ValueError("a number of more than 64 bits")


def _bytes(value: int | bytes | None) -> bytes:
    if not isinstance(value, bytes):
        raise ValueError("a part is missing")
    return value


def _doubles(message: bytes) -> FloatArray:
    """Read all doubles of a message: single ones of successive fields, or packed ones of a repeated field."""
    parts = [_bytes(value) for _, value in _fields(message)]
    return np.frombuffer(b"".join(parts), "<f8").copy()


class PoseStream:
    """Receives poses from the robot in a thread of its own.

    Parameters
    ----------
    port : UDP port; 0: a free one
    host : interface
    """

    def __init__(self, port: int, host: str = "0.0.0.0", now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.settimeout(0.1)
        try:
            self._socket.bind((host, port))
        except OSError as error:
            self._socket.close()
            raise DeviceError(
                f"UDP port {port} for the pose stream cannot be opened: {error.strerror}.", "Choose a free port in settings and controller."
            ) from error
        self.port = int(self._socket.getsockname()[1])
        self._lock = threading.Lock()
        self._latest: StreamedPose | None = None
        self._changed_at = -np.inf
        self._ends = threading.Event()
        self._thread = threading.Thread(target=self._receive, name="pose stream of the robot", daemon=True)
        self._thread.start()

    def latest(self) -> StreamedPose:
        """Return the newest pose.

        Raises
        ------
        DeviceLost
            The counter has not advanced for 500 ms.
        """
        with self._lock:
            pose, age = self._latest, self._now() - self._changed_at
        if pose is None or age > STALE_S:
            told = "has not begun" if pose is None else f"is stale: message {pose.counter} is {age:.1f} s old"
            raise DeviceLost(
                f"The robot's pose stream on UDP port {self.port} {told}.",
                "Check that EGMStreamStart runs in the controller and that its UDP unicast device names this computer and port.",
            )
        return pose

    def close(self) -> None:
        """Stop receiving. Harmless when repeated."""
        self._ends.set()
        self._thread.join()
        self._socket.close()

    def _receive(self) -> None:
        while not self._ends.is_set():
            try:
                message = self._socket.recv(LONGEST_MESSAGE)
            except TimeoutError:
                continue
            except OSError as error:
                _log.warning("pose stream: %s", error)
                continue
            try:
                pose = read_message(message)
            except DeviceError as error:
                _log.warning("%s", error)
                continue
            with self._lock:
                if self._latest is None or pose.counter != self._latest.counter:
                    self._changed_at = self._now()
                self._latest = pose
