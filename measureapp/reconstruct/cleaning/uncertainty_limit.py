"""The largest standard deviation of a point: what the noisiest phase that can be decoded gives in the geometry of the view."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.reconstruct.settings import ReconstructSettings

DECODABLE_RAD = 0.25  # standard deviation of a phase that hardly differs from one without fringes
SAMPLES = 160  # along the longer side of an image
OBLIQUE = 3.0  # times the median: surfaces seen obliquely, and pairs with a short base, are less certain


def uncertainty_limit_mm(
    depth_sigma_mm: FloatArray, phase_sigma_rad: FloatArray, settings: ReconstructSettings, least_mm: float = 0.0
) -> float:
    """Return the largest standard deviation along the viewing ray that a point of this view may have, in mm.

    A limit in mm alone throws points away for being far: at equal phase noise the depth's standard deviation grows with the square of the
    distance. By default it is three times the standard deviation that a phase noise of 0.25 rad, above which fringes cannot be told from
    noise, has in the middle of the view; what exceeds it is at grazing incidence or along the fringes, not merely far or faint.

    Parameters
    ----------
    depth_sigma_mm : (H, W), 0 where there is no point
    phase_sigma_rad : (H, W), of the phases that they were measured with
    settings : `ReconstructSettings.max_sigma_mm`, where it is given, is the limit
    least_mm : never less than this
    """
    if settings.max_sigma_mm is not None:
        return max(settings.max_sigma_mm, least_mm)
    every = max(1, max(depth_sigma_mm.shape) // SAMPLES)
    depth, phase = depth_sigma_mm[::every, ::every], phase_sigma_rad[::every, ::every]
    known = (depth > 0) & (phase > 0)
    if not known.any():
        return float("inf")
    return max(OBLIQUE * DECODABLE_RAD * float(np.median(depth[known] / phase[known])), least_mm)
