"""Compiled loops that turn the sums of pixels into phase, standard deviation and reason, block by block.

The readable statements stand in `phase_shift.py`, `gray_code.py`, `unwrap.py` and the tests. Inner functions are forced inline: a
call would count the references of every array.
"""
# The innermost loops become SIMD code only when they are plain loops over one index and few arrays.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.records import BLOCK, CHUNK, RESIDUAL_SCALE

HALF, QUARTER, THREE_QUARTERS = np.float32(0.5), np.float32(0.25), np.float32(0.75)
TAU = np.float32(2 * np.pi)
TINY = np.float32(1e-12)
VALID, SATURATED, WEAK, SHADOW, CONFLICT, OUTSIDE, BLOOMING = 0, 1, 2, 3, 4, 5, 7  # of PixelState

# With the error model of Python a division is a branch, and the loop around it stays scalar.
ENTRY: dict[str, Any] = {"nogil": True, "_nrt": False, "cache": True, "error_model": "numpy", "fastmath": True}
INNER: dict[str, Any] = {**ENTRY, "forceinline": True}

# Odd polynomial for atan on 0…1 in cycles, fitted by iteratively reweighted least squares; error below 1e-7 rad.
_RAD = (0.999999336, -0.33329861, 0.199465668, -0.139086327, 0.0964220148, -0.0559123465, 0.0218629532, -0.00405456218)
A1, A3, A5, A7, A9, A11, A13, A15 = (np.float32(value / (2 * np.pi)) for value in _RAD)


@njit(**ENTRY, inline="always")
def atan2_cycles(sine: Any, cosine: Any) -> Any:
    """Return atan2 over 2π in float32; branch-free, so that the loop around it becomes SIMD code (numba's own is ten times slower)."""
    across = abs(cosine)
    up = abs(sine)
    small = min(across, up)
    large = max(across, up)
    q = small / (large + TINY)
    p = q * q
    angle = q * (A1 + p * (A3 + p * (A5 + p * (A7 + p * (A9 + p * (A11 + p * (A13 + p * A15)))))))
    angle = QUARTER - angle if up > across else angle
    angle = HALF - angle if cosine < 0 else angle
    return -angle if sine < 0 else angle


@njit(**INNER)
def wrap(sine: Any, cosine: Any, n: int, sign: Any, origin: Any, phase: Any, power: Any) -> None:
    """Turn the sums of a group into wrapped phase, from column 0 in cycles, and squared modulation."""
    for j in range(n):
        s = np.float32(sine[j])
        c = np.float32(cosine[j])
        power[j] = s * s + c * c
        phase[j] = sign * atan2_cycles(s, c) - origin


@njit(**INNER)
def correct(phase: Any, n: int, table: Any, origin: Any) -> None:
    """Take out what the projector's response does to the phase."""
    last = table.shape[0] - 1
    for j in range(n):
        turns = phase[j] + origin + HALF
        place = (turns - np.floor(turns)) * np.float32(last)
        k = min(max(int(place), 0), last - 1)
        phase[j] += table[k] + (place - np.float32(k)) * (table[k + 1] - table[k])


@njit(**INNER)
def combine_phases(factors: Any, n: int, work: Any) -> None:
    """Put the sum of the groups' phases, each times its factor, into ``work.wrapped``."""
    wrapped = work.wrapped
    begun = False
    for g in range(factors.shape[0]):
        factor = factors[g]
        if factor == 0:
            continue
        phase = work.phase[g]
        if begun:
            for j in range(n):
                wrapped[j] += factor * phase[j]
        else:
            for j in range(n):
                wrapped[j] = factor * phase[j]
        begun = True


