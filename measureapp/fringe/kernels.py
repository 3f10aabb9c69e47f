"""Compiled loops over pixels: accumulation of the exposures, unwrapping, order vote.

Every kernel works on the pixels ``start … stop`` (or rows) of flat arrays and releases the interpreter, so that bands run on threads.
Reference implementations in NumPy stand in `phase_shift.py` and in the tests.
"""
# One loop over pixels cannot be cut into functions without leaving SIMD code.
# ruff: noqa: PLR0912, PLR0915

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

CHUNK = 2048
PI = np.float32(np.pi)
HALF_PI = np.float32(np.pi / 2)
TAU = np.float32(2 * np.pi)

# Odd polynomial for atan on 0…1, fitted by iteratively reweighted least squares; error below 1e-7 rad.
A1, A3, A5, A7 = np.float32(0.999999336), np.float32(-0.33329861), np.float32(0.199465668), np.float32(-0.139086327)
A9, A11, A13, A15 = np.float32(0.0964220148), np.float32(-0.0559123465), np.float32(0.0218629532), np.float32(-0.00405456218)


@njit(nogil=True, cache=True, fastmath=True, inline="always")
def fast_atan2(sine: Any, cosine: Any) -> Any:
    """Return atan2 in float32; branch-free, so that the loop around it becomes SIMD code (numba's own is ten times slower)."""
    across = abs(cosine)
    up = abs(sine)
    small = min(across, up)
    large = max(across, up)
    q = small / (large + np.float32(1e-30))
    p = q * q
    angle = q * (A1 + p * (A3 + p * (A5 + p * (A7 + p * (A9 + p * (A11 + p * (A13 + p * A15)))))))
    angle = HALF_PI - angle if up > across else angle
    angle = PI - angle if cosine < 0 else angle
    return -angle if sine < 0 else angle


@njit(nogil=True, cache=True, fastmath=True)
def accumulate(
    images: Any,  # (E, P, N) read-only uint8 or uint16
    group_of: Any,  # (P,) int64, phase-shift group of an image, -1 for others
    cosines: Any,  # (P,) float32
    sines: Any,  # (P,) float32
    saturation: Any,  # float32
    joint: bool,
    first_only: bool,
    start: int,
    stop: int,
    sine: Any,  # out (G, N) float32, sum over the exposures used
    cosine: Any,  # out (G, N) float32
    mean: Any,  # out (G, N) float32, sum of the images over the exposures used
    used: Any,  # out (G, N) uint16, bit e: exposure e is used
    first: Any,  # out (N,) int8, first exposure used, -1 for none
    grey: Any,  # out (N,) float32, mean of all sinusoids at that exposure
    zero: Any,  # out (N,) bool, an image of the exposure taken is 0
    counts: Any,  # out (E + 1,) int64, valid pixels of every exposure and of the composite
) -> None:
    """Sum the sinusoids of every pixel over the exposures that the rule takes."""
    exposures, patterns, _ = images.shape
    groups = sine.shape[0]
    s = np.empty((groups, CHUNK), np.float32)
    c = np.empty((groups, CHUNK), np.float32)
    a = np.empty((groups, CHUNK), np.float32)
    high = np.empty((groups, CHUNK), np.float32)
    low = np.empty((groups, CHUNK), np.float32)
    sinusoids = np.float32(np.sum(group_of >= 0))
    for begin in range(start, stop, CHUNK):
        n = min(CHUNK, stop - begin)
        for g in range(groups):
            for j in range(n):
                sine[g, begin + j] = 0
                cosine[g, begin + j] = 0
                mean[g, begin + j] = 0
                used[g, begin + j] = 0
        for j in range(n):
            first[begin + j] = -1
            grey[begin + j] = 0
            zero[begin + j] = False
        for e in range(exposures):
            for g in range(groups):
                for j in range(n):
                    s[g, j] = 0
                    c[g, j] = 0
                    a[g, j] = 0
                    high[g, j] = 0
                    low[g, j] = np.float32(1e9)
            for p in range(patterns):
                g = group_of[p]
                if g < 0:
                    continue
                row = images[e, p, begin : begin + n]
                weight_c = cosines[p]
                weight_s = sines[p]
                for j in range(n):
                    value = np.float32(row[j])
                    s[g, j] += weight_s * value
                    c[g, j] += weight_c * value
                    a[g, j] += value
                    high[g, j] = max(high[g, j], value)
                    low[g, j] = min(low[g, j], value)
            good = 0
            for j in range(n):
                top = high[0, j]
                bottom = low[0, j]
                total = a[0, j]
                for g in range(1, groups):
                    top = max(top, high[g, j])
                    bottom = min(bottom, low[g, j])
                    total += a[g, j]
                good += (top < saturation) & (bottom > 0)
                if joint:
                    for g in range(groups):
                        high[g, j] = top
                taken = False
                for g in range(groups):
                    if high[g, j] < saturation and (used[g, begin + j] == 0 or not first_only):
                        if used[g, begin + j] == 0:
                            zero[begin + j] |= low[g, j] <= 0
                        sine[g, begin + j] += s[g, j]
                        cosine[g, begin + j] += c[g, j]
                        mean[g, begin + j] += a[g, j]
                        used[g, begin + j] |= np.uint16(1 << e)
                        taken = True
                if taken and first[begin + j] < 0:
                    first[begin + j] = e
                    grey[begin + j] = total / sinusoids
                elif first[begin + j] < 0 and e == exposures - 1:
                    grey[begin + j] = total / sinusoids
            counts[e] += good
        for j in range(n):
            complete = not zero[begin + j]
            for g in range(groups):
                complete &= used[g, begin + j] != 0
            counts[exposures] += complete


