"""Absolute phase map of one camera."""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import IntEnum
from math import tau

import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.fringe import Direction


class PixelState(IntEnum):
    """Whether a pixel has a phase, or the reason why not; the first reason that applies."""

    VALID = 0
    SATURATED = 1  # in every exposure
    WEAK_MODULATION = 2  # too little modulation, or too uncertain a phase
    SHADOW = 3  # no light of the projector
    ORDER_CONFLICT = 4  # the fringe orders of the pitches or bits contradict each other
    OUT_OF_RANGE = 5  # phase outside the projector
    EDGE = 6  # at a depth discontinuity: phases of two surfaces mixed
    BLOOMING = 7  # next to a saturated pixel that blooms


@dataclass(frozen=True, slots=True)
class StackEvidence:
    """What the fringe images of one camera say of its noise, and of what contradicts a scene at rest in steady light."""

    full_well_e: float  # of the noise model that the standard deviations are of
    read_noise_e: float
    from_images: bool  # else it was given, or assumed
    scatter: float = (
        1.0  # standard deviation of phases about smooth surfaces over what the noise model predicts; wider σ than it are stated
    )
    vibration_rad: float = 0.0  # phase noise by fringes that moved between the steps; 0 where none is clear
    light_rad: float = 0.0  # the same by light that changed between the steps
    light_step: float = 0.0  # share by which light changed most from one group of images to the next
    light_exposure_us: float = 0.0  # exposure whose images show that most


@dataclass(frozen=True, slots=True, eq=False)
class PhaseMap:
    """Absolute phase of the finest pitch, its standard deviation and the state of every pixel. Masked pixels are 0, never NaN."""

    camera: str
    viewpoint_id: str
    phase_rad: FloatArray  # (H, W) float32, 0 … 2π · projector_px / pitch_px
    sigma_rad: FloatArray  # (H, W) float32
    modulation: FloatArray | IntArray  # (H, W) of the images' type, B in grey levels at the exposure used, minimum over the pitches
    grey: FloatArray | IntArray  # (H, W) uint16, mean grey level over the exposures used, scaled to the longest exposure
    state: IntArray  # (H, W) uint8 of PixelState
    exposure_index: IntArray  # (H, W) int8, exposure used (paper's rule) or longest unsaturated one; -1 for none
    pitch_px: float
    projector_px: int
    valid_ratio_exposures: tuple[float, ...] = ()  # long to short (figure 13 of the paper); an estimate with the paper's rule
    valid_ratio_composite: float = 0.0
    details: dict[str, float] = field(default_factory=dict)
    saturation: float = 255.0  # grey level of a saturated pixel
    orthogonal: PhaseMap | None = None  # of the orthogonal (horizontal) fringes, if the set has both directions
    direction: Direction = "vertical"  # of the fringes
    snr_at_one_rad: float = 0.0  # B/σ_I of one image that gives a phase standard deviation of 1 rad
    evidence: StackEvidence | None = None  # of the images it came from; None without images
    exposures_us: tuple[float, ...] = ()  # indexed by `exposure_index`, longest first; may be empty for a single one

    @property
    def valid(self) -> BoolArray:
        """Mask of the pixels with a phase, (H, W)."""
        return np.asarray(self.state == PixelState.VALID)

    @property
    def origin_rad(self) -> float:
        """Phase at the centre of the projector's first column (row) as determined by the decoder: 0, or -π for fringes that start dark."""
        return self.details.get("origin_rad", 0.0)

    def pixel_of_phase(self) -> tuple[float, float]:
        """Return projector pixels per radian, and the pixel at phase 0: pixel = phase · scale + offset."""
        scale = self.pitch_px / tau
        return scale, -self.origin_rad * scale

    @property
    def column_px(self) -> FloatArray:
        """Projector column (row for horizontal fringes) of every pixel, (H, W) float32; 0 is the centre of the first one."""
        scale, offset = self.pixel_of_phase()
        return self.phase_rad * np.float32(scale) + np.float32(offset)

    def column_at(self, row: int, column: int) -> float:
        """Return the projector column (row) at one pixel."""
        scale, offset = self.pixel_of_phase()
        return float(self.phase_rad[row, column]) * scale + offset

    @property
    def snr(self) -> FloatArray:
        """Signal-to-noise ratio B/σ_I, (H, W) float32, of a single image that would give the same phase noise; 0 where masked."""
        made = np.zeros(self.sigma_rad.shape, np.float32)
        np.divide(np.float32(self.snr_at_one_rad), self.sigma_rad, out=made, where=self.sigma_rad > 0)
        return made

    @property
    def reasons(self) -> dict[str, int]:
        """Number of pixels per state, by its name in lower case."""
        counts = np.bincount(self.state.ravel(), minlength=len(PixelState))
        return {state.name.lower(): int(counts[state]) for state in PixelState}
