"""The guard against sensors whose saturated pixels spill over into their neighbours."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import BoolArray, ImageArray, in_bands
from measureapp.fringe.kernels.structures import CHUNK, ExposureRule, ImageLayout, round_up_to_chunks


def mark_near_saturation(images: ImageArray, shape: tuple[int, int], layout: ImageLayout, rule: ExposureRule, radius_px: int) -> ImageArray:
    """Mark pixels within a square of ``radius_px`` about those that one exposure (P, N) saturates, uint8 in whole chunks."""
    pixels = images.shape[1]
    saturated = np.zeros(pixels, np.bool_)

    def mark(start: int, stop: int) -> None:
        band = slice(start * CHUNK, stop * CHUNK)
        for first, steps in zip(layout.first_image, layout.steps, strict=True):
            saturated[band] |= images[first : first + steps, band].max(axis=0) > rule.limit

    in_bands(mark, -(-pixels // CHUNK))
    marked = np.zeros(round_up_to_chunks(pixels), np.uint8)
    marked[:pixels] = _dilate(saturated.reshape(shape), radius_px).reshape(-1)
    return marked


def _dilate(mask: BoolArray, radius_px: int) -> BoolArray:
    """Dilate a mask by a square window, within its bounding box."""
    rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
    wide = mask.copy()
    if not rows.size:
        return wide
    top, bottom = max(0, rows[0] - radius_px), min(mask.shape[0], rows[-1] + radius_px + 1)
    left, right = max(0, columns[0] - radius_px), min(mask.shape[1], columns[-1] + radius_px + 1)
    part = mask[top:bottom, left:right]
    in_rows = part.copy()
    for shift in range(1, radius_px + 1):
        in_rows[:, shift:] |= part[:, :-shift]
        in_rows[:, :-shift] |= part[:, shift:]
    dilated = in_rows.copy()
    for shift in range(1, radius_px + 1):
        dilated[shift:] |= in_rows[:-shift]
        dilated[:-shift] |= in_rows[shift:]
    wide[top:bottom, left:right] = dilated
    return wide
