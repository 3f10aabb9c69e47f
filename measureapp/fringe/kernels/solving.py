"""Compiled loops that turn the sums of pixels into phase, standard deviation and reason, chunk by chunk.

The readable statements stand in `phase_shift.py`, `gray_code.py`, `unwrap.py` and the tests. Inner functions are forced inline: a
call would count the references of every array.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.buffer_pool import CACHE_LINE_BYTES
from measureapp.compiled.options import INLINE
from measureapp.compiled.simd.elements import any_lane, broadcast, convert, floor, maximum, minimum, select, sqrt
from measureapp.compiled.simd.memory import gather, load, store
from measureapp.fringe.kernels.constants import BLOOMING, CONFLICT, OUTSIDE, SATURATED, SHADOW, TAU, TINY, VALID, WEAK
from measureapp.fringe.kernels.drawing import draw, draw_exposure, tally
from measureapp.fringe.kernels.prefetching import prefetch_sinusoids
from measureapp.fringe.kernels.records import (
    BLACK,
    CHUNK,
    FLOOR,
    GAIN,
    LOST,
    MODULATION,
    PIXELS,
    SPACING,
    TO_BRIGHTEST,
    TO_LONGEST,
)
from measureapp.fringe.kernels.taken import common, set_apart, set_together
from measureapp.fringe.kernels.unwrapping import unwrap_gray, unwrap_heterodyne
from measureapp.fringe.kernels.wrapping import wrap_groups

LEAST = np.float32(1e-30)


@njit(**INLINE)
def root(square: Any) -> Any:
    """Return the square root of positive numbers, by way of its reciprocal, for which processors have a fast estimate to refine."""
    return square * (np.float32(1) / sqrt(square + LEAST))


@njit(**INLINE)
def weigh_groups(sums: Any, off: int, layout: Any, model: Any, work: Any) -> None:
    """Divide the power of groups that decide apart by the variance of their grey levels' sums; the noise left to them all is 1."""
    rows = work.rows
    for m in range(sums.total.shape[0]):
        each, norm = np.float32(1) / np.float32(layout.steps[m]), model.norms[m]
        for j in range(0, CHUNK, PIXELS):
            taken = convert(load(sums.taken[m], off + j, PIXELS), np.int32)
            power, part = load(work.power, m * SPACING + j, PIXELS), gather(model.to_brightest, taken)
            own = norm * power * part * part
            store(own if m == 0 else minimum(own, load(rows, MODULATION + j, PIXELS)), rows, MODULATION + j)
            light = each * convert(load(sums.total[m], off + j, PIXELS), np.float32) - gather(model.black, taken)
            noise = maximum(light, np.float32(0)) * gather(model.gain, taken) + gather(model.floor, taken)
            store(power / (noise + TINY), work.power, m * SPACING + j)
    rows[TO_BRIGHTEST : TO_BRIGHTEST + CHUNK] = 1
    rows[GAIN : GAIN + CHUNK] = 0
    rows[FLOOR : FLOOR + CHUNK] = 1


@njit(**INLINE)
def averaged(value: Any, j: int, model: Any, work: Any) -> Any:
    """Return the mean of the absolute phases of all pitches by inverse variance, and the sum of their weights, from that of the finest."""
    shift = broadcast(np.float32(0), PIXELS)
    weight = model.shares[model.finest] * load(work.power, model.finest * SPACING + j, PIXELS)
    for g in range(model.scales.shape[0]):
        if g == model.finest:
            continue
        power = load(work.power, g * SPACING + j, PIXELS)
        apart = load(work.phase, g * SPACING + j, PIXELS) - value * model.scales[g]
        apart = apart - floor(apart + 0.5)
        shift = shift + model.pulls[g] * power * apart
        weight = weight + model.shares[g] * power
    known = np.float32(1) / (weight + TINY)
    return value + shift * known, known


@njit(**INLINE)
def reason_of(reason: Any, value: Any, variance: Any, noise: Any, light: Any, modulation: Any, j: int, model: Any, work: Any) -> Any:
    """Return what becomes of pixels, of whose order it is known whether it is in doubt: the gravest reason of all that hold."""
    rows, least = work.rows, model.least_modulation
    square, brightest, lost = load(rows, MODULATION + j, PIXELS), load(rows, TO_BRIGHTEST + j, PIXELS), load(rows, LOST + j, PIXELS)
    alone = light * brightest * model.one_gain + model.one_floor  # noise of one image at the longest exposure taken
    faint = (modulation < least) & ((square * alone < least * least * noise) | (variance > model.sure))
    reason = select((value < model.lowest) | (value > model.highest), np.float32(OUTSIDE), reason)
    reason = select(faint | (variance > model.weak_variance) | (lost == np.float32(WEAK)), np.float32(WEAK), reason)
    reason = select(variance > model.dark_variance, np.float32(SHADOW), reason)
    return select((lost == np.float32(SATURATED)) | (lost == np.float32(BLOOMING)), lost, reason)


