"""Settings of a rotary table on a serial line, and of the line."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from measureapp.data.model import Model


class LineSettings(Model):
    """A table ``[links.NAME]``: one serial line."""

    port: str = Field(default="", description="serial port, such as /dev/ttyUSB0 or COM3; empty: found by usb_serial")
    usb_serial: str = Field(default="", description="serial number of the USB adapter: found again when its port has another name")
    baudrate: int | None = Field(default=None, gt=0, description="none: as the command table says")
    reply_timeout_s: float = Field(default=0.2, gt=0, le=5, description="longest wait for a reply")


class TableSettings(Model):
    """One rotary table: its controller, where it is found, how its counts become degrees."""

    controller: str = Field(
        description="a command table of this plugin (newport_esp301, newport_smc100, owis_ps90, sigma_koki_shot), or the path of one"
    )
    link: str = Field(description="name of the line, described in [links.NAME] of the rig description")
    axis: int = Field(default=1, ge=1, le=31, description="number of the axis, or address of the controller")
    counts_per_unit: float | None = Field(default=None, gt=0, description="counts per degree; none: as the command table says")
    sense: Literal[1, -1] | None = Field(
        default=None, description="-1: counts grow clockwise seen from above; none: as the command table says"
    )
    zero_counts: float = Field(default=0.0, description="position that the controller reports at angle 0 of the rig")
    speed: float = Field(default=10.0, gt=0, description="speed in degrees per second; sent where the command table has a command for it")
    acceleration: float = Field(default=20.0, gt=0, description="in degrees per second squared; for the predicted duration")
    tolerance: float = Field(default=0.005, gt=0, description="largest difference of goal and read-back, in degrees")
    settled_s: float = Field(default=0.1, gt=0, le=5, description="two reads this far apart must agree")
    poll_s: float = Field(default=0.03, gt=0, le=1, description="time between two reads while the table turns")
    absolute_encoder: bool = Field(
        default=False,
        description="for controllers that cannot report whether they are referenced: true where the position is known after power-up",
    )
