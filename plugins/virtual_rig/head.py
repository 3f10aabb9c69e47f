"""Cameras and projector of the virtual rig, with the timing of the real ones."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.data.conditions import LensSetting
from measureapp.data.rig import CameraDescription
from measureapp.devices.camera import Frame, Shutter, StreamStatistics, Trigger
from measureapp.devices.projector import DARK, PLAIN_LIGHT
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, DeviceTimeout, LimitError
from measureapp.simulate.world import World

from .waiting import Clock, Stopping

EXPOSURE_LIMITS_US = (35, 1_000_000)
ROW_S, READOUT_START_S = 35e-6, 490e-6  # read-out of the sensor: every row, and before the first one
LINK_BYTES_PER_S = 123.8e6  # payload of one link of 1 Gbit/s with jumbo frames, shared by all cameras
SWITCHING_S = 0.02  # until a pattern shown by the program is lit, and by itself in a sequence:
SEQUENCE_SWITCHING_S = 0.0002


class SharedLink:
    """The link that transfers the images of all cameras one after the other."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._free_at = 0.0

    def transfer(self, ready_at: float, count: int) -> float:
        """Book the transfer of ``count`` bytes that are ready at a moment; return the moment at which they have arrived."""
        with self._lock:
            self._free_at = max(self._free_at, ready_at) + count / LINK_BYTES_PER_S
            return self._free_at


@dataclass(frozen=True, slots=True, eq=False)
class _Exposure:
    """One triggered exposure: image, or how to make it, and when it will have arrived."""

    number: int
    started_at: float
    exposure_us: int
    pixels: Callable[[], ImageArray]
    arrives_at: float


class VirtualCamera:
    """One camera of the world."""

    shutter: Shutter = "rolling"
    exposure_limits_us = EXPOSURE_LIMITS_US
    exposure_step_us = 1
    longest_rendering_s = 60.0

    def __init__(self, description: CameraDescription, world: World, clock: Clock, link: SharedLink, follow: Callable[[], None]) -> None:
        self.name = description.name
        self.serial = description.serial
        self.width_px = description.width_px
        self.height_px = description.height_px
        self.bit_depth = int(description.bit_depth)
        self.readout_s = description.height_px * ROW_S + READOUT_START_S
        self._bytes = self.width_px * self.height_px * (1 if self.bit_depth == 8 else 2)
        self.transfer_s = self._bytes * len(world.description.cameras) / LINK_BYTES_PER_S
        self._world, self._link, self._follow = world, link, follow
        self._stopping = Stopping(clock)
        self._exposure_us = world.description.exposures_us[-1]
        self._trigger: Trigger | None = None
        self._count = self._most = self._frames = 0
        self._ready_at = 0.0
        self._taken: deque[_Exposure] = deque()

    def set_exposure_us(self, exposure_us: int) -> None:
        """Set the exposure. Raises LimitError when the camera does not support it."""
        low, high = EXPOSURE_LIMITS_US
        if not low <= exposure_us <= high:
            raise LimitError(f"Camera {self.name} does not support an exposure of {exposure_us} µs.", f"Choose {low}…{high} µs.")
        self._exposure_us = int(exposure_us)

    def exposure_us(self) -> int:
        """Read the exposure back."""
        return self._exposure_us

    def arm(self, frames: int, trigger: Trigger) -> None:
        """Begin a sequence of at most ``frames`` images."""
        self._follow()  # nothing moves during a sequence
        self._trigger, self._most, self._count = trigger, frames, 0
        self._taken.clear()

    def trigger(self) -> None:
        """Start one exposure now."""
        if self._trigger != "software":
            raise DeviceError(f"Camera {self.name} is not armed for triggers by the program.", "Arm it first.")
        image = self._world.image(self.name, self._exposure_us)
        self.expose(self._stopping.clock.now(), lambda: image)

    def expose(self, moment: float, pixels: Callable[[], ImageArray]) -> None:
        """Start an exposure at a moment, by the trigger line or by software; an early trigger, and one too many, have no effect."""
        if self._trigger is None or self._count >= self._most or moment < self._ready_at - 1e-9:
            return
        self._ready_at = moment + self._exposure_us * 1e-6 + self.readout_s
        arrives_at = self._link.transfer(self._ready_at, self._bytes)
        self._taken.append(_Exposure(self._count, moment, self._exposure_us, pixels, arrives_at))
        self._count += 1

    @property
    def waits_for_pulses(self) -> bool:
        """Whether the trigger line starts exposures."""
        return self._trigger == "hardware"

    def wait_ready(self, *, timeout_s: float) -> None:
        """Wait until the started exposure has ended and its rows are read out."""
        self._stopping.wait_until(f"Camera {self.name}", self._ready_at, timeout_s)

    def next_frame(self, *, timeout_s: float) -> Frame:
        """Wait for the next image of the sequence."""
        if not self._taken:
            self._stopping.wait(f"Camera {self.name}", timeout_s, timeout_s)
            raise DeviceTimeout(f"Camera {self.name} delivered no image within {timeout_s:g} s.", "Check its trigger line.")
        exposure = self._taken[0]
        self._stopping.wait_until(f"Camera {self.name}", exposure.arrives_at, timeout_s)
        self._taken.popleft()
        self._frames += 1
        return Frame(exposure.pixels(), self.serial, exposure.number, exposure.exposure_us, exposure.started_at)

    def disarm(self) -> None:
        """End the sequence."""
        self._trigger = None
        self._taken.clear()

    def statistics(self) -> StreamStatistics:
        """Read the counters of the stream."""
        return StreamStatistics(self._frames, 0, 0, 0)

    def temperature_c(self) -> float | None:
        """Read the temperature of the housing, with a resolution of 0.1 °C."""
        return round(self._world.housing_c(), 1)

    def lens(self) -> LensSetting:
        """Read the lens setting back: empty, for a manual lens."""
        return LensSetting()

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        text = f"{self.width_px} × {self.height_px} px, exposure {self._exposure_us / 1000:g} ms, {self.temperature_c():.1f} °C"
        return DeviceStatus(True, text, identity=self.serial)

    def stop(self) -> None:
        """Stop now, from any thread; a waiting call then raises Cancelled."""
        self._stopping.stop()

    def close(self) -> None:
        """Nothing to release."""


