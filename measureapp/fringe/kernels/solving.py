"""Compiled loops that turn the sums of pixels into phase, standard deviation and reason, chunk by chunk.

The readable statements stand in `phase_shift.py`, `gray_code.py`, `unwrap.py` and the tests. Inner functions are forced inline: a
call would count the references of every array.
"""
# The innermost loops become SIMD code only when they are plain loops over one index and few arrays.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.drawing import draw, tally
from measureapp.fringe.kernels.options import BLOOMING, CONFLICT, HALF, INLINE, LOOP, OUTSIDE, SATURATED, SHADOW, TAU, TINY, VALID, WEAK
from measureapp.fringe.kernels.records import (
    BLACK,
    CHUNK,
    FLOOR,
    GAIN,
    LEVEL,
    LOST,
    MODULATION,
    REASON,
    RESIDUAL,
    SHIFT,
    SIGMA,
    TO_BRIGHTEST,
    TO_LONGEST,
    VALUE,
    WEIGHT,
)
from measureapp.fringe.kernels.taken import common, draw_exposure, look_up, set_apart, set_together
from measureapp.fringe.kernels.unwrapping import unwrap_gray, unwrap_heterodyne
from measureapp.fringe.kernels.wrapping import correct, wrap

LEAST = np.float32(1e-30)


@njit(**LOOP, inline="always")
def root(square: Any) -> Any:
    """Return the square root of a positive number, by way of its reciprocal, for which processors have a fast estimate to refine."""
    return square * (np.float32(1) / np.sqrt(square + LEAST))


@njit(**INLINE)
def least_modulation(n: int, layout: Any, work: Any) -> None:
    """Put the least squared modulation of all groups, in the sums, into its row."""
    rows = work.rows
    for g in range(layout.steps.shape[0]):
        power = work.power[g]
        norm = np.float32(4.0) / np.float32(layout.steps[g] * layout.steps[g])
        if g == 0:
            for j in range(n):
                rows[MODULATION + j] = norm * power[j]
        else:
            for j in range(n):
                rows[MODULATION + j] = min(rows[MODULATION + j], norm * power[j])


@njit(**INLINE)
def weigh_groups(sums: Any, off: int, n: int, layout: Any, model: Any, work: Any) -> None:
    """Divide the power of groups that decide apart by the variance of their grey levels' sums; the noise left to them all is 1."""
    rows = work.rows
    for m in range(sums.total.shape[0]):
        total, taken, power = sums.total[m, off : off + n], sums.taken[m, off : off + n], work.power[m]
        each = np.float32(1) / np.float32(layout.steps[m])
        norm = np.float32(4.0) * each * each
        look_up(model.to_brightest, taken, n, rows[TO_BRIGHTEST : TO_BRIGHTEST + n])
        for j in range(n):
            part = rows[TO_BRIGHTEST + j]
            own = norm * power[j] * part * part
            rows[MODULATION + j] = own if m == 0 else min(rows[MODULATION + j], own)
        look_up(model.black, taken, n, rows[BLACK : BLACK + n])
        look_up(model.gain, taken, n, rows[GAIN : GAIN + n])
        look_up(model.floor, taken, n, rows[FLOOR : FLOOR + n])
        for j in range(n):
            light = max(np.float32(total[j]) * each - rows[BLACK + j], np.float32(0))
            power[j] /= light * rows[GAIN + j] + rows[FLOOR + j] + TINY
    rows[TO_BRIGHTEST : TO_BRIGHTEST + n] = 1
    rows[GAIN : GAIN + n] = 0
    rows[FLOOR : FLOOR + n] = 1


@njit(**INLINE)
def average(n: int, layout: Any, model: Any, work: Any) -> None:
    """Sum the weights of all pitches, and what they take the phase of the finest away from it, each times its weight."""
    rows = work.rows
    own = work.power[model.finest]
    share = np.float32(2) / np.float32(layout.steps[model.finest])
    begun = False
    for g in range(layout.steps.shape[0]):
        if g == model.finest:
            continue
        power, phase = work.power[g], work.phase[g]
        scale = model.scales[g]
        factor = np.float32(2) * scale * scale / np.float32(layout.steps[g])
        inverse = np.float32(1) / scale
        if begun:
            for j in range(n):
                part = factor * power[j]
                apart = phase[j] - rows[VALUE + j] * scale
                apart -= np.floor(apart + HALF)
                rows[SHIFT + j] += part * inverse * apart
                rows[WEIGHT + j] += part
        else:
            for j in range(n):
                part = factor * power[j]
                apart = phase[j] - rows[VALUE + j] * scale
                apart -= np.floor(apart + HALF)
                rows[SHIFT + j] = part * inverse * apart
                rows[WEIGHT + j] = part + share * own[j]
        begun = True
    if not begun:
        for j in range(n):
            rows[SHIFT + j] = 0
            rows[WEIGHT + j] = share * own[j]


