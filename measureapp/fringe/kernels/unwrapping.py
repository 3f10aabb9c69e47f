"""Compiled steps from wrapped phases to fringe orders; the readable statements stand in `unwrap.py` and `gray_code.py`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE
from measureapp.compiled.simd.elements import broadcast, convert, floor, select
from measureapp.compiled.simd.memory import load
from measureapp.fringe.kernels.records import PIXELS, SPACING


@njit(**INLINE)
def combined(k: int, j: int, model: Any, work: Any) -> Any:
    """Return a combination of the groups' phases: their sum, each times its factor."""
    if model.alone[k] >= 0:
        return load(work.phase, model.alone[k] * SPACING + j, PIXELS)
    factors = model.combinations[k]
    total = factors[0] * load(work.phase, j, PIXELS)
    for g in range(1, factors.shape[0]):
        total = total + factors[g] * load(work.phase, g * SPACING + j, PIXELS)
    return total


@njit(**INLINE)
def unwrap_heterodyne(j: int, model: Any, work: Any) -> Any:
    """Unwrap from the coarsest combination of the phases to the finest pitch; returns absolute phases and rounding residuals."""
    wrapped = combined(0, j, model, work)
    value, residual = wrapped - floor(wrapped + model.guard), broadcast(np.float32(0), PIXELS)
    for k in range(1, model.combinations.shape[0]):
        wrapped = combined(k, j, model, work)
        decision = value * model.ratios[k] - wrapped
        order = floor(decision + 0.5)
        left = decision - order
        if model.watched < 0:
            residual = select(abs(left) > abs(residual), left, residual)
        elif k == model.watched:
            residual = left
        value = wrapped + order
    return value, residual


@njit(**INLINE)
def unwrap_gray(sums: Any, off: int, j: int, layout: Any, model: Any, work: Any) -> Any:
    """Number the periods by Gray code; half a period of overlap with the complementary plane heals the edges of the planes."""
    code, coarse, bit = broadcast(np.int32(0), PIXELS), broadcast(np.int32(0), PIXELS), broadcast(np.int32(0), PIXELS)
    light = convert(load(sums.total[0 if sums.total.shape[0] == 1 else model.finest], off + j, PIXELS), np.float32)
    steps = np.float32(layout.steps[model.finest])
    for b in range(layout.planes.shape[0]):
        bright = steps * convert(load(sums.planes[b], off + j, PIXELS), np.float32) > light
        bit = select(bright, np.int32(1) - bit, bit)
        coarse = code
        code = code + code + bit
    phase = load(work.phase, model.finest * SPACING + j, PIXELS)
    aligned = phase - floor(phase)
    if not model.complementary:
        return convert(code, np.float32) + aligned, 0.5 - aligned
    shifted = (code + np.int32(1)) >> np.int32(1)
    period = select(aligned < 0.25, shifted, select(aligned >= 0.75, shifted - np.int32(1), coarse))
    apart = select(abs(coarse - period) > np.int32(1), broadcast(np.float32(1), PIXELS), np.float32(0))
    return convert(period, np.float32) + aligned, apart
