"""Software prefetch of images that are summed next, while other pixels are solved.

A processor has a limited number of outstanding cache misses and stalls at one more, so prefetches are spread over the arithmetic.
"""

from __future__ import annotations

from typing import Any

from numba import njit

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES
from measureapp.compiled.cache_hints import prefetch
from measureapp.compiled.options import INLINE
from measureapp.fringe.kernels.records import CHUNK


@njit(**INLINE)
def prefetch_sinusoids(images: Any, layout: Any, place: int) -> None:
    """Prefetch the cache line that begins at a pixel, of all sinusoids of one exposure (P, N)."""
    last = layout.first_image.shape[0] - 1
    for p in range(layout.first_image[0], layout.first_image[last] + layout.steps[last]):
        prefetch(images[p], place)


@njit(**INLINE)
def prefetch_chunk(images: Any, layout: Any, begin: int) -> None:
    """Prefetch a chunk of pixels of all sinusoids of one exposure (P, N)."""
    for j in range(0, CHUNK, CACHE_LINE_BYTES // images.itemsize):
        prefetch_sinusoids(images, layout, begin + j)
