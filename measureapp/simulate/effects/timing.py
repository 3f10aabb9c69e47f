"""Exposures that reach into the next image of the projector."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.simulate.options import TimingEffects


def into_next(timing: TimingEffects, rows: int, exposure_us: int, rng: np.random.Generator) -> FloatArray | None:
    """Return the share of an exposure that falls on the next image of the projector, (rows, 1) float32; None if there is none.

    Rows that a rolling shutter reads later lose more of their image; a late trigger delays all rows of one camera alike.
    """
    if not (timing.rolling_share or timing.late_us):
        return None
    delay = abs(float(rng.standard_normal())) * timing.late_us / exposure_us
    share = timing.rolling_share * np.linspace(0.0, 1.0, rows) + delay
    return np.clip(share, 0.0, 1.0).astype(np.float32)[:, None]
