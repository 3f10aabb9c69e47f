"""The call of the compiled loop over the pixels of one camera's images, with the arrays that it needs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from measureapp.arrays import ImageArray, IntArray, in_bands
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PixelState
from measureapp.fringe.absolute import make_maps, make_work
from measureapp.fringe.kernels import decoding
from measureapp.fringe.kernels.records import CHUNK, Layout, Maps, Model, Scratch, Sums, Work
from measureapp.fringe.recipe import Recipe

COUNTERS = len(PixelState) + 1  # of every state, and of complete pixels
NOWHERE = np.empty(0, np.uint8)  # no pixel is kept from an exposure by its neighbours
Room = tuple[Scratch, Work]  # the arrays that the kernel works in
STRETCH_ALONE = -1  # of the sums: they are of the stretch at hand, see `sum_and_solve`


class PixelLoop:
    """Sums images and solves sums, of a recipe and so many pixels of a type.

    Parameters
    ----------
    model : given to the kernel, which asks for one, where nothing is solved
    """

    def __init__(self, recipe: Recipe, dtype: np.dtype[np.unsignedinteger], pixels: int, model: Model, memory: BufferPool) -> None:
        self.layout, self.rule = recipe.layout(), recipe.rule(dtype)
        self._recipe, self._dtype, self._pixels, self._model = recipe, dtype, pixels, model
        self._no_images = flat(np.empty((0, recipe.first + recipe.patterns.count, pixels), dtype))
        self._no_maps = make_maps(dtype, 0, memory)

    def run(
        self,
        sums: Sums,
        base: int,
        start: int,
        stop: int,
        *,
        images: ImageArray | None = None,
        exposure: int = 0,
        blocked: ImageArray = NOWHERE,
        model: Model | None = None,
        layout: Layout | None = None,
        maps: Maps | None = None,
        room: Room | None = None,
    ) -> tuple[IntArray, IntArray]:
        """Sum images, if any, and solve the sums, if there are maps for it; returns what was seen and counted, see `sum_and_solve`."""
        layout, seen, counts = layout or self.layout, self.nothing_seen(), np.zeros(COUNTERS, np.int64)
        scratch, work = room or self.room(layout)
        shown = self._no_images if images is None else images
        decoding.sum_and_solve(
            shown,
            last_chunk(shown) if stop == shown.shape[-1] else shown[:0],
            exposure,
            blocked,
            layout,
            self.rule,
            model or self._model,
            scratch,
            sums,
            base,
            work,
            start,
            stop,
            maps is not None,
            maps or self._no_maps,
            seen,
            counts,
        )
        return seen, counts

    def room(self, layout: Layout) -> Room:
        """Return the arrays that the kernel works in."""
        return self._recipe.scratch(self._dtype), make_work(len(layout.steps))

    def nothing_seen(self) -> IntArray:
        """Return counters of what `sum_and_solve` looks at."""
        return np.zeros((2, 2, len(self._recipe.exposures_us)), np.int64)

    def in_bands(self, work: Callable[[int, int], Any]) -> list[Any]:
        """Share whole chunks of pixels among the processors."""
        chunks = -(-self._pixels // CHUNK)
        return in_bands(lambda start, stop: work(start * CHUNK, min(stop * CHUNK, self._pixels)), chunks)


def last_chunk(images: ImageArray) -> ImageArray:
    """Return the last chunk of images (E, P, N), filled up with their last pixel; nothing where the last one is a whole one."""
    pixels = images.shape[-1]
    left = pixels % CHUNK
    return flat(images[..., np.minimum(np.arange(pixels - left, pixels - left + CHUNK), pixels - 1)] if left else images[:0])


def flat(images: ImageArray) -> ImageArray:
    """Return a read-only contiguous view, so that the kernels see one type only."""
    view = np.ascontiguousarray(images).view()
    view.flags.writeable = False
    return view