@njit(**INLINE)
def judge(total: Any, n: int, layout: Any, model: Any, work: Any) -> None:
    """Turn the rows into what the maps hold: average the phases by inverse variance, give every pixel its reason."""
    rows = work.rows
    each = np.float32(1) / np.float32(layout.steps[model.finest])
    weak, dark = model.most_sigma * model.most_sigma, model.dark_sigma * model.dark_sigma
    low, high, gate, least = model.lowest, model.highest, model.gate, model.least_modulation
    shot, floor, sure = model.one_gain, model.one_floor, model.sure
    origin, beyond = model.origin, model.beyond
    last = np.int32(OUTSIDE if model.undecided else VALID)
    for j in range(n):
        level = np.float32(total[j]) * each
        known = np.float32(1) / (rows[WEIGHT + j] + TINY)
        value = rows[VALUE + j] + rows[SHIFT + j] * known
        light = max(level - rows[BLACK + j], np.float32(0))
        noise = light * rows[GAIN + j] + rows[FLOOR + j]
        variance = noise * known
        modulation = root(rows[MODULATION + j]) * rows[TO_BRIGHTEST + j]
        alone = light * rows[TO_BRIGHTEST + j] * shot + floor  # noise of one image at the longest exposure taken
        faint = (modulation < least) & ((rows[MODULATION + j] * alone < least * least * noise) | (variance > sure))
        lost = np.int32(rows[LOST + j])
        reason = np.int32(CONFLICT) if abs(rows[RESIDUAL + j]) > gate else np.int32(VALID)
        reason = np.int32(OUTSIDE) if (value < low) | (value > high) else reason
        reason = np.int32(WEAK) if faint | (variance > weak) | (lost == WEAK) else reason
        reason = np.int32(SHADOW) if variance > dark else reason
        reason = lost if (lost == SATURATED) | (lost == BLOOMING) else reason
        kept = (reason == VALID) | ((reason >= CONFLICT) & (reason <= last))
        rows[VALUE + j] = (value + origin) * TAU if kept else np.float32(0)
        rows[SIGMA + j] = root(variance) if kept else np.float32(0)
        rows[MODULATION + j] = modulation
        rows[LEVEL + j] = beyond if rows[TO_LONGEST + j] == 0 else level * rows[TO_LONGEST + j]
        rows[REASON + j] = np.float32(reason)


@njit(**INLINE)
def wrap_groups(sums: Any, off: int, n: int, layout: Any, model: Any, work: Any) -> None:
    """Turn the sums of all groups into corrected wrapped phases."""
    for g in range(layout.steps.shape[0]):
        sine, cosine = sums.sine[g, off : off + n], sums.cosine[g, off : off + n]
        wrap(sine, cosine, n, model.sine_sign, model.origin, work.phase[g], work.power[g])
        if model.correction.shape[1] > 0:
            correct(work.phase[g], n, model.correction[g], model.origin)


@njit(**INLINE)
def weigh(sums: Any, off: int, n: int, alike: Any, layout: Any, model: Any, work: Any) -> None:
    """Put the least modulation of the groups into its row; where they decide apart, make their powers and noise alike."""
    if sums.total.shape[0] == 1:
        least_modulation(n, layout, work)
        return
    if alike >= 0:
        sums.taken[:, off : off + n] = np.uint16(alike)
    weigh_groups(sums, off, n, layout, model, work)


@njit(**INLINE)
def solve(
    sums: Any,
    off: int,  # of the pixels in the sums
    layout: Any,
    model: Any,
    work: Any,
    begin: int,  # first of the pixels
    n: int,  # how many they are
    maps: Any,
    counts: Any,  # (states + 1,) int64, gains the pixels of every state, and complete ones last
) -> None:
    """Turn the sums of a chunk of pixels into their maps."""
    apart = sums.total.shape[0] > 1
    alike = sums.alike[off // CHUNK]
    if alike < 0:
        alike = common(sums, off, n)
    wrap_groups(sums, off, n, layout, model, work)
    if model.combinations.shape[0] > 0:
        unwrap_heterodyne(n, model, work)
    else:
        unwrap_gray(sums, off, n, layout, model, work)
    if alike < 0:
        set_apart(sums, off, n, model, work)
    elif alike != work.known[0]:
        set_together(alike, model, work)
    work.known[0] = -1 if apart else alike
    weigh(sums, off, n, alike, layout, model, work)
    average(n, layout, model, work)
    judge(sums.total[model.finest if apart else 0, off : off + n], n, layout, model, work)
    draw(begin, n, model, work, maps)
    draw_exposure(sums, off, begin, n, alike, model, work, maps)
    tally(sums, off, n, alike, work, maps.state[begin : begin + n], counts)
