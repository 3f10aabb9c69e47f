"""Grey pixel formats of GenICam (PFNC) and their conversion into arrays."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import ImageArray
from measureapp.errors import FrameError

Bytes = np.ndarray[tuple[int], np.dtype[np.uint8]]


@dataclass(frozen=True, slots=True)
class GreyFormat:
    """One pixel format: its code in image headers, significant bits, bits in the stream, and how its bytes become grey levels."""

    code: int
    bits: int
    stored_bits: int
    unpack: Callable[[Bytes, int], ImageArray]  # (bytes, pixels)

    def size_bytes(self, pixels: int) -> int:
        """Size of an image of so many pixels."""
        return -(-pixels * self.stored_bits // 8)


def image(raw: Bytes, pixel_format: GreyFormat, width_px: int, height_px: int) -> ImageArray:
    """Return the grey levels as a new array (height, width), uint8 or uint16.

    Raises
    ------
    FrameError
        The image has another size in bytes.
    """
    pixels = width_px * height_px
    if len(raw) != pixel_format.size_bytes(pixels):
        raise FrameError(f"An image has {len(raw)} bytes instead of {pixel_format.size_bytes(pixels)}.", "Take it again.")
    return pixel_format.unpack(raw, pixels).reshape(height_px, width_px)


def _bytes(raw: Bytes, _: int) -> ImageArray:
    return raw.copy()


def _words(raw: Bytes, _: int) -> ImageArray:
    return raw.view("<u2").astype(np.uint16)


def _gige_packed(raw: Bytes, pixels: int, bits: int) -> ImageArray:
    """Two pixels in three bytes, as GigE Vision packs them: high bits, low bits of both, high bits."""
    even, low, odd = _groups(raw, 3)
    shift, mask = bits - 8, 2 ** (bits - 8) - 1
    grey = np.empty((len(low), 2), np.uint16)
    grey[:, 0] = even << shift | low & mask
    grey[:, 1] = odd << shift | low >> 4 & mask
    return grey.reshape(-1)[:pixels]


def _lsb_packed(raw: Bytes, pixels: int, bits: int) -> ImageArray:
    """Pixels one after the other without gaps, least significant bit first (the PFNC's "p" formats)."""
    count = 8 // np.gcd(8, bits)  # pixels in a whole number of bytes
    stored = _groups(raw, count * bits // 8)
    grey = np.empty((len(stored[0]), count), np.uint16)
    for index in range(count):
        first, shift = divmod(index * bits, 8)
        grey[:, index] = (stored[first] >> shift | stored[first + 1] << (8 - shift)) & (2**bits - 1)
    return grey.reshape(-1)[:pixels]


def _groups(raw: Bytes, size: int) -> list[ImageArray]:
    """Return the first, second, … bytes of each group of ``size`` bytes, as 16-bit numbers; the last group is filled up."""
    whole = np.zeros(-(-len(raw) // size) * size, np.uint8)
    whole[: len(raw)] = raw
    return [column.astype(np.uint16) for column in whole.reshape(-1, size).T]


FORMATS = {
    "Mono8": GreyFormat(0x01080001, 8, 8, _bytes),
    "Mono10p": GreyFormat(0x010A0046, 10, 10, lambda raw, pixels: _lsb_packed(raw, pixels, 10)),
    "Mono10Packed": GreyFormat(0x010C0004, 10, 12, lambda raw, pixels: _gige_packed(raw, pixels, 10)),
    "Mono10": GreyFormat(0x01100003, 10, 16, _words),
    "Mono12p": GreyFormat(0x010C0047, 12, 12, lambda raw, pixels: _lsb_packed(raw, pixels, 12)),
    "Mono12Packed": GreyFormat(0x010C0006, 12, 12, lambda raw, pixels: _gige_packed(raw, pixels, 12)),
    "Mono12": GreyFormat(0x01100005, 12, 16, _words),
    "Mono16": GreyFormat(0x01100007, 16, 16, _words),
}
