"""Whether an image is the one that was requested, by what the camera reports with it."""

from __future__ import annotations

import numpy as np

from measureapp.devices.camera import Camera, Frame


def find_difference(frame: Frame, camera: Camera, exposure_us: int) -> str:
    """Return how an image differs from what was requested, as the end of a sentence; empty if it does not."""
    if frame.serial != camera.serial:
        return f"the image is from camera {frame.serial}, not {camera.serial}"
    if frame.pixels.shape != (camera.height_px, camera.width_px):
        found = " × ".join(str(size) for size in reversed(frame.pixels.shape))
        return f"the image is {found} px, not {camera.width_px} × {camera.height_px} px"
    depth = np.uint8 if camera.bit_depth == 8 else np.uint16
    if frame.pixels.dtype != depth:
        return f"the image has pixels of type {frame.pixels.dtype}, not {np.dtype(depth)} for {camera.bit_depth} bit"
    if frame.exposure_us is not None and abs(frame.exposure_us - exposure_us) > camera.exposure_step_us:
        return f"the image was exposed for {frame.exposure_us} µs, not {exposure_us} µs"
    return ""
