"""Compiled loop that compares, at points, what their cameras see of the fringes across the epipolar lines."""
# One loop over pixels, as in `fusing`; its parts are compiled into it, so that it stays one loop.

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.compiled.options import ALLOCATING_LOOP, INLINE
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.looking import look, native_pixel, see
from measureapp.reconstruct.kernels.seen import SEEN
from measureapp.reconstruct.kernels.slopes import SLOPE_X, SLOPE_Y

CONTRADICTED = np.uint8(PointState.CONTRADICTED)
NOTHING, AGREES, DIFFERS = 0, 1, 2


@njit(**INLINE)
def see_across(nx: Any, ny: Any, z: Any, z_sigma: Any, other: Any) -> Any:
    """Look with another camera at the point at depth ``z`` of the ray (nx, ny).

    Returns (BLANK | SEEN | PARTLY, phase, its variance with that of the depth, its slope per pixel across the epipolar line, its
    steepness per pixel in any direction, image place u, v).
    """
    state, pixels, quad, turn, frame, there_frame, grid, stride, baseline = other
    rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
    here = (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) / rz
    row = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) / rz - frame[2]
    place = there_frame[0] * (here - baseline / (rz * z)) - there_frame[1]
    u, v, to_u, to_v = native_pixel(grid, stride, place, row)
    sight, value, noise = look(state, pixels, quad, u, v)
    along, across = 0.0, 0.0
    if sight == SEEN:
        below_u, below_v, _u, _v = native_pixel(grid, stride, place, row + 1.0)
        j, k = int(u + 0.5), int(v + 0.5)
        gx, gy = pixels[k, j, SLOPE_X], pixels[k, j, SLOPE_Y]
        along = gx * to_u + gy * to_v
        across = gx * (below_u - u) + gy * (below_v - v)
        noise += (along * there_frame[0] * baseline * z_sigma / (rz * z * z)) ** 2
    return sight, value, noise, across, np.hypot(along, across), u, v


@njit(**INLINE)
def release(covered: Any, width: Any, u: Any, v: Any) -> None:
    """Give the pixels around an image place free for other points."""
    j, i = int(u + 0.5), int(v + 0.5)
    height = len(covered) // width
    for k in range(max(i - 1, 0), min(i + 2, height)):
        for m in range(max(j - 1, 0), min(j + 2, width)):
            covered[k * width + m] = 0


@njit(**INLINE)
def solve_again(own_phase: Any, own_sigma: Any, nx: Any, ny: Any, z: Any, bits: Any, sights: Any) -> Any:
    """Step from depth ``z`` to that of least squares of the cameras in ``bits`` alone.

    Returns (whether they determine it, depth, its standard deviation, gain of the last of them).
    """
    taking, gain_of_one = 0, 0.0
    zz, zd, dd = 0.0, 0.0, 1.0 / (float(own_sigma) ** 2 + 1e-20)
    rz, rd = 0.0, 0.0
    for c in range(len(sights)):
        if (bits >> c) & 1 == 0:
            continue
        sight, e, _along, g, variance, _here, _there, _line = see(own_phase, nx, ny, z, sights[c])
        if sight != SEEN:
            continue
        weight = 1.0 / (variance + 1e-20)
        zz += weight * g * g
        zd -= weight * g
        dd += weight
        rz -= weight * g * e
        rd += weight * e
        taking += 1
        gain_of_one = g
    determinant = zz * dd - zd * zd
    if taking == 0 or not determinant > 0:
        return False, 0.0, 0.0, 0.0
    return True, z + (rz * dd - zd * rd) / determinant, np.sqrt(dd / determinant), gain_of_one


@njit(**INLINE)
def others_agree(verdict: Any, value: Any, noise: Any, steep: Any, sigmas: Any, tolerance_px: Any) -> bool:
    """Whether two of the cameras that differ from this one agree with each other."""
    for k in range(len(verdict)):
        for m in range(k):
            if verdict[k] == DIFFERS and verdict[m] == DIFFERS:
                limit = sigmas * np.sqrt(noise[k] + noise[m]) + tolerance_px * max(steep[k], steep[m])
                if abs(value[k] - value[m]) <= limit:
                    return True
    return False


@njit(**INLINE)
def release_differing(verdict: Any, places: Any, covered: Any, widths: Any, u: Any, v: Any) -> None:
    """Give the pixels of the cameras that differ free for other points."""
    for k in range(len(verdict)):
        if verdict[k] == DIFFERS:
            release(covered[places[k]], widths[places[k]], u[k], v[k])


