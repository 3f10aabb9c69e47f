"""Basler cameras through pypylon. Every call into the library runs on a thread that may be left to a call that never returns."""

from __future__ import annotations

import time
from collections.abc import Callable
from functools import partial
from typing import TypeVar

from measureapp.data.conditions import LensSetting
from measureapp.data.rig import OTHER_DEVICES, RigDescription
from measureapp.devices.camera import Frame, StreamStatistics, Trigger
from measureapp.devices.link_budget import frame_s
from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, FrameError, LimitError, MeasureError, SequenceError

from .frames import BlockCounter, Received, check_complete
from .opening import load_pylon
from .settings import BaslerSettings
from .stream import Counters, PylonStream
from .worker import Blocked, Stopping, Waiting, Worker

T = TypeVar("T")
SLICE_S = 0.25  # of waiting inside the library, after which a stop is noticed there
PROBE_S = 1.0  # without an image, after which the camera is asked whether it is still there
CONNECT_S = 30.0
START_S = 2.0
CLOSE_S = 1.0
MUCH_RESENT = 1e-3  # of all packets
LOST_HINT = "Check its cable, its power and the network card, then connect again."


def connect(request: DeviceRequest) -> BaslerCamera:
    """Connect the camera that the rig description calls ``request.name``.

    Raises
    ------
    PluginError
        pypylon is not installed.
    DeviceError
        No camera with this serial number, another program holds it, or it does not accept the settings.
    """
    settings = request.settings
    assert isinstance(settings, BaslerSettings)
    described = request.rig.camera(request.name)
    stream = PylonStream(load_pylon(), described, settings, _cameras_on_link(request.rig, settings.link))
    return BaslerCamera(stream, settings)


def _cameras_on_link(rig: RigDescription, link: str) -> int:
    """Return how many of the rig's cameras share the link; drivers without this setting count as on the usual one."""
    usual = BaslerSettings().link
    cameras = [choice for name, choice in rig.devices.items() if name not in OTHER_DEVICES]
    return sum(choice.settings.get("link", usual) == link for choice in cameras) if cameras else len(rig.cameras)


