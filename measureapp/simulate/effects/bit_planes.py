"""A projector that makes grey levels of bit planes, and cameras that see a frame in part."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, ImageArray

PLANES = 8


def light_of_levels(exposure_us: int, frame_us: int) -> FloatArray:
    """Return the mean light (256,) of every grey level during an exposure that begins with a frame, relative to white.

    In each frame the planes follow one another, the most significant first, each for a time proportional to its weight [1]_. Frames that are
    exposed as a whole give the level itself; of the last one only the first planes count.

    References
    ----------
    .. [1] Texas Instruments, DLPU011, LightCrafter 4500, chapter 4.
    """
    frames = exposure_us / frame_us
    whole, part = divmod(frames, 1.0)
    weights = 2.0 ** np.arange(PLANES - 1, -1, -1) / (2**PLANES - 1)  # also the time of a plane as a share of the frame
    begin = np.cumsum(weights) - weights
    seen = np.clip(part - begin, 0.0, weights)
    levels = np.arange(2**PLANES)
    bits = (levels[:, None] >> np.arange(PLANES - 1, -1, -1)) & 1
    return np.asarray((whole * (bits @ weights) + bits @ seen) / frames)


def shown_levels(images: ImageArray | FloatArray, exposure_us: int, frame_us: int, strength: float) -> FloatArray:
    """Return images (n, h, w) of grey levels (uint8) as an exposure averages them, 0…1 float32; ``strength`` 0: the levels themselves."""
    even = np.arange(256) / 255.0
    table = even + strength * (light_of_levels(exposure_us, frame_us) - even)
    return np.asarray(table.astype(np.float32)[images])
