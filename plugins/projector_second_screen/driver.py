"""A projector that is a screen of this computer: images go to a window in a process of its own."""

from __future__ import annotations

import contextlib
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.devices.attempt import Stops
from measureapp.devices.projector import DARK, PLAIN_LIGHT
from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, InputError, MeasureError

from .settings import SecondScreenSettings
from .window_process import WindowProcess

LOAD_TIMEOUT_S = 30.0
DARK_COMMAND = {"do": "show", "level": 0}


def connect(request: DeviceRequest) -> SecondScreen:
    """Cover the projector's screen with a dark window.

    Raises
    ------
    InputError
        Several screens fit the settings, or the screen has another size than the projector of the rig.
    DeviceError
        No screen fits, or the window does not appear.
    """
    settings, projector = request.settings, request.rig.projector
    if not isinstance(settings, SecondScreenSettings):
        raise InputError(f"{request.name}: the settings are not those of a second screen.", "Load them with this driver's model.")
    names = {part: getattr(settings, part) for part in ("name", "manufacturer", "model", "serial")}
    if not any(names.values()):
        raise InputError(
            f"Rig {request.rig.name}: the settings of the projector name no screen.",
            "Set name, manufacturer, model or serial; `python -m ui.second_screen list` prints the screens.",
        )
    arguments = [f"--width={projector.width_px}", f"--height={projector.height_px}", *(f"--{part}={text}" for part, text in names.items())]
    folder = tempfile.TemporaryDirectory(prefix="second-screen-")
    try:
        window = WindowProcess(projector.name, arguments, Path(folder.name) / "log.txt")
        try:
            return SecondScreen(request, settings, window, folder, window.greet(settings.start_timeout_s))
        except BaseException:
            window.close()
            raise
    except BaseException:
        folder.cleanup()
        raise


class SecondScreen:
    """Shows images pixel by pixel; `show` returns after the latency of the screen."""

    def __init__(
        self,
        request: DeviceRequest,
        settings: SecondScreenSettings,
        window: WindowProcess,
        folder: tempfile.TemporaryDirectory[str],
        screen: dict[str, Any],
    ) -> None:
        described = request.rig.projector
        self.name, self.width_px, self.height_px = described.name, described.width_px, described.height_px
        self._settings, self._window, self._folder = settings, window, folder
        self._screen = screen
        self._stops = Stops()
        self._count = 0
        self.frame_us = settings.frame_us or _frame_us(self.name, screen["refresh_hz"])

    def load(self, images: ImageArray) -> None:
        """Load a sequence (count, height, width) of uint8 images. Raises DeviceError for a wrong size."""
        images = np.asarray(images)
        if images.ndim != 3 or images.shape[1:] != (self.height_px, self.width_px) or images.dtype != np.uint8:
            raise DeviceError(
                f"{self.name} does not support images of shape {images.shape} and type {images.dtype}.",
                f"Give 8-bit images of {self.width_px} × {self.height_px} px.",
            )
        file = Path(self._folder.name) / "images.raw"
        np.ascontiguousarray(images).tofile(file)
        try:
            self._window.ask({"do": "load", "file": str(file)}, LOAD_TIMEOUT_S)
        finally:
            file.unlink(missing_ok=True)
        self._count = len(images)

    def show(self, index: int, *, timeout_s: float) -> None:
        """Show image ``index``, PLAIN_LIGHT or DARK, and wait until it is lit, latency included."""
        if not DARK <= index < self._count:
            raise DeviceError(f"{self.name} has {self._count} images and cannot show image {index}.", "Load the pattern set first.")
        attempt = self._stops.begin(f"Showing image {index} on {self.name}", timeout_s)
        levels = {DARK: 0, PLAIN_LIGHT: self._settings.plain_level}
        command = {"do": "show"} | ({"level": levels[index]} if index in levels else {"index": index})
        self._window.ask(command, min(timeout_s, self._settings.reply_timeout_s), attempt.check)
        attempt.wait(self._settings.latency_s)

    def shown(self) -> int:
        """Read back the index of the image painted last, PLAIN_LIGHT or DARK."""
        found: int = self._window.ask({"do": "state"}, self._settings.reply_timeout_s)["shown"]
        return found

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        screen = self._screen
        identity = " ".join(part for part in (screen["manufacturer"], screen["model"], screen["serial"]) if part)
        try:
            index = self.shown()
        except MeasureError as error:
            return DeviceStatus(False, error.message, error.hint, identity)
        words = {DARK: "dark", PLAIN_LIGHT: "uniform light"}.get(index, f"image {index}")
        mode = f"{screen['width_px']} × {screen['height_px']} px at {screen['refresh_hz']:g} Hz"
        return DeviceStatus(True, f"{words} on the screen {screen['name']}, {mode}", identity=identity)

    def stop(self) -> None:
        """Switch the light off now, from any thread; a waiting call then raises Cancelled."""
        self._stops.stop()
        self._window.ask(DARK_COMMAND, self._settings.reply_timeout_s)

    def close(self) -> None:
        """Close the window; the desktop appears on the screen. Harmless when repeated."""
        self._stops.stop()
        self._window.close()
        with contextlib.suppress(FileNotFoundError):
            self._folder.cleanup()


def _frame_us(name: str, refresh_hz: float) -> int:
    """Return the duration of one frame. Raises DeviceError when the screen does not state its refresh rate."""
    if refresh_hz <= 1.0:
        raise DeviceError(f"{name}: the screen does not state its refresh rate.", "Set frame_us, such as 16667 for 60 Hz.")
    return round(1e6 / refresh_hz)
