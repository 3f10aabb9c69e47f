"""Phase map of a camera with its gradients, as matching needs it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.compiled.buffer_pool import BufferPool
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct import kernels
from measureapp.reconstruct.kernels.structures import PhaseImage

SPARSE = 16  # distance of the pixels whose slopes describe the whole map
FULL_TABLES_BELOW = 1_000_000  # pixels of images whose tables hold all of them; of larger ones, every second row and column


def table_step(shape: tuple[int, ...]) -> int:
    """Return the distance, in both directions, of the pixels that are sorted into the tables of a pair."""
    return 1 if shape[0] * shape[1] < FULL_TABLES_BELOW else 2


@dataclass(frozen=True, slots=True, eq=False)
class PhaseView:
    """A phase map and its gradients, read-only."""

    phase: FloatArray  # (H, W) float32
    sigma: FloatArray  # (H, W) float32
    state: IntArray  # (H, W) uint8
    records: FloatArray  # (H, W, 4) float32: phase, slope in rad/px along x and y, (0, 0) where unknown, and sigma
    quads: IntArray  # (H, W) uint8, whether a pixel and its right, lower and lower right neighbours are one surface
    samples: FloatArray  # (3, H', W') float32: phase and both slopes of every `table_step`-th pixel
    slopes: FloatArray  # (N, 2), the known slopes of a sparse choice of pixels

    @classmethod
    def of(cls, phase_map: PhaseMap, step_rad: float, memory: BufferPool | None = None) -> PhaseView:
        """Measure the gradients of a phase map, over neighbours less than ``step_rad`` apart."""
        memory = memory or BufferPool()
        phase, sigma = read_only(phase_map.phase_rad, np.float32), read_only(phase_map.sigma_rad, np.float32)
        state, max_step, every = read_only(phase_map.state, np.uint8), np.float32(step_rad), table_step(phase_map.state.shape)
        records, quads = memory.empty((*phase.shape, 4), np.float32), memory.empty(phase.shape, np.uint8)
        samples = memory.empty((3, *(-(-length // every) for length in phase.shape)), np.float32)
        maps, out = tuple(each.reshape(-1) for each in (phase, sigma, state)), (records.reshape(-1), quads.reshape(-1), samples)
        in_bands(lambda start, stop: kernels.measure_gradients(*maps, phase.shape, max_step, every, start, stop, *out), len(phase))
        some = samples[1:, :: SPARSE // every, :: SPARSE // every].reshape(2, -1)
        slopes = some[:, (some[0] != 0) | (some[1] != 0)].T.astype(np.float64)
        return cls(phase, sigma, state, read_only(records), read_only(quads), read_only(samples), read_only(slopes))

    @property
    def kernel_image(self) -> PhaseImage:
        """The arrays from which kernels interpolate."""
        return PhaseImage(self.state, self.records, self.quads)
