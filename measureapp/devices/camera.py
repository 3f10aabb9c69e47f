"""Camera interface."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from measureapp.arrays import ImageArray
from measureapp.data.conditions import LensSetting


@dataclass(frozen=True, slots=True, eq=False)
class GrabbedImage:
    """One image with the identification reported by the device."""

    pixels: ImageArray  # (height, width)
    frame_number: int  # consecutive; a gap or a repeat means a lost or stale image
    exposure_us: int  # as read back with the image
    serial: str
    pattern_index: int  # the pattern that the projector confirmed during the exposure; -1: uniform light


class Camera(Protocol):
    """A triggered monochrome camera. Every driver must pass ``tests/contracts/test_camera.py``."""

    name: str
    serial: str
    width_px: int
    height_px: int
    bit_depth: int

    def set_exposure_us(self, exposure_us: int) -> None:
        """Set the exposure. Raises LimitError when the camera does not support it."""

    def exposure_us(self) -> int:
        """Read the exposure back."""

    def grab(self, *, timeout_s: float) -> GrabbedImage:
        """Trigger one image and wait for it. Raises DeviceTimeout, DeviceError."""

    def temperature_c(self) -> float | None:
        """Read the temperature of the camera's housing; None if it has no thermometer."""

    def lens(self) -> LensSetting:
        """Read the lens setting back; empty for a manual lens."""

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `grab` then raises Cancelled."""
