"""Settings of the driver: each is a field with a description; the window makes its form of them."""

from __future__ import annotations

from pydantic import Field

from measureapp.data.model import Model


class Settings(Model):
    """What can be set in ``[devices.NAME] settings`` of a rig description."""

    address: str = Field(default="", description="change: where the device is found, such as an IP address or a serial number")
    readout_ms: float = Field(default=10.0, ge=0, description="duration of the sensor's read-out")