@njit(nogil=True, cache=True, fastmath=True)
def wrap_and_weigh(
    sine: Any,  # (G, N) in: sums; out: wrapped phase in (-π, π]
    cosine: Any,  # (G, N) in: sums; out: variance of the phase in rad²
    mean: Any,  # (G, N) sum of the images
    used: Any,  # (G, N) uint16
    first: Any,  # (N,) int8
    steps: Any,  # (G,) float32
    exposure: Any,  # (E,) float32, relative exposure, 1 for the longest
    electrons: Any,  # float32, electrons per grey level
    floor: Any,  # float32, read noise and quantisation, variance in grey levels²
    start: int,
    stop: int,
    modulation: Any,  # out (N,) float32, least B of the groups at the exposure taken
    grey: Any,  # (N,) float32, in: mean at the exposure taken; out: the same at the longest exposure
) -> None:
    """Turn the sums into wrapped phase and its variance, σφ² = 2/N · σ_I² / B²."""
    groups = sine.shape[0]
    for i in range(start, stop):
        modulation[i] = np.float32(1e9)
        taken = exposure[first[i]] if first[i] >= 0 else exposure[-1]
        grey[i] /= taken
    for g in range(groups):
        n = steps[g]
        for i in range(start, stop):
            s = sine[g, i]
            c = cosine[g, i]
            power = s * s + c * c
            count = np.float32(0)
            total = np.float32(0)
            bits = used[g, i]
            for e in range(exposure.shape[0]):
                hit = np.float32((bits >> e) & 1)
                count += hit
                total += hit * exposure[e]
            taken = exposure[first[i]] if first[i] >= 0 else exposure[-1]
            amplitude = np.float32(2) / n * np.sqrt(power)
            modulation[i] = min(modulation[i], amplitude * taken / (total + np.float32(1e-12)))
            noise = mean[g, i] / n / electrons + count * floor
            cosine[g, i] = np.float32(2) / n * noise / (amplitude * amplitude + np.float32(1e-12))
            sine[g, i] = s
            mean[g, i] = c
        for i in range(start, stop):
            sine[g, i] = fast_atan2(sine[g, i], mean[g, i])