@njit(**INLINE)
def vote(nx: Any, ny: Any, z: Any, z_sigma: Any, own: Any, bits: Any, places: Any, sights: Any, limits: Any, votes: Any) -> Any:
    """Ask every camera that takes part in the point at depth ``z`` whether it sees the fringe of this one there.

    Leaves in ``votes`` per camera: NOTHING, AGREES or DIFFERS, the phase it sees, its variance and steepness, the image place; and
    the difference in px across the epipolar line with its variance, 0 where it says NOTHING. Returns (agreeing with this one, differing).
    """
    verdict, value, noise, steep, u, v, shift, shift_variance = votes
    phase, own_noise = own
    sigmas, tolerance_px = limits
    agree, differ = 1, 0
    for k in range(len(places)):
        verdict[k] = NOTHING
        if (bits >> places[k]) & 1 == 0:
            continue
        sight, value[k], noise[k], across, steep[k], u[k], v[k] = see_across(nx, ny, z, z_sigma, sights[k])
        if sight != SEEN or abs(across) < 1e-6:
            continue
        excess, spread = value[k] - phase, noise[k] + own_noise
        shift[k], shift_variance[k] = excess / across, spread / across**2
        if abs(excess) > sigmas * np.sqrt(spread) + tolerance_px * steep[k]:
            verdict[k] = DIFFERS
            differ += 1
        else:
            verdict[k] = AGREES
            agree += 1
    return agree, differ


@njit(**INLINE)
def note_shifts(votes: Any, shifts: Any, row: int, column: int) -> None:
    """Note by how much the cameras that said something differ."""
    for k in range(len(votes[0])):
        if votes[0][k] != NOTHING:
            shifts[k, row, column, 0] = votes[6][k]
            shifts[k, row, column, 1] = votes[7][k]


@njit(**INLINE)
def without_differing(verdict: Any, places: Any, bits: Any) -> Any:
    """Return which cameras take part without those that differ."""
    for k in range(len(verdict)):
        if verdict[k] == DIFFERS:
            bits &= ~np.uint8(1 << places[k])
    return bits


@njit(**ALLOCATING_LOOP)
def check_across(
    rays: Any,
    own: Any,  # (phase, sigma) of this camera along the epipolar lines, (H, W) float32
    own_across: Any,  # (phase, sigma, state) of this camera, across them
    depth: Any,  # in and out (H, W) float32, 0 for none
    z_sigma: Any,  # in and out
    pair_gain: Any,  # in and out, see `fuse`
    bits: Any,  # in and out
    places: Any,  # (K,) int64, of the cameras with phases across, which bit of `bits` they are
    sights: Any,  # per other camera: what `see` needs of it
    sights_across: Any,  # per one of the K: the same, with its phases across
    widths: Any,  # (M,) int64 of the other cameras' images
    sigmas: Any,
    tolerance_px: Any,
    sample: int,
    row_start: int,
    row_stop: int,
    fate: Any,  # in and out (H, W) uint8
    covered: Any,  # in and out per other camera (H · W,) uint8, 0 for its pixels that take part no longer
    set_aside: Any,  # out (H, W) bool, the others agree against this camera
    shifts: Any,  # out (K, rows of samples, columns of samples, 2) float32, px across the epipolar line and variance
) -> None:
    """Let the cameras of a point vote about it with their phases across the epipolar lines.

    A camera that differs from this one takes part no longer, where another one agrees with this one; the depth is solved again
    without it. Where two others agree with each other against this one, the point is theirs: it is set aside here. Else
    there is none.
    """
    count = len(places)
    verdict, u, v = np.zeros(count, np.int64), np.zeros(count), np.zeros(count)
    value, noise, steep = np.zeros(count), np.zeros(count), np.zeros(count)
    votes = (verdict, value, noise, steep, u, v, np.zeros(count), np.zeros(count))
    for y in range(row_start, row_stop):
        for x in range(depth.shape[1]):
            z = float(depth[y, x])
            if z <= 0 or own_across[2][y, x] != 0:
                continue
            nx, ny = rays[y, x, 0], rays[y, x, 1]
            seen = (own_across[0][y, x], float(own_across[1][y, x]) ** 2)
            agree, differ = vote(nx, ny, z, z_sigma[y, x], seen, bits[y, x], places, sights_across, (sigmas, tolerance_px), votes)
            if y % sample == 0 and x % sample == 0:
                note_shifts(votes, shifts, y // sample, x // sample)
            if differ == 0:
                continue
            if agree >= 2 and agree > differ:
                bits[y, x] = without_differing(verdict, places, bits[y, x])
                release_differing(verdict, places, covered, widths, u, v)
                solved, better, sigma, gain = solve_again(own[0][y, x], own[1][y, x], nx, ny, z, bits[y, x], sights)
                if solved:
                    depth[y, x] = better
                    z_sigma[y, x] = sigma
                    if len(pair_gain) > 0:
                        pair_gain[y, x] = gain
                    continue
            if agree == 1 and others_agree(verdict, value, noise, steep, sigmas, tolerance_px):
                set_aside[y, x] = True
                release_differing(verdict, places, covered, widths, u, v)
            depth[y, x] = 0
            z_sigma[y, x] = 0
            fate[y, x] = CONTRADICTED
