"""Point size at which a subset of the points covers the part."""

from __future__ import annotations

import numpy as np

LEAST_PX, MOST_PX = 2.0, 8.0
HOLES = 0.02  # fraction of the part that may remain uncovered
SAMPLES_IN_CELL = 4.0


def point_size_px(sample_px: np.ndarray, picture_px: tuple[int, int], points: int) -> float:
    """Return the side of the squares with which points cover the visible part.

    Squares of area s at n random positions in an area A leave the fraction exp(-n s / A) uncovered; half of the points are on the
    side that faces away. A is measured in cells that contain at least one point of a sample.

    Parameters
    ----------
    sample_px : (K, 2) positions in the picture of a random sample of all points; some may be outside
    picture_px : width and height
    points : number of points drawn, including those outside the picture
    """
    inside = sample_px[np.all((sample_px >= 0) & (sample_px < picture_px), axis=1)]
    if not len(inside) or points <= 0:
        return LEAST_PX
    width, height = picture_px
    edge = max(1.0, np.sqrt(SAMPLES_IN_CELL * width * height / len(inside)))
    cells = np.unique(np.floor(inside / edge) @ [1.0, np.ceil(width / edge) + 1.0])
    facing = points * len(inside) / len(sample_px) / 2.0
    size = np.sqrt(-np.log(HOLES) * min(len(cells) * edge**2, width * height) / facing)
    return float(np.clip(size, LEAST_PX, MOST_PX))
