"""Compiled loop over the borders of what a camera sees."""
# One loop over pixels cannot be cut into functions without leaving SIMD code.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.seen import BORROWED


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def continue_borders(
    phase: Any,
    sigma: Any,
    state: Any,
    step: Any,
    row_start: int,
    row_stop: int,
    new_phase: Any,  # out (H, W) float32
    new_sigma: Any,  # out (H, W) float32
    new_state: Any,  # out (H, W) uint8
) -> None:
    """Continue the phase by one pixel into the holes, along straight lines, so that the outer half of border pixels can be interpolated."""
    height, width = phase.shape
    for y in range(row_start, row_stop):
        for x in range(width):
            new_phase[y, x] = phase[y, x]
            new_sigma[y, x] = sigma[y, x]
            new_state[y, x] = state[y, x]
            if state[y, x] == 0:
                continue
            total = 0.0
            noise = 0.0
            count = 0
            for dy in range(-1, 2):
                for dx in range(-1, 2):
                    v, u = y + 2 * dy, x + 2 * dx
                    if (dx == 0 and dy == 0) or v < 0 or u < 0 or v >= height or u >= width:
                        continue
                    if state[y + dy, x + dx] == 0 and state[v, u] == 0 and abs(phase[v, u] - phase[y + dy, x + dx]) < step:
                        total += 2.0 * phase[y + dy, x + dx] - phase[v, u]
                        noise += 4.0 * sigma[y + dy, x + dx] ** 2 + sigma[v, u] ** 2
                        count += 1
            if count:
                new_phase[y, x] = total / count
                new_sigma[y, x] = np.sqrt(noise) / count
                new_state[y, x] = BORROWED
