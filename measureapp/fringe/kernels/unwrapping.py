"""Compiled loops from wrapped phases to fringe orders; the readable statements stand in `unwrap.py` and `gray_code.py`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.options import HALF, INLINE, QUARTER, THREE_QUARTERS
from measureapp.fringe.kernels.records import RESIDUAL, VALUE, WRAPPED


@njit(**INLINE)
def combine_phases(factors: Any, n: int, work: Any) -> Any:
    """Put the sum of the groups' phases, each times its factor, into its row; where it is one group's alone, return that group, else -1."""
    rows = work.rows
    begun, single = -1, 0
    for g in range(factors.shape[0]):
        factor = factors[g]
        if factor == 0:
            continue
        phase = work.phase[g]
        if begun < 0:
            begun, single = g, 1
        elif single == 1:
            first, before = work.phase[begun], factors[begun]
            for j in range(n):
                rows[WRAPPED + j] = before * first[j] + factor * phase[j]
            single = 0
        else:
            for j in range(n):
                rows[WRAPPED + j] += factor * phase[j]
    if single == 1 and factors[begun] == 1:
        return begun
    if single == 1:
        first, before = work.phase[begun], factors[begun]
        for j in range(n):
            rows[WRAPPED + j] = before * first[j]
    return -1


@njit(**INLINE)
def unwrap_heterodyne(n: int, model: Any, work: Any) -> None:
    """Unwrap from the coarsest combination of the phases to the finest pitch."""
    rows = work.rows
    alone = combine_phases(model.combinations[0], n, work)
    wrapped = work.phase[alone, :n] if alone >= 0 else rows[WRAPPED : WRAPPED + n]
    guard = model.guard
    for j in range(n):
        rows[VALUE + j] = wrapped[j] - np.floor(wrapped[j] + guard)
        rows[RESIDUAL + j] = 0
    for k in range(1, model.combinations.shape[0]):
        alone = combine_phases(model.combinations[k], n, work)
        wrapped = work.phase[alone, :n] if alone >= 0 else rows[WRAPPED : WRAPPED + n]
        ratio = model.ratios[k]
        if k == model.watched:
            for j in range(n):
                decision = rows[VALUE + j] * ratio - wrapped[j]
                order = np.floor(decision + HALF)
                rows[RESIDUAL + j] = decision - order
                rows[VALUE + j] = wrapped[j] + order
        elif model.watched < 0:
            for j in range(n):
                decision = rows[VALUE + j] * ratio - wrapped[j]
                order = np.floor(decision + HALF)
                left, known = decision - order, rows[RESIDUAL + j]
                rows[RESIDUAL + j] = left if abs(left) > abs(known) else known
                rows[VALUE + j] = wrapped[j] + order
        else:
            for j in range(n):
                rows[VALUE + j] = wrapped[j] + np.floor(rows[VALUE + j] * ratio - wrapped[j] + HALF)


@njit(**INLINE)
def unwrap_gray(sums: Any, off: int, n: int, layout: Any, model: Any, work: Any) -> None:
    """Number the periods by Gray code; half a period of overlap with the complementary plane heals the edges of the planes."""
    value, residual = work.rows[VALUE : VALUE + n], work.rows[RESIDUAL : RESIDUAL + n]
    code, coarse, bit = work.code[0], work.code[1], work.code[2]
    steps = np.float32(layout.steps[model.finest])
    total = sums.total[0 if sums.total.shape[0] == 1 else model.finest, off : off + n]
    phase = work.phase[model.finest]
    for j in range(n):
        code[j] = 0
    for j in range(n):
        bit[j] = 0
    for b in range(layout.planes.shape[0]):
        plane = sums.planes[b, off : off + n]
        for j in range(n):
            coarse[j] = code[j]
        for j in range(n):
            bit[j] ^= np.int32(np.float32(plane[j]) * steps > np.float32(total[j]))
            code[j] = 2 * code[j] + bit[j]
    if not model.complementary:
        for j in range(n):
            aligned = phase[j] - np.floor(phase[j])
            residual[j] = HALF - aligned
            value[j] = np.float32(code[j]) + aligned
        return
    for j in range(n):
        aligned = phase[j] - np.floor(phase[j])
        shifted = (code[j] + 1) // 2
        period = shifted if aligned < QUARTER else (shifted - 1 if aligned >= THREE_QUARTERS else coarse[j])
        residual[j] = np.float32(abs(coarse[j] - period) > 1)
        value[j] = np.float32(period) + aligned
