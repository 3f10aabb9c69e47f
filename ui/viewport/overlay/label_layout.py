"""Layout of labels: near their anchors, inside the picture, without overlap."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

NEAR_PX = (24, 32)  # smallest offset from the anchor, right and up
RINGS = 6  # greatest multiple of the offset
GAP_PX = 4


def place_labels(anchors_px: np.ndarray, sizes_px: Sequence[tuple[int, int]], picture_px: tuple[int, int]) -> list[tuple[int, int]]:
    """Return the offset of each label's lower left corner from its anchor; y counts upwards.

    Labels are placed greedily at the nearest free position around their anchor; one without a free position overlaps others.

    Parameters
    ----------
    anchors_px : (L, 2), positions of the labelled points
    sizes_px : width and height of each label
    picture_px : width and height
    """
    placed: list[tuple[float, float, float, float]] = []
    offsets = []
    for (x, y), (width, height) in zip(anchors_px.tolist(), sizes_px, strict=True):
        candidates = _around(width, height)
        boxes = [(x + right, y + up, x + right + width, y + up + height) for right, up in candidates]
        free = [place for place, box in enumerate(boxes) if _inside(box, picture_px) and not any(_meet(box, other) for other in placed)]
        chosen = free[0] if free else 0
        placed.append(boxes[chosen])
        offsets.append(candidates[chosen])
    return offsets


def _around(width: int, height: int) -> list[tuple[int, int]]:
    across, up = NEAR_PX
    return [
        (right, high)
        for ring in range(1, RINGS + 1)
        for high in (up * ring, -up * ring - height)
        for right in (across, -across - width, across * ring, -across * ring - width, -width // 2)
    ]


def _inside(box: tuple[float, float, float, float], picture_px: tuple[int, int]) -> bool:
    return box[0] >= 0 and box[1] >= 0 and box[2] <= picture_px[0] and box[3] <= picture_px[1]


def _meet(one: tuple[float, float, float, float], other: tuple[float, float, float, float]) -> bool:
    apart = one[0] > other[2] + GAP_PX or other[0] > one[2] + GAP_PX or one[1] > other[3] + GAP_PX or other[1] > one[3] + GAP_PX
    return not apart
