"""A Modbus device on 127.0.0.1 or on a pair of pseudo-terminals: framing, function codes and faults of the line."""

from __future__ import annotations

import os
import select
import socket
import struct
import threading
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, replace
from typing import Literal, Protocol

from measureapp.peers.pseudo_terminal import serial_line

Kind = Literal["coil", "discrete", "holding", "input"]
Framing = Literal["rtu", "ascii"]
READS: dict[int, Kind] = {1: "coil", 2: "discrete", 3: "holding", 4: "input"}
WRITES: dict[int, Kind] = {5: "coil", 6: "holding", 15: "coil", 16: "holding"}
LOOK_S = 0.02


class Refused(Exception):
    """The device answers with this exception code."""

    def __init__(self, code: int) -> None:
        super().__init__(code)
        self.code = code


class Memory(Protocol):
    """What the device's registers do."""

    def read(self, kind: Kind, address: int) -> int:
        """Return a register or bit. Raises Refused."""

    def write(self, kind: Kind, address: int, value: int) -> None:
        """Write a register or bit. Raises Refused."""


@dataclass(frozen=True, slots=True)
class LineFaults:
    """What goes wrong on the line; may be replaced at any time."""

    silent: bool = False  # nothing is answered, and nothing is done
    late_s: float = 0.0  # requests are carried out at once and answered this much later
    late_once: bool = False  # only the next answer is late
    shifted: bool = False  # every answer is that to the request before
    refuse: int = 0  # exception code for every request
    refuse_times: int = -1  # how often; -1: always
    sliced: bool = False  # answers arrive byte by byte
    garbage: bytes = b""  # sent in place of answers
    longer: int = 0  # bytes appended to answers
    broken: bool = False  # one bit of every answer is flipped


