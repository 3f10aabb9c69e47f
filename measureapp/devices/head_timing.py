"""Timing of a sequence: how long a pattern is held, when the next trigger may come, and what cannot work."""

from __future__ import annotations

from collections.abc import Mapping

from measureapp.data.scan_cost import image_time_s
from measureapp.devices.camera import Camera
from measureapp.devices.projector import Projector
from measureapp.errors import DeviceError, LimitError

MARGIN_US = 1_000  # between the end of the read-out and the next trigger; a trigger that comes earlier is ignored silently
LATE_S = 0.5  # an image that comes later than this is lost
FRAME_TOLERANCE = 0.02  # of one frame of the projector


def period_us(cameras: Mapping[str, Camera], exposure_us: int) -> int:
    """Return the shortest time between two triggers for all cameras: exposure and read-out, and no less than the transfer of the images."""
    readout_s, transfer_s = (max(times) for times in zip(*((one.readout_s, one.transfer_s) for one in cameras.values()), strict=True))
    return round(1e6 * image_time_s(exposure_us + MARGIN_US, readout_s, transfer_s))


def frame_timeout_s(camera: Camera, exposure_us: int) -> float:
    """Return how long an image may take from its trigger until it has arrived, with the transfer of the image before it."""
    return exposure_us * 1e-6 + camera.readout_s + 2.0 * camera.transfer_s + LATE_S


def check_timing(cameras: Mapping[str, Camera], projector: Projector, exposure_us: int, *, gated: bool = False) -> None:
    """Refuse an exposure at which the rows of an image would see different light.

    Parameters
    ----------
    gated : the projector is lit during the exposure only; otherwise it holds the pattern until every row is read out

    Raises
    ------
    LimitError
        The exposure is not a whole number of the projector's frames.
    DeviceError
        A camera's shutter does not fit the way in which the projector is lit.
    """
    frame_us = projector.frame_us
    frames = exposure_us / frame_us if frame_us else 1.0
    if frames < 1 - FRAME_TOLERANCE or abs(frames - round(frames)) > FRAME_TOLERANCE:
        below, above = max(1, int(frames)) * frame_us, (int(frames) + 1) * frame_us
        raise LimitError(
            f"An exposure of {exposure_us} µs is not a whole number of the frames of {projector.name} ({frame_us} µs each).",
            f"Choose {below} or {above} µs; the grey levels are only right over whole frames.",
        )
    for name, camera in cameras.items():
        if camera.shutter == "rolling" and gated:
            raise DeviceError(
                f"Camera {name} exposes its rows one after the other over {camera.readout_s * 1e3:.1f} ms, and {projector.name} is lit during "
                f"the exposure of {exposure_us / 1e3:g} ms only: no instant of light is common to all rows.",
                "Set the camera to global reset, or the projector to hold each pattern for the whole period.",
            )
        if camera.shutter == "global-reset" and not gated:
            raise DeviceError(
                f"Camera {name} ends the exposure of its rows one after the other (global reset), and {projector.name} stays lit meanwhile: "
                f"the last row would get {camera.readout_s * 1e3:.1f} ms more light.",
                "Set the camera to rolling shutter, or use a projector that is dark after the exposure.",
            )
