"""What the kernels call what they see at a place of an image."""

from __future__ import annotations

import numpy as np

BLANK, SEEN, PARTLY = 0, 1, 2
BORROWED = np.uint8(255)  # state of a hole beside valid pixels whose phase continues theirs
