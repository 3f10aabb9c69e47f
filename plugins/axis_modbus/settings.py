"""Settings of an axis on Modbus, and of the line that several axes may share."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from measureapp.data.model import Model


class LineSettings(Model):
    """A table ``[links.NAME]``: one serial line or gateway."""

    port: str = Field(default="", description="serial port, such as /dev/ttyUSB0 or COM3; empty: found by usb_serial, or TCP")
    usb_serial: str = Field(default="", description="serial number of the USB adapter: found again when its port has another name")
    host: str = Field(default="", description="address of a device or gateway on TCP; then no port")
    tcp_port: int = Field(default=502, ge=1, le=65535)
    framing: Literal["map", "rtu", "ascii", "socket"] = Field(default="map", description="how messages are framed on the line")
    baudrate: int | None = Field(default=None, gt=0, description="none: as the drive's map says")
    parity: Literal["N", "E", "O"] | None = Field(default=None, description="none: as the drive's map says")
    reply_timeout_s: float = Field(default=0.15, gt=0, le=5, description="longest wait for a reply; a stop waits no longer than this")


class AxisSettings(Model):
    """One axis: its drive, where it is found, how its counts become millimetres or degrees."""

    drive: str = Field(description="a map of this plugin (toyo_xc100, iai_pcon, oriental_az, smc_lecp6, simple_axis), or the path of one")
    link: str = Field(description="name of the line, described in [links.NAME] of the rig description")
    unit_id: int | None = Field(default=None, ge=0, le=247, description="station number; none: as the drive's map says")
    counts_per_unit: float | None = Field(default=None, gt=0, description="counts per mm or degree; none: as the drive's map says")
    sense: Literal[1, -1] = Field(default=1, description="-1: counts grow against the rig's positive direction")
    zero_counts: int = Field(default=0, description="counts at position 0 of the rig")
    speed: float = Field(default=100.0, gt=0, description="speed in mm or degrees per second")
    acceleration: float = Field(default=500.0, gt=0, description="in mm or degrees per second squared; for the predicted duration")
    tolerance: float = Field(default=0.02, gt=0, description="largest difference of goal and read-back, in mm or degrees")
    settled_s: float = Field(default=0.1, gt=0, le=5, description="two reads this far apart must agree")
    poll_s: float = Field(default=0.03, gt=0, le=1, description="time between two reads while the axis moves")
    absolute_encoder: bool = Field(
        default=False,
        description="for drives that cannot report whether they are referenced: true where the position is known after power-up",
    )
