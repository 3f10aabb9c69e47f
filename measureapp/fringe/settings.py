"""Settings of decoding."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from measureapp.data.model import Model
from measureapp.fringe.noise.model import CameraNoise

EIGHT_BIT_WHITE = 255.0


class DecodeSettings(Model):
    """How fringe images are decoded to a phase map. The defaults suit rendered and real images."""

    rule: Literal["combined", "paper"] = Field(
        default="combined",
        description="combined: all unsaturated exposures, weighted by their signal and noise; paper: the brightest unsaturated one",
    )
    joint: bool = Field(default=True, description="all groups from the same exposures; otherwise each pitch for itself")
    min_modulation: float = Field(
        default=10.0,
        ge=0,
        description="least B at the exposure taken, in grey levels of an 8-bit image; the orders of fainter pixels may need their neighbours",
    )
    faint_modulation: float = Field(
        default=3.0,
        ge=0,
        description="least B of a valid pixel, of one image as exact as all its exposures together",
    )
    max_sigma_rad: float = Field(default=0.25, gt=0, description="largest standard deviation of the absolute phase")
    residual_gate: float = Field(default=0.35, gt=0, le=0.5, description="largest rounding residual of an order without support, cycles")
    vote_radius: int = Field(default=2, ge=0, le=4, description="radius of the window that votes about orders, px; 0: no vote")
    edge_step_rad: float = Field(default=3.0, gt=0, description="phase step between neighbours that marks an edge")
    blooming_radius_px: int = Field(
        default=0,
        ge=0,
        le=16,
        description="an exposure is not used so close to a pixel it saturates; 0 for sensors that do not spill over (`spill_radius_px`)",
    )
    noise: CameraNoise = Field(default=CameraNoise(), description="assumed of cameras without an entry in `camera_noise`")
    noise_from_images: bool = Field(
        default=True,
        description="the noise of cameras without an entry is estimated from the residuals of their fringe images, and standard deviations are "
        "widened where phases scatter more than predicted",
    )
    camera_noise: dict[str, CameraNoise] = Field(default_factory=dict, description="of cameras that differ from `noise`, by name")
    phase_correction: tuple[tuple[tuple[int, float, float], ...], ...] = Field(
        default=(),
        description="for every phase-shift group, in order, the harmonics (k, a, p) of the projector: phase − Σ a sin(k phase + p)",
    )

    def limited(self, min_modulation: float | None, max_sigma_rad: float | None) -> DecodeSettings:
        """Return the settings with another least modulation of a valid pixel, or largest σ; None keeps it."""
        given: dict[str, float] = {}
        if min_modulation is not None:
            given = {"faint_modulation": min_modulation, "min_modulation": max(self.min_modulation, min_modulation)}
        if max_sigma_rad is not None:
            given["max_sigma_rad"] = max_sigma_rad
        return self.model_copy(update=given)

    def min_modulation_grey(self, saturation: float) -> float:
        """Return the least modulation in grey levels of images that saturate at ``saturation``."""
        return self.min_modulation * saturation / EIGHT_BIT_WHITE

    def faint_modulation_grey(self, saturation: float) -> float:
        """Return the least modulation of a valid pixel, in grey levels of images that saturate at ``saturation``."""
        return min(self.faint_modulation, self.min_modulation) * saturation / EIGHT_BIT_WHITE

    def noise_of(self, camera: str) -> CameraNoise:
        """Return the noise model of a camera."""
        return self.camera_noise.get(camera, self.noise)
