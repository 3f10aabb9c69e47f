"""Bytes of GigE Vision 1.2: control (GVCP) and stream (GVSP), and the registers that every camera has."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from dataclasses import dataclass

PORT = 3956
COMMAND_KEY, ACK_WANTED = 0x42, 0x01
DISCOVERY, RESEND, READ_REGISTER, WRITE_REGISTER, READ_MEMORY, WRITE_MEMORY = 0x02, 0x40, 0x80, 0x82, 0x84, 0x86
OK, INVALID_ADDRESS, ACCESS_DENIED = 0x0000, 0x8003, 0x8006
DISCOVERY_BYTES = 0xF8
# addresses of bootstrap registers
DEVICE_MODE, IP_ADDRESS, SERIAL, XML_URL = 0x04, 0x24, 0xD8, 0x200
NAMES = {0x48: "MeasureApp", 0x68: "Virtual", 0x88: "1.0", 0xA8: "virtual GigE Vision camera"}
CHANNELS, CAPABILITY, HEARTBEAT_MS, TICKS_LOW = 0x904, 0x934, 0x938, 0x940
CONTROL, OWNER_PORT, OWNER = 0xA00, 0xA04, 0xA14
STREAM_PORT, PACKET_SIZE, STREAM_ADDRESS = 0xD00, 0xD04, 0xD18
CAN_RESEND, CAN_WRITE_MEMORY = 1 << 2, 1 << 1
PACKET_OVERHEAD = 36  # IP, UDP and GVSP headers, which the packet size counts
LEADER, TRAILER, PAYLOAD = 1, 2, 3
IMAGE, WITH_CHUNKS = 0x0001, 0x4000


@dataclass(frozen=True, slots=True)
class Command:
    """One command of a client."""

    code: int
    body: bytes
    number: int


def parse(packet: bytes) -> Command | None:
    """Return the command in a packet; None: it holds none."""
    if len(packet) < 8 or packet[0] != COMMAND_KEY:
        return None
    code, length, number = struct.unpack(">HHH", packet[2:8])
    return Command(code, packet[8 : 8 + length], number)


def answer(command: Command, status: int, body: bytes = b"") -> bytes:
    """Return the packet that answers a command."""
    return struct.pack(">HHHH", status, command.code + 1, len(body), command.number) + body


@dataclass(frozen=True, slots=True)
class Image:
    """One image as it is sent."""

    block: int  # 1…65535
    time_ns: int
    pixel_format: int
    width_px: int
    height_px: int
    data: bytes  # with chunks
    has_chunks: bool

    def packets(self, size_bytes: int) -> Iterator[bytes]:
        """Yield all packets in order: leader, data, trailer."""
        kind = IMAGE | (WITH_CHUNKS if self.has_chunks else 0)
        layout = (self.pixel_format, self.width_px, self.height_px, 0, 0, 0, 0)
        yield self._packet(LEADER, 0, struct.pack(">HHQIIIIIHH", 0, kind, self.time_ns, *layout))
        step = size_bytes - PACKET_OVERHEAD
        parts = [self.data[start : start + step] for start in range(0, len(self.data), step)]
        for index, part in enumerate(parts, 1):
            yield self._packet(PAYLOAD, index, part)
        yield self._packet(TRAILER, len(parts) + 1, struct.pack(">HHI", 0, kind, self.height_px))

    def _packet(self, kind: int, number: int, body: bytes) -> bytes:
        return struct.pack(">HHI", 0, self.block, kind << 24 | number) + body


def chunk(identifier: int, data: bytes) -> bytes:
    """Return data with the tag that follows it where images carry chunks."""
    return data + struct.pack(">II", identifier, len(data))
