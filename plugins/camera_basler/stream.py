"""The camera as pypylon sees it. These calls block as long as the library likes: the driver makes them on threads of its own."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import count
from typing import Any

from measureapp.data.rig import CameraDescription
from measureapp.devices.camera import Trigger
from measureapp.errors import DeviceError

from . import nodes as names
from .frames import Received, read_result
from .nodes import Nodes
from .opening import find_device, open_camera
from .settings import BaslerSettings
from .setup import SetUp, set_hardware_trigger, set_up

READY_S = 1.0  # after the start of the stream
COUNTERS = {
    "packets": "Statistic_Total_Packet_Count",
    "lost": "Statistic_Failed_Packet_Count",
    "resent": "Statistic_Resend_Packet_Count",
    "dropped_images": "Statistic_Buffer_Underrun_Count",
}
CONTEXTS = count(1)  # marks the results of each camera, which the library could mix up


@dataclass(frozen=True, slots=True)
class Counters:
    """Statistics of the stream; None where the transport has none."""

    packets: int | None = None
    lost: int | None = None
    resent: int | None = None
    dropped_images: int = 0


class PylonStream:
    """One camera of pypylon.

    Parameters
    ----------
    pylon : the module
    cameras_on_link : number of cameras that share the network link
    """

    def __init__(self, pylon: Any, described: CameraDescription, settings: BaslerSettings, cameras_on_link: int) -> None:
        self.described = described
        self.model, self.firmware, self.is_gige = described.model, "", False
        self._pylon, self._settings, self._cameras_on_link = pylon, settings, cameras_on_link
        self._context = next(CONTEXTS)
        self._camera: Any = None
        self._trigger: Trigger = "software"
        self._before: dict[str, int] = {}  # counters of earlier sequences: the library counts from zero in each

    def open(self) -> SetUp:
        """Find, open and set up the camera. Raises DeviceError."""
        factory = self._pylon.TlFactory.GetInstance()
        info = find_device(factory, self.described.name, self.described.serial)

        def attempt() -> None:
            self._camera = self._pylon.InstantCamera(factory.CreateDevice(info))
            self._camera.Open()

        open_camera(attempt, info, self.described.name, self._settings.open_retry_s)
        self._camera.SetCameraContext(self._context)
        self._nodes = Nodes(self.described.name, self._camera.GetNodeMap())
        self.model, self.is_gige = info.GetModelName(), bool(self._camera.IsGigE())
        firmware = self._nodes.find(("DeviceFirmwareVersion",))
        self.firmware = str(firmware.GetValue()) if firmware else "unknown"
        try:
            return set_up(self._nodes, self.described, self._settings, self._cameras_on_link)
        except Exception:
            self._camera.Close()
            raise

    def close(self) -> None:
        """End the stream and release the camera."""
        if self._camera is not None:
            self._camera.StopGrabbing()
            self._camera.Close()

    def write_exposure(self, exposure_us: int, step_us: int) -> float:
        """Set the exposure and return it as read back."""
        return self._nodes.write_number(names.EXPOSURE, exposure_us, step_us)

    def read_exposure(self) -> float:
        """Read the exposure back."""
        return self._nodes.number(names.EXPOSURE) or 0.0

    def start(self, frames: int, trigger: Trigger) -> None:
        """Start the stream, and wait until the camera accepts triggers."""
        self.end()
        if trigger != self._trigger:
            if trigger == "hardware":
                set_hardware_trigger(self._nodes, self._settings)
            else:
                self._nodes.write_word(("TriggerSource",), "Software")
            self._trigger = trigger
        self._camera.GetInstantCameraNodeMap().GetNode("MaxNumBuffer").SetValue(max(2, min(frames, self._settings.buffers)))
        self._camera.StartGrabbing(self._pylon.GrabStrategy_OneByOne)
        if not self.wait_ready(READY_S):
            raise DeviceError(f"Camera {self.described.name} does not accept triggers after {READY_S:g} s.", "Check its trigger settings.")

    def end(self) -> None:
        """End the stream."""
        if self._camera.IsGrabbing():
            self._before = self._counts()
            self._camera.StopGrabbing()

    def trigger(self) -> None:
        """Start an exposure."""
        self._camera.ExecuteSoftwareTrigger()

    def wait_ready(self, timeout_s: float) -> bool:
        """Wait until the camera accepts a trigger; at once where it cannot report this."""
        if not self._camera.CanWaitForFrameTriggerReady():
            return True
        return bool(self._camera.WaitForFrameTriggerReady(round(timeout_s * 1000), self._pylon.TimeoutHandling_Return))

    def retrieve(self, timeout_s: float) -> Received | None:
        """Wait for a grab result and copy it; None if there is none in time."""
        if not self._camera.IsGrabbing():
            raise RuntimeError("its stream has ended")
        result = self._camera.RetrieveResult(round(timeout_s * 1000), self._pylon.TimeoutHandling_Return)
        if not result.IsValid():
            return None
        try:
            if result.GetCameraContext() != self._context:
                raise DeviceError(f"Camera {self.described.name} got an image of another camera.", "Restart the program.")
            return read_result(result)
        finally:
            result.Release()

    def probe(self) -> None:
        """Read from the camera; raises an exception if it does not answer."""
        if self._camera.IsCameraDeviceRemoved():
            raise RuntimeError("it was removed")
        self.read_exposure()

    def temperature_c(self) -> float | None:
        """Read the thermometer at the camera's core board, or the only one."""
        if "Coreboard" in self._nodes.words(names.TEMPERATURE_SELECTOR[0]) + self._nodes.words(names.TEMPERATURE_SELECTOR[1]):
            self._nodes.write_word(names.TEMPERATURE_SELECTOR, "Coreboard")
        return self._nodes.number(names.TEMPERATURE)

    def counters(self) -> Counters:
        """Read the statistics since the camera was opened."""
        found = self._counts()
        return Counters(found.get("packets"), found.get("lost"), found.get("resent"), found.get("dropped_images", 0))

    def _counts(self) -> dict[str, int]:
        found = dict(self._before)
        if self._camera.IsGrabbing():
            stream = Nodes(self.described.name, self._camera.GetStreamGrabberNodeMap())
            for key, node in COUNTERS.items():
                value = stream.number((node,))
                if value is not None:
                    found[key] = found.get(key, 0) + int(value)
        return found
