"""What the kernels call what they see at a place of an image, and what became of a match."""

from __future__ import annotations

import numpy as np

BLANK, SEEN, PARTLY = 0, 1, 2
WITHOUT_PARTNER, MATCHED, REPEATS = np.uint8(0), np.uint8(1), np.uint8(2)
