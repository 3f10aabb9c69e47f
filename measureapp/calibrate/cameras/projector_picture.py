"""Image of the board from the projector's viewpoint, for display."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import FloatArray, ImageArray
from measureapp.data.phase import PhaseMap

REACH = 2.0  # of the smoothing that closes the gaps between camera pixels, in projector pixels
SMALLEST_WEIGHT = 1e-3  # of the light next to a projector pixel, below which it stays dark


def projector_picture(image: ImageArray, vertical: PhaseMap, size_px: tuple[int, int]) -> ImageArray:
    """Resample a camera's image in the projector's pixels by the phases of both directions [1]_.

    For people only: no mark is read in it, since the smoothing would move them.

    Parameters
    ----------
    image : (H, W) uint8, of the camera that the phases belong to
    vertical : phase of the vertical fringes; its ``across`` is that of the horizontal fringes
    size_px : width and height of the projector's image

    Returns
    -------
    (height, width) uint8; 0 where no camera pixel is lit by a projector pixel nearby, and everywhere with fringes of one direction

    References
    ----------
    .. [1] S. Zhang, P. S. Huang, Optical Engineering 45(8), 083601, 2006, section 3.2.
    """
    width, height = size_px
    seen: FloatArray = np.zeros(height * width)
    weight: FloatArray = np.zeros(height * width)
    if vertical.orthogonal is not None:
        lit = vertical.valid & vertical.orthogonal.valid
        column, row = (np.round(phase.column_px[lit]).astype(int) for phase in (vertical, vertical.orthogonal))
        inside = (column >= 0) & (column < width) & (row >= 0) & (row < height)
        place = row[inside] * width + column[inside]
        weight = np.asarray(np.bincount(place, minlength=height * width), float)
        seen = np.asarray(np.bincount(place, image[lit][inside].astype(float), height * width), float)
    light, smooth = (cv2.GaussianBlur(one.reshape(height, width), (0, 0), REACH) for one in (seen, weight))
    return np.where(smooth > SMALLEST_WEIGHT, np.round(light / np.maximum(smooth, SMALLEST_WEIGHT)), 0).astype(np.uint8)
