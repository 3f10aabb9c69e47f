"""Reading of greyscale images: PNG, TIFF, BMP (and JPEG), 8 or 16 bit."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np

from measureapp.arrays import ImageArray
from measureapp.errors import InputError

PNG_START, PNG_END = b"\x89PNG\r\n\x1a\n", b"IEND\xaeB`\x82"
FORMATS = "Use an undamaged PNG, TIFF or BMP of 8 or 16 bit."


def read_image(path: Path) -> ImageArray:
    """Read an image as grey levels (H, W), uint8 or uint16; 10- and 12-bit images keep their levels in 16 bit.

    Raises
    ------
    InputError
        The file is missing, truncated, not an image, or has an unsupported pixel type; the message names it.
    """
    path = Path(path)
    try:
        data = path.read_bytes()
    except OSError as error:
        raise InputError(f"Image {path} cannot be read: {error.strerror or error}.", "Check the path in the manifest.") from error
    if data.startswith(PNG_START) and PNG_END not in data[-64:]:
        raise InputError(f"Image {path} is truncated: its end is missing.", "Copy or record it again.")
    try:
        image = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_GRAYSCALE | cv2.IMREAD_ANYDEPTH) if data else None
    except cv2.error as error:
        raise InputError(f"Image {path} cannot be decoded.", FORMATS) from error
    if image is None:
        raise InputError(f"{path} is not a readable image.", FORMATS)
    if image.dtype not in (np.uint8, np.uint16):
        raise InputError(f"Image {path} has {image.dtype} pixels.", FORMATS)
    return np.asarray(image)
