"""The loop over the pixels of one camera's images, compiled or as NumPy statements, with the arrays that it needs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from measureapp.arrays import ImageArray, in_bands
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.compiled.selection import use_reference
from measureapp.data.phase import PixelState
from measureapp.fringe.decode_model import make_maps, make_workspace
from measureapp.fringe.decode_plan import DecodePlan
from measureapp.fringe.kernels import reference
from measureapp.fringe.kernels.structures import (
    CHUNK,
    Counts,
    DecodeModel,
    ExposureImages,
    ExposureSums,
    ImageLayout,
    PixelMaps,
    PixelRange,
    Workspace,
)

UNGUARDED = np.empty(0, np.uint8)  # no guard against blooming
ONE_STRETCH = -1  # base of sums that hold one stretch only, see `PixelRange`


class PixelLoop:
    """Sums images and solves sums of one camera and direction.

    Parameters
    ----------
    model : given to the kernel where nothing is solved
    """

    def __init__(self, plan: DecodePlan, dtype: np.dtype[np.unsignedinteger], pixels: int, model: DecodeModel, memory: BufferPool) -> None:
        self.layout, self.rule = plan.layout(), plan.rule(dtype)
        self._plan, self._dtype, self._pixels, self._model = plan, dtype, pixels, model
        self._no_images = contiguous(np.empty((0, plan.first + plan.patterns.count, pixels), dtype))
        self._no_maps = make_maps(dtype, 0, memory)

    def add(
        self, images: ImageArray, sums: ExposureSums, pixels: tuple[int, int], first: int = 0, blocked: ImageArray = UNGUARDED
    ) -> Counts:
        """Add exposures (E, P, N) from number ``first`` on to the sums of all pixels."""
        shown = ExposureImages(images, _last_chunk(images, pixels[1]), first, blocked)
        return self._run(shown, self.layout, self._model, PixelRange(*pixels, 0), sums, self.workspace(), self._no_maps)

    def solve(
        self, sums: ExposureSums, pixels: tuple[int, int], model: DecodeModel, maps: PixelMaps, layout: ImageLayout | None = None
    ) -> Counts:
        """Convert the sums of all pixels to maps."""
        shown = ExposureImages(self._no_images, self._no_images, 0, UNGUARDED)
        return self._run(shown, layout or self.layout, model, PixelRange(*pixels, 0), sums, self.workspace(), maps)

    def decode(
        self, images: ImageArray, sums: ExposureSums, pixels: tuple[int, int], model: DecodeModel, work: Workspace, maps: PixelMaps
    ) -> Counts:
        """Add all exposures and solve their sums, stretch by stretch; ``sums`` has room for one stretch."""
        shown = ExposureImages(images, _last_chunk(images, pixels[1]), 0, UNGUARDED)
        return self._run(shown, self.layout, model, PixelRange(*pixels, ONE_STRETCH), sums, work, maps)

    def _run(
        self,
        shown: ExposureImages,
        layout: ImageLayout,
        model: DecodeModel,
        pixels: PixelRange,
        sums: ExposureSums,
        work: Workspace,
        maps: PixelMaps,
    ) -> Counts:
        counts = self.no_counts()
        _decode_pixels()(shown, layout, self.rule, model, pixels, sums, work, maps, counts)
        return counts

    def workspace(self) -> Workspace:
        """Allocate the intermediate results of `decode_pixels`."""
        groups = len(self.layout.steps)
        return make_workspace(self._dtype, groups, 1 if self._plan.settings.joint else groups)

    def no_counts(self) -> Counts:
        """Return counts of no pixels."""
        exposures = np.zeros((2, 2, len(self._plan.exposures_us)), np.int64)
        return Counts(exposures, np.zeros(len(PixelState), np.int64), np.zeros(1, np.int64))

    def in_bands(self, work: Callable[[int, int], Any]) -> list[Any]:
        """Share whole chunks of pixels among the processors, each call with its first pixel and the end."""
        chunks = -(-self._pixels // CHUNK)
        return in_bands(lambda start, stop: work(start * CHUNK, min(stop * CHUNK, self._pixels)), chunks)


def _decode_pixels() -> Callable[..., None]:
    if use_reference():
        return reference.decode_pixels
    from measureapp.fringe.kernels import solve

    return solve.decode_pixels


def total_counts(bands: list[Counts]) -> Counts:
    """Return the sum of the counts of several bands of pixels."""
    return Counts(*(np.sum(each, axis=0) for each in zip(*bands, strict=True)))


def _last_chunk(images: ImageArray, stop: int) -> ImageArray:
    """Return the last chunk of images (E, P, N), filled up with zeros; nothing where ``stop`` ends a whole one."""
    rest = stop % CHUNK
    if not rest:
        return images[:0]
    padded = np.zeros((*images.shape[:-1], CHUNK), images.dtype)
    padded[..., :rest] = images[..., -rest:]
    return contiguous(padded)


def contiguous(images: ImageArray) -> ImageArray:
    """Return a read-only contiguous view, so that the kernels get one type only."""
    view = np.ascontiguousarray(images).view()
    view.flags.writeable = False
    return view
