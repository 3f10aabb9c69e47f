"""The absolute phase seen by one camera."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from math import tau

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray


class PixelState(IntEnum):
    """Why a pixel has a phase, or has none; the first reason that applies."""

    VALID = 0
    SATURATED = 1  # in every exposure
    WEAK_MODULATION = 2  # light, but too little of it follows the pattern, or its phase is too uncertain
    SHADOW = 3  # no light of the projector
    ORDER_CONFLICT = 4  # the fringe orders of the pitches or bits contradict each other
    OUT_OF_RANGE = 5  # phase outside the projector
    EDGE = 6  # at a depth step: phase of two surfaces mixed
    BLOOMING = 7  # beside a saturated pixel that spills over


@dataclass(frozen=True, slots=True, eq=False)
class PhaseMap:
    """Absolute phase of the finest pitch, its standard deviation and the reason of every hole. Masked pixels hold 0, never NaN."""

    camera: str
    viewpoint_id: str
    phase_rad: FloatArray  # (H, W) float32, 0 … 2π · projector_px / pitch_px
    sigma_rad: FloatArray  # (H, W) float32
    modulation: FloatArray  # (H, W) float32, B in grey levels at the exposure taken
    grey: FloatArray  # (H, W) float32, A in grey levels of the longest unsaturated exposure, scaled to the longest exposure
    state: IntArray  # (H, W) uint8 of PixelState
    exposure_index: IntArray  # (H, W) int8, exposure taken (paper's rule) or longest unsaturated one; -1 for none
    pitch_px: float
    projector_px: int
    valid_ratio_exposures: tuple[float, ...] = ()  # paper's figure 13, long to short
    valid_ratio_composite: float = 0.0
    details: dict[str, float] = field(default_factory=dict)
    saturation: float = 255.0  # grey level of a saturated pixel
    across: PhaseMap | None = None  # of the horizontal fringes, where the set has both directions

    @property
    def valid(self) -> BoolArray:
        """Where there is a phase, (H, W)."""
        return np.asarray(self.state == PixelState.VALID)

    @property
    def column_px(self) -> FloatArray:
        """The projector's column, (H, W)."""
        return self.phase_rad * np.float32(self.pitch_px / tau)