@njit(nogil=True, cache=True, fastmath=True)
def heterodyne(
    phase: Any,  # (G, N) float32 wrapped
    origin: Any,  # float32, phase at column 0
    combinations: Any,  # (K, G) float32 integers
    ratios: Any,  # (K,) float32, frequency of a combination over that of the one before
    watched: int,  # the decision whose residual is wanted
    guard: Any,  # float32, share of the coarsest period kept below 0
    start: int,
    stop: int,
    absolute: Any,  # out (N,) float32, phase of the last combination from column 0
    residual: Any,  # out (N,) float32, rounding residual of the watched decision in cycles
) -> None:
    """Unwrap from the coarsest combination of the phases to the finest pitch."""
    groups = phase.shape[0]
    for i in range(start, stop):
        value = np.float32(0)
        for g in range(groups):
            value += combinations[0, g] * (phase[g, i] - origin)
        cycles = value / TAU
        cycles -= np.floor(cycles + guard)
        value = cycles * TAU
        residual[i] = 0
        for k in range(1, combinations.shape[0]):
            wrapped = np.float32(0)
            for g in range(groups):
                wrapped += combinations[k, g] * (phase[g, i] - origin)
            decision = (value * ratios[k] - wrapped) / TAU
            order = np.floor(decision + np.float32(0.5))
            if k == watched:
                residual[i] = decision - order
            value = wrapped + order * TAU
        absolute[i] = value


@njit(nogil=True, cache=True, fastmath=True)
def gray_code(
    images: Any,  # (E, P, N) read-only
    planes: Any,  # (B,) int64, indices of the planes, most significant first
    complementary: bool,
    phase: Any,  # (N,) float32 wrapped phase of the numbered pitch
    mean: Any,  # (N,) float32, mean of the sinusoids summed over the exposures used
    used: Any,  # (N,) uint16
    origin: Any,  # float32
    start: int,
    stop: int,
    absolute: Any,  # out (N,) float32
    residual: Any,  # out (N,) float32, how far the bits allow another period, in cycles; 1: the bits contradict each other
) -> None:
    """Number the periods by Gray code; half a period of overlap with the complementary plane heals the edges of the planes."""
    count = planes.shape[0]
    for i in range(start, stop):
        code = 0
        bit = 0
        coarse = 0
        for b in range(count):
            level = np.float32(0)
            for e in range(images.shape[0]):
                if (used[i] >> e) & 1:
                    level += np.float32(images[e, planes[b], i])
            bit ^= 1 if level > mean[i] else 0
            code = 2 * code + bit
            if b == count - 2:
                coarse = code
        aligned = (phase[i] - origin) / TAU
        aligned -= np.floor(aligned)
        if complementary:
            shifted = (code + 1) // 2
            period = coarse
            if aligned < 0.25:
                period = shifted
            elif aligned >= 0.75:
                period = shifted - 1
            settled = coarse == shifted if aligned < 0.5 else coarse == shifted - 1
            near = aligned < 0.25 or aligned >= 0.75 or abs(aligned - 0.5) < 0.25
            residual[i] = 0 if settled or (near and abs(coarse - period) <= 1) else 1
        else:
            period = code
            residual[i] = np.float32(0.5) - aligned
        absolute[i] = (np.float32(period) + aligned) * TAU


