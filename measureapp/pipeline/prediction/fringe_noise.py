"""Phase noise of a plan's fringes by the light of the part, for the planner."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.fringe import PatternSet
from measureapp.data.rig import RigDescription
from measureapp.fringe.noise.model import CameraNoise
from measureapp.fringe.settings import DecodeSettings
from measureapp.pipeline.prediction.light import CameraExposures, PartLight
from measureapp.pipeline.prediction.phase_maps import WHITE
from measureapp.pipeline.prediction.typical_rig import BLUR_PX
from measureapp.planning.coverage.limits import FringeNoise

LIGHT = np.geomspace(0.01, 4.0, 120)  # of a matt surface that faces the projector at the standoff: 1


def fringe_noise(
    patterns: PatternSet,
    exposures_us: Sequence[int],
    rig: RigDescription,
    noise: Mapping[str, CameraNoise] | None = None,
    light: PartLight | None = None,
) -> FringeNoise:
    """Return the phase noise of a camera's pixel over the light, as decoding will have it; the root mean square over the cameras.

    The fringes are those on a surface that faces the head at the standoff, blurred as by a typical lens. Light that saturates even the shortest exposure has the noise of the brightest light that does not.

    Parameters
    ----------
    exposures_us : from long to short
    noise : measured noise of cameras, by name; default: `CameraNoise()`
    light : of the part; default: it just saturates at the longest exposure
    """
    settings, part = DecodeSettings(camera_noise=dict(noise or {})), light or PartLight()
    alone, _ = patterns.subset(patterns.directions[0])
    mean = WHITE * part.white * LIGHT
    variances = []
    for camera in rig.cameras:
        taken = CameraExposures(alone, tuple(exposures_us), exposures_us[0], settings.noise_of(camera.name), float(camera.saturation))
        sharp = part.contrast * sharpness(camera.focal_px / rig.projector.focal_px * alone.finest_pitch_px)
        variances.append(np.square(taken.phase_noise(mean + part.ambient, mean * sharp).sigma_rad))
    sigma = np.sqrt(np.mean(variances, axis=0))
    usable = np.isfinite(sigma)
    kept: tuple[FloatArray, FloatArray] = (LIGHT[usable], sigma[usable]) if usable.any() else (LIGHT[:1], np.full(1, np.pi))
    return FringeNoise(pitch_px=alone.finest_pitch_px, light=_rounded(kept[0]), sigma_rad=_rounded(kept[1]))


def sharpness(pitch_px: float) -> float:
    """Return the share of the modulation that a lens in focus leaves of fringes with this pitch in the camera's image."""
    return float(np.exp(-2.0 * (np.pi * BLUR_PX / pitch_px) ** 2))


def _rounded(values: FloatArray) -> tuple[float, ...]:
    return tuple(float(f"{value:.6g}") for value in values)
