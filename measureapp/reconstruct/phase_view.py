"""A phase map as the kernels want it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands, read_only
from measureapp.data.phase import PhaseMap
from measureapp.reconstruct import kernels


@dataclass(frozen=True, slots=True, eq=False)
class PhaseView:
    """The arrays of a phase map as the kernels want them."""

    phase: FloatArray  # (H, W) float32
    sigma: FloatArray  # (H, W) float32
    state: IntArray  # (H, W) uint8; `kernels.BORROWED` where the phase is continued

    @classmethod
    def of(cls, phase_map: PhaseMap, step_rad: float) -> PhaseView:
        """Take them out of a phase map and continue its borders by one pixel, over neighbours less than ``step_rad`` apart."""
        phase, sigma = read_only(phase_map.phase_rad, np.float32), read_only(phase_map.sigma_rad, np.float32)
        state = read_only(phase_map.state, np.uint8)
        made = cls(np.empty_like(phase), np.empty_like(sigma), np.empty_like(state))
        in_bands(
            lambda start, stop: kernels.continue_borders(phase, sigma, state, step_rad, start, stop, made.phase, made.sigma, made.state),
            len(phase),
        )
        return cls(read_only(made.phase), read_only(made.sigma), read_only(made.state))