@njit(nogil=True, cache=True)
def vote(
    absolute: Any,  # (H, W) float32
    residual: Any,  # (H, W) float32, cycles
    variance: Any,  # (H, W) float32, of the wrapped phase
    usable: Any,  # (H, W) bool
    gate: Any,  # float32, cycles
    amplification: Any,  # float32, noise of the order decision over that of the phase
    slack: Any,  # float32, cycles a repaired pixel may be off in any case
    radius: int,
    row_start: int,
    row_stop: int,
    voted: Any,  # out (H, W) float32
    conflict: Any,  # out (H, W) bool
) -> int:
    """Let the window decide the order of every pixel; returns how many pixels changed their order.

    A pixel follows the majority only when its own rounding residual allows that order at 3.5 standard deviations,
    or stays as it is; one that neither its residual nor its neighbours support is a conflict.
    """
    height, width = absolute.shape
    repaired = 0
    tally = np.zeros(9, np.int64)
    for y in range(row_start, row_stop):
        for x in range(width):
            voted[y, x] = absolute[y, x]
            conflict[y, x] = False
            if not usable[y, x]:
                continue
            own = absolute[y, x]
            trusted = abs(residual[y, x]) <= gate
            others = 0
            same = 0
            tally[:] = 0
            for v in range(max(0, y - radius), min(height, y + radius + 1)):
                for u in range(max(0, x - radius), min(width, x + radius + 1)):
                    if not usable[v, u] or (u == x and v == y):
                        continue
                    step = np.floor((absolute[v, u] - own) / TAU + np.float32(0.5))
                    if step == 0:
                        same += 1
                    elif abs(step) <= 4:
                        tally[int(step) + 4] += 1
                    others += 1
            best = 4
            for m in range(9):
                if tally[m] > tally[best]:
                    best = m
            if best != 4 and tally[best] > same and 2 * tally[best] > others:
                tolerance = slack + np.float32(3.5) * amplification * np.sqrt(variance[y, x]) / TAU
                if abs(residual[y, x] - np.float32(best - 4)) <= tolerance:
                    voted[y, x] = own + TAU * np.float32(best - 4)
                    repaired += 1
                elif not trusted:
                    conflict[y, x] = True
            elif (not trusted and (same < 3 or 2 * same <= others)) or (same == 0 and others >= 4):
                conflict[y, x] = True
    return repaired


@njit(nogil=True, cache=True, fastmath=True)
def combine(
    absolute: Any,  # (N,) float32, from column 0, of the finest pitch; out: combined, in the convention of the images
    phase: Any,  # (G, N) float32 wrapped
    variance: Any,  # (G, N) float32
    scales: Any,  # (G,) float32, frequency of the group over the finest
    origin: Any,  # float32
    start: int,
    stop: int,
    sigma: Any,  # out (N,) float32
) -> None:
    """Average the phases of all pitches, each unwrapped by the finest and weighted by its inverse variance."""
    for i in range(start, stop):
        total = np.float32(0)
        shift = np.float32(0)
        for g in range(scales.shape[0]):
            expected = absolute[i] * scales[g]
            off = phase[g, i] - origin - expected
            off -= TAU * np.floor(off / TAU + np.float32(0.5))
            weight = scales[g] * scales[g] / (variance[g, i] + np.float32(1e-20))
            shift += weight * off / scales[g]
            total += weight
        absolute[i] += shift / total + origin
        sigma[i] = np.sqrt(np.float32(1) / total)


@njit(nogil=True, cache=True)
def find_edges(phase: Any, valid: Any, step: Any, row_start: int, row_stop: int, edge: Any) -> None:
    """Mark valid pixels whose phase differs by more than ``step`` from a valid neighbour (left, right, above, below)."""
    height, width = phase.shape
    for y in range(row_start, row_stop):
        for x in range(width):
            edge[y, x] = False
            if not valid[y, x]:
                continue
            own = phase[y, x]
            if (
                (x > 0 and valid[y, x - 1] and abs(phase[y, x - 1] - own) > step)
                or (x + 1 < width and valid[y, x + 1] and abs(phase[y, x + 1] - own) > step)
                or (y > 0 and valid[y - 1, x] and abs(phase[y - 1, x] - own) > step)
                or (y + 1 < height and valid[y + 1, x] and abs(phase[y + 1, x] - own) > step)
            ):
                edge[y, x] = True
