"""Finding and opening a projector on the USB."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from measureapp.errors import DeviceError, PluginError

from .link import HidDevice
from .registers import INTERFACE, PRODUCT_ID, VENDOR_ID


def open_projector(name: str, serial: str) -> HidDevice:
    """Open the control interface of the projector with this serial number; empty: of the only one.

    Raises
    ------
    PluginError
        The package hidapi is missing.
    DeviceError
        No such projector, several, or one that may not be opened.
    """
    hid = _library()
    found = [one for one in hid.enumerate(VENDOR_ID, PRODUCT_ID) if one["interface_number"] in (INTERFACE, -1)]
    fitting = [one for one in found if serial in ("", one["serial_number"])]
    if len(fitting) != 1:
        present = ", ".join(one["serial_number"] or "one without a serial number" for one in found) or "none"
        wanted = f"no LightCrafter {serial}" if serial else f"{len(fitting) or 'no'} LightCrafter{'s' if len(fitting) > 1 else ''}"
        raise DeviceError(
            f"{name}: there is {wanted} on the USB (found: {present}).",
            "Name one of them in the setting serial." if fitting else "Check its power and its USB cable.",
        )
    device: HidDevice = hid.device()
    try:
        device.open_path(fitting[0]["path"])  # type: ignore[attr-defined]
    except OSError as error:
        raise DeviceError(
            f"{name}: the LightCrafter is present and cannot be opened: {error}.",
            "Close other programs that use it; on Linux, allow access by a udev rule (see the README of the driver).",
        ) from error
    return device


def _library() -> Any:
    try:
        hid = import_module("hid")
    except ImportError as error:
        raise PluginError("The driver of the LightCrafter needs the package hidapi.", "Install it: pip install hidapi") from error
    if not hasattr(hid, "device"):
        raise PluginError(
            "The driver of the LightCrafter needs the package hidapi, and another package provides its module hid.",
            "Replace it: pip uninstall hid; pip install hidapi",
        )
    return hid