class VirtualProjector:
    """The projector of the world; uniform light comes from the head lamp."""

    frame_us = 0
    gated = False

    def __init__(self, world: World, clock: Clock, cameras: Sequence[VirtualCamera]) -> None:
        self.name = world.description.projector.name
        self.width_px = world.description.projector.width_px
        self.height_px = world.description.projector.height_px
        self._world, self._cameras = world, cameras
        self._stopping = Stopping(clock)
        self._count = self._pulses = 0

    def load(self, images: ImageArray) -> None:
        """Load a sequence (count, height, width) of uint8 images. Raises DeviceError for a wrong size."""
        images = np.asarray(images)
        if images.ndim != 3 or images.shape[1:] != (self.height_px, self.width_px) or images.dtype != np.uint8:
            raise DeviceError(
                f"{self.name} does not support images of shape {images.shape} and type {images.dtype}.",
                f"Give 8-bit images of {self.width_px} × {self.height_px} px.",
            )
        self._world.load_patterns(images)
        self._count = len(images)

    def show(self, index: int, *, timeout_s: float) -> None:
        """Show image ``index`` of the sequence, PLAIN_LIGHT or DARK, and wait until it is stable."""
        self._check(index, lowest=DARK)
        if index != self._world.shown:
            self._stopping.wait(self.name, SWITCHING_S, timeout_s)
        self._world.show(index)

    def play(self, first: int, count: int, *, exposure_us: int, period_us: int) -> None:
        """Play images once, with a trigger pulse for all cameras at each of them."""
        self._check(first, lowest=0)
        self._check(first + count - 1, lowest=0)
        if period_us < exposure_us:
            raise LimitError(f"{self.name} cannot expose {exposure_us} µs in a period of {period_us} µs.", "Lengthen the period.")
        start = self._stopping.clock.now() + SEQUENCE_SWITCHING_S
        self._pulses = count
        for step in range(count):
            for camera in self._cameras:
                if camera.waits_for_pulses:
                    camera.expose(start + step * period_us * 1e-6, self._image_of(camera, first + step, exposure_us))

    def triggers_sent(self) -> int:
        """Read the number of trigger pulses since the last `play`."""
        return self._pulses

    def shown(self) -> int:
        """Read back the image shown: an index, PLAIN_LIGHT or DARK."""
        return self._world.shown

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        words = {DARK: "dark", PLAIN_LIGHT: "uniform light"}
        shown = words.get(self._world.shown, f"shows image {self._world.shown + 1} of {self._count}")
        return DeviceStatus(True, f"{self.width_px} × {self.height_px} px, {shown}")

    def stop(self) -> None:
        """Switch the light off now, from any thread."""
        self._stopping.stop()
        self._world.show(DARK)

    def close(self) -> None:
        """Switch the light off."""
        self._world.show(DARK)

    def _image_of(self, camera: VirtualCamera, pattern: int, exposure_us: int) -> Callable[[], ImageArray]:
        return lambda: self._world.image_under(camera.name, exposure_us, pattern)

    def _check(self, index: int, lowest: int) -> None:
        if not lowest <= index < self._count:
            raise DeviceError(f"{self.name} has {self._count} images and cannot show image {index}.", "Load the pattern set first.")