@njit(**INNER)
def unwrap_heterodyne(n: int, model: Any, work: Any) -> None:
    """Unwrap from the coarsest combination of the phases to the finest pitch."""
    value, wrapped, residual = work.value, work.wrapped, work.residual
    combine_phases(model.combinations[0], n, work)
    guard = model.guard
    for j in range(n):
        value[j] = wrapped[j] - np.floor(wrapped[j] + guard)
    for j in range(n):
        residual[j] = 0
    for k in range(1, model.combinations.shape[0]):
        combine_phases(model.combinations[k], n, work)
        ratio = model.ratios[k]
        if k == model.watched:
            for j in range(n):
                decision = value[j] * ratio - wrapped[j]
                order = np.floor(decision + HALF)
                residual[j] = decision - order
                value[j] = wrapped[j] + order
        elif model.watched < 0:
            for j in range(n):
                decision = value[j] * ratio - wrapped[j]
                order = np.floor(decision + HALF)
                left = decision - order
                residual[j] = left if abs(left) > abs(residual[j]) else residual[j]
                value[j] = wrapped[j] + order
        else:
            for j in range(n):
                value[j] = wrapped[j] + np.floor(value[j] * ratio - wrapped[j] + HALF)


@njit(**INNER)
def unwrap_gray(sums: Any, off: int, n: int, layout: Any, model: Any, work: Any) -> None:
    """Number the periods by Gray code; half a period of overlap with the complementary plane heals the edges of the planes."""
    value, residual = work.value, work.residual
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


@njit(**INNER)
def look_up(table: Any, taken: Any, alike: int, n: int, out: Any) -> None:
    """Write what belongs to the exposures that each pixel took."""
    if alike >= 0:
        value = table[alike]
        for j in range(n):
            out[j] = value
    else:
        for j in range(n):
            out[j] = table[taken[j]]


@njit(**INNER)
def common(sums: Any, off: int, n: int) -> Any:
    """Return the exposures that all pixels of a block took, as bits; -1 where they differ or some have a reason of their own."""
    zero, bloomed = sums.zero[off : off + n], sums.bloomed[off : off + n]
    first = sums.taken[0, off]
    marked, differs = np.uint8(0), np.uint16(0)
    for j in range(n):
        marked |= zero[j] | bloomed[j]
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            differs |= taken[j] ^ first
    return np.int64(first) if marked == 0 and differs == 0 else np.int64(-1)


@njit(**INNER)
def least_modulation(sums: Any, off: int, n: int, alike: int, layout: Any, model: Any, work: Any) -> None:
    """Put the least modulation of all groups, at the longest exposure taken, into ``work.modulation``."""
    modulation, part = work.modulation, work.weight
    apart = sums.total.shape[0] > 1
    for g in range(layout.steps.shape[0]):
        power = work.power[g]
        norm = np.float32(4.0) / np.float32(layout.steps[g] * layout.steps[g])
        if apart:
            look_up(model.to_brightest, sums.taken[g, off : off + n], alike, n, part)
            for j in range(n):
                own = norm * power[j] * part[j] * part[j]
                modulation[j] = own if g == 0 else min(modulation[j], own)
        elif g == 0:
            for j in range(n):
                modulation[j] = norm * power[j]
        else:
            for j in range(n):
                modulation[j] = min(modulation[j], norm * power[j])
    if apart:
        for j in range(n):
            modulation[j] = np.sqrt(modulation[j])
        return
    look_up(model.to_brightest, sums.taken[0, off : off + n], alike, n, part)
    for j in range(n):
        modulation[j] = np.sqrt(modulation[j]) * part[j]


@njit(**INNER)
def weigh(sums: Any, off: int, n: int, alike: int, layout: Any, model: Any, work: Any) -> None:
    """Put the variance of the grey levels' sums into ``work.noise``; where groups decide apart, into their powers instead."""
    noise, count, shot, dark = work.noise, work.count, work.weight, work.wrapped
    gain, floor, black = model.gain, model.floor, model.black
    apart = sums.total.shape[0] > 1
    for m in range(sums.total.shape[0]):
        total = sums.total[m, off : off + n]
        each = np.float32(1) / np.float32(layout.steps[m if apart else model.finest])
        look_up(model.count, sums.taken[m, off : off + n], alike, n, count)
        look_up(model.shot, sums.taken[m, off : off + n], alike, n, shot)
        look_up(model.dark, sums.taken[m, off : off + n], alike, n, dark)
        for j in range(n):
            light = np.float32(total[j]) * each - count[j] * black
            noise[j] = max(light, np.float32(0)) * gain * shot[j] + dark[j] * floor
        if apart:
            power = work.power[m]
            for j in range(n):
                power[j] /= noise[j] + TINY
    if apart:
        for j in range(n):
            noise[j] = 1


