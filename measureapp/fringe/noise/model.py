"""The noise of a camera, and what it does to the phase."""

from __future__ import annotations

import numpy as np
from pydantic import Field

from measureapp.arrays import FloatArray
from measureapp.data.model import Model

QUANTISATION_VARIANCE = 1.0 / 12.0  # of one grey level


class CameraNoise(Model):
    """Shot noise, read noise and quantisation. The defaults describe a 2.2 µm CMOS pixel; the full well is reached at saturation."""

    full_well_e: float = Field(default=6000.0, gt=0, description="electrons at saturation")
    read_noise_e: float = Field(default=7.0, ge=0, description="electrons")
    step_grey: float = Field(
        default=1.0, gt=0, description="distance of two grey levels the camera can give; 16 for 12 bits stretched to 16"
    )
    black_grey: float = Field(default=0.0, ge=0, description="grey level of no light")

    def electrons_per_grey(self, saturation: float) -> float:
        """Return how many electrons one grey level stands for."""
        return self.full_well_e / saturation

    def floor_variance(self, saturation: float) -> float:
        """Return the variance in the dark, in grey levels²."""
        return (self.read_noise_e / self.electrons_per_grey(saturation)) ** 2 + QUANTISATION_VARIANCE * self.step_grey**2

    def variance(self, grey: FloatArray, saturation: float) -> FloatArray:
        """Return the variance in grey levels² of pixels whose mean is ``grey``."""
        light = np.maximum(np.asarray(grey) - self.black_grey, 0.0)
        return np.asarray(light / self.electrons_per_grey(saturation) + self.floor_variance(saturation))


def phase_sigma(steps: int, sigma_grey: FloatArray, modulation: FloatArray) -> FloatArray:
    """Return the standard deviation of the phase of ``steps`` equally shifted images, √(2/N) · σ_I / B, in radians.

    References
    ----------
    .. [1] Y. Surrel, Applied Optics 36(4), 805-807, 1997.
    """
    return np.asarray(np.sqrt(2.0 / steps) * sigma_grey / modulation)
