"""The loop over the pixels of one camera's images, compiled or as NumPy statements, with the arrays that it needs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from measureapp.arrays import ImageArray, IntArray, in_bands
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.compiled.selection import use_reference
from measureapp.data.phase import PixelState
from measureapp.fringe.decode_model import make_maps, make_workspace
from measureapp.fringe.decode_plan import DecodePlan
from measureapp.fringe.kernels import reference
from measureapp.fringe.kernels.structures import CHUNK, DecodeModel, ExposureSums, ImageLayout, PixelMaps, Workspace

COUNTERS = len(PixelState) + 1  # one per state, and one for complete pixels
UNGUARDED = np.empty(0, np.uint8)  # no guard against blooming
ONE_STRETCH = -1  # start of sums that hold one stretch only, see `decode_pixels`


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

    def run(
        self,
        sums: ExposureSums,
        base: int,
        pixels: tuple[int, int],
        *,
        images: ImageArray | None = None,
        exposure: int = 0,
        blocked: ImageArray = UNGUARDED,
        model: DecodeModel | None = None,
        layout: ImageLayout | None = None,
        maps: PixelMaps | None = None,
        work: Workspace | None = None,
    ) -> tuple[IntArray, IntArray]:
        """Sum images, if any, and solve the sums, if there are maps for it; returns what `decode_pixels` counts."""
        start, stop = pixels
        layout, counted, counts = layout or self.layout, self.no_counts(), np.zeros(COUNTERS, np.int64)
        shown = self._no_images if images is None else images
        _decode_pixels()(
            shown,
            last_chunk(shown) if stop == shown.shape[-1] else shown[:0],
            exposure,
            blocked,
            layout,
            self.rule,
            sums,
            base,
            start,
            stop,
            model or self._model,
            work or self.workspace(),
            maps or self._no_maps,
            counted,
            counts,
        )
        return counted, counts

    def workspace(self) -> Workspace:
        """Allocate the intermediate results of `decode_pixels`."""
        groups = len(self.layout.steps)
        return make_workspace(self._dtype, groups, 1 if self._plan.settings.joint else groups)

    def no_counts(self) -> IntArray:
        """Return zeros to count pixels with (`decode_pixels`)."""
        return np.zeros((2, 2, len(self._plan.exposures_us)), np.int64)

    def in_bands(self, work: Callable[[int, int], Any]) -> list[Any]:
        """Share whole chunks of pixels among the processors, each call with its first pixel and the end."""
        chunks = -(-self._pixels // CHUNK)
        return in_bands(lambda start, stop: work(start * CHUNK, min(stop * CHUNK, self._pixels)), chunks)


def _decode_pixels() -> Callable[..., None]:
    if use_reference():
        return reference.decode_pixels
    from measureapp.fringe.kernels import solve

    return solve.decode_pixels


def last_chunk(images: ImageArray) -> ImageArray:
    """Return the last chunk of images (E, P, N), filled up with zeros; nothing where the last one is a whole one."""
    rest = images.shape[-1] % CHUNK
    if not rest:
        return images[:0]
    padded = np.zeros((*images.shape[:-1], CHUNK), images.dtype)
    padded[..., :rest] = images[..., -rest:]
    return contiguous(padded)


def contiguous(images: ImageArray) -> ImageArray:
    """Return a read-only contiguous view, so that the kernels see one type only."""
    view = np.ascontiguousarray(images).view()
    view.flags.writeable = False
    return view
