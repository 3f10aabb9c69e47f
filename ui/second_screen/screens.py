"""Screens, found by what they are called and never by their place in a list."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, dataclass

from PySide6.QtGui import QScreen

from measureapp.errors import DeviceError, InputError


@dataclass(frozen=True, slots=True)
class ScreenChoice:
    """What a screen must be called; empty: anything."""

    name: str = ""
    manufacturer: str = ""
    model: str = ""
    serial: str = ""

    def fits(self, screen: QScreen) -> bool:
        """Whether every part given is the screen's."""
        return all(wanted in ("", found) for wanted, found in zip(asdict(self).values(), identity(screen), strict=True))

    def __str__(self) -> str:
        return ", ".join(f"{key} {value!r}" for key, value in asdict(self).items() if value) or "any name"


def identity(screen: QScreen) -> tuple[str, str, str, str]:
    """Return name, manufacturer, model and serial number."""
    return screen.name(), screen.manufacturer(), screen.model(), screen.serialNumber()


def native_size_px(screen: QScreen) -> tuple[int, int]:
    """Return width and height in pixels of the screen; with a fractional scaling they may be off by the rounding of one."""
    ratio = screen.devicePixelRatio()
    return round(screen.geometry().width() * ratio), round(screen.geometry().height() * ratio)


def describe(screen: QScreen) -> dict[str, object]:
    """Return what identifies a screen, and its mode."""
    name, manufacturer, model, serial = identity(screen)
    width, height = native_size_px(screen)
    return {
        "name": name,
        "manufacturer": manufacturer,
        "model": model,
        "serial": serial,
        "width_px": width,
        "height_px": height,
        "refresh_hz": round(screen.refreshRate(), 3),
        "scaling": screen.devicePixelRatio(),
    }


def find_screen(screens: Sequence[QScreen], choice: ScreenChoice) -> QScreen:
    """Return the one screen that fits.

    Raises
    ------
    DeviceError
        No screen fits.
    InputError
        Several fit.
    """
    fitting = [screen for screen in screens if choice.fits(screen)]
    present = "; ".join(_words(screen) for screen in screens) or "none"
    if not fitting:
        raise DeviceError(f"No screen has {choice} (connected: {present}).", "Switch the projector on, and check its cable and its name.")
    if len(fitting) > 1:
        raise InputError(f"{len(fitting)} screens have {choice} (connected: {present}).", "Name manufacturer, model or serial number too.")
    return fitting[0]


def check_size(screen: QScreen, width_px: int, height_px: int) -> None:
    """Refuse a screen on which a pattern's pixels would not be the screen's. Raises InputError."""
    ratio, size = screen.devicePixelRatio(), screen.geometry().size()
    if (round(width_px / ratio), round(height_px / ratio)) == (size.width(), size.height()):
        return
    width, height = native_size_px(screen)
    raise InputError(
        f"The screen {screen.name()} has {width} × {height} px, and the patterns have {width_px} × {height_px} px.",
        f"Set the screen to {width_px} × {height_px} px, or correct the projector's size in the rig description.",
    )


def _words(screen: QScreen) -> str:
    name, manufacturer, model, serial = identity(screen)
    width, height = native_size_px(screen)
    return " ".join(part for part in (name, manufacturer, model, serial) if part) + f" {width} × {height} px"
