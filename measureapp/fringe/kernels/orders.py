"""Compiled loops over neighbourhoods: whose fringe order is doubtful, what the window says about it, where edges are."""
# A loop over a window cannot be cut into functions without losing its speed.
# ruff: noqa: PLR0912, PLR1714

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import ALLOCATING_LOOP
from measureapp.fringe.kernels.records import RESIDUAL_SCALE

HALF = np.float32(0.5)
TAU = np.float32(2 * np.pi)
VALID, CONFLICT, OUTSIDE, EDGE = 0, 4, 5, 6  # of PixelState
MOST_ORDERS = 4  # a repair changes the order by at most so many
STANDS, REFUSED = 0, 100  # what the window says besides a change of order


@njit(**ALLOCATING_LOOP)
def find_doubtful(phase: Any, state: Any, step: Any, reach: int, row_start: int, row_stop: int, doubtful: Any) -> None:
    """Mark pixels with a phase that are in conflict, or differ by more than ``step`` from one of eight others.

    These are the four neighbours and the four pixels ``reach`` away, so that the middle of a small island is found too.
    """
    height, width = phase.shape
    usable = np.empty((3, width), np.uint8)
    for y in range(row_start, row_stop):
        mark = doubtful[y]
        own, reason = phase[y], state[y]
        here = usable[0]
        for x in range(width):
            here[x] = np.uint8((reason[x] == VALID) | (reason[x] == CONFLICT) | (reason[x] == OUTSIDE))
            mark[x] = np.uint8(reason[x] == CONFLICT)
        for far in range(2):
            shift = reach if far else 1
            if far and reach <= 1:
                break
            for side in range(2):
                v = min(y + shift, height - 1) if side else max(y - shift, 0)
                other, its = phase[v], state[v]
                for x in range(width):
                    there = (its[x] == VALID) | (its[x] == CONFLICT) | (its[x] == OUTSIDE)
                    mark[x] |= np.uint8(there & (abs(other[x] - own[x]) > step)) & here[x]
            ahead, behind = own[shift:], own[: width - shift]
            mark_ahead, mark_behind = mark[shift:], mark[: width - shift]
            here_ahead, here_behind = here[shift:], here[: width - shift]
            differs = usable[1]
            for x in range(width - shift):
                differs[x] = np.uint8(abs(ahead[x] - behind[x]) > step) & here_ahead[x] & here_behind[x]
            for x in range(width - shift):
                mark_behind[x] |= differs[x]
            for x in range(width - shift):
                mark_ahead[x] |= differs[x]


@njit(**ALLOCATING_LOOP)
def vote(
    places: Any,  # (D,) flat indices of doubtful pixels
    phase: Any,  # (H, W) float32
    sigma: Any,  # (H, W) float32
    state: Any,  # (H, W) uint8
    residual: Any,  # (H, W) int8, cycles × RESIDUAL_SCALE
    gate: Any,  # float32, cycles
    allowance: Any,  # float32, cycles of tolerance per radian of sigma
    slack: Any,  # float32, cycles a repaired pixel may be off in any case
    radius: int,
    start: int,
    stop: int,
    verdicts: Any,  # out (D,) int8: by how many orders a pixel changes, or REFUSED
) -> None:
    """Let the window decide the order of doubtful pixels.

    A pixel follows the majority only when its own rounding residual allows that order, or stays as it is; one that neither
    its residual nor its neighbours support is refused.
    """
    height, width = phase.shape
    tally = np.zeros(2 * MOST_ORDERS + 1, np.int64)
    for i in range(start, stop):
        y, x = places[i] // width, places[i] % width
        verdicts[i] = STANDS
        reason = state[y, x]
        if reason != VALID and reason != CONFLICT and reason != OUTSIDE:
            continue
        own = phase[y, x]
        left = np.float32(residual[y, x]) / np.float32(RESIDUAL_SCALE)
        trusted = abs(left) <= gate and reason != CONFLICT
        others, same = 0, 0
        tally[:] = 0
        for v in range(max(0, y - radius), min(height, y + radius + 1)):
            for u in range(max(0, x - radius), min(width, x + radius + 1)):
                its = state[v, u]
                if (its != VALID and its != CONFLICT and its != OUTSIDE) or (u == x and v == y):
                    continue
                step = np.floor((phase[v, u] - own) / TAU + HALF)
                if step == 0:
                    same += 1
                elif abs(step) <= MOST_ORDERS:
                    tally[int(step) + MOST_ORDERS] += 1
                others += 1
        best = 0
        for m in range(tally.shape[0]):
            if tally[m] > tally[best]:
                best = m
        if tally[best] > same and 2 * tally[best] > others:
            if abs(left - np.float32(best - MOST_ORDERS)) <= slack + allowance * sigma[y, x]:
                verdicts[i] = best - MOST_ORDERS
            elif not trusted:
                verdicts[i] = REFUSED
        elif (not trusted and (same < 3 or 2 * same <= others)) or (same == 0 and others >= 4):
            verdicts[i] = REFUSED


@njit(**ALLOCATING_LOOP)
def apply_verdicts(
    places: Any, verdicts: Any, order_steps: Any, lowest: Any, highest: Any, start: int, stop: int, phase: Any, state: Any
) -> int:
    """Change orders and reasons (flat maps) as the window said; returns how many pixels changed their order.

    ``order_steps`` (2 · MOST_ORDERS + 1,) float32 holds what the phase changes by, in radians, for every change of order.
    """
    repaired = 0
    for i in range(start, stop):
        k = places[i]
        if state[k] != VALID and state[k] != CONFLICT and state[k] != OUTSIDE:
            continue
        if verdicts[i] == REFUSED:
            state[k] = CONFLICT
            continue
        if verdicts[i] != STANDS:
            phase[k] += order_steps[verdicts[i] + MOST_ORDERS]
            repaired += 1
        state[k] = OUTSIDE if phase[k] < lowest or phase[k] > highest else VALID
    return repaired


@njit(**ALLOCATING_LOOP)
def find_edges(places: Any, phase: Any, state: Any, step: Any, start: int, stop: int, edge: Any) -> None:
    """Mark (D,) valid pixels whose phase differs by more than ``step`` from a valid neighbour (left, right, above, below)."""
    height, width = phase.shape
    for i in range(start, stop):
        y, x = places[i] // width, places[i] % width
        edge[i] = False
        if state[y, x] != VALID:
            continue
        own = phase[y, x]
        edge[i] = (
            (x > 0 and state[y, x - 1] == VALID and abs(phase[y, x - 1] - own) > step)
            or (x + 1 < width and state[y, x + 1] == VALID and abs(phase[y, x + 1] - own) > step)
            or (y > 0 and state[y - 1, x] == VALID and abs(phase[y - 1, x] - own) > step)
            or (y + 1 < height and state[y + 1, x] == VALID and abs(phase[y + 1, x] - own) > step)
        )
