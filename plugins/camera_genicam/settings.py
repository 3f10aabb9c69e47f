"""Settings of a GenICam camera."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from measureapp.data.model import Model
from measureapp.devices.camera import Shutter

from .pixels import FORMATS

PixelFormat = Literal["auto", "Mono8", "Mono10", "Mono10Packed", "Mono10p", "Mono12", "Mono12Packed", "Mono12p", "Mono16"]


class GenicamSettings(Model):
    """Settings of a GenICam camera; serial number, size and bit depth are those of the rig description."""

    pixel_format: PixelFormat = Field(
        default="auto", description="automatic: the most compact format with the bit depth of the rig description"
    )
    gain: float | None = Field(default=None, description="in the camera's own unit (Gain: dB, GainRaw: counts); none: leave it as it is")
    offset_x_px: int = Field(default=0, ge=0, description="first column read out")
    offset_y_px: int = Field(default=0, ge=0, description="first row read out")
    user_set: str = Field(default="Default", description="settings stored in the camera that are loaded first; empty: none")
    exposure_chunk: bool = Field(default=True, description="let each image carry its exposure, where the camera can; it is then checked")
    trigger_line: str = Field(default="Line1", description="input of the hardware trigger, rising edge")
    debounce_us: float | None = Field(default=None, ge=0, description="pulses shorter than this are ignored; none: leave it as it is")
    packet_size_bytes: int | None = Field(default=None, ge=220, le=16000, description="GigE Vision; none: the largest that arrives")
    packet_delay_us: float | None = Field(default=None, ge=0, description="GigE Vision, pause between packets; none: leave it as it is")
    link_mbit_per_s: int = Field(default=1000, gt=0, description="GigE 1000, 5GigE 5000, USB3 about 3200")
    cameras_on_link: int = Field(default=1, ge=1, le=16, description="cameras that send their images over the same link")
    buffers: int = Field(default=16, ge=2, le=256, description="images that can wait for being read")
    shutter: Shutter = Field(default="global", description="used where the camera does not report it")
    readout_s: float = Field(default=0.1, gt=0, le=10, description="read-out time, used where the camera does not report it")
    control_wait_s: float = Field(
        default=4.0, ge=0, le=60, description="how long to try while another program controls the camera; longer than its heartbeat, 3 s"
    )

    def formats(self, bit_depth: int) -> tuple[str, ...]:
        """Return the pixel formats to try, the most compact first."""
        return (
            (self.pixel_format,) if self.pixel_format != "auto" else tuple(name for name, one in FORMATS.items() if one.bits == bit_depth)
        )
