"""Compiled loops that take from the phase by how far blur has shifted it, and tell the doubt where that is not known.

Loops of few arrays write to one scratch array at constant offsets: only then does the compiler see what cannot overlap, and uses SIMD
instructions.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.reconstruct.kernels.options import INLINE, LOOP
from measureapp.reconstruct.kernels.scratch import stack_float32

CHUNK = 512  # pixels of a row at a time
REACH = 2  # px to either side, over which slopes of the phase are taken: its noise hardly grows by it, and the blur reaches no further
STEEPEST = np.float32(0.3)  # of the logarithm of the light per px; beyond, at edges, the first order says nothing
NEAR, FAR = 3, 6  # px to either side, over which bends are taken; over the far ones they cost 3 % in noise
RATIO = np.float32((FAR / NEAR) ** 2)  # of an even bend over both
ALIKE = np.float32(0.25)  # of a bend: by how much an even one may differ from that over the near pixels, and its halves from each other,
BENDS_APART, HALVES_APART = np.float32(17), np.float32(6.3)  # and two standard deviations of both in those of the phase
PER_RISE, PER_RUNS = np.float32(1 / 12), np.float32(1 / (2 * REACH))
PER_BEND, PER_RUN = np.float32(0.5 / FAR**2), np.float32(1 / (2 * FAR) ** 2)
# How a phase bends 2 to 5 px from the rim of a round body, where a hole hides that: φ'' is there φ' over twice the distance.
BEND_AT_RIM = np.float32(1 / 7)
SPAN, EIGHT, TWO, ONE, HALF, ZERO = (np.float32(number) for number in (2 * REACH, 8, 2, 1, 0.5, 0))
SHIFT, RUN, RISE, HOLE, FAR_BEND, NEAR_BEND, CUT, DOUBT = (k * CHUNK for k in range(8))
SCRATCH = 8 * CHUNK


@njit(**INLINE)
def add_slope(s: Any, n: int, own: Any, phases: Any, lights: Any, states: Any, around: Any, limits: Any) -> None:
    """Add what comes of light that changes along one direction, ∇φ · ∇ ln I, of pixels between a row before and a row behind them.

    Of a phase that rises evenly the shift follows, however the light changes, from the slope of the blurred light at the pixel itself: by
    differences over one and two pixels, which leave nothing of the third order. Over a wider reach an edge would act where it does not reach.
    Where a hole is too near to tell how the phase bends (``around``, the states as `add_bend` has them), that stays with it: at the rim of a
    round body the phase bends as much as the light falls, and one without the other is worse than neither. Both are in doubt then, as they are
    where the light changes too fast.
    """
    before, behind = phases
    farthest, dark, hidden_bend = limits
    no_before, no_behind = states
    for i in range(n):
        back, ahead = own[i] - before[i] if no_before[i] == 0 else ZERO, behind[i] - own[i] if no_behind[i] == 0 else ZERO
        one_sided = (no_before[i] | no_behind[i]) != 0
        s[RUN + i] = (TWO if one_sided else ONE) * (back + ahead)
    light, two_before, one_before, one_behind, two_behind = lights
    for i in range(n):
        s[RISE + i] = EIGHT * (np.float32(one_behind[i]) - np.float32(one_before[i]))
    for i in range(n):
        s[RISE + i] -= np.float32(two_behind[i]) - np.float32(two_before[i])
    for i in range(n):
        s[RISE + i] *= PER_RISE / max(np.float32(light[i]) - dark, ONE)
    _, no_near_before, no_near_behind, _ = around
    for i in range(n):
        s[HOLE + i] = np.float32(no_before[i] | no_behind[i] | no_near_before[i] | no_near_behind[i])
    for i in range(n):
        run, rise = s[RUN + i], s[RISE + i]
        slope = PER_RUNS * run if abs(run) < farthest else ZERO
        known = (s[HOLE + i] == ZERO) & (abs(rise) < STEEPEST)
        s[SHIFT + i] += slope * rise if known else ZERO
        doubt = ZERO if known else slope * (min(abs(rise), ONE) + hidden_bend)
        s[DOUBT + i] += doubt * doubt


@njit(**INLINE)
def add_bend(s: Any, n: int, own: Any, phases: Any, states: Any, noise: Any, variances: Any) -> None:
    """Add what comes of a phase that bends evenly along one direction, of pixels between rows far and near before and behind them.

    Of blurred fringes exp(i φ) that is φ'' (1 - s² φ'²) / 2: steep ones fade where they are out of step, and count less.
    An edge between two walls is no even bend: on it the near pixels bend more than the far ones, beside it one half of them does not bend.
    Where a hole is among the far pixels, the near ones have to do. Twice what an uneven bend would do is in doubt: an edge may be sharper than
    the near pixels tell.
    """
    far_before, near_before, near_behind, far_behind = phases
    for i in range(n):
        s[FAR_BEND + i] = far_before[i] + far_behind[i] - TWO * own[i]
    for i in range(n):
        s[NEAR_BEND + i] = RATIO * (near_before[i] + near_behind[i] - TWO * own[i])
    for i in range(n):
        s[RUN + i] = far_behind[i] - far_before[i]
    for i in range(n):
        s[RISE + i] = TWO * (near_behind[i] - near_before[i])
    no_far_before, no_near_before, no_near_behind, no_far_behind = states
    for i in range(n):
        s[HOLE + i] = np.float32(no_near_before[i] | no_near_behind[i])
    for i in range(n):
        s[CUT + i] = np.float32(no_far_before[i] | no_far_behind[i])
    variance, read = variances
    for i in range(n):
        far, near, sigma = s[FAR_BEND + i], s[NEAR_BEND + i], noise[i]
        allowed = ALIKE * abs(far)
        even = (abs(far - near) <= allowed + BENDS_APART * sigma) & (abs(s[RUN + i] - s[RISE + i]) <= allowed + HALVES_APART * sigma)
        cut = s[CUT + i] != ZERO
        run = s[RISE + i] if cut else s[RUN + i]
        steep = max(ONE - variance * PER_RUN * run * run, ZERO) + read
        bend = near if cut else (far if even else ZERO)
        told = s[HOLE + i] == ZERO
        s[SHIFT + i] += PER_BEND * bend * steep if told else ZERO
        doubt = TWO * PER_BEND * near * steep if told & (not cut) & (not even) else ZERO
        s[DOUBT + i] += doubt * doubt


@njit(**INLINE)
def two_beside(row: Any, first: int, last: int) -> Any:
    """Return the pixels REACH to the left and to the right of pixels first … last."""
    return row[first - REACH : last - REACH], row[first + REACH : last + REACH]


@njit(**INLINE)
def two_rows(image: Any, y: int, first: int, last: int) -> Any:
    """Return the pixels REACH above and below."""
    return image[y - REACH, first:last], image[y + REACH, first:last]


@njit(**INLINE)
def five_beside(row: Any, first: int, last: int) -> Any:
    """Return pixels first … last, and those two and one to the left, one and two to the right."""
    return row[first:last], row[first - 2 : last - 2], row[first - 1 : last - 1], row[first + 1 : last + 1], row[first + 2 : last + 2]


@njit(**INLINE)
def five_rows(image: Any, y: int, first: int, last: int) -> Any:
    """Return pixels first … last of a row, and of those two and one above, one and two below."""
    return image[y, first:last], image[y - 2, first:last], image[y - 1, first:last], image[y + 1, first:last], image[y + 2, first:last]


@njit(**INLINE)
def four_beside(row: Any, first: int, last: int) -> Any:
    """Return the pixels FAR and NEAR to the left, NEAR and FAR to the right."""
    return row[first - FAR : last - FAR], row[first - NEAR : last - NEAR], row[first + NEAR : last + NEAR], row[first + FAR : last + FAR]


@njit(**INLINE)
def four_rows(image: Any, y: int, first: int, last: int) -> Any:
    """Return the pixels FAR and NEAR above, NEAR and FAR below."""
    return image[y - FAR, first:last], image[y - NEAR, first:last], image[y + NEAR, first:last], image[y + FAR, first:last]


@njit(**INLINE)
def write_taken(s: Any, n: int, own: Any, noise: Any, states: Any, variance: Any, phases: Any, sigmas: Any) -> None:
    """Write the phases of n pixels less what blur has added, and their standard deviations with what is in doubt of it."""
    for i in range(n):
        s[HOLE + i] = ZERO if states[i] else variance
    for i in range(n):
        phases[i] = own[i] - s[HOLE + i] * s[SHIFT + i]
    for i in range(n):
        sigmas[i] = np.sqrt(noise[i] * noise[i] + s[HOLE + i] * s[HOLE + i] * s[DOUBT + i])


@njit(**LOOP)
def take_blur(
    phase: Any,  # (H, W) float32
    sigma: Any,  # (H, W) float32
    grey: Any,  # (H, W) uint16
    state: Any,  # (H, W) uint8, 0 valid
    variance: Any,  # float32, of the blur, px²
    read: Any,  # float32, what reading between pixels does as well, in shares of it
    step: Any,  # float32, largest phase step between neighbours of one surface
    dark: Any,  # float32, grey level without the light of the projector
    row_start: int,
    row_stop: int,
    out: Any,  # (H, W) float32
    out_sigma: Any,  # (H, W) float32
) -> None:
    """Write the phase of some rows as it were without blur, and its standard deviation with what of that is in doubt.

    What has no neighbours on its surface, and FAR pixels at every border, stay.
    """
    height, width = phase.shape
    limits, s = (step * SPAN, dark, BEND_AT_RIM * HALF * (ONE + read)), stack_float32(SCRATCH)
    for y in range(row_start, row_stop):
        row, noise, made, doubted = phase[y], sigma[y], out[y], out_sigma[y]
        for x in range(width):
            made[x] = row[x]
        for x in range(width):
            doubted[x] = noise[x]
        if y < FAR or y >= height - FAR:
            continue
        for first in range(FAR, width - FAR, CHUNK):
            last = min(first + CHUNK, width - FAR)
            part = slice(first, last)
            n, own = last - first, row[part]
            for i in range(n):
                s[SHIFT + i], s[DOUBT + i] = ZERO, ZERO
            beside, above = four_beside(state[y], first, last), four_rows(state, y, first, last)
            phases, lights, states = two_beside(row, first, last), five_beside(grey[y], first, last), two_beside(state[y], first, last)
            add_slope(s, n, own, phases, lights, states, beside, limits)
            phases, lights, states = two_rows(phase, y, first, last), five_rows(grey, y, first, last), two_rows(state, y, first, last)
            add_slope(s, n, own, phases, lights, states, above, limits)
            add_bend(s, n, own, four_beside(row, first, last), beside, noise[part], (variance, read))
            add_bend(s, n, own, four_rows(phase, y, first, last), above, noise[part], (variance, read))
            write_taken(s, n, own, noise[part], state[y, part], variance, made[part], doubted[part])
