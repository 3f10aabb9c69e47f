"""A LightCrafter 4500 whose patterns come through its video port: a screen shows them, the controller displays their green channel."""

from __future__ import annotations

import contextlib

from pydantic import ValidationError

from measureapp.arrays import ImageArray
from measureapp.data.model import first_problem
from measureapp.devices.attempt import Stops
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.projector import DARK, Projector
from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, InputError, MeasureError

from .controller import Controller, TriggerEdge
from .link import Link
from .registers import BY_VSYNC, EXTERNAL_TRIGGER, FROM_VIDEO, LEDS, SHORTEST_EXPOSURE_US
from .sequence import PatternEntry, PatternSequence, check_times
from .settings import LightCrafterSettings

CONFIGURE_TIMEOUT_S, START_TIMEOUT_S = 5.0, 1.0
SYNC_GAP_US = 500  # from the end of the exposure to the next vertical synchronisation


class VideoLightCrafter:
    """Shows what the screen at its video port shows, linearly: one pattern of 8 bits with each video frame."""

    def __init__(self, request: DeviceRequest, settings: LightCrafterSettings, link: Link, controller: Controller) -> None:
        self._screen = _connect_screen(request, settings)
        self._link, self._controller = link, controller
        self._stops, self._poll_s = Stops(), settings.poll_s
        try:
            self._begin(settings)
        except BaseException:
            self._screen.close()
            raise
        self.name, self.frame_us = self._screen.name, self._screen.frame_us
        self.width_px, self.height_px = self._screen.width_px, self._screen.height_px

    def load(self, images: ImageArray) -> None:
        """Load a sequence; raises as the driver of the screen does."""
        self._screen.load(images)

    def show(self, index: int, *, timeout_s: float) -> None:
        """Show an image of the sequence, PLAIN_LIGHT or DARK; raises as the driver of the screen does."""
        self._light(on=index != DARK)
        self._screen.show(index, timeout_s=timeout_s)

    def shown(self) -> int:
        """Read back what the screen shows; DARK when the projector does not display it."""
        return self._screen.shown() if self._controller.is_playing() else DARK

    def status(self) -> DeviceStatus:
        """Read the state of projector and screen, for display."""
        try:
            problem = self._controller.status().problem
        except MeasureError as error:
            return DeviceStatus(False, error.message, error.hint)
        return DeviceStatus(False, problem, "Switch it off and on again.") if problem else self._screen.status()

    def stop(self) -> None:
        """Switch the light off now, from any thread."""
        self._stops.stop()
        self._controller.darken_at_once()
        self._screen.stop()
        self._controller.check_dark()

    def close(self) -> None:
        """Switch the light off and release projector and screen. Harmless when repeated."""
        with contextlib.suppress(DeviceError):  # lost or closed before: there is nothing to switch off
            self._controller.darken_at_once()
        self._screen.close()
        self._link.close()

    def _begin(self, settings: LightCrafterSettings) -> None:
        """Display the green channel of every video frame, once a frame, until stopped."""
        entry = PatternEntry(0, 8, LEDS[settings.led], trigger=EXTERNAL_TRIGGER, swap=True)
        lit_us = self._screen.frame_us - SYNC_GAP_US
        if lit_us < SHORTEST_EXPOSURE_US[8]:
            raise InputError(
                f"{self._controller.name}: the screen at its video port has a frame time of {self._screen.frame_us} µs, too short for 8 bits.",
                f"Set the screen to a frame time of {SHORTEST_EXPOSURE_US[8] + SYNC_GAP_US} µs or more, such as 60 Hz.",
            )
        self._sequence = PatternSequence((entry,), (), lit_us, lit_us, repeat=True)
        check_times(self._sequence, self._controller.name, {})
        self._edge = TriggerEdge(settings.trigger_delay_us, settings.trigger_inverted)
        self._configure()

    def _configure(self) -> None:
        attempt = self._stops.begin(f"Preparing the video port of {self._controller.name}", CONFIGURE_TIMEOUT_S)
        self._controller.configure(self._sequence, FROM_VIDEO, BY_VSYNC, self._edge, attempt)

    def _light(self, *, on: bool) -> None:
        """Display the video, or nothing."""
        if not on:
            self._controller.darken()
        elif not self._controller.is_playing():
            attempt = self._stops.begin(f"Starting {self._controller.name}", START_TIMEOUT_S)
            self._controller.start(attempt)
            while not self._controller.is_playing():
                attempt.wait(self._poll_s)


def _connect_screen(request: DeviceRequest, settings: LightCrafterSettings) -> Projector:
    """Connect the driver that shows images on the screen at the video port. Raises InputError, DeviceError, PluginError."""
    choice = settings.video
    loaded = load_driver(None, choice.driver, "projector")
    try:
        chosen = loaded.settings.model_validate(dict(choice.settings))
    except ValidationError as error:
        raise InputError(
            f"Rig {request.rig.name}: the settings of the screen at the video port: {first_problem(error, 'the settings')}.",
            "Correct the setting video.",
        ) from error
    screen: Projector = loaded.entry(DeviceRequest(request.name, request.rig, chosen, request.links))
    return screen
