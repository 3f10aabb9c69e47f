"""A LightCrafter 4500 that plays patterns from its flash."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.devices.attempt import Attempt, Stops
from measureapp.devices.projector import DARK, PLAIN_LIGHT, Projector
from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, InputError, MeasureError

from .controller import Controller, TriggerEdge
from .link import HidDevice, Link
from .registers import BY_ITSELF, FROM_FLASH, HEIGHT_PX, LEDS, WIDTH_PX
from .sequence import PatternSequence, check_times, hold_pattern, hold_white, pattern_hash, play_patterns
from .settings import FlashedPatterns, LightCrafterSettings
from .usb import open_projector
from .video import VideoLightCrafter

CONFIGURE_TIMEOUT_S = 5.0
LOAD_TIME_TIMEOUT_S = 3.0  # of one image
FIRST_IMAGE_S = 0.25  # until the first image is loaded, where it was not measured
EARLY_S = 0.05  # by which the start may have been noticed late
LATE_S = 0.5  # after which a sequence must have begun, or ended

Open = Callable[[str, str], HidDevice]


def connect(request: DeviceRequest, open_device: Open = open_projector) -> Projector:
    """Connect a LightCrafter 4500.

    Parameters
    ----------
    open_device : opens the USB interface by name and serial number

    Raises
    ------
    InputError
        The rig describes a projector of another size, or flash images that do not exist.
    DeviceError
        There is no projector, it does not answer, or it reports a fault.
    """
    settings = request.settings
    if not isinstance(settings, LightCrafterSettings):
        raise InputError(f"{request.name}: the settings are not those of a LightCrafter.", "Load them with this driver's model.")
    description = request.rig.projector
    if (description.width_px, description.height_px) != (WIDTH_PX, HEIGHT_PX):
        raise InputError(
            f"Rig {request.rig.name}: the projector has {description.width_px} × {description.height_px} px, and a LightCrafter 4500 "
            f"{WIDTH_PX} × {HEIGHT_PX}.",
            "Correct the rig description, or choose another driver.",
        )
    name = description.name
    link = Link(open_device(name, settings.serial), name, settings.reply_timeout_s)
    try:
        controller = Controller(link, settings.poll_s)
        controller.wake(Stops().begin(f"Waking {name}", settings.wake_timeout_s))
        _check_health(controller, settings)
        controller.prepare(Stops().begin(f"Preparing {name}", CONFIGURE_TIMEOUT_S))
        if settings.led_current:
            controller.set_led_current(settings.led_current)
        if settings.source == "video":
            return VideoLightCrafter(request, settings, link, controller)
        frame_us = settings.hold_cycle_us if request.rig.head.sequence == "software" else 0
        return LightCrafter(name, settings, link, controller, frame_us)
    except BaseException:
        link.close()
        raise


def _check_health(controller: Controller, settings: LightCrafterSettings) -> None:
    problem = controller.status().problem
    if problem:
        raise DeviceError(f"{controller.name} reports a fault: {problem}.", "Switch it off and on again; if it stays so, it is defective.")
    if settings.source == "flash":
        present = controller.flash_images()
        wrong = [f"{one.name}: image {image}" for one in settings.flash for image in one.images if image >= present]
        if wrong:
            raise InputError(
                f"{controller.name} has {present} images in flash, and the settings name others ({', '.join(wrong)}).",
                "Correct the setting flash, or program the images with the vendor's tool.",
            )


class LightCrafter:
    """Patterns from flash: held one at a time, or played with a trigger pulse each."""

    gated = True  # a black field follows every exposure

    def __init__(self, name: str, settings: LightCrafterSettings, link: Link, controller: Controller, frame_us: int) -> None:
        self.name, self.width_px, self.height_px = name, WIDTH_PX, HEIGHT_PX
        self.frame_us = frame_us
        self._settings, self._link, self._controller = settings, link, controller
        self._leds = LEDS[settings.led]
        self._edge = TriggerEdge(settings.trigger_delay_us, settings.trigger_inverted)
        self._identity = f"{settings.serial or 'LightCrafter 4500'}, firmware {controller.version()}"
        self._stops = Stops()
        self._flashed: FlashedPatterns | None = None
        self._count = 0
        self._load_s: dict[int, float] = {}
        self._held = DARK
        self._played: tuple[PatternSequence, float] | None = None  # the last one played, and when it was seen to begin

    def load(self, images: ImageArray) -> None:
        """Choose the flash images that hold this sequence (count, height, width).

        Raises
        ------
        DeviceError
            Wrong size, or a pattern set that is not declared to be in flash.
        """
        images = np.asarray(images)
        if images.ndim != 3 or images.shape[1:] != (HEIGHT_PX, WIDTH_PX) or images.dtype != np.uint8:
            raise DeviceError(
                f"{self.name} does not support images of shape {images.shape} and type {images.dtype}.",
                f"Give 8-bit images of {WIDTH_PX} × {HEIGHT_PX} px.",
            )
        flashed = self._find(pattern_hash(images), len(images))
        attempt = self._stops.begin(f"Loading {flashed.name} into {self.name}", CONFIGURE_TIMEOUT_S + LOAD_TIME_TIMEOUT_S * len(images))
        self._controller.darken()
        self._held, self._played = DARK, None
        for image in sorted(set(flashed.images) - set(self._load_s)):
            self._load_s[image] = self._controller.load_time_s(image, attempt)
        self._flashed, self._count = flashed, len(images)

    def show(self, index: int, *, timeout_s: float) -> None:
        """Hold image ``index``, PLAIN_LIGHT or DARK, and wait until it is lit and stable."""
        if not DARK <= index < self._count:
            raise DeviceError(f"{self.name} has {self._count} images and cannot show image {index}.", "Load the pattern set first.")
        if index == DARK:
            self._controller.darken()
            self._held = DARK
        elif self.shown() != index:
            self._hold(index, self._stops.begin(f"Showing image {index} on {self.name}", timeout_s))

    def shown(self) -> int:
        """Read back the index of the image shown; DARK when the sequencer does not run."""
        return self._held if self._controller.is_playing() else DARK

    def play(self, first: int, count: int, *, exposure_us: int, period_us: int) -> None:
        """Play images once, dark between them, with a pulse of trigger output 1 each; returns when the sequence has started."""
        if count < 1 or first < 0 or first + count > self._count or self._flashed is None:
            raise DeviceError(
                f"{self.name} has {self._count} images and cannot play {first}…{first + count - 1}.", "Load the pattern set first."
            )
        sequence = play_patterns(first, count, self._flashed.images, self._leds, exposure_us=exposure_us, period_us=period_us)
        check_times(sequence, self.name, self._load_s)
        attempt = self._stops.begin(f"Starting the patterns of {self.name}", CONFIGURE_TIMEOUT_S)
        self._held, self._played = DARK, None
        self._controller.configure(sequence, FROM_FLASH, BY_ITSELF, self._edge, attempt)
        self._controller.start(attempt)
        self._played = (sequence, self._wait_for_start(sequence, attempt))

    def triggers_sent(self) -> int:
        """Return the number of trigger pulses since the last `play`.

        The controller counts no pulses: while the sequence plays, the number follows from the time; once the sequencer has ended
        without a fault, it is the length of the table that was read back.

        Raises
        ------
        DeviceError
            The sequence was aborted, or still plays after its end: the number is unknown.
        """
        if self._played is None:
            return 0
        sequence, began_s = self._played
        elapsed_s, problem, plays = time.monotonic() - began_s, self._controller.status().problem, self._controller.is_playing()
        count, period_s = len(sequence.entries), sequence.period_us * 1e-6
        if problem:
            raise DeviceError(f"{self.name} reports a fault: {problem}. The number of its trigger pulses is unknown.", "Play again.")
        if not plays and elapsed_s < (count - 1) * period_s - EARLY_S:
            raise DeviceError(
                f"{self.name} stopped {elapsed_s:.2f} s after the start of a sequence of {count * period_s:.2f} s: the number of its trigger "
                "pulses is unknown.",
                "Play again.",
            )
        if not plays:
            return count
        if elapsed_s > count * period_s + FIRST_IMAGE_S + LATE_S:
            raise DeviceError(
                f"{self.name} still plays {elapsed_s:.2f} s after the start of a sequence of {count * period_s:.2f} s: it repeats "
                "the patterns, and the number of its trigger pulses is unknown.",
                "Update its firmware; this one takes the command for one run as the one for repetition.",
            )
        return min(count, 1 + int(elapsed_s / period_s))

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        try:
            found, plays = self._controller.status(), self._controller.is_playing()
        except MeasureError as error:
            return DeviceStatus(False, error.message, error.hint, self._identity)
        if found.problem:
            return DeviceStatus(False, found.problem, "Switch it off and on again.", self._identity)
        patterns = f"{self._flashed.name}, {self._count} images" if self._flashed else "no patterns loaded"
        return DeviceStatus(True, f"{'lit' if plays else 'dark'}, {patterns}", identity=self._identity)

    def stop(self) -> None:
        """Switch the light off now, from any thread; a waiting call then raises Cancelled."""
        self._stops.stop()
        self._controller.darken_at_once()
        self._controller.check_dark()

    def close(self) -> None:
        """Switch the light off and release the projector. Harmless when repeated."""
        self._stops.stop()
        with contextlib.suppress(DeviceError):  # lost or closed before: there is nothing to switch off
            self._controller.darken_at_once()
        self._link.close()

    def _find(self, identity: str, count: int) -> FlashedPatterns:
        """Return the declared pattern set with this identity. Raises DeviceError."""
        known = ", ".join(f"{one.name} ({one.hash})" for one in self._settings.flash) or "none"
        for one in self._settings.flash:
            if one.hash == identity and one.holds(count):
                return one
            if one.hash == identity:
                raise DeviceError(
                    f"{self.name}: the pattern set {one.name} ({identity}) has {count} images, three to a flash image, and the settings "
                    f"name {len(one.images)} flash images.",
                    "Correct the setting flash.",
                )
        raise DeviceError(
            f"{self.name}: the pattern set of {count} images ({identity}) is not in its flash (declared: {known}).",
            f"Export it by `measureapp patterns export --width {WIDTH_PX} --height {HEIGHT_PX}`, program the images with the vendor's "
            f"tool, three patterns to an image (green, red, blue), and add hash {identity} with their numbers to the setting flash.",
        )

    def _hold(self, index: int, attempt: Attempt) -> None:
        cycle_us = self._settings.hold_cycle_us
        images = self._flashed.images if self._flashed else ()
        sequence = hold_white(self._leds, cycle_us) if index == PLAIN_LIGHT else hold_pattern(index, images, self._leds, cycle_us)
        self._held, self._played = DARK, None
        self._controller.configure(sequence, FROM_FLASH, BY_ITSELF, self._edge, attempt)
        self._controller.start(attempt)
        self._wait_for_start(sequence, attempt)
        loading_s = self._load_s.get(sequence.images[0], FIRST_IMAGE_S)
        attempt.wait(loading_s + 2e-6 * cycle_us)  # the cycle that begins during the swap may be mixed
        self._held = index

    def _wait_for_start(self, sequence: PatternSequence, attempt: Attempt) -> float:
        """Wait until the sequencer runs; return when it was seen to. Raises DeviceError when it does not."""
        asked_s = time.monotonic()
        while not self._controller.is_playing():
            waited_s = time.monotonic() - asked_s
            if not sequence.repeat and waited_s > len(sequence.entries) * sequence.period_us * 1e-6:
                return asked_s  # so short that it may have ended already
            if waited_s > LATE_S + FIRST_IMAGE_S:
                problem = self._controller.status().problem or "its sequencer does not run"
                raise DeviceError(f"{self.name} did not start the sequence: {problem}.", "Switch it off and on again.")
            attempt.wait(self._settings.poll_s)
        return time.monotonic()
