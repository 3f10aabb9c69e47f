"""Correction of the phase for the blur of the cameras.

A pixel receives the light of its surroundings. Where that grows to one side, as on a wall oblique to the projector or at a printed edge,
the brighter side counts more and the pixel has the phase of a place beside it: for a blur of variance s², small against the distance over
which things change, of the place s² ∇ ln I further on. Uncorrected, oblique walls are measured some micrometres in front of their place, all
to the same side. Where the phase is curved, its mean over the blur is off by s² ∇²φ / 2, which makes holes narrower and round bodies thinner.
Linear interpolation of a phase between pixels does the same, like a blur of a sixth of a px² (decision 15).

Where a hole or an edge hides how the phase is curved, its shift by the light alone is corrected and the standard deviation grows: such pixels,
steep near the horizons of round bodies, would have the largest weights otherwise. What stays of the shift has one sign all over a view, and is
not averaged away by the number of points.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace

import numpy as np

from measureapp.arrays import in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.calibration import CameraArrayCalibration
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct import kernels
from measureapp.reconstruct.kernels.blur import Blur
from measureapp.reconstruct.projector_light import projector_light

INTERPOLATION_PX2 = 1 / 6  # variance of linear interpolation, (1 - f) f, over all places f between two pixels
MAX_BLUR_PX = 1.5  # beyond, neither the first order nor slopes over four pixels hold


def correct_blur(
    phase_maps: Mapping[str, PhaseMap],
    cameras: CameraArrayCalibration,
    step_rad: float,
    memory: BufferPool | None = None,
    interpolated: Collection[str] = (),
) -> dict[str, PhaseMap]:
    """Correct phase maps for blur; the uncertainty of the correction goes into ``sigma_rad``.

    Those of cameras whose blur is unknown stay as they are.

    Parameters
    ----------
    step_rad : largest phase step between neighbouring pixels of one surface
    interpolated : cameras whose phases will be interpolated between pixels; this blur is corrected too
    """
    memory = memory or BufferPool()
    return {
        name: _correct(phase_map, cameras.cameras[name].blur_px, step_rad, memory, name in interpolated)
        if name in cameras.cameras
        else phase_map
        for name, phase_map in phase_maps.items()
    }


def _correct(phase_map: PhaseMap, blur_px: float, step_rad: float, memory: BufferPool, interpolated: bool) -> PhaseMap:
    if blur_px <= 0:
        return phase_map
    shape = phase_map.phase_rad.shape
    variance = min(blur_px, MAX_BLUR_PX) ** 2
    blur = Blur(
        read_only(phase_map.phase_rad, np.float32).reshape(-1),
        read_only(phase_map.sigma_rad, np.float32).reshape(-1),
        read_only(projector_light(phase_map, variance, memory), np.float32).reshape(-1),
        read_only(phase_map.state, np.uint8).reshape(-1),
        np.float32(variance),
        np.float32(INTERPOLATION_PX2 / variance if interpolated else 0.0),
        np.float32(step_rad),
        *shape,
    )
    phase, sigma = memory.empty(phase_map.state.size, np.float32), memory.empty(phase_map.state.size, np.float32)
    in_bands(lambda start, stop: kernels.correct_blur(blur, start, stop, phase, sigma), shape[0])
    orthogonal = None if phase_map.orthogonal is None else _correct(phase_map.orthogonal, blur_px, step_rad, memory, interpolated)
    return replace(phase_map, phase_rad=read_only(phase.reshape(shape)), sigma_rad=read_only(sigma.reshape(shape)), orthogonal=orthogonal)
