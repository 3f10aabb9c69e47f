"""State of a device, as its driver reads it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class DeviceStatus:
    """State of one device now; reading it moves nothing and raises no DeviceError: a device that does not answer is not ready."""

    ready: bool
    text: str  # such as "motors on, automatic mode, flange at 412.0 3.1 600.0 mm"
    remedy: str = ""  # what to do when it is not ready
    identity: str = ""  # serial number and firmware, where the device tells them
