"""Settings of a Basler camera. Serial number, size and bit depth stand in the rig description."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from measureapp.data.model import Model
from measureapp.devices.camera import Shutter


class ActionKeys(Model):
    """Keys of a GigE Vision action command; cameras react to commands with the same keys only."""

    device_key: int = Field(default=1, ge=0, le=0xFFFFFFFF)
    group_key: int = Field(default=1, ge=0, le=0xFFFFFFFF)
    group_mask: int = Field(default=1, ge=1, le=0xFFFFFFFF)


class BaslerSettings(Model):
    """Settings of one Basler camera."""

    shutter: Shutter = Field(default="rolling", description="rolling, global-reset (for a projector with gated light) or global")
    gain: float | None = Field(default=None, description="in the camera's unit (raw steps on ace GigE, dB on newer ones); none: the lowest")
    black_level: float | None = Field(default=None, description="in the camera's unit; none: as in its default user set")
    packed: bool = Field(default=True, description="transfer 10 and 12 bit in packed formats, where the camera has them")
    offset_px: tuple[int, int] = Field(default=(0, 0), description="column and row of the image's first pixel on the sensor")
    hardware_trigger: Literal["Line1", "Line2", "Line3", "Action1"] = Field(default="Line1", description="source of hardware triggers")
    debounce_us: float | None = Field(
        default=20.0, ge=0, description="shortest pulse on the trigger line; none: as in the default user set"
    )
    action: ActionKeys = Field(default=ActionKeys(), description="keys of the action command, for the trigger source Action1")
    link: str = Field(default="ethernet", min_length=1, description="name of the network link; cameras with the same name share it")
    packet_bytes: int = Field(
        default=1500, ge=576, le=16_000, description="packet size; above 1500 network card and switch need jumbo frames"
    )
    inter_packet_delay: int | None = Field(default=None, ge=0, description="in ticks; none: shared equally by the cameras of the link")
    row_us: float = Field(default=35.0, ge=0, description="read-out of one row, for cameras that do not report their read-out")
    buffers: int = Field(default=16, ge=2, le=200, description="images that the computer holds until they are fetched")
    open_retry_s: float = Field(default=4.0, ge=0, le=60, description="how long a camera that another program holds is tried again")
    answer_s: float = Field(default=1.5, gt=0, le=1.75, description="after this time without an answer the camera counts as lost")
