"""A camera that replays recorded images: for demonstrations, and for tests without a camera."""

from __future__ import annotations

import threading
import time
from collections import Counter, deque
from pathlib import Path

from measureapp.data.conditions import LensSetting
from measureapp.data.rig import CameraDescription
from measureapp.devices.camera import Frame, StreamStatistics, Trigger
from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, DeviceTimeout, LimitError, MeasureError
from measureapp.progress import Cancelled

from .recording import Recording, read_pixels
from .settings import FolderSettings

ANY_EXPOSURE_US = (1, 10_000_000)  # where the recording does not tell its exposures


def connect(request: DeviceRequest) -> FolderCamera:
    """Open the recording of the camera that the rig description calls ``request.name``.

    Raises
    ------
    InputError
        There are no images, or the first one does not fit the camera.
    """
    settings = request.settings
    assert isinstance(settings, FolderSettings)
    camera = FolderCamera(request.rig.camera(request.name), Recording(settings), settings)
    camera.check_first_image()
    return camera


class FolderCamera:
    """Replays the images of each exposure in their order; hardware triggers are taken as given, one for each image fetched."""

    exposure_step_us = 1
    transfer_s = 0.0

    def __init__(self, described: CameraDescription, recording: Recording, settings: FolderSettings) -> None:
        self.name, self.serial = described.name, described.serial
        self.width_px, self.height_px, self.bit_depth = described.width_px, described.height_px, int(described.bit_depth)
        self.shutter, self.readout_s = settings.shutter, settings.readout_ms * settings.time_scale / 1000.0
        known = recording.exposures_us
        self.exposure_limits_us = (known[0], known[-1]) if known else ANY_EXPOSURE_US
        self._described, self._recording, self._settings = described, recording, settings
        self._exposure_us = known[-1] if known else 10_000
        self._trigger: Trigger | None = None
        self._most = self._triggered = self._fetched = self._frames = 0
        self._replayed: Counter[int] = Counter()  # images replayed at each exposure; one count where they are not known
        self._exposed: deque[tuple[Path, int, float]] = deque()  # image, exposure, and when it is ready
        self._ready_at = 0.0
        self._stopped = threading.Condition()
        self._stops = 0

    def check_first_image(self) -> None:
        """Raise InputError if the first image does not fit the camera."""
        read_pixels(self._recording.paths(self._exposure_us)[0], self._described)

    def set_exposure_us(self, exposure_us: int) -> None:
        """Choose the images recorded at an exposure. Raises LimitError if there are none."""
        known, (low, high) = self._recording.exposures_us, self.exposure_limits_us
        if known and exposure_us not in known:
            listed = ", ".join(map(str, known))
            raise LimitError(f"Camera {self.name} has no images recorded at {exposure_us} µs.", f"Choose one of {listed} µs.")
        if not low <= exposure_us <= high:
            raise LimitError(f"Camera {self.name} does not support an exposure of {exposure_us} µs.", f"Choose {low}…{high} µs.")
        self._exposure_us = exposure_us

    def exposure_us(self) -> int:
        """Return the exposure chosen."""
        return self._exposure_us

    def arm(self, frames: int, trigger: Trigger) -> None:
        """Begin a sequence of at most ``frames`` images."""
        self.disarm()
        if self._settings.at_arm == "restart":
            self._replayed.clear()
        self._most, self._trigger, self._triggered, self._fetched, self._ready_at = frames, trigger, 0, 0, 0.0

    def trigger(self) -> None:
        """Expose the next image of the recording. Raises DeviceError after the last one, if the recording ends."""
        if self._trigger != "software":
            raise DeviceError(f"Camera {self.name} is not armed for triggers by the program.", "Arm it first.")
        self._expose()

    def wait_ready(self, *, timeout_s: float) -> None:
        """Wait until the exposure has ended and its rows are read out."""
        self._wait(self._ready_at - time.monotonic(), timeout_s)

    def next_frame(self, *, timeout_s: float) -> Frame:
        """Return the next image.

        Raises
        ------
        InputError
            Its file is missing or damaged, or does not fit the camera.
        DeviceTimeout
            Nothing has triggered an image.
        """
        if self._trigger == "hardware" and not self._exposed and self._triggered < self._most:
            self._expose()
        if not self._exposed:
            self._wait(timeout_s, timeout_s)
            raise DeviceTimeout(f"Camera {self.name} delivered no image within {timeout_s:g} s.", "Trigger it, or arm it for more images.")
        path, exposure_us, ready_at = self._exposed[0]
        self._wait(ready_at - time.monotonic(), timeout_s)
        self._exposed.popleft()
        number, self._fetched = self._fetched, self._fetched + 1
        pixels = read_pixels(path, self._described)
        self._frames += 1
        return Frame(pixels, self.serial, number, exposure_us)

    def disarm(self) -> None:
        """End the sequence; images not fetched are skipped."""
        self._exposed.clear()
        self._trigger = None

    def statistics(self) -> StreamStatistics:
        """Return the number of images replayed."""
        return StreamStatistics(self._frames)

    def temperature_c(self) -> float | None:
        """Return None: a recording has no temperature."""
        return None

    def lens(self) -> LensSetting:
        """Return an empty setting."""
        return LensSetting()

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        identity = f"recording {self._recording.folder}"
        try:
            self.check_first_image()
        except MeasureError as error:
            return DeviceStatus(False, error.message, error.hint, identity)
        paths = self._recording.paths(self._exposure_us)
        return DeviceStatus(
            True, f"replays {len(paths)} images at {self._exposure_us / 1000:g} ms from {self._recording.folder}", "", identity
        )

    def stop(self) -> None:
        """Cancel the call that waits, from any thread; later calls are not affected."""
        with self._stopped:
            self._stops += 1
            self._stopped.notify_all()

    def close(self) -> None:
        """End the sequence. Harmless when repeated."""
        self.disarm()

    def _expose(self) -> None:
        if self._triggered >= self._most:
            raise DeviceError(f"All {self._most} images of the sequence of camera {self.name} are triggered.", "Arm it for more images.")
        paths = self._recording.paths(self._exposure_us)
        counted = self._exposure_us if self._recording.exposures_us else 0
        index = self._replayed[counted]
        if index >= len(paths) and self._settings.at_end == "end":
            raise DeviceError(
                f"The recording of camera {self.name} in {self._recording.folder} has ended after {len(paths)} images.",
                'Set at_end = "loop" to begin again.',
            )
        self._replayed[counted] += 1
        self._triggered += 1
        begins = max(time.monotonic(), self._ready_at)
        self._ready_at = begins + self._exposure_us * 1e-6 * self._settings.time_scale + self.readout_s
        self._exposed.append((paths[index % len(paths)], self._exposure_us, self._ready_at))

    def _wait(self, seconds: float, timeout_s: float) -> None:
        with self._stopped:
            stops = self._stops
            if self._stopped.wait_for(lambda: self._stops != stops, max(0.0, min(seconds, timeout_s))):
                raise Cancelled
        if seconds > timeout_s:
            raise DeviceTimeout(f"Camera {self.name} did not finish within {timeout_s:g} s.", "Wait longer, or lower time_scale.")
