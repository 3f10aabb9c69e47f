"""Compiled loops that turn the sums of pixels into phase, standard deviation and reason, block by block.

The readable statements stand in `phase_shift.py`, `gray_code.py`, `unwrap.py` and the tests. Inner functions are forced inline: a
call would count the references of every array.
"""
# The innermost loops become SIMD code only when they are plain loops over one index and few arrays.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.fringe.kernels.memory import STREAMED, write_past_caches
from measureapp.fringe.kernels.records import (
    BLACK,
    BLOCK,
    CHUNK,
    FLOOR,
    GAIN,
    LEVEL,
    LOST,
    MODULATION,
    REASON,
    RESIDUAL,
    RESIDUAL_SCALE,
    SHIFT,
    SIGMA,
    TO_BRIGHTEST,
    TO_LONGEST,
    VALUE,
    WEIGHT,
    WRAPPED,
)
from measureapp.map_memory import LINE

HALF, QUARTER, THREE_QUARTERS = np.float32(0.5), np.float32(0.25), np.float32(0.75)
TAU = np.float32(2 * np.pi)
TINY = np.float32(1e-12)
LEAST = np.float32(1e-30)
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


@njit(**ENTRY, inline="always")
def root(square: Any) -> Any:
    """Return the square root of a positive number, by way of its reciprocal, for which processors have a fast estimate to refine."""
    return square * (np.float32(1) / np.sqrt(square + LEAST))


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


@njit(**INNER)
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


@njit(**INNER)
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


@njit(**INNER)
def look_up(table: Any, taken: Any, n: int, out: Any) -> None:
    """Write what belongs to the exposures that each pixel took."""
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
def set_together(alike: int, model: Any, work: Any) -> None:
    """Put what belongs to the exposures ``alike`` into the rows of the noise, the light and the reasons, for all pixels of a block."""
    rows = work.rows
    rows[BLACK : BLACK + BLOCK] = model.black[alike]
    rows[GAIN : GAIN + BLOCK] = model.gain[alike]
    rows[FLOOR : FLOOR + BLOCK] = model.floor[alike]
    rows[TO_BRIGHTEST : TO_BRIGHTEST + BLOCK] = model.to_brightest[alike]
    rows[TO_LONGEST : TO_LONGEST + BLOCK] = model.to_longest[alike]
    rows[LOST : LOST + BLOCK] = np.float32(SATURATED if alike == 0 else VALID)


@njit(**INNER)
def set_apart(sums: Any, off: int, n: int, model: Any, work: Any) -> None:
    """Put what belongs to the exposures of every pixel into the same rows; where groups decide apart, those of the finest count."""
    rows = work.rows
    taken = sums.taken[0 if sums.taken.shape[0] == 1 else model.finest, off : off + n]
    look_up(model.black, taken, n, rows[BLACK : BLACK + n])
    look_up(model.gain, taken, n, rows[GAIN : GAIN + n])
    look_up(model.floor, taken, n, rows[FLOOR : FLOOR + n])
    look_up(model.to_brightest, taken, n, rows[TO_BRIGHTEST : TO_BRIGHTEST + n])
    look_up(model.to_longest, taken, n, rows[TO_LONGEST : TO_LONGEST + n])
    zero, bloomed, lost = sums.zero[off : off + n], sums.bloomed[off : off + n], rows[LOST : LOST + n]
    unlit = np.float32(WEAK if model.zero_is_dark else VALID)
    for j in range(n):
        lost[j] = unlit if zero[j] != 0 else np.float32(VALID)
    for m in range(sums.taken.shape[0]):
        taken = sums.taken[m, off : off + n]
        for j in range(n):
            reason = np.float32(BLOOMING) if bloomed[j] != 0 else np.float32(SATURATED)
            lost[j] = reason if taken[j] == 0 else lost[j]


@njit(**INNER)
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


@njit(**INNER)
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


@njit(**INNER)
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