@njit(**INLINE)
def judge(value: Any, residual: Any, known: Any, level: Any, j: int, model: Any, work: Any) -> Any:
    """Return what the maps hold of pixels: phase, its standard deviation, modulation, grey level and reason.

    Reasons other than an order in doubt are looked at one by one only where there is one.

    Parameters
    ----------
    known : 1 over the weights of all pitches; times the noise of the sums the variance of the phase
    level : mean of the images summed of the finest pitch
    """
    rows = work.rows
    longest, brightest, lost = load(rows, TO_LONGEST + j, PIXELS), load(rows, TO_BRIGHTEST + j, PIXELS), load(rows, LOST + j, PIXELS)
    light = maximum(level - load(rows, BLACK + j, PIXELS), np.float32(0))
    noise = light * load(rows, GAIN + j, PIXELS) + load(rows, FLOOR + j, PIXELS)
    variance = noise * known
    modulation = root(load(rows, MODULATION + j, PIXELS)) * brightest
    phase, sigma, grey = value * TAU + model.origin * TAU, root(variance), level * longest
    unsure = abs(residual) > model.gate
    reason, kept = select(unsure, broadcast(np.float32(CONFLICT), PIXELS), np.float32(VALID)), ~unsure | model.undecided
    faint = (modulation < model.least_modulation) | (variance > min(model.weak_variance, model.dark_variance))
    if any_lane((value < model.lowest) | (value > model.highest) | faint | (lost != np.float32(VALID))):
        reason = reason_of(reason, value, variance, noise, light, modulation, j, model, work)
        last = np.float32(OUTSIDE if model.undecided else VALID)
        kept = (reason == np.float32(VALID)) | ((reason >= np.float32(CONFLICT)) & (reason <= last))
        grey = select(longest == np.float32(0), model.beyond, grey)
    phase, sigma = select(kept, phase, np.float32(0)), select(kept, sigma, np.float32(0))
    return phase, sigma, modulation, grey, reason


@njit(**INLINE)
def solve(
    sums: Any,
    off: int,  # of the pixels in the sums
    images: Any,  # (E, P, N) that are summed soon
    ahead: int,  # the first of CHUNK pixels of them to prefetch; -1: none
    layout: Any,
    model: Any,
    work: Any,
    begin: int,  # first of CHUNK pixels
    n: int,  # how many of them count
    maps: Any,
    counts: Any,  # (states + 1,) int64, gains the pixels of every state, and complete ones last
) -> None:
    """Turn the sums of a chunk of pixels into their maps."""
    apart = sums.total.shape[0] > 1
    alike = sums.alike[off // CHUNK]
    if alike < 0:
        alike = common(sums, off)
    wrap_groups(sums, off, model, work)
    if alike < 0:
        set_apart(sums, off, model, work)
    elif alike != work.known[0]:
        set_together(alike, model, work)
    work.known[0] = -1 if apart else alike
    if apart:
        if alike >= 0:
            sums.taken[:, off : off + CHUNK] = np.uint16(alike)
        weigh_groups(sums, off, layout, model, work)
    total, each = sums.total[model.finest if apart else 0], np.float32(1) / np.float32(layout.steps[model.finest])
    for j in range(0, CHUNK, PIXELS):
        if ahead >= 0 and j * images.itemsize % CACHE_LINE_BYTES == 0:
            for e in range(images.shape[0]):
                prefetch_sinusoids(images[e], layout, ahead + j)
        if model.combinations.shape[0] > 0:
            value, residual = unwrap_heterodyne(j, model, work)
        else:
            value, residual = unwrap_gray(sums, off, j, layout, model, work)
        value, known = averaged(value, j, model, work)
        level = each * convert(load(total, off + j, PIXELS), np.float32)
        draw(begin + j, judge(value, residual, known, level, j, model, work), residual, model, maps)
    draw_exposure(sums, off, begin, alike, model, maps)
    tally(sums, off, n, alike, maps.state[begin : begin + CHUNK], counts)
