"""A camera that makes its own images: a complete driver to start from.

What a driver owes is written at `measureapp.devices.camera.Camera`, and checked by `tests/contracts/test_camera.py`.
"""

from __future__ import annotations

import threading
import time
from collections import deque

import numpy as np

from measureapp.data.conditions import LensSetting
from measureapp.devices.camera import Frame, Shutter, StreamStatistics, Trigger
from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, DeviceTimeout, LimitError
from measureapp.progress import Cancelled

from .settings import Settings


def connect(request: DeviceRequest) -> TemplateCamera:
    """Connect the camera that the rig description calls ``request.name``; raises DeviceError in words when it does not answer."""
    settings = request.settings
    assert isinstance(settings, Settings)
    described = request.rig.camera(request.name)
    return TemplateCamera(described.name, described.serial, (described.width_px, described.height_px), described.bit_depth, settings)


class TemplateCamera:
    """Change: the calls of the vendor's library go where this class makes its images."""

    shutter: Shutter = "global"
    transfer_s = 0.0
    exposure_limits_us = (10, 1_000_000)  # change: read these from the camera
    exposure_step_us = 1

    def __init__(self, name: str, serial: str, size_px: tuple[int, int], bit_depth: int, settings: Settings) -> None:
        self.name, self.serial, self.bit_depth = name, serial, bit_depth
        self.width_px, self.height_px = size_px
        self.readout_s = settings.readout_ms / 1000.0
        self._exposure_us, self._ready_at, self._frames = 10_000, 0.0, 0
        self._trigger: Trigger | None = None
        self._taken: deque[Frame] = deque()
        self._number = 0
        self._stopped = threading.Event()

    def set_exposure_us(self, exposure_us: int) -> None:
        """Set the exposure. Raises LimitError when the camera does not support it."""
        low, high = self.exposure_limits_us
        if not low <= exposure_us <= high:
            raise LimitError(f"Camera {self.name} does not support an exposure of {exposure_us} µs.", f"Choose {low}…{high} µs.")
        self._exposure_us = int(exposure_us)

    def exposure_us(self) -> int:
        """Read the exposure back: always from the camera, never what was last asked for."""
        return self._exposure_us

    def arm(self, frames: int, trigger: Trigger) -> None:
        """Begin a sequence; images of an earlier one are discarded."""
        del frames  # change: the number of buffers to provide
        self._taken.clear()
        self._number, self._trigger = 0, trigger

    def trigger(self) -> None:
        """Start one exposure and return at once."""
        if self._trigger != "software":
            raise DeviceError(f"Camera {self.name} is not armed for triggers by the program.", "Arm it first.")
        self._ready_at = time.monotonic() + self._exposure_us * 1e-6 + self.readout_s
        self._taken.append(Frame(self._image(), self.serial, self._number, self._exposure_us, self._ready_at))
        self._number += 1

    def wait_ready(self, *, timeout_s: float) -> None:
        """Wait until the exposure has ended and its rows are read out."""
        self._wait(self._ready_at - time.monotonic(), timeout_s)

    def next_frame(self, *, timeout_s: float) -> Frame:
        """Wait for the next image. Change: raise FrameError for one that the library reports as damaged or incomplete."""
        if not self._taken:
            self._wait(timeout_s, timeout_s)
            raise DeviceTimeout(f"Camera {self.name} delivered no image within {timeout_s:g} s.", "Check its trigger and its link.")
        self._wait((self._taken[0].device_time_s or 0.0) - time.monotonic(), timeout_s)
        self._frames += 1
        return self._taken.popleft()

    def disarm(self) -> None:
        """End the sequence."""
        self._taken.clear()
        self._trigger = None

    def statistics(self) -> StreamStatistics:
        """Read the counters of the stream."""
        return StreamStatistics(self._frames)

    def temperature_c(self) -> float | None:
        """Read the temperature of the housing; this camera has no thermometer."""
        return None

    def lens(self) -> LensSetting:
        """Read the lens setting back: empty, for a manual lens."""
        return LensSetting()

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        return DeviceStatus(True, f"{self.width_px} × {self.height_px} px, exposure {self._exposure_us / 1000:g} ms", identity=self.serial)

    def stop(self) -> None:
        """Cancel the call that waits, from any thread; later calls are not affected."""
        self._stopped.set()

    def close(self) -> None:
        """Release the camera; harmless when repeated."""
        self.disarm()

    def _wait(self, seconds: float, timeout_s: float) -> None:
        self._stopped.clear()
        if self._stopped.wait(max(0.0, min(seconds, timeout_s))):
            raise Cancelled
        if seconds > timeout_s:
            raise DeviceTimeout(f"Camera {self.name} did not finish within {timeout_s:g} s.", "Check its power and its link.")

    def _image(self) -> np.ndarray:
        """Return a grey wedge that brightens with the exposure; change: the library's image, copied."""
        wedge = np.linspace(0.0, 1.0, self.width_px) * min(1.0, self._exposure_us / 100_000) * (2**self.bit_depth - 1)
        return np.broadcast_to(wedge, (self.height_px, self.width_px)).astype(np.uint8 if self.bit_depth == 8 else np.uint16)