class BaslerCamera:
    """One camera: triggers and settings go through one thread, images through another, so that neither waits for the other."""

    def __init__(self, stream: PylonStream, settings: BaslerSettings) -> None:
        described = stream.described
        self.name, self.serial = described.name, described.serial
        self.width_px, self.height_px, self.bit_depth = described.width_px, described.height_px, int(described.bit_depth)
        self.shutter = settings.shutter
        self._stream, self._answer_s = stream, settings.answer_s
        self._stopping = Stopping()
        self._control, self._images = Worker(f"{self.name} control"), Worker(f"{self.name} images")
        self._lost = ""
        self._is_closed = False
        self._blocks = BlockCounter()
        self._trigger: Trigger | None = None
        self._most = 0  # images of the sequence
        self._asked_us: list[int] = []  # exposure at each trigger of the program
        self._ready_at = 0.0
        self._ignored: int | None = None  # triggers that the camera ignored, as last reported
        self._frames = self._failed = 0
        try:
            with self._stopping.waiting() as waiting:
                found = self._control.call(stream.open, waiting, CONNECT_S + settings.open_retry_s)
        except BaseException as error:
            self._end_threads()
            if isinstance(error, Blocked):
                raise DeviceError(f"Camera {self.name} did not answer within {CONNECT_S:g} s of connecting.", LOST_HINT) from error
            raise
        self.readout_s, self.link = found.readout_s, found.link
        self.transfer_s = frame_s(found.link) if stream.is_gige else 0.0
        self.exposure_limits_us, self.exposure_step_us = found.exposure_limits_us, found.exposure_step_us
        self._found = found
        self._exposure_us = self.exposure_us()

    def set_exposure_us(self, exposure_us: int) -> None:
        """Set the exposure and read it back.

        Raises
        ------
        LimitError
            The camera does not support it; nothing is sent.
        DeviceError
            The camera reads another exposure back.
        """
        low, high = self.exposure_limits_us
        if not low <= exposure_us <= high:
            raise LimitError(f"Camera {self.name} does not support an exposure of {exposure_us} µs.", f"Choose {low}…{high} µs.")
        self._exposure_us = round(self._ask(lambda: self._stream.write_exposure(exposure_us, self.exposure_step_us)))

    def exposure_us(self) -> int:
        """Read the exposure back from the camera."""
        return round(self._ask(self._stream.read_exposure))

    def arm(self, frames: int, trigger: Trigger) -> None:
        """Begin a sequence of at most ``frames`` images; older ones are discarded."""
        self._trigger = None
        self._ask(lambda: self._stream.start(frames, trigger), START_S)
        self._blocks.begin()
        self._asked_us.clear()
        self._most, self._trigger, self._ready_at = frames, trigger, 0.0

    def trigger(self) -> None:
        """Start one exposure now."""
        if self._trigger != "software":
            raise DeviceError(f"Camera {self.name} is not armed for triggers by the program.", "Arm it first.")
        if len(self._asked_us) >= self._most:
            raise DeviceError(f"All {self._most} images of the sequence of camera {self.name} are triggered.", "Arm it for more images.")
        self._asked_us.append(self._exposure_us)
        self._ask(self._stream.trigger)
        self._ready_at = time.monotonic() + self._exposure_us * 1e-6 + self.readout_s

    def wait_ready(self, *, timeout_s: float) -> None:
        """Wait until the exposure has ended, its rows are read out and the camera accepts the next trigger.

        After a trigger of the program this takes at least exposure and read-out, also where the camera reports to be ready earlier. The time of
        a hardware trigger is not known: exposure and read-out count from this call.
        """
        now = time.monotonic()
        end = now + timeout_s
        if self._trigger == "hardware":
            self._ready_at = now + self._exposure_us * 1e-6 + self.readout_s
        with self._stopping.waiting() as waiting:
            waiting.until(lambda: False, max(0.0, min(self._ready_at, end) - now))
            while (left := end - time.monotonic()) > 0.0:
                wait_s = min(left, SLICE_S)
                if self._call(self._control, partial(self._stream.wait_ready, wait_s), waiting, wait_s):
                    return
            self._probe(waiting)
        raise DeviceTimeout(f"Camera {self.name} did not become ready within {timeout_s:g} s.", "Lengthen the time between triggers.")

    def next_frame(self, *, timeout_s: float) -> Frame:
        """Wait for the next image of the sequence.

        Raises
        ------
        FrameError
            The image is damaged, incomplete or exposed otherwise than requested; the sequence goes on.
        SequenceError
            A repeated or surplus image, or a trigger that the camera ignored.
        DeviceTimeout
            No image in time, and the camera answers.
        DeviceLost
            The camera does not answer.
        """
        if self._trigger is None:
            raise DeviceError(f"Camera {self.name} is not armed.", "Arm it first.")
        received = self._receive(timeout_s)
        try:
            frame = self._accept(received)
        except FrameError as error:
            self._failed += 1
            hint = "Check its trigger line." if isinstance(error, SequenceError) else "Check its cable, packet size and inter-packet delay."
            raise type(error)(f"Camera {self.name}: {error.message}.", hint) from error
        self._frames += 1
        return frame

    def disarm(self) -> None:
        """End the sequence; images not taken from it are discarded."""
        was_armed, self._trigger = self._trigger is not None, None
        if was_armed and not self._lost and not self._is_closed:
            self._ask(self._stream.end)

    def statistics(self) -> StreamStatistics:
        """Read the counters of the stream since the camera was connected."""
        return self._statistics(self._ask(self._stream.counters))

    def _statistics(self, counted: Counters) -> StreamStatistics:
        return StreamStatistics(self._frames, self._failed + counted.dropped_images, counted.resent, counted.lost, counted.packets)

    def temperature_c(self) -> float | None:
        """Read the temperature of the housing; None if the camera has no thermometer."""
        return self._ask(self._stream.temperature_c)

    def lens(self) -> LensSetting:
        """Read the lens setting back: empty, for a manual lens."""
        return LensSetting()

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        identity = f"{self._stream.model} {self.serial}, firmware {self._stream.firmware}"
        unheard = Waiting()  # a stop of the rig does not concern who displays the state
        try:
            exposure_us = self._call(self._control, self._stream.read_exposure, unheard, SLICE_S)
            counted = self._call(self._control, self._stream.counters, unheard, SLICE_S)
        except MeasureError as error:
            return DeviceStatus(False, error.message, error.hint, identity)
        text = (
            f"{self.width_px} × {self.height_px} px, {self._found.pixel_format}, {self.shutter} shutter, exposure {exposure_us / 1000:g} ms"
        )
        if (resent := self._statistics(counted).resend_share) and resent > MUCH_RESENT:
            text += f"; {100 * resent:.2f} % of the packets were sent again: check cable, switch and inter-packet delay"
        return DeviceStatus(True, text, identity=identity)

    def stop(self) -> None:
        """Cancel the calls that wait, from any thread, also while the library blocks; later calls are not affected."""
        self._stopping.stop()

    def close(self) -> None:
        """Release the camera; a call of the library that does not return is left to its thread. Harmless when repeated."""
        if self._is_closed:
            return
        self._is_closed, self._trigger = True, None
        self._stopping.stop()
        try:
            with self._stopping.waiting() as waiting:
                self._control.call(self._stream.close, waiting, CLOSE_S)
        except Exception:  # blocked, or pylon refuses to release what is gone: nothing is left to do
            self._lost = self._lost or f"Camera {self.name} could not be released."
        self._end_threads()

    def _receive(self, timeout_s: float) -> Received:
        """Wait for a grab result, and ask the camera whether it is there when none comes."""
        end, probe_at = time.monotonic() + timeout_s, time.monotonic() + PROBE_S
        with self._stopping.waiting() as waiting:
            while True:
                wait_s = max(0.0, min(SLICE_S, end - time.monotonic()))
                received = self._call(self._images, partial(self._stream.retrieve, wait_s), waiting, wait_s)
                if received is not None:
                    return received
                now = time.monotonic()
                if now >= min(probe_at, end):
                    self._probe(waiting)
                    probe_at = now + PROBE_S
                if now >= end:
                    sent = f" after {len(self._asked_us)} triggers" if self._trigger == "software" else ""
                    raise DeviceTimeout(
                        f"Camera {self.name} delivered no image within {timeout_s:g} s{sent}.",
                        "Check its trigger and the load of its link.",
                    )

    def _accept(self, received: Received) -> Frame:
        """Check a grab result, and number it."""
        try:
            check_complete(received, self._found.image_bytes)
        except FrameError:
            self._blocks.skip()
            raise
        number = self._blocks.number(received.block_id)
        self._check_count(number, received)
        exposure_us = self._check_exposure(number, received)
        assert received.pixels is not None  # it succeeded
        device_time_s = received.ticks / self._found.tick_hz if received.ticks else None
        return Frame(received.pixels, self.serial, number, exposure_us, device_time_s)

    def _check_count(self, number: int, received: Received) -> None:
        before, self._ignored = self._ignored, received.ignored_triggers
        if before is not None and self._ignored is not None and self._ignored > before:
            raise SequenceError(f"{self._ignored - before} triggers came while it was busy and were ignored")
        if self._trigger == "software" and number >= len(self._asked_us):
            raise SequenceError(f"it sent image {number + 1} after {len(self._asked_us)} triggers")
        if number >= self._most:
            raise SequenceError(f"it sent image {number + 1} of a sequence of {self._most}")

    def _check_exposure(self, number: int, received: Received) -> int | None:
        """Return the exposure of an image: sent with it, else as set for its trigger, and None for a trigger on the line."""
        asked_us = self._asked_us[number] if self._trigger == "software" else None
        if received.exposure_us is not None:
            found_us = round(received.exposure_us)
            if asked_us is not None and abs(found_us - asked_us) > self.exposure_step_us:
                raise FrameError(f"image {number} was exposed for {found_us} µs, not {asked_us} µs")
            return found_us
        read_us = round(self._ask(self._stream.read_exposure))
        if abs(read_us - self._exposure_us) > self.exposure_step_us:
            raise FrameError(f"its exposure reads {read_us} µs, and {self._exposure_us} µs was set")
        return asked_us

    def _probe(self, waiting: Waiting) -> None:
        """Raise DeviceLost if the camera does not answer."""
        try:
            self._control.call(self._stream.probe, waiting, self._answer_s)
        except Blocked as error:
            raise self._lose("a call has not returned") from error
        except Exception as error:  # of pylon
            raise self._lose(_first_words(error)) from error

    def _ask(self, work: Callable[[], T], busy_s: float = SLICE_S) -> T:
        """Run a call on the control thread; a stop cancels the wait for it."""
        with self._stopping.waiting() as waiting:
            return self._call(self._control, work, waiting, busy_s)

    def _call(self, worker: Worker, work: Callable[[], T], waiting: Waiting, busy_s: float) -> T:
        """Run a call of the library that lasts ``busy_s`` at most; one that blocks means that the camera is lost."""
        if self._lost or self._is_closed:
            raise DeviceLost(self._lost or f"Camera {self.name} is closed.", LOST_HINT)
        try:
            return worker.call(work, waiting, busy_s + self._answer_s)
        except MeasureError:
            raise
        except Blocked as error:
            raise self._lose("a call has not returned") from error
        except Exception as error:  # of pylon, which has few types
            self._probe(waiting)
            raise DeviceError(f"Camera {self.name} failed: {_first_words(error)}.", LOST_HINT) from error

    def _lose(self, reason: str) -> DeviceLost:
        self._lost = self._lost or f"Camera {self.name} ({self.serial}) does not answer any more: {reason}."
        return DeviceLost(self._lost, LOST_HINT)

    def _end_threads(self) -> None:
        for worker in (self._control, self._images):
            worker.finish(SLICE_S + 0.1)


def _first_words(error: Exception) -> str:
    """Return an error of pylon without the place in its source code."""
    return str(error).split(" : ")[0].rstrip(". ")
