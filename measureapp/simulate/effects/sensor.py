"""Fixed differences between the pixels of a camera, and its response curve."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, read_only
from measureapp.simulate.options import SensorEffects

HOT_FROM = 0.1  # dark signal from which a pixel is called hot, of full scale


@dataclass(frozen=True, slots=True, eq=False)
class PixelErrors:
    """Gain and dark level of every pixel, and the curvature of the response.

    The response is y = x - c x (1 - x) (1 - 2 a x), which leaves black and white in place: quadratic and cubic terms as cameras have them.
    """

    gain: FloatArray  # (H, W) float32, mean 1
    dark: FloatArray  # (H, W) float32, of full scale
    curvature: float  # of full scale, with a sign
    skew: float

    def apply(self, mean: FloatArray) -> FloatArray:
        """Return the image (H, W) as the pixels report it, relative to full scale."""
        seen = mean * self.gain + self.dark
        if self.curvature != 0.0:
            held = np.clip(seen, 0.0, 1.0)
            seen = seen - np.float32(4.0 * self.curvature) * held * (1.0 - held) * (1.0 - np.float32(2.0 * self.skew) * held)
        return np.asarray(seen, np.float32)


def draw_pixels(effects: SensorEffects, width_px: int, height_px: int, full_well_e: float, rng: np.random.Generator) -> PixelErrors | None:
    """Draw the differences between pixels; None if there are none."""
    if effects == SensorEffects():
        return None
    gain = 1.0 + effects.gain_spread * rng.standard_normal((height_px, width_px), np.float32)
    dark = effects.dark_spread_e / full_well_e * np.abs(rng.standard_normal((height_px, width_px), np.float32))
    curvature, skew = effects.curvature * rng.uniform(0.3, 1.0) * rng.choice([-1.0, 1.0]), rng.uniform(0.0, 0.5)
    hot = rng.random((height_px, width_px), np.float32) < 1e-6 * effects.hot_ppm
    dark[hot] = rng.uniform(HOT_FROM, 1.0, np.count_nonzero(hot))
    return PixelErrors(read_only(gain, np.float32), read_only(dark, np.float32), float(curvature), float(skew))