@njit(**INNER)
def draw(sums: Any, off: int, begin: int, n: int, alike: int, layout: Any, model: Any, work: Any, maps: Any) -> None:
    """Write modulation, grey level at the longest exposure, and exposure of the pixels into their maps."""
    modulation, shown = work.modulation, maps.modulation[begin : begin + n]
    most = np.float32(255 if maps.modulation.itemsize == 1 else 65535)
    for j in range(n):
        shown[j] = np.int32(min(modulation[j] + HALF, most))
    m = 0 if sums.total.shape[0] == 1 else model.finest
    total, grey, scale = sums.total[m, off : off + n], maps.grey[begin : begin + n], work.count
    each = np.float32(1) / np.float32(layout.steps[model.finest])
    beyond, white = model.beyond, np.float32(65535)
    look_up(model.to_longest, sums.taken[m, off : off + n], alike, n, scale)
    for j in range(n):
        level = np.float32(total[j]) * each * scale[j]
        level = beyond if scale[j] == 0 else level
        grey[j] = np.int32(min(level + HALF, white))
    exposure, code = maps.exposure[begin : begin + n], work.code[0]
    for j in range(n):
        code[j] = 0
    if alike < 0:
        for k in range(sums.taken.shape[0]):
            taken = sums.taken[k, off : off + n]
            for j in range(n):
                code[j] |= np.int32(taken[j])
    look_up(model.first, code, alike, n, exposure)


@njit(**INNER)
def average(n: int, layout: Any, model: Any, work: Any) -> None:
    """Average the phases of all pitches by inverse variance; ``work.weight`` becomes the variance in rad²."""
    value, weight, shift, noise = work.value, work.weight, work.wrapped, work.noise
    own = work.power[model.finest]
    share = np.float32(2) / np.float32(layout.steps[model.finest])
    for j in range(n):
        weight[j] = share * own[j]
    for j in range(n):
        shift[j] = 0
    for g in range(layout.steps.shape[0]):
        if g == model.finest:
            continue
        power, phase = work.power[g], work.phase[g]
        scale = model.scales[g]
        factor = np.float32(2) * scale * scale / np.float32(layout.steps[g])
        inverse = np.float32(1) / scale
        for j in range(n):
            part = factor * power[j]
            off = phase[j] - value[j] * scale
            off -= np.floor(off + HALF)
            shift[j] += part * inverse * off
            weight[j] += part
    for j in range(n):
        known = np.float32(1) / (weight[j] + TINY)
        value[j] += shift[j] * known
        weight[j] = noise[j] * known


@njit(**INNER)
def judge(sums: Any, off: int, n: int, alike: int, model: Any, work: Any, state: Any) -> None:
    """Give every pixel its reason."""
    value, variance, residual, modulation = work.value, work.weight, work.residual, work.modulation
    weak, dark = model.most_sigma * model.most_sigma, model.dark_sigma * model.dark_sigma
    low, high, gate, least = model.lowest, model.highest, model.gate, model.least_modulation
    for j in range(n):
        reason = np.int32(CONFLICT) if abs(residual[j]) > gate else np.int32(VALID)
        reason = np.int32(OUTSIDE) if (value[j] < low) | (value[j] > high) else reason
        reason = np.int32(WEAK) if (modulation[j] < least) | (variance[j] > weak) else reason
        reason = np.int32(SHADOW) if variance[j] > dark else reason
        state[j] = np.uint8(reason)
    if alike > 0:
        return
    if alike == 0:
        for j in range(n):
            state[j] = np.uint8(SATURATED)
        return
    zero = sums.zero[off : off + n]
    if model.zero_is_dark:
        for j in range(n):
            state[j] = np.uint8(WEAK) if (zero[j] != 0) & (state[j] != SHADOW) else state[j]
    bloomed = sums.bloomed[off : off + n]
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            lost = np.uint8(BLOOMING) if bloomed[j] != 0 else np.uint8(SATURATED)
            state[j] = lost if taken[j] == 0 else state[j]


