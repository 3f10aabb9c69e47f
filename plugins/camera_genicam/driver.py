"""A GenICam camera (GigE Vision, USB3 Vision) as a `measureapp.devices.camera.Camera`."""

from __future__ import annotations

import threading
import time
from typing import Any

from measureapp.data.conditions import LensSetting
from measureapp.data.rig import CameraDescription
from measureapp.devices.camera import Frame, StreamStatistics, Trigger
from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, DeviceTimeout, FrameError, LimitError
from measureapp.progress import Cancelled

from .features import TEMPERATURE, Features
from .link import CameraLink
from .pixels import Bytes, image
from .sequence import FrameNumbers
from .set_up import set_up
from .settings import GenicamSettings

DISCOVERY_S, OPENING_S = 10.0, 20.0
PAGE = 4096
LOOK_S = 0.02  # how often a waiting call looks whether it was stopped
RETAKE = "Take it again. If it happens often: larger packets, a longer packet delay, larger network buffers (README of the driver)."
READY_LOOK_S = 0.002
ASK_S = 0.5  # how often a camera is asked whether it is there while no image arrives
STATUSES = {2: "incomplete after a time-out", 3: "incomplete", 4: "with packets of another image", 5: "of the wrong size", 7: "aborted"}


def connect(request: DeviceRequest) -> GenicamCamera:
    """Connect the camera that has the serial number of the rig description.

    Raises
    ------
    PluginError
        Aravis is not installed.
    DeviceError
        No such camera is there, another program controls it, or it refuses a setting.
    InputError
        The camera does not offer what the settings or the rig description require.
    """
    description, settings = request.rig.camera(request.name), request.settings
    assert isinstance(settings, GenicamSettings)
    link = CameraLink(request.name)
    try:
        open_by_serial(link, description, settings.control_wait_s)
        return GenicamCamera(description, settings, link)
    except BaseException:
        link.close()
        raise


def open_by_serial(link: CameraLink, description: CameraDescription, wait_s: float) -> None:
    """Find the camera and take control of it, waiting while another program has it. Raises DeviceError."""
    found = link.call("cameras", timeout_s=DISCOVERY_S)
    chosen = next((one for one in found if one["serial"] == description.serial), None)
    if chosen is None:
        listed = ", ".join(f"{one['vendor']} {one['model']} {one['serial']} at {one['address']}" for one in found) or "none"
        raise DeviceError(
            f"Camera {description.name}: no camera with serial number {description.serial} was found (found: {listed}).",
            "Correct the serial number in the rig description, or check power, cable and the network address of the camera.",
        )
    owner = link.call("open", chosen["id"], wait_s, timeout_s=OPENING_S + wait_s)
    if owner != "me":
        who = f"A program on {owner}" if owner else "Another program"
        raise DeviceError(
            f"{who} controls camera {description.name} ({description.serial}).",
            "Close that program. If it crashed, wait a few seconds, then connect again.",
        )


