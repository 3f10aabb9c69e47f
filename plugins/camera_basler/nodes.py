"""Settings of a camera by name: ace GigE cameras use the names of SFNC 1.x, newer ones those of 2.x."""

from __future__ import annotations

from dataclasses import dataclass
from math import isclose
from typing import Any

from measureapp.errors import DeviceError

Names = tuple[str, ...]

EXPOSURE: Names = ("ExposureTimeAbs", "ExposureTime")  # µs
EXPOSURE_STEP: Names = ("ExposureTimeBaseAbs",)  # µs of one raw step
GAIN: Names = ("GainRaw", "Gain")  # raw steps; dB
BLACK_LEVEL: Names = ("BlackLevelRaw", "BlackLevel")
SHUTTER: Names = ("ShutterMode", "SensorShutterMode")
GLOBAL_RESET: Names = ("GlobalResetReleaseModeEnable",)
READOUT: Names = ("ReadoutTimeAbs", "SensorReadoutTime")  # µs
DEBOUNCE: Names = ("LineDebouncerTimeAbs", "LineDebouncerTime")  # µs
TEMPERATURE: Names = ("TemperatureAbs", "DeviceTemperature")  # °C
TEMPERATURE_SELECTOR: Names = ("TemperatureSelector", "DeviceTemperatureSelector")
PACKET_SIZE: Names = ("GevSCPSPacketSize",)
PACKET_DELAY: Names = ("GevSCPD",)
TICK_RATE: Names = ("GevTimestampTickFrequency",)

ADVICE = "Check the driver's settings in the rig description, and the camera's model and firmware."


@dataclass(frozen=True, slots=True)
class Range:
    """What a numeric setting accepts."""

    low: float
    high: float
    step: float  # 0: any value


class Nodes:
    """A camera's node map; what is written is read back from the camera, not from a cache.

    Parameters
    ----------
    camera : name of the camera, for messages
    node_map : of pypylon
    """

    def __init__(self, camera: str, node_map: Any) -> None:
        self._camera, self._map = camera, node_map

    def find(self, names: Names) -> Any | None:
        """Return the first of these nodes that the camera has, or None."""
        for name in names:
            node = self._map.GetNode(name)
            if node is not None and (node.IsReadable() or node.IsWritable()):
                return node
        return None

    def has(self, *names: str) -> bool:
        """Return whether the camera has one of these nodes."""
        return self.find(names) is not None

    def number(self, names: Names) -> float | None:
        """Read a number from the camera; None if it has none of these nodes."""
        node = self.find(names)
        return None if node is None or not node.IsReadable() else float(node.GetValue(False, True))

    def range(self, names: Names) -> Range:
        """Read what a setting accepts."""
        node = self._need(names)
        step = float(node.GetInc()) if not hasattr(node, "HasInc") or node.HasInc() else 0.0
        return Range(float(node.GetMin()), float(node.GetMax()), step)

    def write_number(self, names: Names, value: float, step: float = 0.0) -> float:
        """Set a number and return it as read back; raises DeviceError if it differs by more than ``step`` or the camera's own step."""
        node = self._need(names)
        sent = int(value) if float(value).is_integer() else value  # nodes of integers accept nothing else
        found = float(self._write(node, names, sent).GetValue(False, True))
        if abs(found - value) > max(step, self.range(names).step) and not isclose(found, value, rel_tol=1e-4):
            raise self._differs(names, value, found)
        return found

    def write_word(self, names: Names, *words: str) -> str:
        """Set the first of ``words`` that the camera accepts, and return it; raises DeviceError if none is."""
        node = self._need(names)
        known = tuple(node.GetSymbolics())
        word = next((word for word in words if word in known), None)
        if word is None:
            raise DeviceError(f"Camera {self._camera} has no {names[0]} {' or '.join(words)} (it has: {', '.join(known)}).", ADVICE)
        found = str(self._write(node, names, word).ToString(False, True))
        if found != word:
            raise self._differs(names, word, found)
        return word

    def write_flag(self, names: Names, value: bool) -> None:
        """Switch something on or off, and read it back."""
        found = bool(self._write(self._need(names), names, value).GetValue(False, True))
        if found != value:
            raise self._differs(names, value, found)

    def execute(self, name: str) -> None:
        """Execute a command of the camera."""
        self._need((name,)).Execute()

    def words(self, name: str) -> tuple[str, ...]:
        """Return the choices of a setting; none if the camera does not have it."""
        node = self.find((name,))
        return () if node is None else tuple(node.GetSymbolics())

    def _need(self, names: Names) -> Any:
        node = self.find(names)
        if node is None:
            raise DeviceError(f"Camera {self._camera} has no setting {' or '.join(names)}.", ADVICE)
        return node

    def _write(self, node: Any, names: Names, value: object) -> Any:
        try:
            node.SetValue(value)
        except Exception as error:  # of pypylon: out of range, or locked
            whole = isinstance(error, TypeError)  # a fraction for a node of integers
            reason = "it needs a whole number" if whole else str(error).split(" : ")[0].rstrip(". ")
            raise DeviceError(f"Camera {self._camera} refused {names[0]} = {value}: {reason}.", ADVICE) from error
        return node

    def _differs(self, names: Names, value: object, found: object) -> DeviceError:
        return DeviceError(
            f"Camera {self._camera} reads back {names[0]} = {found} after {value} was set: it ignored or limited the value.",
            "Choose a value that the camera supports, and close other programs that may set it.",
        )
