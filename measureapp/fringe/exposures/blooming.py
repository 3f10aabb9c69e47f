"""The guard against sensors whose saturated pixels spill over into their neighbours."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, ImageArray, in_bands
from measureapp.fringe.kernels import summing
from measureapp.fringe.kernels.records import CHUNK, Layout, Rule, in_chunks


def near_saturation(images: ImageArray, shape: tuple[int, int], layout: Layout, rule: Rule, radius_px: int) -> ImageArray:
    """Mark pixels within a square of ``radius_px`` about those that one exposure (P, N) saturates, uint8.

    The last chunk is filled up with its last pixel. It reads the images a second time, and the neighbourhood only where there is saturation.
    """
    pixels = images.shape[1]
    marked = np.empty(in_chunks(pixels), np.uint8)

    def work(start: int, stop: int) -> None:
        summing.mark_saturated(images, layout, rule.limit, start * CHUNK, min(stop * CHUNK, pixels), marked)

    in_bands(work, len(marked) // CHUNK)
    marked[:pixels] = _widened(marked[:pixels].view(np.bool_).reshape(shape), radius_px).reshape(-1)
    marked[pixels:] = marked[pixels - 1]
    return marked


def _widened(mask: BoolArray, radius_px: int) -> BoolArray:
    """Widen a mask by a square window, looking only at the rows and columns that hold something."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    wide = mask.copy()
    if not rows.size:
        return wide
    top, bottom = max(0, rows[0] - radius_px), min(mask.shape[0], rows[-1] + radius_px + 1)
    left, right = max(0, columns[0] - radius_px), min(mask.shape[1], columns[-1] + radius_px + 1)
    part = mask[top:bottom, left:right]
    across = part.copy()
    for shift in range(1, radius_px + 1):
        across[:, shift:] |= part[:, :-shift]
        across[:, :-shift] |= part[:, shift:]
    both = across.copy()
    for shift in range(1, radius_px + 1):
        both[shift:] |= across[:-shift]
        both[:-shift] |= across[shift:]
    wide[top:bottom, left:right] = both
    return wide