class GenicamCamera:
    """One camera, opened through a link."""

    def __init__(self, description: CameraDescription, settings: GenicamSettings, link: CameraLink) -> None:
        self.name, self.serial = description.name, description.serial
        self.width_px, self.height_px, self.bit_depth = description.width_px, description.height_px, int(description.bit_depth)
        self._settings, self._link = settings, link
        self._features = Features(description.name, link)
        self._facts = facts = set_up(self._features, description, settings)
        self.shutter, self.readout_s, self.transfer_s = facts.shutter, facts.readout_s, facts.transfer_s
        self.exposure_limits_us, self.exposure_step_us = facts.exposure_limits_us, facts.exposure_step_us
        link.share(settings.buffers, -(-facts.payload_bytes // PAGE) * PAGE)
        self._armed: Trigger | None = None
        self._started_by: Trigger = "software"  # images of the sequence, or of the last one
        self._stopped = threading.Event()
        self._numbers, self._sequence, self._wanted = FrameNumbers(), 0, 0
        self._exposure_us = self.exposure_us()  # as last read back
        self._exposures_us: list[int] = []  # of the software triggers of the sequence
        self._triggered_s = 0.0
        self._frames = self._failed = 0

    def set_exposure_us(self, exposure_us: int) -> None:
        """Set the exposure. Raises LimitError when the camera does not support it."""
        low, high = self.exposure_limits_us
        if not low <= exposure_us <= high:
            raise LimitError(f"Camera {self.name} does not support an exposure of {exposure_us} µs.", f"Choose {low}…{high} µs.")
        self._features.write_number((self._facts.exposure,), exposure_us)
        self._exposure_us = self.exposure_us()

    def exposure_us(self) -> int:
        """Read the exposure back, rounded to µs."""
        return round(self._features.read(self._facts.exposure))

    def arm(self, frames: int, trigger: Trigger) -> None:
        """Begin a sequence of at most ``frames`` images, each started by one trigger; numbers begin at 0. Discards older images."""
        self.disarm()
        self._stopped.clear()
        self._features.frame_trigger("Software" if trigger == "software" else self._settings.trigger_line)
        self._sequence += 1
        self._numbers.begin(self._triggers)
        self._exposures_us, self._wanted, self._started_by = [], frames, trigger
        self._exposure_us = self.exposure_us()
        self._link.call("start", self._sequence, self._facts.exposure_chunk)
        self._armed = trigger

    def trigger(self) -> None:
        """Start one exposure now and return at once. Raises DeviceError when the camera is not armed for software triggers."""
        if self._armed != "software":
            raise DeviceError(f"Camera {self.name} is not armed for software triggers.", "Arm it first.")
        self._exposures_us.append(self._exposure_us)
        self._triggered_s = time.monotonic()
        self._link.call("execute", "TriggerSoftware", stopped=self._stopped.is_set)

    def wait_ready(self, *, timeout_s: float) -> None:
        """Wait until the started exposure has ended, its rows are read out, and the next trigger is accepted. Raises DeviceTimeout."""
        started_s = self._triggered_s if self._armed == "software" else time.monotonic()
        read_out_s = started_s + self._exposure_us * 1e-6 + self.readout_s
        end_s = time.monotonic() + timeout_s
        while time.monotonic() < read_out_s or not self._accepts_trigger():
            if time.monotonic() >= end_s:
                raise self._timeout("was not ready for the next trigger", timeout_s)
            if self._stopped.wait(max(READY_LOOK_S, min(read_out_s, end_s) - time.monotonic())):
                raise Cancelled

    def next_frame(self, *, timeout_s: float) -> Frame:
        """Wait for the next image of the sequence.

        Raises
        ------
        FrameError
            The image arrived damaged or incomplete and was discarded; the sequence goes on with the following one.
        DeviceTimeout
            No image arrived in time.
        DeviceLost
            The camera does not answer any more.
        """
        if self._armed is None:
            raise DeviceError(f"Camera {self.name} is not armed.", "Arm it first.")
        end = time.monotonic() + timeout_s
        asked = time.monotonic()
        while True:
            found = self._link.frame(LOOK_S)
            if self._stopped.is_set():
                raise Cancelled
            if found is not None and found["sequence"] == self._sequence:
                return self._frame(found)
            now = time.monotonic()
            if now >= min(end, asked + ASK_S):
                self._link.call("alive", stopped=self._stopped.is_set)  # a lost camera is not a late one
                asked = now
            if now >= end:
                raise self._timeout("sent no image", timeout_s)

    @property
    def _triggers(self) -> int:
        """Number of images that the sequence, or the last one, should have given so far."""
        return len(self._exposures_us) if self._started_by == "software" else self._wanted

    def disarm(self) -> None:
        """End the sequence; images not taken from it are discarded. Harmless without one."""
        if self._armed is not None:
            self._armed = None
            self._link.call("stop")

    def statistics(self) -> StreamStatistics:
        """Read the counters of the stream; for USB3 Vision there are no packets."""
        counted = self._link.call("statistics")
        return StreamStatistics(
            self._frames,
            self._failed,
            counted.get("n_resent_packets"),
            counted.get("n_missing_packets"),
            counted.get("n_received_packets"),
        )

    def temperature_c(self) -> float | None:
        """Read the temperature of the camera's housing; None if it has no thermometer."""
        value = self._features.read_first(TEMPERATURE)
        return None if value is None else float(value)

    def lens(self) -> LensSetting:
        """Read the lens setting back: empty, for a manual lens."""
        return LensSetting()

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        try:
            self._link.call("alive")
        except DeviceError as error:
            return DeviceStatus(False, error.message, error.hint, self._facts.identity)
        text = f"{self.width_px} × {self.height_px} px, {self.bit_depth} bit, " + ("armed" if self._armed else "ready")
        text = "; ".join(filter(None, (text, self.statistics().warning)))
        return DeviceStatus(True, text, identity=self._facts.identity)

    def stop(self) -> None:
        """Stop now, from any thread: a waiting call then raises Cancelled, and so do all others of this sequence."""
        self._stopped.set()

    def close(self) -> None:
        """Release the camera for other programs. Harmless when repeated."""
        self._stopped.set()
        self._armed = None
        self._link.close()

    def _accepts_trigger(self) -> bool:
        return not self._facts.reports_ready or bool(self._link.call("read", "AcquisitionStatus", stopped=self._stopped.is_set))

    def _frame(self, found: dict[str, Any]) -> Frame:
        """Copy an image out of the shared memory, check it, and let its place be filled again. Raises FrameError."""
        try:
            triggers = self._triggers
            if found["status"] != 0 or not found["size"]:
                self._numbers.damaged(found["block"], triggers)
                reason = STATUSES.get(found["status"], "damaged")
                raise FrameError(
                    f"An image arrived {reason}.", "Take it again. If it happens often: larger packets, a longer packet delay."
                )
            number = self._numbers.number(found["block"], triggers)
            self._check_layout(found)
            exposure_us = self._exposure_of(number, found["exposure_us"])
            pixels = image(self._raw(found), self._facts.pixel_format, self.width_px, self.height_px)
        except FrameError as error:
            self._failed += 1
            raise type(error)(f"Camera {self.name}: {error.message}", error.hint) from error
        finally:
            self._link.call("give_back", found["slot"], self._sequence)
        self._frames += 1
        return Frame(pixels, self.serial, number, exposure_us, 1e-9 * found["time_ns"])

    def _raw(self, found: dict[str, Any]) -> Bytes:
        """Return the bytes of the pixels, which come first where chunks follow."""
        pixel_bytes = self._facts.pixel_format.size_bytes(self.width_px * self.height_px)
        return self._link.raw(found["start"], min(found["size"], pixel_bytes) if self._facts.exposure_chunk else found["size"])

    def _check_layout(self, found: dict[str, Any]) -> None:
        """Refuse an image that has not the size and format set."""
        layout = (found["width"], found["height"], found["format"])
        if layout != (self.width_px, self.height_px, self._facts.pixel_format.code):
            raise FrameError(f"An image has size and format {layout}, which were not set.", "Connect the camera again.")

    def _exposure_of(self, number: int, measured_us: float | None) -> int | None:
        """Return the exposure of an image: as it carries it, else as it was set at its software trigger; None for one started by the line.

        Raises FrameError for an image that was exposed otherwise than set at its trigger, or does not carry what it should.
        """
        set_us = self._exposures_us[number] if self._armed == "software" else None
        if not self._facts.exposure_chunk:
            return set_us
        if measured_us is None or (set_us is not None and abs(measured_us - set_us) > self.exposure_step_us):
            raise FrameError(f"An image was exposed for {measured_us} µs instead of {set_us} µs.", "Take it again.")
        return round(measured_us)

    def _timeout(self, what: str, timeout_s: float) -> DeviceTimeout:
        return DeviceTimeout(f"Camera {self.name} {what} within {timeout_s:g} s.", "Check trigger and exposure; allow more time.")
