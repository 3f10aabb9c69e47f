"""Cameras and projector of the virtual rig."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.data.conditions import LensSetting
from measureapp.data.rig import CameraDescription
from measureapp.devices.camera import GrabbedImage
from measureapp.errors import DeviceError, LimitError
from measureapp.simulate.world import DARK, PLAIN_LIGHT, World

from .waiting import Clock, Stopping

EXPOSURE_LIMITS_US = (35, 1_000_000)
READOUT_S = 0.071
SWITCHING_S = 0.02


class VirtualCamera:
    """One camera of the world."""

    def __init__(self, description: CameraDescription, world: World, clock: Clock) -> None:
        self.name = description.name
        self.serial = description.serial
        self.width_px = description.width_px
        self.height_px = description.height_px
        self.bit_depth = int(description.bit_depth)
        self._world = world
        self._stopping = Stopping(clock)
        self._exposure_us = world.description.exposures_us[-1]
        self._frames = 0

    def set_exposure_us(self, exposure_us: int) -> None:
        """Set the exposure. Raises LimitError when the camera does not support it."""
        low, high = EXPOSURE_LIMITS_US
        if not low <= exposure_us <= high:
            raise LimitError(f"Camera {self.name} does not support an exposure of {exposure_us} µs.", f"Choose {low}…{high} µs.")
        self._exposure_us = int(exposure_us)

    def exposure_us(self) -> int:
        """Read the exposure back."""
        return self._exposure_us

    def grab(self, *, timeout_s: float) -> GrabbedImage:
        """Trigger one image and wait for it. Raises DeviceTimeout, DeviceError."""
        self._stopping.wait(f"Camera {self.name}", self._exposure_us * 1e-6 + READOUT_S, timeout_s)
        pixels = self._world.image(self.name, self._exposure_us)
        self._frames += 1
        return GrabbedImage(pixels, self._frames, self._exposure_us, self.serial, self._world.shown)

    def temperature_c(self) -> float | None:
        """Read the temperature of the housing, with a resolution of 0.1 °C."""
        return round(self._world.housing_c(), 1)

    def lens(self) -> LensSetting:
        """Read the lens setting back: empty, for a manual lens."""
        return LensSetting()

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `grab` then raises Cancelled."""
        self._stopping.stop()


class VirtualProjector:
    """The projector of the world; uniform light comes from the head lamp."""

    def __init__(self, world: World, clock: Clock) -> None:
        self.name = world.description.projector.name
        self.width_px = world.description.projector.width_px
        self.height_px = world.description.projector.height_px
        self._world = world
        self._stopping = Stopping(clock)
        self._count = 0

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
        """Show image ``index`` of the sequence, or -1 for uniform grey light, and wait until it is stable."""
        if not PLAIN_LIGHT <= index < self._count:
            raise DeviceError(f"{self.name} has {self._count} images and cannot show image {index}.", "Load the pattern set first.")
        self._stopping.wait(self.name, SWITCHING_S, timeout_s)
        self._world.show(index)

    def shown(self) -> int:
        """Read back the image shown: an index, -1 for uniform light, -2 for dark."""
        return self._world.shown

    def stop(self) -> None:
        """Switch the light off now, from any thread."""
        self._stopping.stop()
        self._world.show(DARK)
