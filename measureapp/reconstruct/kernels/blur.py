"""Blur of the cameras: correction of the phase to first order, and the pixels at depth discontinuities, where blur mixes two surfaces.

With SIMD vectors: plain loops over as many neighbours take three times as long (decision 16). Maps are C-contiguous.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.simd.elements import broadcast, convert, maximum, minimum, select, sqrt
from measureapp.compiled.simd.memory import load, store
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.structures import LANES, VALID, copy_row

SLOPE_REACH = 2  # px to either side, over which slopes of the phase are taken; the blur reaches no further
NEAR, FAR = 3, 6  # px to either side, over which curvatures are taken; the far ones cost 3 % in noise
MIN_WIDTH = 2 * FAR + LANES
MAX_LIGHT_SLOPE = np.float32(0.3)  # of the logarithm of the light per px; beyond, at edges, the first order does not hold
FAR_PER_NEAR = np.float32((FAR / NEAR) ** 2)  # ratio of the second differences of an even curvature
EVEN = np.float32(0.25)  # share of a curvature by which an even one may differ over the near pixels, and its halves from each other,
CURVATURE_SIGMAS, HALVES_SIGMAS = np.float32(17), np.float32(6.3)  # plus two standard deviations of either, in those of the phase
PER_LIGHT, PER_SLOPE = np.float32(1 / 12), np.float32(1 / (2 * SLOPE_REACH))
PER_CURVATURE, PER_RUN = np.float32(0.5 / FAR**2), np.float32(1 / (2 * FAR) ** 2)
# Curvature 2 to 5 px from the horizon of a round body, relative to the slope: φ'' is φ' over twice the distance.
HORIZON_CURVATURE = np.float32(1 / 7)
ZERO, HALF, ONE, TWO, EIGHT = (np.float32(number) for number in (0, 0.5, 1, 2, 8))
RIM = np.uint8(PointState.RIM)
RIM_PX = 3  # an edge two pixels wide, beside a hole that is two deep


class Blur(NamedTuple):
    """Blur of a camera and the images it acts on, (H, W)."""

    phase: Any  # float32
    sigma: Any  # float32
    grey: Any  # uint16
    state: Any  # uint8, 0 valid
    variance: Any  # float32, px²
    interpolation: Any  # float32, variance of the interpolation between pixels, relative to it
    max_step: Any  # float32, largest phase step between neighbours of one surface
    ambient: Any  # float32, grey level without the light of the projector


@njit(**INLINE)
def light_at(grey: Any, at: int) -> Any:
    """Return grey levels as float32."""
    return convert(load(grey, at, LANES), np.float32)


@njit(**INLINE)
def missing_at(state: Any, at: int, apart: int) -> Any:
    """Return masks of the pixels so far before and behind that have no phase."""
    return load(state, at - apart, LANES) != VALID, load(state, at + apart, LANES) != VALID


@njit(**INLINE)
def slope_term(blur: Blur, at: int, along: int, per_light: Any) -> Any:
    """Return the shift by the slope of the light along one direction, ∇φ · ∇ ln I, and the square of its uncertainty.

    For a linear phase the shift follows exactly from the slope of the blurred light at the pixel itself: by differences over one and two
    pixels, free of third-order terms. Where a hole is too near to know the curvature of the phase, the shift is not corrected: towards the
    horizon of a round body both terms nearly cancel. It is uncertain then, as it is where the light changes too fast.

    Parameters
    ----------
    along : distance of neighbours in that direction
    per_light : 1/12 over the light of the pixels
    """
    no_before, no_after = missing_at(blur.state, at, SLOPE_REACH * along)
    no_near_before, no_near_after = missing_at(blur.state, at, NEAR * along)
    own = load(blur.phase, at, LANES)
    before = select(no_before, ZERO, own - load(blur.phase, at - SLOPE_REACH * along, LANES))
    after = select(no_after, ZERO, load(blur.phase, at + SLOPE_REACH * along, LANES) - own)
    one_sided = no_before | no_after
    run = select(one_sided, TWO * (before + after), before + after)
    near = light_at(blur.grey, at + along) - light_at(blur.grey, at - along)
    far = light_at(blur.grey, at + 2 * along) - light_at(blur.grey, at - 2 * along)
    light = (EIGHT * near - far) * per_light
    slope = select(abs(run) < blur.max_step * np.float32(2 * SLOPE_REACH), PER_SLOPE * run, ZERO)
    unknown = one_sided | no_near_before | no_near_after | (abs(light) >= MAX_LIGHT_SLOPE)
    hidden_curvature = HORIZON_CURVATURE * HALF * (ONE + blur.interpolation)
    uncertainty = select(unknown, slope * (minimum(abs(light), ONE) + hidden_curvature), ZERO)
    return select(unknown, ZERO, slope * light), uncertainty * uncertainty


@njit(**INLINE)
def curvature_term(blur: Blur, at: int, along: int, sigma: Any) -> Any:
    """Return the shift by an even curvature of the phase along one direction, and the square of its uncertainty.

    For blurred fringes exp(i φ) it is φ'' (1 - s² φ'²) / 2: steep ones lose modulation and count less. An edge between two walls is no even
    curvature: the near pixels on it show more than the far ones, and beside it one half shows none. Where a hole is among the far pixels,
    the near ones replace them. Twice the shift of an uneven curvature is its uncertainty: an edge may be sharper than the near pixels show.
    """
    twice = TWO * load(blur.phase, at, LANES)
    far_before, far_after = load(blur.phase, at - FAR * along, LANES), load(blur.phase, at + FAR * along, LANES)
    near_before, near_after = load(blur.phase, at - NEAR * along, LANES), load(blur.phase, at + NEAR * along, LANES)
    far, near = far_before + far_after - twice, FAR_PER_NEAR * (near_before + near_after - twice)
    far_run, near_run = far_after - far_before, TWO * (near_after - near_before)
    no_far_before, no_far_after = missing_at(blur.state, at, FAR * along)
    no_near_before, no_near_after = missing_at(blur.state, at, NEAR * along)
    allowed = EVEN * abs(far)
    even = (abs(far - near) <= allowed + CURVATURE_SIGMAS * sigma) & (abs(far_run - near_run) <= allowed + HALVES_SIGMAS * sigma)
    cut, hidden = no_far_before | no_far_after, no_near_before | no_near_after
    run = select(cut, near_run, far_run)
    weight = maximum(ONE - blur.variance * PER_RUN * run * run, ZERO) + blur.interpolation
    curvature = select(cut, near, select(even, far, ZERO))
    uncertainty = select(hidden | cut | even, ZERO, TWO * PER_CURVATURE * near * weight)
    return select(hidden, ZERO, PER_CURVATURE * curvature * weight), uncertainty * uncertainty


@njit(**LOOP)
def correct_blur(blur: Blur, row_start: int, row_stop: int, phase: Any, sigma: Any) -> None:
    """Write the phase of some rows without blur, and its standard deviation with the uncertainty of the correction.

    Pixels without neighbours on their surface, FAR pixels at every border, and images of less than MIN_WIDTH columns are not corrected.
    """
    height, width = blur.phase.shape
    for y in range(row_start, row_stop):
        inner = FAR <= y < height - FAR and width >= MIN_WIDTH
        border = FAR if inner else width
        copy_row(blur.phase[y, :border], phase[y, :border])
        copy_row(blur.sigma[y, :border], sigma[y, :border])
        if not inner:
            continue
        copy_row(blur.phase[y, width - FAR :], phase[y, width - FAR :])
        copy_row(blur.sigma[y, width - FAR :], sigma[y, width - FAR :])
        last = width - FAR - LANES
        for first in range(FAR, width - FAR, LANES):
            at = y * width + min(first, last)  # some pixels twice
            own, noise = load(blur.phase, at, LANES), load(blur.sigma, at, LANES)
            per_light = PER_LIGHT / maximum(light_at(blur.grey, at) - blur.ambient, ONE)
            slope_x, slope_x_variance = slope_term(blur, at, 1, per_light)
            slope_y, slope_y_variance = slope_term(blur, at, width, per_light)
            curvature_x, curvature_x_variance = curvature_term(blur, at, 1, noise)
            curvature_y, curvature_y_variance = curvature_term(blur, at, width, noise)
            variance = select(load(blur.state, at, LANES) != VALID, ZERO, broadcast(blur.variance, LANES))
            store(own - variance * (slope_x + slope_y + curvature_x + curvature_y), phase, at)
            unknown = slope_x_variance + slope_y_variance + curvature_x_variance + curvature_y_variance
            store(sqrt(noise * noise + variance * variance * unknown), sigma, at)


@njit(**INLINE)
def hole_begins(state: Any, at: int, apart: int) -> Any:
    """Whether a hole two pixels deep begins one or two pixels away in a direction."""
    first, second = load(state, at + apart, LANES) != VALID, load(state, at + 2 * apart, LANES) != VALID
    return second & (first | (load(state, at + 3 * apart, LANES) != VALID))


@njit(**INLINE)
def hole_at_corner(state: Any, at: int, apart: int) -> Any:
    """Whether the next two pixels in a diagonal direction have no phase."""
    return (load(state, at + apart, LANES) != VALID) & (load(state, at + 2 * apart, LANES) != VALID)


@njit(**LOOP)
def mark_discontinuities(
    state: Any,  # (H, W) uint8, 0 for pixels with a phase
    row_start: int,
    row_stop: int,
    marked: Any,  # out (H, W) uint8: RIM at depth discontinuities, `state` elsewhere
) -> None:
    """Mark the two pixels beside, above or below a hole that is at least two deep, and the one diagonal to it.

    A single pixel without a phase is no discontinuity. Pixels within RIM_PX of the border of the image stay as they are.
    """
    height, width = state.shape
    for y in range(row_start, row_stop):
        copy_row(state[y], marked[y])
        if not (RIM_PX <= y < height - RIM_PX and width >= LANES + 2 * RIM_PX):
            continue
        for first in range(RIM_PX, width - RIM_PX, LANES):
            at = y * width + min(first, width - RIM_PX - LANES)
            edge = hole_begins(state, at, -1) | hole_begins(state, at, 1) | hole_begins(state, at, -width) | hole_begins(state, at, width)
            edge = edge | hole_at_corner(state, at, -width - 1) | hole_at_corner(state, at, -width + 1)
            edge = edge | hole_at_corner(state, at, width - 1) | hole_at_corner(state, at, width + 1)
            own = load(state, at, LANES)
            store(select(edge & (own == VALID), RIM, own), marked, at)
