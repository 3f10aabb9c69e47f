"""Grey levels as the bytes of each pixel format, stated apart from any driver's unpacking."""

from __future__ import annotations

from collections.abc import Callable, Mapping

import numpy as np

from measureapp.arrays import ImageArray


def two_in_three_bytes(grey: ImageArray) -> bytes:
    """Mono12Packed of GigE Vision: high byte of the first pixel, low four bits of both, high byte of the second."""
    even, odd = grey.ravel()[::2], grey.ravel()[1::2]
    return np.stack([even >> 4, (odd & 15) << 4 | even & 15, odd >> 4], axis=1).astype(np.uint8).tobytes()


def stream_of_bits(grey: ImageArray) -> bytes:
    """Mono12p of the PFNC: all bits in one stream, the least significant first."""
    even, odd = grey.ravel()[::2], grey.ravel()[1::2]
    return np.stack([even & 255, (odd & 15) << 4 | even >> 8, odd >> 4], axis=1).astype(np.uint8).tobytes()


def words(grey: ImageArray) -> bytes:
    """One pixel in two bytes, the lower one first."""
    return grey.astype("<u2").tobytes()


PACKING: Mapping[str, Callable[[ImageArray], bytes]] = {
    "Mono8": lambda grey: grey.astype(np.uint8).tobytes(),
    "Mono10": words,
    "Mono12": words,
    "Mono12Packed": two_in_three_bytes,
    "Mono12p": stream_of_bits,
    "Mono16": words,
}
