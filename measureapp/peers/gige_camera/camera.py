"""A GigE Vision camera in this process, with faults to order."""

from __future__ import annotations

import select
import socket
import struct
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.peers.gige_camera import protocol
from measureapp.peers.gige_camera.features import CHUNK_EXPOSURE_ID, PIXEL_FORMATS, addresses, decoded, described, encoded, features
from measureapp.peers.gige_camera.packing import PACKING

HOST = "127.0.0.1"
HEARD = ("127.0.0.1", "127.255.255.255", "255.255.255.255")  # its own address, and those on which it is searched for
XML_ADDRESS, MEMORY_BYTES = 0x100000, 0x10000
KEPT_IMAGES = 8
LOOK_S = 0.02
Address = tuple[str, int]
Render = Callable[[int, float], ImageArray]  # (number of the exposure from 0, exposure in µs) → grey levels (height, width)


@dataclass(frozen=True, slots=True)
class Faults:
    """What goes wrong; may be replaced at any time."""

    lost_share: float = 0.0  # of the packets of images
    lost_again_share: float = 0.0  # of those sent again
    silent: bool = False  # answers nothing
    resends: bool = True  # sends lost packets again
    ignores: frozenset[str] = frozenset()  # features whose new values are acknowledged and forgotten
    wrong_exposure_us: float = 0.0  # by which the real exposure differs from the one set


