"""What a generated plan is compared with: greedy set cover over the same candidates, without any shortcut."""

from __future__ import annotations

import numpy as np


def greedy_cover(seen: np.ndarray, areas: np.ndarray, share: float) -> int:
    """Number of viewpoints, of those of ``seen`` (V, N), that cover a share of what all of them see; always the one that adds most."""
    covered, number = np.zeros(seen.shape[1], bool), 0
    wanted = share * areas[seen.any(axis=0)].sum()
    while areas[covered].sum() < wanted * (1 - 1e-12):
        covered |= seen[((seen & ~covered) @ areas).argmax()]
        number += 1
    return number
