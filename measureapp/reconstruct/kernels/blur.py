"""Blur of the cameras: correction of the phase to first order, and the pixels at depth discontinuities, where blur mixes two surfaces.

Plain loops over flat maps, which the compiler turns into SIMD code: without branches, and with `read` instead of indices.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.structures import VALID, read, write

SLOPE_REACH = 2  # px to either side, over which slopes of the phase are taken; the blur reaches no further
NEAR, FAR = 3, 6  # px to either side, over which curvatures are taken; the far ones cost 3 % in noise
MAX_LIGHT_SLOPE = np.float32(0.3)  # of the logarithm of the light per px; beyond, at edges, the first order does not hold
FAR_PER_NEAR = np.float32((FAR / NEAR) ** 2)  # ratio of the second differences of an even curvature
EVEN = np.float32(0.25)  # share of a curvature by which an even one may differ over the near pixels, and its halves from each other,
CURVATURE_SIGMAS, HALVES_SIGMAS = np.float32(17), np.float32(6.3)  # plus two standard deviations of either, in those of the phase
PER_LIGHT, PER_SLOPE = np.float32(1 / 12), np.float32(1 / (2 * SLOPE_REACH))
PER_CURVATURE, PER_RUN = np.float32(0.5 / FAR**2), np.float32(1 / (2 * FAR) ** 2)
# Curvature 2 to 5 px from the horizon of a round body, relative to the slope: φ'' is φ' over twice the distance.
HORIZON_CURVATURE = np.float32(1 / 7)
SURE_OF_SLOPE = np.float32(0.75)  # share of the shift by the light that is sure where the correction is of less than the usual order
ZERO, HALF, ONE, TWO, THREE, EIGHT = (np.float32(number) for number in (0, 0.5, 1, 2, 3, 8))
RIM = np.uint8(PointState.RIM)
RIM_PX = 3  # an edge two pixels wide, beside a hole that is two deep


class Blur(NamedTuple):
    """Blur of a camera and the flat images it acts on, (H · W,)."""

    phase: Any  # float32
    sigma: Any  # float32
    light: Any  # float32, grey level of the projector's light
    state: Any  # uint8, 0 valid
    variance: Any  # float32, px²
    interpolation: Any  # float32, variance of the interpolation between pixels, relative to it
    max_step: Any  # float32, largest phase step between neighbours of one surface
    height: int
    width: int


@njit(**INLINE)
def missing_at(state: Any, at: int, apart: int) -> Any:
    """Return whether the pixels so far before and behind have no phase."""
    return read(state, at - apart) != VALID, read(state, at + apart) != VALID


@njit(**INLINE)
def slope_term(blur: Blur, at: int, along: int, per_light: Any) -> Any:
    """Return the shift by the slope of the light along one direction, ∇φ · ∇ ln I, and the square of its uncertainty.

    For a linear phase the shift follows exactly from the slope of the blurred light at the pixel itself: by differences over one and two
    pixels, free of third-order terms. Beside a hole the slope of the phase is taken from the other side, to second order. How the phase
    curves there is not known: that, and a share of the shift, are uncertain. So they are where the light changes too fast; there the shift is
    that of the fastest change for which the first order holds.

    Parameters
    ----------
    along : distance of neighbours in that direction
    per_light : 1/12 over the light of the pixels
    """
    no_before, no_after = missing_at(blur.state, at, SLOPE_REACH * along)
    no_near_before, no_near_after = missing_at(blur.state, at, NEAR * along)
    no_second_before, no_second_after = missing_at(blur.state, at, 2 * SLOPE_REACH * along)
    own, behind, ahead = read(blur.phase, at), read(blur.phase, at - SLOPE_REACH * along), read(blur.phase, at + SLOPE_REACH * along)
    before, after = ZERO if no_before else own - behind, ZERO if no_after else ahead - own
    second_before = before if no_second_before else behind - read(blur.phase, at - 2 * SLOPE_REACH * along)
    second_after = after if no_second_after else read(blur.phase, at + 2 * SLOPE_REACH * along) - ahead
    one_sided = no_before | no_after
    first, second = before + after, (ZERO if no_before else second_before) + (ZERO if no_after else second_after)
    run = THREE * first - second if one_sided else first
    near = read(blur.light, at + along) - read(blur.light, at - along)
    far = read(blur.light, at + 2 * along) - read(blur.light, at - 2 * along)
    light = (EIGHT * near - far) * per_light
    slope = PER_SLOPE * run if abs(run) < blur.max_step * np.float32(2 * SLOPE_REACH) else ZERO
    beside_hole, too_fast = one_sided | no_near_before | no_near_after, abs(light) > MAX_LIGHT_SLOPE
    taken = min(max(light, -MAX_LIGHT_SLOPE), MAX_LIGHT_SLOPE)
    doubt = min(abs(light), ONE) - SURE_OF_SLOPE * abs(taken) + HORIZON_CURVATURE * HALF * (ONE + blur.interpolation)
    uncertainty = slope * doubt if beside_hole | too_fast else ZERO
    return slope * taken, uncertainty * uncertainty


@njit(**INLINE)
def curvature_term(blur: Blur, at: int, along: int, sigma: Any) -> Any:
    """Return the shift by an even curvature of the phase along one direction, and the square of its uncertainty.

    For blurred fringes exp(i φ) it is φ'' (1 - s² φ'²) / 2: steep ones lose modulation and count less. An edge between two walls is no even
    curvature: the near pixels on it show more than the far ones, and beside it one half shows none. Where a hole is among the far pixels,
    the near ones replace them. Twice the shift of an uneven curvature is its uncertainty: an edge may be sharper than the near pixels show.
    """
    twice = TWO * read(blur.phase, at)
    far_before, far_after = read(blur.phase, at - FAR * along), read(blur.phase, at + FAR * along)
    near_before, near_after = read(blur.phase, at - NEAR * along), read(blur.phase, at + NEAR * along)
    far, near = far_before + far_after - twice, FAR_PER_NEAR * (near_before + near_after - twice)
    far_run, near_run = far_after - far_before, TWO * (near_after - near_before)
    no_far_before, no_far_after = missing_at(blur.state, at, FAR * along)
    no_near_before, no_near_after = missing_at(blur.state, at, NEAR * along)
    allowed = EVEN * abs(far)
    even = (abs(far - near) <= allowed + CURVATURE_SIGMAS * sigma) & (abs(far_run - near_run) <= allowed + HALVES_SIGMAS * sigma)
    cut, hidden = no_far_before | no_far_after, no_near_before | no_near_after
    run = near_run if cut else far_run
    weight = max(ONE - blur.variance * PER_RUN * run * run, ZERO) + blur.interpolation
    curvature = near if cut else (far if even else ZERO)
    uncertainty = ZERO if hidden | cut | even else TWO * PER_CURVATURE * near * weight
    return ZERO if hidden else PER_CURVATURE * curvature * weight, uncertainty * uncertainty


@njit(**LOOP)
def correct_blur(blur: Blur, row_start: int, row_stop: int, phase: Any, sigma: Any) -> None:
    """Write the phase of some rows without blur, and its standard deviation with the uncertainty of the correction; both (H · W,).

    Pixels without neighbours on their surface, and FAR pixels at every border, are not corrected.
    """
    width = blur.width
    for y in range(row_start, row_stop):
        row, inner = y * width, FAR <= y < blur.height - FAR and width > 2 * FAR
        for k in range(2 * FAR if inner else width):
            at = row + k if k < FAR or not inner else row + width - 2 * FAR + k
            phase[at], sigma[at] = blur.phase[at], blur.sigma[at]
        for at in range(row + FAR, row + width - FAR if inner else 0):
            own, noise = read(blur.phase, at), read(blur.sigma, at)
            per_light = PER_LIGHT / max(read(blur.light, at), ONE)
            slope_x, slope_x_variance = slope_term(blur, at, 1, per_light)
            slope_y, slope_y_variance = slope_term(blur, at, width, per_light)
            curvature_x, curvature_x_variance = curvature_term(blur, at, 1, noise)
            curvature_y, curvature_y_variance = curvature_term(blur, at, width, noise)
            variance = blur.variance if read(blur.state, at) == VALID else ZERO
            write(phase, at, own - variance * (slope_x + slope_y + curvature_x + curvature_y))
            unknown = slope_x_variance + slope_y_variance + curvature_x_variance + curvature_y_variance
            write(sigma, at, np.sqrt(noise * noise + variance * variance * unknown))


@njit(**INLINE)
def hole_begins(state: Any, at: int, apart: int) -> bool:
    """Whether a hole two pixels deep begins one or two pixels away in a direction."""
    first, second, third = read(state, at + apart) != VALID, read(state, at + 2 * apart) != VALID, read(state, at + 3 * apart) != VALID
    return second & (first | third)


@njit(**INLINE)
def hole_at_corner(state: Any, at: int, apart: int) -> bool:
    """Whether the next two pixels in a diagonal direction have no phase."""
    return (read(state, at + apart) != VALID) & (read(state, at + 2 * apart) != VALID)


@njit(**LOOP)
def mark_discontinuities(
    state: Any,  # (H · W,) uint8, 0 for pixels with a phase
    height: int,
    width: int,
    row_start: int,
    row_stop: int,
    marked: Any,  # out (H · W,) uint8: RIM at depth discontinuities, `state` elsewhere
) -> None:
    """Mark the two pixels beside, above or below a hole that is at least two deep, and the one diagonal to it.

    A single pixel without a phase is no discontinuity. Pixels within RIM_PX of the border of the image stay as they are.
    """
    for y in range(row_start, row_stop):
        row, inner = y * width, RIM_PX <= y < height - RIM_PX and width > 2 * RIM_PX
        for at in range(row, row + width):
            write(marked, at, read(state, at))
        for at in range(row + RIM_PX, row + width - RIM_PX if inner else 0):
            edge = hole_begins(state, at, -1) | hole_begins(state, at, 1) | hole_begins(state, at, -width) | hole_begins(state, at, width)
            edge |= hole_at_corner(state, at, -width - 1) | hole_at_corner(state, at, -width + 1)
            edge |= hole_at_corner(state, at, width - 1) | hole_at_corner(state, at, width + 1)
            own = read(state, at)
            write(marked, at, RIM if edge & (own == VALID) else own)
