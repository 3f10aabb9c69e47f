"""A phase map as the kernels want it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct import kernels

SPARSE = 16  # one pixel of so many in each direction tells what a phase map is like
EVERY_PIXEL_BELOW = 1_000_000  # images with fewer pixels are sorted completely, larger ones every second row and column


def table_step(shape: tuple[int, ...]) -> int:
    """Return of how many pixels, in both directions, one is sorted into the tables of a pair."""
    return 1 if shape[0] * shape[1] < EVERY_PIXEL_BELOW else 2


@dataclass(frozen=True, slots=True, eq=False)
class PhaseView:
    """The arrays of a phase map, and what the kernels need to look into it."""

    phase: FloatArray  # (H, W) float32
    sigma: FloatArray  # (H, W) float32
    state: IntArray  # (H, W) uint8
    pixels: FloatArray  # (H, W, 4) float32: phase, slope in rad/px along x and y, (0, 0) where unknown, and sigma, found at one place
    quad: IntArray  # (H, W) uint8, whether a pixel and its right, lower and lower right neighbour are one surface
    samples: FloatArray  # (3, H', W') float32: phase and both slopes of the pixels that tables are made of, see `table_step`
    some_slopes: FloatArray  # (N, 2) the known slopes of a sparse choice of pixels

    @classmethod
    def of(cls, phase_map: PhaseMap, step_rad: float, memory: BufferPool | None = None) -> PhaseView:
        """Take the slopes of a phase map, over neighbours less than ``step_rad`` apart."""
        memory = memory or BufferPool()
        phase, sigma = read_only(phase_map.phase_rad, np.float32), read_only(phase_map.sigma_rad, np.float32)
        state = read_only(phase_map.state, np.uint8)
        pixels, quad = memory.empty((*phase.shape, 4), np.float32), memory.empty(phase.shape, np.uint8)
        every, step = table_step(phase.shape), np.float32(step_rad)
        samples = memory.empty((3, *(-(-length // every) for length in phase.shape)), np.float32)
        maps = tuple(each.reshape(-1) for each in (phase, sigma, state))
        out = (pixels.reshape(-1), quad.reshape(-1), samples)
        in_bands(lambda start, stop: kernels.slopes(maps, *phase.shape, step, every, start, stop, *out), len(phase))
        some = samples[1:, :: SPARSE // every, :: SPARSE // every].reshape(2, -1)
        some_slopes = some[:, (some[0] != 0) | (some[1] != 0)].T.astype(np.float64)
        return cls(phase, sigma, state, read_only(pixels), read_only(quad), read_only(samples), read_only(some_slopes))