class ModbusDevice:
    """Answers requests for one station. All methods may be called from any thread."""

    def __init__(self, memory: Memory, unit_id: int = 1) -> None:
        self.faults = LineFaults()
        self.requests = 0
        self._memory, self._unit_id = memory, unit_id
        self._before = b""
        self._ends = threading.Event()

    def answer(self, unit_id: int, pdu: bytes) -> bytes | None:
        """Carry a request out and return the answer, or None for another station."""
        if unit_id != self._unit_id or self.faults.silent:
            return None
        self.requests += 1
        try:
            self._refuse_by_order()
            return self._carry_out(pdu)
        except Refused as refused:
            return bytes([pdu[0] | 0x80, refused.code])

    def _refuse_by_order(self) -> None:
        faults = self.faults
        if faults.refuse and faults.refuse_times:
            self.faults = replace(faults, refuse_times=faults.refuse_times - 1 if faults.refuse_times > 0 else -1)
            raise Refused(faults.refuse)

    def _carry_out(self, pdu: bytes) -> bytes:
        code, address, value = struct.unpack(">BHH", pdu[:5])
        if code in READS:
            values = [self._memory.read(READS[code], address + place) for place in range(value)]
            if code in (1, 2):
                packed = sum(bool(bit) << place for place, bit in enumerate(values)).to_bytes((value + 7) // 8, "little")
                return bytes([code, len(packed)]) + packed
            return bytes([code, 2 * value]) + struct.pack(f">{value}H", *values)
        if code in (5, 6):
            self._memory.write(WRITES[code], address, int(value == 0xFF00) if code == 5 else value)
            return pdu[:5]
        if code == 16:
            for place, word in enumerate(struct.unpack(f">{value}H", pdu[6 : 6 + 2 * value])):
                self._memory.write("holding", address + place, word)
            return pdu[:5]
        raise Refused(1)

    # lines

    def serve_serial(self, handle: int, framing: Framing) -> None:
        """Answer on a terminal until `end`."""
        heard = b""
        while not self._ends.is_set():
            if not select.select([handle], [], [], LOOK_S)[0]:
                continue
            try:
                heard += os.read(handle, 4096)
            except OSError:
                return
            requests, heard = _serial_requests(heard, framing)
            for frame in requests:
                reply = self.answer(frame[0], frame[1:])
                if reply is not None:
                    self._send(lambda data: os.write(handle, data), _framed(frame[0], reply, framing))

    def serve_tcp(self, listening: socket.socket) -> None:
        """Answer one client after the other until `end`."""
        listening.settimeout(LOOK_S)
        while not self._ends.is_set():
            try:
                client, _ = listening.accept()
            except TimeoutError:
                continue
            with client:
                client.settimeout(LOOK_S)
                self._serve_client(client)

    def _serve_client(self, client: socket.socket) -> None:
        heard = b""
        while not self._ends.is_set():
            try:
                new = client.recv(4096)
            except TimeoutError:
                continue
            except OSError:
                return
            if not new:
                return
            heard += new
            while len(heard) >= 8 and len(heard) >= (size := 6 + struct.unpack(">H", heard[4:6])[0]):
                packet, heard = heard[:size], heard[size:]
                reply = self.answer(packet[6], packet[7:])
                if reply is not None:
                    self._send(client.sendall, packet[:4] + struct.pack(">HB", len(reply) + 1, packet[6]) + reply)

    def _send(self, write: Callable[[bytes], object], reply: bytes) -> None:
        faults = self.faults
        if faults.shifted:
            reply, self._before = self._before or reply, reply
        reply = faults.garbage or reply + bytes(faults.longer)
        if faults.broken:
            reply = reply[:4] + bytes([reply[4] ^ 1]) + reply[5:]
        if faults.late_s:
            if faults.late_once:
                self.faults = replace(faults, late_s=0.0, late_once=False)
            self._ends.wait(faults.late_s)
        try:
            for piece in [reply[place : place + 1] for place in range(len(reply))] if faults.sliced else [reply]:
                write(piece)
                if faults.sliced:
                    self._ends.wait(0.001)
        except OSError:
            return

    def end(self) -> None:
        """Let the serving threads return."""
        self._ends.set()


@contextmanager
def on_serial(device: ModbusDevice, framing: Framing) -> Iterator[str]:
    """Serve on a pair of pseudo-terminals; yields the port for the client."""
    with serial_line() as (handle, port):
        thread = threading.Thread(target=device.serve_serial, args=(handle, framing), name="Modbus device, serial")
        thread.start()
        try:
            yield port
        finally:
            device.end()
            thread.join()


@contextmanager
def on_tcp(device: ModbusDevice) -> Iterator[int]:
    """Serve on a free port of 127.0.0.1; yields the port."""
    with socket.create_server(("127.0.0.1", 0)) as listening:
        thread = threading.Thread(target=device.serve_tcp, args=(listening,), name="Modbus device, TCP")
        thread.start()
        try:
            yield listening.getsockname()[1]
        finally:
            device.end()
            thread.join()


def crc16(data: bytes) -> bytes:
    """Return the check sum of an RTU frame, low byte first."""
    register = 0xFFFF
    for byte in data:
        register ^= byte
        for _ in range(8):
            register = register >> 1 ^ (0xA001 if register & 1 else 0)
    return struct.pack("<H", register)


def _serial_requests(heard: bytes, framing: Framing) -> tuple[list[bytes], bytes]:
    """Return the complete frames (station, then request), and what follows them."""
    found: list[bytes] = []
    while True:
        frame, heard = _next_rtu(heard) if framing == "rtu" else _next_ascii(heard)
        if frame is None:
            return found, heard
        found.append(frame)


def _next_rtu(heard: bytes) -> tuple[bytes | None, bytes]:
    """Return the first frame with a right check sum, without it; bytes that begin none are skipped."""
    for start in range(len(heard) - 7):
        frame = heard[start:]
        size = 9 + frame[6] if frame[1] in (15, 16) and len(frame) > 6 else 8
        if len(frame) >= size and crc16(frame[: size - 2]) == frame[size - 2 : size]:
            return frame[: size - 2], frame[size:]
    return None, heard


def _next_ascii(heard: bytes) -> tuple[bytes | None, bytes]:
    start, end = heard.find(b":"), heard.find(b"\r\n")
    if start < 0 or end < start:
        return None, heard
    try:
        frame = bytes.fromhex(heard[start + 1 : end].decode("ascii"))
    except ValueError:
        return _next_ascii(heard[end + 2 :])
    return (frame[:-1], heard[end + 2 :]) if sum(frame) % 256 == 0 else _next_ascii(heard[end + 2 :])


def _framed(unit_id: int, pdu: bytes, framing: Framing) -> bytes:
    frame = bytes([unit_id]) + pdu
    if framing == "rtu":
        return frame + crc16(frame)
    return b":" + (frame + bytes([-sum(frame) % 256])).hex().upper().encode() + b"\r\n"
