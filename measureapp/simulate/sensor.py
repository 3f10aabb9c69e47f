"""Image sensor: shot noise, read noise, saturation, quantisation."""

from __future__ import annotations

from functools import cache

import numpy as np
from pydantic import Field

from measureapp.arrays import FloatArray, ImageArray, read_only
from measureapp.data.model import Model

TABLE_SIZE = 65536


class SensorSettings(Model):
    """Settings of an MT9P031-class sensor."""

    full_well_e: float = Field(default=6000.0, gt=0, description="electrons at full scale")
    read_noise_e: float = Field(default=7.0, ge=0)
    noise: bool = Field(default=True, description="no: the mean image is quantised as it is")

    def variance(self, full_scale: int) -> tuple[float, float]:
        """Return the noise variance of a dark pixel in grey levels squared and its increase per grey level, without quantisation."""
        if not self.noise:
            return 0.0, 0.0
        electrons_per_level = self.full_well_e / full_scale
        return (self.read_noise_e / electrons_per_level) ** 2, 1.0 / electrons_per_level


def read_out(mean: FloatArray, bit_depth: int, settings: SensorSettings, key: int) -> ImageArray:
    """Simulate the read-out of a mean image, given relative to full scale.

    Parameters
    ----------
    mean : (H, W) float32
    bit_depth : 8 gives uint8, more gives uint16
    key : seed of the noise
    """
    from measureapp.simulate.kernels import in_bands
    from measureapp.simulate.noise_kernel import quantise

    full_scale = 2**bit_depth - 1
    image = np.empty(mean.shape, np.uint8 if bit_depth == 8 else np.uint16)
    variance = np.array(settings.variance(full_scale), np.float32)
    in_bands(quantise, 0, (mean.size + 3) // 4, mean.reshape(-1), full_scale, variance, key, normal_quantiles(), image.reshape(-1))
    return image


@cache
def normal_quantiles() -> FloatArray:
    """Return the middle quantiles of the standard normal distribution, (65536,) float32, scaled to unit variance."""
    from scipy.special import ndtri

    quantiles = ndtri((np.arange(TABLE_SIZE) + 0.5) / TABLE_SIZE)
    return read_only(quantiles / quantiles.std(), np.float32)
