"""Compiled loops that take from the phase by how far blur has shifted it, and tell the doubt where that is not known."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.simd.elements import broadcast, convert, maximum, minimum, select, sqrt
from measureapp.compiled.simd.memory import load, store
from measureapp.reconstruct.kernels.constants import PIXELS

REACH = 2  # px to either side, over which slopes of the phase are taken: its noise hardly grows by it, and the blur reaches no further
STEEPEST = np.float32(0.3)  # of the logarithm of the light per px; beyond, at edges, the first order says nothing
NEAR, FAR = 3, 6  # px to either side, over which bends are taken; over the far ones they cost 3 % in noise
NARROWEST = 2 * FAR + PIXELS  # px that a row must have
RATIO = np.float32((FAR / NEAR) ** 2)  # of an even bend over both
ALIKE = np.float32(0.25)  # of a bend: by how much an even one may differ from that over the near pixels, and its halves from each other,
BENDS_APART, HALVES_APART = np.float32(17), np.float32(6.3)  # and two standard deviations of both in those of the phase
PER_RISE, PER_RUNS = np.float32(1 / 12), np.float32(1 / (2 * REACH))
PER_BEND, PER_RUN = np.float32(0.5 / FAR**2), np.float32(1 / (2 * FAR) ** 2)
# How a phase bends 2 to 5 px from the rim of a round body, where a hole hides that: φ'' is there φ' over twice the distance.
BEND_AT_RIM = np.float32(1 / 7)
SPAN, EIGHT, TWO, ONE, HALF, ZERO = (np.float32(number) for number in (2 * REACH, 8, 2, 1, 0.5, 0))
NOTHING = np.uint8(0)


@njit(**INLINE)
def grey_at(grey: Any, at: int) -> Any:
    """Return grey levels as numbers with a fraction."""
    return convert(load(grey, at, PIXELS), np.float32)


@njit(**INLINE)
def holes_at(state: Any, at: int, apart: int) -> Any:
    """Return where a pixel so far before or behind has no phase, one mask for each."""
    return load(state, at - apart, PIXELS) != NOTHING, load(state, at + apart, PIXELS) != NOTHING


@njit(**INLINE)
def slope_at(phase: Any, grey: Any, state: Any, at: int, along: int, per_light: Any, limits: Any) -> Any:
    """Return what comes of light that changes along one direction, ∇φ · ∇ ln I, and the square of what is in doubt of it.

    Of a phase that rises evenly the shift follows, however the light changes, from the slope of the blurred light at the pixel itself: by
    differences over one and two pixels, which leave nothing of the third order. Over a wider reach an edge would act where it does not reach.
    Where a hole is too near to tell how the phase bends, that stays with it: at the rim of a round body the phase bends as much as the light
    falls, and one without the other is worse than neither. Both are in doubt then, as they are where the light changes too fast.

    Parameters
    ----------
    along : from a pixel to the next in that direction
    per_light : 1/12 over the light of the pixels
    """
    farthest, hidden_bend = limits
    no_before, no_behind = holes_at(state, at, REACH * along)
    no_near_before, no_near_behind = holes_at(state, at, NEAR * along)
    own = load(phase, at, PIXELS)
    back = select(no_before, ZERO, own - load(phase, at - REACH * along, PIXELS))
    ahead = select(no_behind, ZERO, load(phase, at + REACH * along, PIXELS) - own)
    one_sided = no_before | no_behind
    run = select(one_sided, TWO * (back + ahead), back + ahead)
    near, far = grey_at(grey, at + along) - grey_at(grey, at - along), grey_at(grey, at + 2 * along) - grey_at(grey, at - 2 * along)
    rise = (EIGHT * near - far) * per_light
    slope = select(abs(run) < farthest, PER_RUNS * run, ZERO)
    unknown = one_sided | no_near_before | no_near_behind | (abs(rise) >= STEEPEST)
    doubt = select(unknown, slope * (minimum(abs(rise), ONE) + hidden_bend), ZERO)
    return select(unknown, ZERO, slope * rise), doubt * doubt


@njit(**INLINE)
def bend_at(phase: Any, state: Any, at: int, along: int, sigma: Any, variances: Any) -> Any:
    """Return what comes of a phase that bends evenly along one direction, and the square of what is in doubt of it.

    Of blurred fringes exp(i φ) that is φ'' (1 - s² φ'²) / 2: steep ones fade where they are out of step, and count less.
    An edge between two walls is no even bend: on it the near pixels bend more than the far ones, beside it one half of them does not bend.
    Where a hole is among the far pixels, the near ones have to do. Twice what an uneven bend would do is in doubt: an edge may be sharper than
    the near pixels tell.
    """
    variance, read = variances
    twice = TWO * load(phase, at, PIXELS)
    far_before, far_behind = load(phase, at - FAR * along, PIXELS), load(phase, at + FAR * along, PIXELS)
    near_before, near_behind = load(phase, at - NEAR * along, PIXELS), load(phase, at + NEAR * along, PIXELS)
    far, near = far_before + far_behind - twice, RATIO * (near_before + near_behind - twice)
    far_run, near_run = far_behind - far_before, TWO * (near_behind - near_before)
    no_far_before, no_far_behind = holes_at(state, at, FAR * along)
    no_near_before, no_near_behind = holes_at(state, at, NEAR * along)
    allowed = ALIKE * abs(far)
    even = (abs(far - near) <= allowed + BENDS_APART * sigma) & (abs(far_run - near_run) <= allowed + HALVES_APART * sigma)
    cut, hidden = no_far_before | no_far_behind, no_near_before | no_near_behind
    run = select(cut, near_run, far_run)
    steep = maximum(ONE - variance * PER_RUN * run * run, ZERO) + read
    bend = select(cut, near, select(even, far, ZERO))
    doubt = select(hidden | cut | even, ZERO, TWO * PER_BEND * near * steep)
    return select(hidden, ZERO, PER_BEND * bend * steep), doubt * doubt


@njit(**LOOP)
def take_blur(
    phase: Any,  # (H · W,) float32
    sigma: Any,  # (H · W,) float32
    grey: Any,  # (H · W,) uint16
    state: Any,  # (H · W,) uint8, 0 valid
    height: int,
    width: int,
    variance: Any,  # float32, of the blur, px²
    read: Any,  # float32, what reading between pixels does as well, in shares of it
    step: Any,  # float32, largest phase step between neighbours of one surface
    dark: Any,  # float32, grey level without the light of the projector
    row_start: int,
    row_stop: int,
    out: Any,  # (H · W,) float32
    out_sigma: Any,  # (H · W,) float32
) -> None:
    """Write the phase of some rows as it were without blur, and its standard deviation with what of that is in doubt.

    What has no neighbours on its surface, FAR pixels at every border, and images of less than NARROWEST columns stay.
    """
    limits = (step * SPAN, BEND_AT_RIM * HALF * (ONE + read))
    for y in range(row_start, row_stop):
        row, end = y * width, (y + 1) * width
        inner = FAR <= y < height - FAR and width >= NARROWEST
        for at in range(row, row + FAR if inner else end):
            out[at], out_sigma[at] = phase[at], sigma[at]
        for at in range(end - FAR if inner else end, end):
            out[at], out_sigma[at] = phase[at], sigma[at]
        if not inner:
            continue
        last = end - FAR - PIXELS
        for first in range(row + FAR, end - FAR, PIXELS):
            at = min(first, last)  # some pixels twice rather than some beyond
            own, noise = load(phase, at, PIXELS), load(sigma, at, PIXELS)
            per_light = PER_RISE / maximum(grey_at(grey, at) - dark, ONE)
            across, doubt_across = slope_at(phase, grey, state, at, 1, per_light, limits)
            down, doubt_down = slope_at(phase, grey, state, at, width, per_light, limits)
            bend_across, unsure_across = bend_at(phase, state, at, 1, noise, (variance, read))
            bend_down, unsure_down = bend_at(phase, state, at, width, noise, (variance, read))
            taken = select(load(state, at, PIXELS) != NOTHING, ZERO, broadcast(variance, PIXELS))
            store(own - taken * (across + down + bend_across + bend_down), out, at)
            doubt = doubt_across + doubt_down + unsure_across + unsure_down
            store(sqrt(noise * noise + taken * taken * doubt), out_sigma, at)
