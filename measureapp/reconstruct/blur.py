"""The phase without what the blur of the cameras does to it.

A pixel shows the light of its surroundings. Where that grows to one side, as on a wall askance to the projector or across a printed edge,
the brighter side counts more, and the pixel shows the phase of a place beside it: for a blur of variance s², which is small beside
the distance over which things change, of the place s² ∇ ln I further on. In a measurement this puts walls seen askance some
micrometres before their place, all to the same side. And where the phase bends, the surroundings lie to one side of the pixel: the mean
is off by s² ∇²φ / 2, which makes holes narrower and round bodies thinner. Reading a phase in straight lines between pixels does the
same, like a blur of a sixth of a px² (decision 15).

Where a hole or an edge hides how much that is, it stays, and counts as noise: such pixels, steep at the rims of round bodies, would
weigh most otherwise.
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
from measureapp.reconstruct.other_light import other_light

READ_PX2 = 1 / 6  # variance of what reading between pixels does, (1 - f) f, over all places f between two of them
MOST_PX = 1.5  # of the blur; the first order takes back no more, and slopes over four pixels show no more


def without_blur(
    phase_maps: Mapping[str, PhaseMap],
    cameras: CameraArrayCalibration,
    step_rad: float,
    memory: BufferPool | None = None,
    read: Collection[str] = (),
) -> dict[str, PhaseMap]:
    """Return the phase maps as cameras without blur would give them, with what is in doubt of that in ``sigma_rad``.

    Those of cameras whose blur is not known stay as they are.

    Parameters
    ----------
    step_rad : largest phase step between neighbouring pixels of one surface
    read : cameras whose phases will be read between pixels, in straight lines, which cut bends short as blur does; that is taken back too
    """
    memory = memory or BufferPool()
    return {
        name: _sharp(phase_map, cameras.cameras[name].blur_px, step_rad, memory, name in read) if name in cameras.cameras else phase_map
        for name, phase_map in phase_maps.items()
    }


def _sharp(phase_map: PhaseMap, blur_px: float, step_rad: float, memory: BufferPool, read: bool) -> PhaseMap:
    if blur_px <= 0:
        return phase_map
    shape = phase_map.phase_rad.shape
    phase, sigma = read_only(phase_map.phase_rad, np.float32).reshape(-1), read_only(phase_map.sigma_rad, np.float32).reshape(-1)
    grey, state = read_only(phase_map.grey, np.uint16).reshape(-1), read_only(phase_map.state, np.uint8).reshape(-1)
    out, doubted = memory.empty(phase.shape, np.float32), memory.empty(phase.shape, np.float32)
    variance = min(blur_px, MOST_PX) ** 2
    numbers = (
        np.float32(variance),
        np.float32(READ_PX2 / variance if read else 0.0),
        np.float32(step_rad),
        np.float32(other_light(phase_map)),
    )
    in_bands(lambda start, stop: kernels.take_blur(phase, sigma, grey, state, *shape, *numbers, start, stop, out, doubted), shape[0])
    across = None if phase_map.orthogonal is None else _sharp(phase_map.orthogonal, blur_px, step_rad, memory, read)
    return replace(phase_map, phase_rad=read_only(out.reshape(shape)), sigma_rad=read_only(doubted.reshape(shape)), orthogonal=across)
