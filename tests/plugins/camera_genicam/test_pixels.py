"""Packed grey formats, packed here bit by bit as the standards draw them, and unpacked by the driver."""

from __future__ import annotations

import sys
from types import ModuleType

import numpy as np
import pytest

from measureapp.devices.plugin_loader import load_driver
from measureapp.errors import FrameError

WIDTH_PX, HEIGHT_PX = 6, 5  # 30 pixels of 10 bit do not fill their last group of bytes


def pixels() -> ModuleType:
    return sys.modules[load_driver(None, "camera_genicam", "camera").module.image.__module__]


def greys(bits: int) -> np.ndarray:
    grey = np.random.default_rng(bits).integers(0, 2**bits, (HEIGHT_PX, WIDTH_PX))
    grey[0, :2] = 0, 2**bits - 1
    return grey


def one_after_the_other(grey: np.ndarray, bits: int) -> np.ndarray:
    """PFNC "p": a stream of bits, the least significant first."""
    stream = "".join(format(int(value), f"0{bits}b")[::-1] for value in grey.ravel())
    stream += "0" * (-len(stream) % 8)
    return np.array([int(stream[at : at + 8][::-1], 2) for at in range(0, len(stream), 8)], np.uint8)


def two_in_three_bytes(grey: np.ndarray, bits: int) -> np.ndarray:
    """GigE Vision "Packed": the high 8 bits of the first, the low bits of both, the high 8 bits of the second."""
    packed: list[int] = []
    for even, odd in grey.reshape(-1, 2):
        low = bits - 8
        packed += [even >> low, (odd % 2**low) << 4 | even % 2**low, odd >> low]
    return np.array(packed, np.uint8)


def words(grey: np.ndarray, _: int) -> np.ndarray:
    return grey.astype("<u2").view(np.uint8).ravel()


@pytest.mark.parametrize(
    ("name", "bits", "pack"),
    [
        ("Mono8", 8, lambda grey, _: grey.astype(np.uint8).ravel()),
        ("Mono10", 10, words),
        ("Mono10p", 10, one_after_the_other),
        ("Mono10Packed", 10, two_in_three_bytes),
        ("Mono12", 12, words),
        ("Mono12p", 12, one_after_the_other),
        ("Mono12Packed", 12, two_in_three_bytes),
        ("Mono16", 16, words),
    ],
)
def test_every_grey_format_gives_back_what_was_packed(name: str, bits: int, pack: object) -> None:
    module = pixels()
    grey = greys(bits)
    raw = pack(grey, bits)  # type: ignore[operator]
    unpacked = module.image(raw, module.FORMATS[name], WIDTH_PX, HEIGHT_PX)
    np.testing.assert_array_equal(unpacked, grey)
    assert unpacked.dtype == (np.uint8 if bits == 8 else np.uint16)
    assert not np.shares_memory(unpacked, raw)
    assert module.FORMATS[name].bits == bits


def test_an_image_of_another_size_is_refused() -> None:
    module = pixels()
    with pytest.raises(FrameError, match="29 bytes instead of 30"):
        module.image(np.zeros(29, np.uint8), module.FORMATS["Mono8"], WIDTH_PX, HEIGHT_PX)
