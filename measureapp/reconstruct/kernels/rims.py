"""Compiled loop that finds the pixels at the rims of surfaces."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import LOOP
from measureapp.data.point_state import PointState

RIM = np.uint8(PointState.RIM)
REACH = 3  # px: a rim two pixels wide, and the hole beyond it two deep


@njit(**LOOP)
def mark_rims(
    state: Any,  # (H, W) uint8, 0 for pixels with a phase
    row_start: int,
    row_stop: int,
    marked: Any,  # out (H, W) uint8: RIM at rims, `state` elsewhere
) -> None:
    """Mark the two pixels next to a hole that is at least two deep, beside or above or below them, and the one cornerwise.

    A single pixel without a phase ends no surface. What lies within REACH of the border of the image stays as it is.
    """
    height, width = state.shape
    for y in range(row_start, row_stop):
        own, out = state[y], marked[y]
        for x in range(width):
            out[x] = own[x]
        if y < REACH or y >= height - REACH or width <= 2 * REACH:
            continue
        n = width - 2 * REACH
        here, made = own[REACH : REACH + n], out[REACH : REACH + n]
        left, left2, left3 = own[2 : 2 + n], own[1 : 1 + n], own[0:n]
        right, right2, right3 = own[4 : 4 + n], own[5 : 5 + n], own[6 : 6 + n]
        up, up2, up3 = state[y - 1, 3 : 3 + n], state[y - 2, 3 : 3 + n], state[y - 3, 3 : 3 + n]
        down, down2, down3 = state[y + 1, 3 : 3 + n], state[y + 2, 3 : 3 + n], state[y + 3, 3 : 3 + n]
        corner_a, corner_a2 = state[y - 1, 2 : 2 + n], state[y - 2, 1 : 1 + n]
        corner_b, corner_b2 = state[y - 1, 4 : 4 + n], state[y - 2, 5 : 5 + n]
        corner_c, corner_c2 = state[y + 1, 2 : 2 + n], state[y + 2, 1 : 1 + n]
        corner_d, corner_d2 = state[y + 1, 4 : 4 + n], state[y + 2, 5 : 5 + n]
        for i in range(n):
            beside = ((left2[i] != 0) & ((left[i] != 0) | (left3[i] != 0))) | ((right2[i] != 0) & ((right[i] != 0) | (right3[i] != 0)))
            made[i] = RIM if (here[i] == 0) & beside else made[i]
        for i in range(n):
            beyond = ((up2[i] != 0) & ((up[i] != 0) | (up3[i] != 0))) | ((down2[i] != 0) & ((down[i] != 0) | (down3[i] != 0)))
            made[i] = RIM if (here[i] == 0) & beyond else made[i]
        for i in range(n):
            above = ((corner_a[i] != 0) & (corner_a2[i] != 0)) | ((corner_b[i] != 0) & (corner_b2[i] != 0))
            below = ((corner_c[i] != 0) & (corner_c2[i] != 0)) | ((corner_d[i] != 0) & (corner_d2[i] != 0))
            made[i] = RIM if (here[i] == 0) & (above | below) else made[i]
