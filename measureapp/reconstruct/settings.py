"""Settings of reconstruction."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from measureapp.data.model import Model


class ReconstructSettings(Model):
    """Settings of matching, fusing and cleaning."""

    grid: Literal["auto", "image", "rectified"] = Field(
        default="auto", description="pixels that become points: of the images, or of the rectified images (two cameras only; auto there)"
    )
    max_phase_step_rad: float = Field(default=3.0, gt=0, description="largest phase step between neighbouring pixels of one surface")
    agreement_sigmas: float = Field(
        default=4.0, gt=0, description="phase difference, in standard deviations, at which a camera contradicts"
    )
    agreement_px: float = Field(
        default=0.5, ge=0, description="plus this distance along the epipolar line in px, for errors of the calibration"
    )
    max_sigma_mm: float | None = Field(
        default=None,
        gt=0,
        description="largest standard deviation along the viewing ray; none: what the noisiest phase that can be decoded gives in the "
        "geometry of the view, so that it grows with the standoff (`uncertainty_limit_mm`)",
    )
    max_incidence_deg: float = Field(default=85.0, gt=0, lt=90, description="largest angle between normal and viewing ray")
    max_partner_incidence_deg: float = Field(default=85.0, gt=0, lt=90, description="the same for the other cameras that take part")
    normal_radius_px: int = Field(default=4, ge=1, le=15, description="radius of the window of normals and of the outlier filter")
    min_neighbours: int = Field(default=6, ge=3, le=24, description="of 24 places in that window; fewer: a flying pixel")
    outlier_sigmas: float = Field(default=5.0, gt=0, description="distance to the local plane, in standard deviations")
    outlier_slope: float = Field(default=0.5, ge=0, description="plus this share of the window's radius, for sharp edges")
    min_island_px: int = Field(default=50, ge=1, description="smaller isolated patches (connected components) are removed")
