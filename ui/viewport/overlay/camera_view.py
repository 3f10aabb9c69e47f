"""The camera of one picture as numbers, independent of VTK."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class CameraView:
    """Projection of the scene to a picture, in the units of its painter."""

    projection: np.ndarray  # (4, 4), to −1…1
    rotation: np.ndarray  # (3, 3), rows: right, up and towards the viewer
    width: float
    height: float
    mm_per_px: float | None = None  # None in perspective, where no scale bar is true

    def pixels(self, points_mm: np.ndarray) -> np.ndarray:
        """Project points (N, 3) to (N, 2), from the top left corner."""
        placed = points_mm @ self.projection[:, :3].T + self.projection[:, 3]
        share = (placed[:, :2] / placed[:, 3:] + 1.0) / 2.0
        return np.column_stack([share[:, 0] * self.width, (1.0 - share[:, 1]) * self.height])
