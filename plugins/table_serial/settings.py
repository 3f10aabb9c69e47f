"""Settings of a rotary table on a serial line."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from measureapp.data.model import Model


class TableSettings(Model):
    """Which controller it is, where it is found, and how its counts become degrees."""

    controller: str = Field(description="a table of this plugin (esp301, smc100, ps90, shot), or the path of one")
    port: str = Field(default="", description="serial port, such as /dev/ttyUSB0 or COM3; empty: found by usb_serial")
    usb_serial: str = Field(default="", description="serial number of the USB adapter: found again when its port has another name")
    baudrate: int | None = Field(default=None, gt=0, description="none: as the controller's table says")
    counts_per_unit: float | None = Field(default=None, gt=0, description="counts per degree; none: as the controller's table says")
    sense: Literal[1, -1] = Field(default=1, description="-1: the controller counts clockwise, seen from above")
    zero_deg: float = Field(default=0.0, description="the controller's angle at angle 0 of the rig")
    speed_deg_per_s: float = Field(default=20.0, gt=0, description="as set in the controller; for the predicted duration")
    acceleration_deg_per_s2: float = Field(default=40.0, gt=0, description="as set in the controller; for the predicted duration")
    tolerance_deg: float = Field(default=0.005, gt=0, description="largest difference of goal and read-back")
    settled_s: float = Field(default=0.1, gt=0, le=5, description="two reads this far apart must agree")
    poll_s: float = Field(default=0.05, gt=0, le=1, description="time between two reads while the table turns")
    reply_timeout_s: float = Field(default=0.15, gt=0, le=5, description="longest wait for a reply; a stop waits no longer than this")
