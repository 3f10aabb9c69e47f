"""Finding a camera by its serial number and opening it."""

from __future__ import annotations

import time
import warnings
from collections.abc import Callable
from importlib import import_module
from typing import Any

from measureapp.errors import DeviceError, PluginError

HELD = ("0xE1018006", "controlled by another application", "exclusively opened")  # GigE twice, USB
RETRY_EVERY_S = 0.5


def load_pylon() -> Any:
    """Import pypylon; raises PluginError naming what to install."""
    with warnings.catch_warnings():
        # A warning made an error ends the interpreter while the library's types are registered.
        warnings.filterwarnings("ignore", "builtin type .* has no __module__", DeprecationWarning)
        try:
            return import_module("pypylon.pylon")
        except ImportError as error:
            raise PluginError(
                f"The driver camera_basler needs the package pypylon, which cannot be imported: {error}.",
                "Install it: pip install pypylon.",
            ) from error


def find_device(factory: Any, name: str, serial: str) -> Any:
    """Return the device information of the camera with this serial number; the error names those that are there."""
    devices = list(factory.EnumerateDevices())
    for device in devices:
        if device.GetSerialNumber() == serial:
            return device
    found = ", ".join(sorted(_describe(device) for device in devices))
    raise DeviceError(
        f"Camera {name}: no Basler camera with serial number {serial} answers. " + (f"Found: {found}." if found else "None was found."),
        "Correct the serial number in the rig description, or check power, cable and IP address: camera and network card need one subnet."
        if found
        else "Check power and cables, and that network card and cameras have addresses in one subnet.",
    )


def open_camera(attempt: Callable[[], None], info: Any, name: str, retry_s: float) -> None:
    """Open a camera; one that another program holds is tried again for ``retry_s``, longer than the heartbeat of a program that died.

    Parameters
    ----------
    attempt : opens it once, or raises an exception of pypylon
    """
    end = time.monotonic() + retry_s
    while True:
        try:
            attempt()
        except DeviceError:
            raise
        except Exception as error:  # of pypylon, which has no type for it
            if not any(sign in str(error) for sign in HELD):
                raise DeviceError(
                    f"Camera {name} ({_describe(info)}) cannot be opened: {str(error).rstrip('. ')}.", "Check its power and its cable."
                ) from error
            if time.monotonic() >= end:
                raise DeviceError(
                    f"Camera {name} ({_describe(info)}) is controlled by another program; it was tried for {retry_s:g} s.",
                    "Close the other program (pylon Viewer, another MeasureApp, also on another computer), then connect again.",
                ) from error
            time.sleep(min(RETRY_EVERY_S, retry_s))
        else:
            return


def _describe(info: Any) -> str:
    found, address = info.GetPropertyValue("IpAddress")
    return f"{info.GetModelName()} {info.GetSerialNumber()}" + (f" at {address}" if found and address else "")
