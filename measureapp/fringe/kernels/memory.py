"""Asking for images before they are needed: they lie megabytes apart and are used a few kilobytes at a time."""

from __future__ import annotations

from typing import Any

from numba import njit

from measureapp.fringe.kernels.options import INLINE
from measureapp.machine_memory import will_read
from measureapp.map_memory import LINE


@njit(**INLINE)
def ask_for_part(images: Any, begin: Any, length: int, part: Any, parts: int) -> None:
    """Ask for one of so many parts of the pixels from ``begin`` on of all images (P, N), none where images end before ``length`` pixels.

    All at once would make the processor wait: it keeps count of a few dozen lines that are on their way.
    """
    if begin + length > images.shape[1]:
        return
    step = LINE // images.itemsize
    of_image = length // step
    lines = images.shape[0] * of_image
    for line in range(lines * part // parts, lines * (part + 1) // parts):
        will_read(images[line // of_image], begin + step * (line % of_image))
