"""Numbers that several decoding kernels use."""

from __future__ import annotations

import numpy as np

TAU = np.float32(2 * np.pi)
TINY = np.float32(1e-12)  # keeps denominators off zero
VALID, SATURATED, WEAK, SHADOW, CONFLICT, OUTSIDE, BLOOMING = 0, 1, 2, 3, 4, 5, 7  # of PixelState
