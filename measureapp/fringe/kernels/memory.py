"""Asking for images before they are needed: they lie megabytes apart and are used a few kilobytes at a time."""

from __future__ import annotations

from typing import Any

from numba import njit

from measureapp.fringe.kernels.options import INLINE
from measureapp.machine_memory import will_read
from measureapp.map_memory import LINE


@njit(**INLINE)
def ask_for_part(images: Any, begin: Any, length: int, part: Any, parts: int) -> None:
    """Ask for one of so many parts of the images (P, N), from pixel ``begin`` on; none where images end before ``length`` pixels.

    All at once would make the processor wait: it keeps count of a few dozen lines that are on their way.
    """
    if begin + length > images.shape[1]:
        return
    step, count = LINE // images.itemsize, images.shape[0]
    for image in range(count * part // parts, count * (part + 1) // parts):  # no division inside: it would cost what is gained
        row = images[image]
        for at in range(0, length, step):
            will_read(row, begin + at)
