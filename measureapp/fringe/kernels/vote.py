"""Fringe orders checked against their neighbourhood: doubtful pixels, the vote of the window about them, edges. Plain compiled loops.

The NumPy statements of the same names are in `reference`.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import ALLOCATING_LOOP, INLINE, LOOP
from measureapp.fringe.kernels.structures import MOST_ORDERS, REFUSED, RESIDUAL_SCALE, UNCHANGED
from measureapp.fringe.kernels.wrap import nearest_integer

TAU = np.float32(2 * np.pi)
VALID, CONFLICT, OUTSIDE = np.uint8(0), np.uint8(4), np.uint8(5)  # of PixelState
FEW_SUPPORTERS, MANY_OTHERS = 3, 4


@njit(**INLINE)
def has_phase(state: Any) -> bool:
    """Whether a pixel in this state has a phase before the vote."""
    return (state == VALID) | (state == CONFLICT) | (state == OUTSIDE)


@njit(**LOOP)
def find_doubtful(maps: Any, step: Any, reach: int, row_start: int, row_stop: int, doubtful: Any) -> None:
    """Mark pixels (H, W) with a phase that are in conflict, or differ by more than ``step`` from one of eight others.

    These are the four neighbours and the four pixels ``reach`` away, so that the middle of a small isolated patch is found too.
    """
    height, width = maps.phase.shape
    for y in range(row_start, row_stop):
        mark, phase, state = doubtful[y], maps.phase[y], maps.state[y]
        for x in range(width):
            mark[x] = state[x] == CONFLICT
        for shift in (1, max(reach, 1)):
            for v in (max(y - shift, 0), min(y + shift, height - 1)):
                mark_steps(phase, state, maps.phase[v], maps.state[v], step, mark)
            left, right = slice(0, max(width - shift, 0)), slice(shift, width)
            mark_steps(phase[left], state[left], phase[right], state[right], step, mark[left])
            mark_steps(phase[right], state[right], phase[left], state[left], step, mark[right])


@njit(**INLINE)
def mark_steps(phase: Any, state: Any, other_phase: Any, other_state: Any, step: Any, mark: Any) -> None:
    """Mark pixels of a row whose phase differs by more than ``step`` from that of a pixel of another row."""
    for x in range(mark.shape[0]):
        mark[x] |= has_phase(state[x]) & has_phase(other_state[x]) & (abs(other_phase[x] - phase[x]) > step)


@njit(**ALLOCATING_LOOP)
def vote(places: Any, maps: Any, limits: Any, start: int, stop: int, verdicts: Any) -> None:
    """Let the window decide the orders of doubtful pixels.

    A pixel follows the majority only when its own rounding residual allows that order, or stays as it is; one that neither
    its residual nor its neighbours support is refused.

    Parameters
    ----------
    places : (D,) flat indices of doubtful pixels, of which ``start … stop`` are decided
    maps : (H, W) each
    verdicts : out (D,) int8, by how many orders a pixel changes, or REFUSED
    """
    width = maps.phase.shape[1]
    tally = np.zeros(2 * MOST_ORDERS + 1, np.int64)
    for i in range(start, stop):
        y, x = places[i] // width, places[i] % width
        verdicts[i] = UNCHANGED
        if not has_phase(maps.state[y, x]):
            continue
        residual = np.float32(maps.residual[y, x]) / np.float32(RESIDUAL_SCALE)
        trusted = abs(residual) <= limits.gate and maps.state[y, x] != CONFLICT
        same, others = tally_orders(maps.phase, maps.state, y, x, limits.radius, tally)
        best = np.argmax(tally)
        if tally[best] > same and 2 * tally[best] > others:
            if abs(residual - np.float32(best - MOST_ORDERS)) <= limits.slack + limits.allowance * maps.sigma[y, x]:
                verdicts[i] = best - MOST_ORDERS
            elif not trusted:
                verdicts[i] = REFUSED
        elif (not trusted and (same < FEW_SUPPORTERS or 2 * same <= others)) or (same == 0 and others >= MANY_OTHERS):
            verdicts[i] = REFUSED


@njit(**INLINE)
def tally_orders(phase: Any, state: Any, y: int, x: int, radius: int, tally: Any) -> Any:
    """Count the pixels of a window by the change of order that would bring this pixel to them; returns those of the same order, and all."""
    height, width = phase.shape
    same, others = 0, 0
    tally[:] = 0
    for v in range(max(0, y - radius), min(height, y + radius + 1)):
        for u in range(max(0, x - radius), min(width, x + radius + 1)):
            if not has_phase(state[v, u]) or (u == x and v == y):
                continue
            change = nearest_integer((phase[v, u] - phase[y, x]) / TAU)
            if change == 0:
                same += 1
            elif abs(change) <= MOST_ORDERS:
                tally[int(change) + MOST_ORDERS] += 1
            others += 1
    return same, others


@njit(**LOOP)
def apply_verdicts(places: Any, verdicts: Any, limits: Any, start: int, stop: int, maps: Any) -> int:
    """Change orders and states as the window decided; returns how many pixels changed their order."""
    width, repaired = maps.phase.shape[1], 0
    for i in range(start, stop):
        y, x = places[i] // width, places[i] % width
        if not has_phase(maps.state[y, x]):
            continue
        if verdicts[i] == REFUSED:
            maps.state[y, x] = CONFLICT
            continue
        if verdicts[i] != UNCHANGED:
            maps.phase[y, x] += limits.order_steps[verdicts[i] + MOST_ORDERS]
            repaired += 1
        outside = maps.phase[y, x] < limits.lowest or maps.phase[y, x] > limits.highest
        maps.state[y, x] = OUTSIDE if outside else VALID
    return repaired


@njit(**LOOP)
def find_edges(places: Any, maps: Any, step: Any, start: int, stop: int, edge: Any) -> None:
    """Mark (D,) valid pixels whose phase differs by more than ``step`` from a valid neighbour (left, right, above, below)."""
    height, width = maps.phase.shape
    for i in range(start, stop):
        y, x = places[i] // width, places[i] % width
        edge[i] = False
        if maps.state[y, x] != VALID:
            continue
        for v, u in ((y, x - 1), (y, x + 1), (y - 1, x), (y + 1, x)):
            inside = 0 <= v < height and 0 <= u < width
            if inside and maps.state[v, u] == VALID and abs(maps.phase[v, u] - maps.phase[y, x]) > step:
                edge[i] = True
