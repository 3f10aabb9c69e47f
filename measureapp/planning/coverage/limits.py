"""What a point has to fulfil to count as seen."""

from __future__ import annotations

from pydantic import Field

from measureapp.data.model import Model


class VisibilityLimits(Model):
    """Limits within which a surface point is measured, and the noise of the phase."""

    image_margin_px: float = Field(
        default=20.0, ge=0, description="distance from the borders of all images, for cameras at full resolution"
    )
    camera_incidence_deg: float = Field(default=62.0, gt=0, lt=90, description="largest angle between the normal and the ray to a camera")
    projector_incidence_deg: float = Field(
        default=68.0, gt=0, lt=90, description="largest angle between the normal and the projector's ray"
    )
    mirror_deg: float = Field(default=10.0, ge=0, lt=90, description="angle kept from the mirror direction of the projector; 0: matt parts")
    phase_sigma_rad: float = Field(default=0.01, gt=0, description="phase noise of a surface facing the projector at the standoff")
    pitch_px: float = Field(default=32.0, gt=0, description="finest pitch of the fringes on the projector")

    def without_light(self) -> VisibilityLimits:
        """Return the same limits for a matt part."""
        return self.model_copy(update={"mirror_deg": 0.0})

    def without_incidence(self) -> VisibilityLimits:
        """Return the limits of a matt part at any incidence below 88°."""
        return self.model_copy(update={"mirror_deg": 0.0, "camera_incidence_deg": 88.0, "projector_incidence_deg": 88.0})
