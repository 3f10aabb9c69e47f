"""Smooth errors of predicted clouds: what lenses, light and blur add beyond noise and calibration.

No lens follows its model exactly, and no surface scatters light as a predictor assumes; clouds therefore bend a little, and registration and inspection
state U by how much they do. The size is what a scan of the same rig has shown, else what usual rigs show.
"""

from __future__ import annotations

from dataclasses import replace
from math import pi, sqrt
from zlib import crc32

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.measurement import Measurement, ViewResult
from measureapp.data.rig import RigDescription
from measureapp.register.pairs.smooth_errors import CORRELATION_LENGTH

USUAL_SHARE = 1.5e-5  # of the standoff: 8 µm at 550 mm, by residuals of 0.03 px beyond the lens model
WAVES = 64  # of which a field is the sum; enough for a nearly Gaussian one
SEED = 2


def measured_form_mm(measurement: Measurement | None) -> float | None:
    """Return the rms of the views' form errors (mm) that registration found in a scan; None without one."""
    errors = None if measurement is None or measurement.stitched is None else measurement.stitched.errors
    if errors is None or errors.form is None or not len(errors.form.sizes_mm):
        return None
    return float(np.sqrt(np.mean(np.square(errors.form.sizes_mm))))


def usual_form_mm(rig: RigDescription) -> float:
    """Return the form error (mm, one standard deviation) of usual rigs at the standoff of this one."""
    return USUAL_SHARE * rig.standoff_mm


def bend(view: ViewResult, size_mm: float) -> ViewResult:
    """Displace the points of a cloud along their normals by a smooth random field of standard deviation ``size_mm``.

    The field has the Gaussian covariance that registration assumes of a cloud (decision 9), and depends on the viewpoint's id alone. It is a sum of random waves
    (A. Rahimi, B. Recht, Random features for large-scale kernel machines, 2007).
    """
    points = np.asarray(view.cloud.points_mm)
    if size_mm <= 0 or not len(points):
        return view
    reach_mm = CORRELATION_LENGTH * float(np.sqrt(np.mean(np.sum((points - points.mean(axis=0)) ** 2, axis=1))))
    rng = np.random.default_rng([SEED, crc32(view.viewpoint_id.encode())])
    field = _waves(points, reach_mm, rng)
    return replace(view, cloud=replace(view.cloud, points_mm=points + size_mm * field[:, None] * np.asarray(view.cloud.normals, float)))


def _waves(points_mm: FloatArray, reach_mm: float, rng: np.random.Generator) -> FloatArray:
    """Return a Gaussian random field (N,) of variance one with the covariance exp(-d²/2r²) at points (N, 3)."""
    field = np.zeros(len(points_mm))
    for _ in range(WAVES):
        wave, phase = rng.standard_normal(3) / max(reach_mm, 1e-9), rng.uniform(0, 2 * pi)
        field += np.cos(points_mm @ wave + phase)
    return field * sqrt(2 / WAVES)
