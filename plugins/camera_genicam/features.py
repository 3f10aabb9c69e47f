"""Features of a camera by their standard names (SFNC 1.x and 2.x), written only with their value read back."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from measureapp.errors import DeviceError, InputError, LimitError

from .link import CameraLink

SLOW_S = 15.0  # loading a user set
EXPOSURE = ("ExposureTime", "ExposureTimeAbs", "ExposureTimeRaw")
GAIN = ("Gain", "GainRaw")
DEBOUNCE = ("LineDebouncerTime", "LineDebouncerTimeAbs")
TEMPERATURE = ("DeviceTemperature", "TemperatureAbs")
READOUT = ("SensorReadoutTime", "ReadoutTimeAbs")
SHUTTER = ("SensorShutterMode", "ShutterMode")
FIRMWARE = ("DeviceFirmwareVersion", "DeviceVersion")
RELATIVE_TOLERANCE = 1e-3  # of read-back to written numbers that have no step


class Features:
    """The features of one camera."""

    def __init__(self, camera: str, link: CameraLink) -> None:
        self.camera = camera
        self.link = link

    def first(self, names: Iterable[str]) -> str | None:
        """Return the first of these features that the camera has; None: it has none of them."""
        return next((name for name in names if self.link.call("available", name)), None)

    def need(self, names: Iterable[str]) -> str:
        """Return the first of these features that the camera has. Raises DeviceError: it has none of them."""
        found = self.first(names := tuple(names))
        if found is None:
            raise DeviceError(f"Camera {self.camera} has no feature {' or '.join(names)}.", "Update its firmware, or use another driver.")
        return found

    def read(self, name: str) -> Any:
        """Read a feature."""
        return self.link.call("read", name)

    def read_first(self, names: Iterable[str]) -> Any:
        """Read the first of these features that the camera has; None: it has none of them."""
        name = self.first(names)
        return None if name is None else self.read(name)

    def write(self, name: str, value: Any) -> None:
        """Write a feature and read it back.

        Raises
        ------
        InputError
            An enumeration has no such value.
        DeviceError
            The camera refuses, ignores or changes the value.
        """
        if isinstance(value, str) and value not in (entries := self.link.call("entries", name)):
            raise InputError(
                f"Camera {self.camera}: {name} cannot be {value} (possible: {', '.join(entries) or 'nothing'}).", "Choose one."
            )
        self.link.call("write", name, value)
        read = self.read(name)
        if not _agree(value, read):
            raise DeviceError(f"Camera {self.camera}: {name} is {read} after {value} was written.", "Choose a value that the camera keeps.")

    def write_if_any(self, name: str, value: Any) -> None:
        """Write a feature that not every camera has."""
        if self.link.call("available", name):
            self.write(name, value)

    def write_number(self, names: Iterable[str], value: float) -> None:
        """Write the first of these numbers that the camera has, within its limits.

        Raises
        ------
        LimitError
            The value lies outside the camera's limits; nothing was written.
        DeviceError
            The camera has none of them, or reads back another value.
        """
        name = self.need(names)
        low, high, step = self.link.call("bounds", name)
        if not low <= value <= high:
            raise LimitError(f"Camera {self.camera} does not support {name} {value:g}.", f"Choose {low:g}…{high:g}.")
        wanted = round(value) if isinstance(low, int) else float(value)
        self.link.call("write", name, wanted)
        read = self.read(name)
        if abs(read - wanted) > max(step, RELATIVE_TOLERANCE * abs(wanted)):
            raise DeviceError(
                f"Camera {self.camera}: {name} is {read:g} after {wanted:g} was written.", "Choose a value that the camera keeps."
            )

    def load_user_set(self, name: str) -> None:
        """Load the settings stored in the camera under this name, where it stores any."""
        if name and self.link.call("available", "UserSetLoad"):
            self.write("UserSetSelector", name)
            self.link.call("execute", "UserSetLoad", timeout_s=SLOW_S)

    def all_triggers_off(self) -> None:
        """Switch every kind of trigger off, so that only the chosen one starts an exposure."""
        for entry in self.link.call("entries", "TriggerSelector") if self.link.call("available", "TriggerSelector") else ():
            self.write("TriggerSelector", entry)
            self.write("TriggerMode", "Off")

    def frame_trigger(self, source: str) -> None:
        """Let each rising edge of this source, or each software trigger, start one exposure."""
        self.write_if_any("TriggerSelector", "FrameStart")
        self.write("TriggerMode", "On")
        self.write("TriggerSource", source)
        if source != "Software":
            self.write_if_any("TriggerActivation", "RisingEdge")


def _agree(written: Any, read: Any) -> bool:
    if isinstance(written, float):
        return bool(abs(read - written) <= RELATIVE_TOLERANCE * max(1.0, abs(written)))
    return bool(read == written)
