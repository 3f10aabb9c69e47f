"""What a click in the 3-D view met."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class Pick:
    """A click: the place on the foremost visible surface, and the measured point nearest to it."""

    ray_mm: np.ndarray  # (3,), a point of the ray of sight
    direction: np.ndarray  # (3,), of the ray, away from the viewer
    position_mm: np.ndarray | None = None  # (3,), on what is visible there; None: the background
    layer: int = -1  # of the clouds, −1 where no point is near
    index: int = -1  # of the point in its layer
    adds: bool = False  # Shift: add to what is selected
    removes: bool = False  # Ctrl: remove from what is selected

    @property
    def is_point(self) -> bool:
        """Whether a point of a cloud was met."""
        return self.layer >= 0