class GigeCamera:
    """The camera; `gige_camera` runs it. All methods may be called from any thread."""

    def __init__(self, serial: str, width_px: int, height_px: int, render: Render, seed: int = 0) -> None:
        self.faults = Faults()
        self.exposures = 0
        self._features = features(width_px, height_px)
        self._where = addresses(self._features)
        self._xml = described(self._features)
        self._memory = bytearray(MEMORY_BYTES)
        self._render, self._random = render, np.random.default_rng(seed)
        self._controller: Address | None = None
        self._heard_s = 0.0
        self._acquires = self._busy = self._loses_image = False
        self._block = 0
        self._kept: deque[tuple[int, list[bytes]]] = deque(maxlen=KEPT_IMAGES)
        self._triggers: deque[None] = deque()
        self._lock, self._ends = threading.RLock(), threading.Event()
        self._stream = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._sockets = [_listening(host) for host in HEARD]
        bodies = {"commands": self._answer_commands, "images": self._take_images}
        self._threads = [threading.Thread(target=body, name=f"GigE camera, {what}") for what, body in bodies.items()]
        self._fill(serial)

    def pulse(self) -> None:
        """Give a rising edge on Line1; it starts an exposure where the camera waits for one, else it is ignored as by real cameras."""
        with self._lock:
            if self._value("TriggerSource") == self._entry("TriggerSource", "Line1"):
                self._trigger()

    def expose_unasked(self) -> None:
        """Take one image without a trigger."""
        self._triggers.append(None)

    def send_last_again(self) -> None:
        """Send the last image again, with its old identifier."""
        self._send(self._kept[-1][1], 0.0)

    def lose_image(self) -> None:
        """Let the next image get lost as a whole."""
        self._loses_image = True

    def seize(self, owner: str) -> None:
        """Let a program on another host take control."""
        with self._lock:
            self._controller, self._heard_s = (owner, 1), float("inf")
            self._write(protocol.CONTROL, struct.pack(">I", 2))
            self._write(protocol.OWNER, socket.inet_aton(owner))

    def start(self) -> None:
        """Begin to serve."""
        for thread in self._threads:
            thread.start()

    def close(self) -> None:
        """Stop serving and free the port."""
        self._ends.set()
        for thread in self._threads:
            thread.join()
        for one in (*self._sockets, self._stream):
            one.close()

    def _fill(self, serial: str) -> None:
        for address, text in (*protocol.NAMES.items(), (protocol.SERIAL, serial)):
            self._write(address, text.encode() + b"\0")
        self._write(protocol.XML_URL, f"Local:virtual.xml;{XML_ADDRESS:x};{len(self._xml):x}".encode())
        self._write(protocol.IP_ADDRESS, socket.inet_aton(HOST))
        registers = {
            0: 0x00010002,
            protocol.DEVICE_MODE: 0x80000001,
            protocol.CHANNELS: 1,
            protocol.CAPABILITY: protocol.CAN_RESEND | protocol.CAN_WRITE_MEMORY,
            protocol.HEARTBEAT_MS: 3000,
            protocol.TICKS_LOW: 1_000_000_000,
            protocol.PACKET_SIZE: 1500,
        }
        for address, value in registers.items():
            self._write(address, struct.pack(">I", value))
        for name, feature in self._features.items():
            self._write(self._where[name], encoded(feature, feature.start))
        self._update()

    def _answer_commands(self) -> None:
        while not self._ends.is_set():
            for heard in select.select(self._sockets, [], [], LOOK_S)[0]:
                packet, client = heard.recvfrom(2048)
                command = protocol.parse(packet)
                if command is None or self.faults.silent:
                    continue
                with self._lock:
                    reply = self._obey(command, client)
                if reply:
                    self._sockets[0].sendto(reply, client)
            with self._lock:
                self._check_heartbeat()

    def _obey(self, command: protocol.Command, client: Address) -> bytes | None:
        """Execute a command and return its answer; a request to send again has none."""
        self._check_heartbeat()
        if client == self._controller:
            self._heard_s = time.monotonic()
        if command.code == protocol.RESEND:
            self._resend(command.body)
            return None
        if command.code in (protocol.WRITE_REGISTER, protocol.WRITE_MEMORY):
            if self._controller not in (None, client):
                return protocol.answer(command, protocol.ACCESS_DENIED)
            address, data = int.from_bytes(command.body[:4], "big"), command.body[4:]
            self._written(address, data, client)
            return protocol.answer(command, protocol.OK, struct.pack(">HH", 0, 1))
        return self._answer_read(command)

    def _answer_read(self, command: protocol.Command) -> bytes:
        if command.code == protocol.DISCOVERY:
            return protocol.answer(command, protocol.OK, self._read(0, protocol.DISCOVERY_BYTES))
        address = int.from_bytes(command.body[:4], "big")
        if command.code == protocol.READ_REGISTER:
            return protocol.answer(command, protocol.OK, self._read(address, 4))
        if command.code == protocol.READ_MEMORY:
            return protocol.answer(command, protocol.OK, command.body[:4] + self._read(address, int.from_bytes(command.body[6:8], "big")))
        return protocol.answer(command, protocol.INVALID_ADDRESS)

    def _check_heartbeat(self) -> None:
        timeout_s = struct.unpack(">I", self._read(protocol.HEARTBEAT_MS, 4))[0] / 1000
        if self._controller is not None and time.monotonic() - self._heard_s > timeout_s:
            self._control(0, self._controller)

    def _control(self, value: int, client: Address) -> None:
        """Give control to a client, or take it away (0), which ends the acquisition."""
        self._controller = client if value else None
        self._heard_s = time.monotonic()
        self._acquires = self._acquires and bool(value)
        self._write(protocol.CONTROL, struct.pack(">I", value))
        self._write(protocol.OWNER, socket.inet_aton(client[0] if value else "0.0.0.0"))
        self._write(protocol.OWNER_PORT, struct.pack(">I", client[1] if value else 0))

    def _written(self, address: int, data: bytes, client: Address) -> None:
        if address == protocol.CONTROL:
            self._control(int.from_bytes(data, "big"), client)
            return
        name = next((name for name, one in self._where.items() if one == address), "")
        if name not in self.faults.ignores:
            self._write(address, data)
        actions = {"AcquisitionStart": self._start, "AcquisitionStop": self._stop, "TriggerSoftware": self._software_trigger}
        actions.get(name, self._update)()

    def _start(self) -> None:
        self._acquires, self._block = True, 0
        self._triggers.clear()

    def _stop(self) -> None:
        self._acquires = False

    def _software_trigger(self) -> None:
        if self._value("TriggerSource") == self._entry("TriggerSource", "Software"):
            self._trigger()

    def _trigger(self) -> None:
        if self._acquires and not self._busy and not self._triggers:
            self._triggers.append(None)

    def _update(self) -> None:
        """Compute the registers that follow from others."""
        pixels = int(self._value("Width") * self._value("Height"))
        image_bytes = pixels * (self._pixel_format() >> 16 & 0xFF) // 8
        self._set("PayloadSize", image_bytes + (24 if self._has_chunks() else 0))

    def _take_images(self) -> None:
        while not self._ends.is_set():
            with self._lock:
                exposes = bool(self._triggers) and self._acquires
                self._busy = exposes
                self._set("AcquisitionStatus", self._acquires and not exposes)
            if not exposes:
                time.sleep(0.001)
                continue
            self._triggers.popleft()
            exposure_us = self._value("ExposureTime") + self.faults.wrong_exposure_us
            time.sleep((exposure_us + self._value("SensorReadoutTime")) * 1e-6)
            packets = self._image(exposure_us)
            self.exposures += 1
            if not self._loses_image:
                self._send(packets, self.faults.lost_share)
            self._loses_image = False

    def _image(self, exposure_us: float) -> list[bytes]:
        """Take an image and return its packets, which are kept in case they are wanted again."""
        grey = self._render(self.exposures, exposure_us)
        code = self._pixel_format()
        data = PACKING[next(name for name, one in PIXEL_FORMATS.items() if one == code)](grey)
        if self._has_chunks():
            data = protocol.chunk(0, data) + protocol.chunk(CHUNK_EXPOSURE_ID, struct.pack(">d", exposure_us))
        self._block = _next(self._block)
        image = protocol.Image(self._block, time.monotonic_ns(), code, grey.shape[1], grey.shape[0], data, self._has_chunks())
        size_bytes = int.from_bytes(self._read(protocol.PACKET_SIZE, 4), "big") & 0xFFFF
        packets = list(image.packets(size_bytes))
        self._kept.append((self._block, packets))
        return packets

    def _send(self, packets: list[bytes], lost_share: float) -> None:
        host = socket.inet_ntoa(self._read(protocol.STREAM_ADDRESS, 4))
        port = int.from_bytes(self._read(protocol.STREAM_PORT, 4), "big") & 0xFFFF
        for packet, lot in zip(packets, self._random.random(len(packets)), strict=True):
            if lot >= lost_share:
                self._stream.sendto(packet, (host, port))

    def _resend(self, body: bytes) -> None:
        _, block, first, last = struct.unpack(">HHII", body[:12])
        packets = dict(self._kept).get(block)
        if packets and self.faults.resends:
            self._send(packets[first & 0xFFFFFF : (last & 0xFFFFFF) + 1], self.faults.lost_again_share)

    def _has_chunks(self) -> bool:
        return bool(self._value("ChunkModeActive") and self._value("ChunkEnable"))

    def _pixel_format(self) -> int:
        return int(self._value("PixelFormat"))

    def _value(self, name: str) -> float:
        return decoded(self._features[name], self._read(self._where[name], 8))

    def _set(self, name: str, value: float) -> None:
        self._write(self._where[name], encoded(self._features[name], value))

    def _entry(self, name: str, entry: str) -> int:
        return self._features[name].entries[entry]

    def _read(self, address: int, size: int) -> bytes:
        if address >= XML_ADDRESS:
            return self._xml[address - XML_ADDRESS :][:size].ljust(size, b"\0")
        return bytes(self._memory[address : address + size])

    def _write(self, address: int, data: bytes) -> None:
        self._memory[address : address + len(data)] = data


@contextmanager
def gige_camera(
    serial: str = "VIRTUAL-1", width_px: int = 640, height_px: int = 480, render: Render | None = None, seed: int = 0
) -> Iterator[GigeCamera]:
    """Run a camera on the GigE Vision port of 127.0.0.1, of which there is only one.

    Parameters
    ----------
    render : what the camera sees; default: noise that depends on the number of the exposure
    seed : of the packets lost

    Raises
    ------
    OSError
        Another program uses the port.
    """
    camera = GigeCamera(serial, width_px, height_px, render or noise(width_px, height_px), seed)
    camera.start()
    try:
        yield camera
    finally:
        camera.close()


def noise(width_px: int, height_px: int, bits: int = 8) -> Render:
    """Return a scene in which each exposure gives an image of its own, the same for the same number."""
    return lambda number, _: np.random.default_rng(number).integers(0, 2**bits, (height_px, width_px), np.uint16)


def _next(block: int) -> int:
    return block % 0xFFFF + 1


def _listening(host: str) -> socket.socket:
    one = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    one.bind((host, protocol.PORT))
    return one
