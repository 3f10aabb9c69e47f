"""The virtual GigE Vision camera, spoken to in bytes from the standard; `tests/plugins/camera_genicam` speaks to it by Aravis."""

from __future__ import annotations

import socket
import struct
import time
from collections.abc import Iterator
from xml.etree import ElementTree

import numpy as np
import pytest
from genicam_camera import SERIAL, port

from measureapp.peers.gige_camera import GigeCamera, gige_camera, noise

CAMERA = ("127.0.0.1", 3956)
CONTROL, HEARTBEAT = 0x0A00, 0x0938
SIDE_PX = 128  # few packets: they fit into the buffer of any socket


@pytest.fixture
def camera() -> Iterator[GigeCamera]:
    with port(), gige_camera(SERIAL, SIDE_PX, SIDE_PX) as running:
        yield running


class Client:
    """A client of GVCP: one command, one answer."""

    def __init__(self) -> None:
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("127.0.0.1", 0))
        self.socket.settimeout(1.0)
        self._number = 0

    def __enter__(self) -> Client:
        return self

    def __exit__(self, *_: object) -> None:
        self.socket.close()

    def ask(self, code: int, body: bytes = b"") -> tuple[int, bytes]:
        self._number += 1
        self.socket.sendto(struct.pack(">BBHHH", 0x42, 0x01, code, len(body), self._number) + body, CAMERA)
        reply = self.socket.recv(2048)
        status, answered, length, number = struct.unpack(">HHHH", reply[:8])
        assert (answered, length, number) == (code + 1, len(reply) - 8, self._number)
        return status, reply[8:]

    def write(self, address: int, value: int) -> int:
        return self.ask(0x82, struct.pack(">II", address, value))[0]

    def read(self, address: int) -> int:
        return int.from_bytes(self.ask(0x80, struct.pack(">I", address))[1], "big")

    def memory(self, address: int, size: int) -> bytes:
        found = b""
        while len(found) < size:
            part = min(512, size - len(found))
            found += self.ask(0x84, struct.pack(">IHH", address + len(found), 0, part))[1][4:]
        return found

    def addresses(self) -> dict[str, int]:
        """Read the description of the camera, and the addresses of its registers from it."""
        _, address, size = self.memory(0x200, 512).split(b"\0")[0].decode().split(";")
        root = ElementTree.fromstring(self.memory(int(address, 16), int(size, 16)).rstrip(b"\0"))
        found = {node.get("Name", ""): node.findtext("{*}Address") for node in root}
        return {name.removesuffix("Reg"): int(text) for name, text in found.items() if text is not None}


def test_it_is_found_with_its_serial_number(camera: GigeCamera) -> None:
    with Client() as client:
        status, body = client.ask(0x02)
    assert (status, len(body)) == (0, 248)
    assert body[0xD8:0xE8].rstrip(b"\0").decode() == SERIAL
    assert body[0x24:0x28] == socket.inet_aton("127.0.0.1")


def test_one_client_controls_it_until_it_lets_go_or_falls_silent(camera: GigeCamera) -> None:
    with Client() as first, Client() as second:
        assert first.write(CONTROL, 2) == 0
        assert second.write(CONTROL, 2) == 0x8006
        assert second.read(CONTROL) == 2, "reading is free"
        assert first.write(CONTROL, 0) == 0
        assert second.write(CONTROL, 2) == 0
        assert second.write(HEARTBEAT, 100) == 0
        time.sleep(0.2)
        assert first.write(CONTROL, 2) == 0


def test_an_image_arrives_in_packets_between_leader_and_trailer_and_each_can_be_had_again(camera: GigeCamera) -> None:
    with Client() as client, Client() as stream:
        where = client.addresses()
        client.write(CONTROL, 2)
        client.write(0xD18, int.from_bytes(socket.inet_aton("127.0.0.1"), "big"))
        client.write(0xD00, stream.socket.getsockname()[1])
        client.write(where["TriggerSource"], 1)
        client.write(where["AcquisitionStart"], 1)
        client.write(where["TriggerSoftware"], 1)
        count = -(-(SIDE_PX**2) // (1500 - 36))
        packets = [stream.socket.recv(2048) for _ in range(count + 2)]
        heads = [struct.unpack(">HHI", packet[:8]) for packet in packets]
        assert heads == [(0, 1, 1 << 24), *((0, 1, 3 << 24 | number) for number in range(1, count + 1)), (0, 1, 2 << 24 | count + 1)]
        assert struct.unpack(">III", packets[0][20:32]) == (0x01080001, SIDE_PX, SIDE_PX)
        grey = np.frombuffer(b"".join(packet[8:] for packet in packets[1:-1]), np.uint8).reshape(SIDE_PX, SIDE_PX)
        np.testing.assert_array_equal(grey, noise(SIDE_PX, SIDE_PX)(0, 0.0))
        client.socket.sendto(struct.pack(">BBHHHHHII", 0x42, 0, 0x40, 12, 99, 0, 1, 7, 8), CAMERA)
        assert [stream.socket.recv(2048) for _ in range(2)] == packets[7:9]