@njit(**INNER)
def keep(begin: int, n: int, model: Any, work: Any, maps: Any, state: Any) -> None:
    """Write phase and standard deviation of valid pixels, and of doubtful ones where the window decides later."""
    value, variance, residual = work.value, work.weight, work.residual
    phase = maps.phase[begin : begin + n]
    sigma = maps.sigma[begin : begin + n]
    origin = model.origin
    last = np.uint8(OUTSIDE) if model.undecided else np.uint8(VALID)
    for j in range(n):
        kept = (state[j] == VALID) | ((state[j] >= CONFLICT) & (state[j] <= last))
        phase[j] = (value[j] + origin) * TAU if kept else np.float32(0)
    for j in range(n):
        kept = (state[j] == VALID) | ((state[j] >= CONFLICT) & (state[j] <= last))
        sigma[j] = np.sqrt(variance[j]) if kept else np.float32(0)
    if model.undecided:
        left = maps.residual[begin : begin + n]
        for j in range(n):
            left[j] = np.int32(residual[j] * np.float32(RESIDUAL_SCALE))


@njit(**INNER)
def tally(sums: Any, off: int, n: int, alike: int, work: Any, state: Any, counts: Any) -> None:
    """Count the pixels of every state, and last those with an exposure above zero in all groups."""
    lost = np.int32(0)
    for j in range(n):
        lost += np.int32(state[j] != VALID)
    counts[VALID] += n - lost
    if lost > 0:
        for reason in range(1, counts.shape[0] - 1):
            number = np.int32(0)
            for j in range(n):
                number += np.int32(state[j] == reason)
            counts[reason] += number
    if alike >= 0:
        counts[-1] += n if alike > 0 else 0
        return
    zero, complete = sums.zero[off : off + n], work.code[0]
    for j in range(n):
        complete[j] = np.int32(zero[j] == 0)
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            complete[j] &= np.int32(taken[j] != 0)
    whole = np.int32(0)
    for j in range(n):
        whole += complete[j]
    counts[-1] += whole


@njit(**ENTRY)
def solve(
    sums: Any,
    base: int,  # pixel that the sums begin with
    layout: Any,
    model: Any,
    work: Any,
    start: int,
    stop: int,
    maps: Any,
    counts: Any,  # (states + 1,) int64, gains the pixels of every state, and complete ones last
) -> None:
    """Turn the sums of pixels ``start … stop`` into their maps."""
    for chunk in range(start, stop, CHUNK):
        for begin in range(chunk, min(chunk + CHUNK, stop), BLOCK):
            off, n = begin - base, min(BLOCK, stop - begin)
            alike = sums.alike[(chunk - base) // CHUNK]
            if alike < 0:
                alike = common(sums, off, n)
            for g in range(layout.steps.shape[0]):
                sine, cosine = sums.sine[g, off : off + n], sums.cosine[g, off : off + n]
                wrap(sine, cosine, n, model.sine_sign, model.origin, work.phase[g], work.power[g])
                if model.correction.shape[1] > 0:
                    correct(work.phase[g], n, model.correction[g], model.origin)
            if model.combinations.shape[0] > 0:
                unwrap_heterodyne(n, model, work)
            else:
                unwrap_gray(sums, off, n, layout, model, work)
            least_modulation(sums, off, n, alike, layout, model, work)
            weigh(sums, off, n, alike, layout, model, work)
            average(n, layout, model, work)
            state = maps.state[begin : begin + n]
            judge(sums, off, n, alike, model, work, state)
            keep(begin, n, model, work, maps, state)
            draw(sums, off, begin, n, alike, layout, model, work, maps)
            tally(sums, off, n, alike, work, state, counts)
