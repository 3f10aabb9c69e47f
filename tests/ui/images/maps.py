"""A decoded camera made by hand."""

from __future__ import annotations

import numpy as np

from measureapp.data.phase import PhaseMap, PixelState

PATIENCE_MS = 30_000
LARGE = (972, 1296)


def phase_map(shape=(40, 60)) -> PhaseMap:
    """A map with one column of every state."""
    rng = np.random.default_rng(5)
    state = np.zeros(shape, np.uint8)
    state[:, : len(PixelState)] = np.arange(len(PixelState))
    exposure = rng.integers(-1, 3, shape).astype(np.int8)
    phase = np.where(state == 0, rng.uniform(0, 200, shape), 0).astype(np.float32)
    sigma = np.where(state == 0, rng.uniform(0.01, 0.1, shape), 0).astype(np.float32)
    modulation = rng.integers(0, 100, shape).astype(np.uint8)
    grey = modulation.astype(np.uint16)
    return PhaseMap(
        "left", "view01", phase, sigma, modulation, grey, state, exposure, 16.0, 1024, exposures_us=(80_000.0, 20_000.0, 5_000.0)
    )
