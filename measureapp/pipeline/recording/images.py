"""Size and bit depth of recorded images, against the description of the rig."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.data.rig import CameraDescription
from measureapp.errors import InputError


def is_deep(image: ImageArray) -> bool:
    """Whether an image has more than 8 bit."""
    return image.dtype != np.uint8


def check_image(place: str, file: Path, image: ImageArray, camera: CameraDescription) -> None:
    """Check an image (H, W) of a camera. Raises InputError.

    Parameters
    ----------
    place : where the recording names the image
    """
    height, width = image.shape
    if (width, height) != (camera.width_px, camera.height_px):
        raise InputError(
            f"{place}: {file} is {width} × {height} px, the rig's camera {camera.name!r} has {camera.width_px} × {camera.height_px} px.",
            "Correct the size in the rig description, or give the images of this camera at this resolution.",
        )
    if is_deep(image) != (camera.bit_depth > 8):
        raise InputError(
            f"{place}: {file} has {image.dtype.itemsize * 8} bit, the rig's camera {camera.name!r} has {camera.bit_depth} bit.",
            "Correct bit_depth in the rig description; images of 10 or 12 bit are stored with 16.",
        )
