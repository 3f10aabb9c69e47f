"""What a point has to fulfil to count as seen, and the phase noise by the light that it reflects."""

from __future__ import annotations

import numpy as np
from pydantic import Field, model_validator

from measureapp.arrays import FloatArray
from measureapp.data.model import Model

REFERENCE_LIGHT = (0.01, 0.02, 0.05, 0.1, 0.2, 0.4, 0.7, 0.9, 1.0, 1.1, 1.2, 1.3, 1.5, 1.7, 2.0)
REFERENCE_SIGMA_RAD = (
    0.172,
    0.0896,
    0.0397,
    0.0227,
    0.0137,
    0.0088,
    0.00633,
    0.0055,
    0.00638,
    0.00605,
    0.0059,
    0.00717,
    0.00663,
    0.00883,
    0.00809,
)


class FringeNoise(Model):
    """Standard deviation of the absolute phase of one camera's pixel, by the light that a matt surface reflects.

    Light 1 is that of a surface that faces the projector at the standoff. Between the given values σ is interpolated in their logarithms;
    beyond them it is that of the nearest. The default is that of the reference rig: its bracket, the default patterns, a part that just
    saturates at the longest exposure; `pipeline.prediction.fringe_noise` calculates others.
    """

    pitch_px: float = Field(default=16.0, gt=0, description="finest pitch of the fringes on the projector")
    light: tuple[float, ...] = Field(default=REFERENCE_LIGHT, min_length=1, description="rising")
    sigma_rad: tuple[float, ...] = Field(default=REFERENCE_SIGMA_RAD, min_length=1, description="one for each light")

    @model_validator(mode="after")
    def _is_a_curve(self) -> FringeNoise:
        rises = all(low < high for low, high in zip(self.light, self.light[1:], strict=False))
        if len(self.light) != len(self.sigma_rad) or not rises or min(*self.light, *self.sigma_rad) <= 0:
            raise ValueError("light must rise, and have one positive standard deviation for each value")
        return self

    def sigma_at(self, light: FloatArray) -> FloatArray:
        """Return the standard deviation in rad for light (N,)."""
        known = np.log(np.maximum(light, self.light[0]))
        return np.exp(np.interp(known, np.log(self.light), np.log(self.sigma_rad)))


class VisibilityLimits(Model):
    """Limits within which a surface point is measured, and the noise of its phase."""

    image_margin_px: float = Field(
        default=20.0, ge=0, description="distance from the borders of all images, for cameras at full resolution"
    )
    camera_incidence_deg: float = Field(default=62.0, gt=0, lt=90, description="largest angle between the normal and the ray to a camera")
    projector_incidence_deg: float = Field(
        default=68.0, gt=0, lt=90, description="largest angle between the normal and the projector's ray"
    )
    mirror_deg: float = Field(default=10.0, ge=0, lt=90, description="angle kept from the mirror direction of the projector; 0: matt parts")
    fringes: FringeNoise = FringeNoise()

    def without_light(self) -> VisibilityLimits:
        """Return the same limits for a matt part."""
        return self.model_copy(update={"mirror_deg": 0.0})

    def without_incidence(self) -> VisibilityLimits:
        """Return the limits of a matt part at any incidence below 88°."""
        return self.model_copy(update={"mirror_deg": 0.0, "camera_incidence_deg": 88.0, "projector_incidence_deg": 88.0})
