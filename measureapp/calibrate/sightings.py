"""What a camera calibration starts from: the corners of the board as cameras saw them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, read_only


@dataclass(frozen=True, slots=True, eq=False)
class Sighting:
    """The corners of one board position in one camera, ordered like ``board.corners_mm``."""

    camera: str
    view: str  # the same in all cameras that saw the same position
    corners_px: FloatArray  # (N, 2)

    def __post_init__(self) -> None:
        object.__setattr__(self, "corners_px", read_only(self.corners_px, np.float64, (None, 2)))


@dataclass(frozen=True, slots=True)
class Rejection:
    """A sighting that was left out, or some corners of it, and why."""

    camera: str
    view: str
    reason: str


@dataclass(frozen=True, slots=True)
class ViewResidual:
    """How well one used sighting fits; rms of the distances of its corners."""

    camera: str
    view: str
    rms_px: float
    corners: int


def rms(residuals_px: FloatArray, used: BoolArray | None = None) -> float:
    """Return the root mean square length of residual vectors (N, 2), as OpenCV counts it; 0 without any."""
    chosen = residuals_px if used is None else residuals_px[used]
    return float(np.sqrt(np.mean(np.sum(chosen**2, axis=-1)))) if len(chosen) else 0.0