@njit(**INNER)
def judge(total: Any, n: int, layout: Any, model: Any, work: Any) -> None:
    """Turn the rows into what the maps hold: average the phases by inverse variance, give every pixel its reason."""
    rows = work.rows
    each = np.float32(1) / np.float32(layout.steps[model.finest])
    weak, dark = model.most_sigma * model.most_sigma, model.dark_sigma * model.dark_sigma
    low, high, gate, least = model.lowest, model.highest, model.gate, model.least_modulation
    origin, beyond = model.origin, model.beyond
    last = np.int32(OUTSIDE if model.undecided else VALID)
    for j in range(n):
        level = np.float32(total[j]) * each
        known = np.float32(1) / (rows[WEIGHT + j] + TINY)
        value = rows[VALUE + j] + rows[SHIFT + j] * known
        variance = (max(level - rows[BLACK + j], np.float32(0)) * rows[GAIN + j] + rows[FLOOR + j]) * known
        modulation = root(rows[MODULATION + j]) * rows[TO_BRIGHTEST + j]
        lost = np.int32(rows[LOST + j])
        reason = np.int32(CONFLICT) if abs(rows[RESIDUAL + j]) > gate else np.int32(VALID)
        reason = np.int32(OUTSIDE) if (value < low) | (value > high) else reason
        reason = np.int32(WEAK) if (modulation < least) | (variance > weak) | (lost == WEAK) else reason
        reason = np.int32(SHADOW) if variance > dark else reason
        reason = lost if (lost == SATURATED) | (lost == BLOOMING) else reason
        kept = (reason == VALID) | ((reason >= CONFLICT) & (reason <= last))
        rows[VALUE + j] = (value + origin) * TAU if kept else np.float32(0)
        rows[SIGMA + j] = root(variance) if kept else np.float32(0)
        rows[MODULATION + j] = modulation
        rows[LEVEL + j] = beyond if rows[TO_LONGEST + j] == 0 else level * rows[TO_LONGEST + j]
        rows[REASON + j] = np.float32(reason)


@njit(**INNER)
def write(row: Any, shown: Any, n: int) -> None:
    """Write a row into a map: past the caches, where the map lies so that whole lines of them can be written."""
    done = 0
    if shown.ctypes.data % LINE == 0:
        done = n - n % STREAMED
        for j in range(0, done, STREAMED):
            write_past_caches(row, shown, j)
    for j in range(done, n):
        shown[j] = row[j]


@njit(**INNER)
def draw(begin: int, n: int, model: Any, work: Any, maps: Any) -> None:
    """Write the rows of the pixels into their maps."""
    rows = work.rows
    phase, sigma, state = maps.phase[begin : begin + n], maps.sigma[begin : begin + n], maps.state[begin : begin + n]
    shown, grey = maps.modulation[begin : begin + n], maps.grey[begin : begin + n]
    most, white = np.float32(255 if maps.modulation.itemsize == 1 else 65535), np.float32(65535)
    write(rows[VALUE : VALUE + n], phase, n)
    write(rows[SIGMA : SIGMA + n], sigma, n)
    for j in range(n):
        shown[j] = np.int32(min(rows[MODULATION + j] + HALF, most))
    for j in range(n):
        grey[j] = np.int32(min(rows[LEVEL + j] + HALF, white))
    for j in range(n):
        state[j] = np.int32(rows[REASON + j])
    if model.undecided:
        left = maps.residual[begin : begin + n]
        for j in range(n):
            left[j] = np.int32(rows[RESIDUAL + j] * np.float32(RESIDUAL_SCALE))


@njit(**INNER)
def draw_exposure(sums: Any, off: int, begin: int, n: int, alike: int, model: Any, work: Any, maps: Any) -> None:
    """Write the longest exposure that any group of a pixel took into its map."""
    exposure, code = maps.exposure[begin : begin + n], work.code[0]
    if alike >= 0:
        exposure[:] = model.first[alike]
        return
    for j in range(n):
        code[j] = 0
    for k in range(sums.taken.shape[0]):
        taken = sums.taken[k, off : off + n]
        for j in range(n):
            code[j] |= np.int32(taken[j])
    look_up(model.first, code, n, exposure)


@njit(**INNER)
def tally(sums: Any, off: int, n: int, alike: int, work: Any, state: Any, counts: Any) -> None:
    """Count the pixels of every state, and last those with an exposure above zero in all groups."""
    present = np.int32(0)
    for j in range(n):
        present |= np.int32(1) << np.int32(state[j])
    for reason in range(counts.shape[0] - 1):
        bit = np.int32(1) << np.int32(reason)
        if present == bit:
            counts[reason] += n
        elif present & bit:
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
    apart = sums.total.shape[0] > 1
    known = np.int64(-1)  # the exposures that the rows hold the numbers of
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
            if alike < 0:
                set_apart(sums, off, n, model, work)
            elif alike != known:
                set_together(alike, model, work)
            known = np.int64(-1 if apart else alike)
            if apart:
                if alike >= 0:
                    sums.taken[:, off : off + n] = np.uint16(alike)
                weigh_groups(sums, off, n, layout, model, work)
            else:
                least_modulation(n, layout, work)
            average(n, layout, model, work)
            judge(sums.total[model.finest if apart else 0, off : off + n], n, layout, model, work)
            draw(begin, n, model, work, maps)
            draw_exposure(sums, off, begin, n, alike, model, work, maps)
            tally(sums, off, n, alike, work, maps.state[begin : begin + n], counts)
