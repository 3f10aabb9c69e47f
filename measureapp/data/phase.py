"""The absolute phase seen by one camera."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from math import tau

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.fringe import Direction


class PixelState(IntEnum):
    """Why a pixel has a phase, or has none; the gravest reason that applies."""

    VALID = 0
    SATURATED = 1  # in every exposure
    WEAK_MODULATION = 2  # modulation too low, or phase too uncertain
    SHADOW = 3  # no light from the projector
    ORDER_CONFLICT = 4  # the fringe orders of the pitches or bits contradict each other
    OUT_OF_RANGE = 5  # phase outside the projector
    EDGE = 6  # at a depth discontinuity: mixed phase of two surfaces
    BLOOMING = 7  # beside a saturated pixel that blooms


@dataclass(frozen=True, slots=True, eq=False)
class PhaseMap:
    """Absolute phase of the finest pitch, its standard deviation and the reason of every hole. Masked pixels hold 0, never NaN."""

    camera: str
    viewpoint_id: str
    phase_rad: FloatArray  # (H, W) float32, 0 … 2π · projector_px / pitch_px
    sigma_rad: FloatArray  # (H, W) float32
    modulation: FloatArray | IntArray  # (H, W) of the images' type, B in grey levels at the exposure used, least of all pitches
    grey: FloatArray | IntArray  # (H, W) uint16, mean grey level over the exposures used, scaled to the longest exposure
    state: IntArray  # (H, W) uint8 of PixelState
    exposure_index: IntArray  # (H, W) int8, exposure used (paper's rule) or longest unsaturated one; -1 for none
    pitch_px: float
    projector_px: int
    valid_ratio_exposures: tuple[float, ...] = ()  # paper's figure 13, long to short; by the paper's rule an estimate
    valid_ratio_composite: float = 0.0
    details: dict[str, float] = field(default_factory=dict)
    saturation: float = 255.0  # grey level of a saturated pixel
    orthogonal: PhaseMap | None = None  # of the orthogonal (horizontal) fringes, where the set has both directions
    direction: Direction = "vertical"  # of the fringes
    snr_at_one_rad: float = 0.0  # B/σ_I of one image at which the phase would have a standard deviation of 1 rad
    exposures_us: tuple[float, ...] = ()  # those that `exposure_index` counts, longest first; empty: a single one

    @property
    def valid(self) -> BoolArray:
        """Where there is a phase, (H, W)."""
        return np.asarray(self.state == PixelState.VALID)

    @property
    def origin_rad(self) -> float:
        """Phase at the centre of the projector's first column (row), as the decoder found it: 0, or -π where fringes start dark."""
        return self.details.get("origin_rad", 0.0)

    def pixel_of_phase(self) -> tuple[float, float]:
        """Return projector pixels per radian, and the pixel at phase 0: pixel = phase · scale + offset."""
        scale = self.pitch_px / tau
        return scale, -self.origin_rad * scale

    @property
    def column_px(self) -> FloatArray:
        """The projector's column, (H, W) float32; its row where the fringes are horizontal. Column 0 is the centre of the first one."""
        scale, offset = self.pixel_of_phase()
        return self.phase_rad * np.float32(scale) + np.float32(offset)

    def column_at(self, row: int, column: int) -> float:
        """Return the projector's column (row) at one pixel."""
        scale, offset = self.pixel_of_phase()
        return float(self.phase_rad[row, column]) * scale + offset

    @property
    def snr(self) -> FloatArray:
        """Modulation over noise, B/σ_I, (H, W) float32: of one image that would give the phase as exactly as all of them; 0 where masked."""
        made = np.zeros(self.sigma_rad.shape, np.float32)
        np.divide(np.float32(self.snr_at_one_rad), self.sigma_rad, out=made, where=self.sigma_rad > 0)
        return made

    @property
    def reasons(self) -> dict[str, int]:
        """How many pixels have which state, by name in lower case."""
        counts = np.bincount(self.state.ravel(), minlength=len(PixelState))
        return {state.name.lower(): int(counts[state]) for state in PixelState}
