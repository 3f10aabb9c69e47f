"""The fake GigE Vision camera of Aravis, which others wrote, our virtual one, and the driver connected to them over loopback."""

from __future__ import annotations

import os
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import closing, contextmanager
from ctypes.util import find_library
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from filelock import FileLock

from measureapp.arrays import ImageArray
from measureapp.data.rig import RigDescription
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.peers.gige_camera import GigeCamera, gige_camera, noise
from measureapp.project.rig_file import read_rig

PROGRAM = "arv-fake-gv-camera-0.8"
SERIAL = "FAKE-7"
SIZE_PX = 512
NAME = "left"
PERIOD_S = 0.04  # the fake camera looks for a trigger 25 times a second
GVCP = ("127.0.0.1", 3956)
DISCOVER = bytes([0x42, 0x01, 0x00, 0x02, 0x00, 0x00, 0x00, 0x01])

LIBRARY, TOOLS = "libaravis-0.8-0", "aravis-tools"
SMALL_BUFFERS = 1_000_000  # bytes that a socket may hold; a whole image comes at once over loopback


def _missing(*tools: str) -> str:
    """Say what has to be installed or set for these tests; empty: nothing."""
    if find_library("aravis-0.8") is None or not all(shutil.which(tool) for tool in tools):
        return f"needs Aravis: apt-get install {LIBRARY} {TOOLS if tools else ''}".rstrip()
    allowed = Path("/proc/sys/net/core/rmem_max")
    if allowed.exists() and os.geteuid() != 0 and int(allowed.read_text()) < SMALL_BUFFERS:  # root reads packets past the socket
        return "needs larger network buffers: sysctl -w net.core.rmem_max=8000000"
    return ""


MISSING_LIBRARY, MISSING = _missing(), _missing(PROGRAM)
needs_library = pytest.mark.skipif(bool(MISSING_LIBRARY), reason=MISSING_LIBRARY or "it is there")
needs_fake_camera = pytest.mark.skipif(bool(MISSING), reason=MISSING or "it is there")


class FakeCamera:
    """The running program; it can be made to hang, or be killed."""

    def __init__(self, process: subprocess.Popen[bytes]) -> None:
        self._process = process

    def hang(self) -> None:
        self._process.send_signal(signal.SIGSTOP)

    def go_on(self) -> None:
        self._process.send_signal(signal.SIGCONT)

    def kill(self) -> None:
        self._process.kill()
        self._process.wait()


@contextmanager
def fake_camera(lost_per_1000: int = 0, serial: str = SERIAL) -> Iterator[FakeCamera]:
    """Run the fake camera."""
    with port():
        command = [PROGRAM, "-i", GVCP[0], "-s", serial, "-r", str(lost_per_1000)]
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            _wait_until_it_answers()
            yield FakeCamera(process)
        finally:
            process.kill()
            process.wait()


@contextmanager
def virtual_camera(width_px: int = SIZE_PX, height_px: int = SIZE_PX, bits: int = 8) -> Iterator[GigeCamera]:
    """Run our virtual camera, which sees another image at each exposure: `scene`."""
    with port(), gige_camera(SERIAL, width_px, height_px, noise(width_px, height_px, bits)) as camera:
        yield camera


@contextmanager
def port() -> Iterator[None]:
    """Hold the GigE Vision port, of which this machine has one."""
    with FileLock(Path(tempfile.gettempdir()) / "measureapp-gige-vision-port.lock", timeout=300):
        yield


@contextmanager
def connected(serial: str = SERIAL, size_px: int = SIZE_PX, bit_depth: int = 8, **settings: Any) -> Iterator[Any]:
    """The driver on the fake camera."""
    camera = connect(rig_with(serial, size_px, bit_depth), **settings)
    try:
        yield camera
    finally:
        camera.close()


def connect(rig: RigDescription, **settings: Any) -> Any:
    driver = load_driver(None, "camera_genicam", "camera")
    chosen = driver.settings.model_validate({"readout_s": PERIOD_S, "user_set": "", **settings})
    return driver.entry(DeviceRequest(NAME, rig, chosen, Links({})))


def rig_with(serial: str = SERIAL, size_px: int = SIZE_PX, bit_depth: int = 8) -> RigDescription:
    rig = read_rig("paper")
    changed = {"name": NAME, "serial": serial, "width_px": size_px, "height_px": size_px, "bit_depth": bit_depth}
    return rig.model_copy(update={"cameras": (rig.cameras[0].model_copy(update=changed), *rig.cameras[1:])})


def ramp(first_pixel: int, size_px: int = SIZE_PX) -> ImageArray:
    """The image of the fake camera at 10 ms and gain 0: a diagonal ramp modulo 255, which begins at another grey level each time."""
    rows, columns = np.ogrid[:size_px, :size_px]
    return ((rows + columns + first_pixel) % 255).astype(np.uint8)


def _wait_until_it_answers() -> None:
    with closing(socket.socket(socket.AF_INET, socket.SOCK_DGRAM)) as probe:
        probe.settimeout(0.1)
        for _ in range(100):
            probe.sendto(DISCOVER, GVCP)
            try:
                probe.recv(1024)
            except OSError:
                time.sleep(0.02)
            else:
                return
    raise RuntimeError(f"{PROGRAM} does not answer")
