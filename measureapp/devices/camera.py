"""Cameras."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from measureapp.arrays import ImageArray
from measureapp.data.conditions import LensSetting


@dataclass(frozen=True, slots=True, eq=False)
class GrabbedImage:
    """One image with the identity the device gave it."""

    pixels: ImageArray  # (height, width)
    frame_number: int  # counts every image of this camera; a gap or repeat means a lost or stale one
    exposure_us: int  # as read back with the image
    serial: str
    pattern_index: int  # the pattern the projector confirmed while the image was exposed; -1: a plain image


class Camera(Protocol):
    """A triggered monochrome camera. Every driver must pass ``tests/contracts/test_camera.py``."""

    name: str
    serial: str
    width_px: int
    height_px: int
    bit_depth: int

    def set_exposure_us(self, exposure_us: int) -> None:
        """Ask for an exposure. Raises LimitError when the camera cannot do it."""

    def exposure_us(self) -> int:
        """Read the exposure back."""

    def grab(self, *, timeout_s: float) -> GrabbedImage:
        """Trigger one image and wait for it. Raises DeviceTimeout, DeviceError."""

    def temperature_c(self) -> float | None:
        """Read the temperature of the camera's housing back; None where it has no thermometer."""

    def lens(self) -> LensSetting:
        """Read back how the lens is set; an empty setting where nothing tells, as with a lens that is set by hand."""

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `grab` then raises Cancelled."""
