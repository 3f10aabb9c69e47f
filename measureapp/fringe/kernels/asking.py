"""Compiled steps that ask for images before they are summed, while the processor is busy with other pixels.

Only so many requests are under way at a time, and one too many stops it: they are spread over the arithmetic.
"""

from __future__ import annotations

from typing import Any

from numba import njit

from measureapp.fringe.kernels.options import INLINE
from measureapp.fringe.kernels.records import CHUNK
from measureapp.machine_memory import will_read
from measureapp.map_memory import LINE


@njit(**INLINE)
def ask_for(images: Any, layout: Any, place: int) -> None:
    """Ask for the line of the cache that begins at a pixel, of all sinusoids of one exposure (P, N)."""
    last = layout.first_image.shape[0] - 1
    for p in range(layout.first_image[0], layout.first_image[last] + layout.steps[last]):
        will_read(images[p], place)


@njit(**INLINE)
def ask_for_chunk(images: Any, layout: Any, begin: int) -> None:
    """Ask for a chunk of pixels of all sinusoids of one exposure (P, N)."""
    for j in range(0, CHUNK, LINE // images.itemsize):
        ask_for(images, layout, begin + j)
