"""Fusion of the matches of a pixel with all other cameras: which candidate they agree on, and the depth of all by least squares.

Unknowns are the depth and the projector's true phase; every camera gives one equation, the pixel's own phase another.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import ALLOCATING_LOOP, INLINE, LOOP
from measureapp.compiled.simd.elements import select, sqrt
from measureapp.compiled.simd.memory import load, load_records, store
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.match import STRIP, match
from measureapp.reconstruct.kernels.reproject import observe
from measureapp.reconstruct.kernels.structures import ABSENT, INTERPOLATED, LANES, VALID, Candidates, DepthArrays, Limits, Table
from measureapp.reconstruct.kernels.structures import AMBIGUOUS as AMBIGUOUS_MATCH
from measureapp.reconstruct.kernels.table import COLUMN_MASK, LINES_PER_CELL, PIXEL_MASK, REPEATED, ROW_SHIFT

UNMATCHED, AMBIGUOUS, CONTRADICTED = (np.uint8(state) for state in (PointState.UNMATCHED, PointState.AMBIGUOUS, PointState.CONTRADICTED))
BOTH = np.uint8(0b11)
OCCLUSION_PX = 16.0  # disparity by which a surface must be nearer to occlude a point
CONTRADICTION = -100  # outweighs the support of all cameras
TINY = 1e-20  # rad²
EXCESS, SLOPE, GAIN, VARIANCE, OWN_X, LINE = range(6)  # of a candidate's observation
ZERO, ONE = np.float32(0), np.float32(1)


class OwnTable(NamedTuple):
    """Table of the camera that is matched, to find what occludes its points from another camera."""

    table: Table  # (rows + 2, bins + 2)
    rectified: Any  # (H, W, 2) float32, of its pixels
    x0: Any


class Camera(NamedTuple):
    """Camera that is matched, (H, W) float32."""

    rays: Any  # (H, W, 2), normalised image coordinates
    flat_rays: Any  # (H, 2 W)
    phase: Any
    sigma: Any
    skip: Any  # uint8, 0 for pixels to match, else their state


class Others(NamedTuple):
    """Other cameras, one entry for each."""

    partners: Any  # `Partner`
    observers: Any  # `Observer`
    tables: Any  # `OwnTable`
    px_per_mm: Any  # (c0, c1, c2) float32 of the last one: (c0 · x + c1 · y + c2) · z is the share of z that moves a point by 1 px there


class Seen(NamedTuple):
    """Observations of the candidates of a pixel: candidate k by camera c; a candidate's own camera sees what was matched."""

    sight: Any  # (M, M)
    values: Any  # (6, M, M): EXCESS, SLOPE, …
    agrees: Any  # (M, M) bool


@njit(**LOOP)
def fuse_pairs(
    camera: Camera, found: Candidates, px_per_mm: Any, limits: Limits, row_start: int, row_stop: int, column_start: int, column_stop: int,
    depth: Any, depth_sigma: Any,
) -> None:  # fmt: skip
    """Fuse the candidates of two other cameras that agree, with SIMD vectors: the greatest part of a viewpoint; ``found`` (2, rows, columns).

    Writes depth and standard deviation, 0 where the candidates differ or one is missing.
    """
    c0, c1, c2 = px_per_mm
    sigmas2, width = limits.sigmas * limits.sigmas, camera.phase.shape[1]
    for y in range(row_start, row_stop):
        first_row, second_row = (y - row_start) * found.depth.shape[2], (row_stop - row_start + y - row_start) * found.depth.shape[2]
        for first in range(column_start, column_stop, LANES):
            x = min(first, column_stop - LANES)
            at, i, k = y * width + x, first_row + x - column_start, second_row + x - column_start
            z0, g0, v0 = load(found.depth, i, LANES), load(found.gain, i, LANES), load(found.variance, i, LANES)
            z1, g1, v1 = load(found.depth, k, LANES), load(found.gain, k, LANES), load(found.variance, k, LANES)
            ray_x, ray_y = load_records(camera.rays, 2 * at, LANES, 2)
            own = load(camera.sigma, at, LANES)
            own = own * own
            excess = g1 * (z0 - z1)
            variance = v1 * g0 * g0 + own * (g1 - g0) * (g1 - g0) + v0 * g1 * g1  # of the excess, times g0²
            px = (c0 * ray_x + c1 * ray_y + c2) * z1 * z1
            agrees = abs(excess * g0) <= sqrt(sigmas2 * variance) + limits.px * abs(g1 * g0) * px
            share = ONE / own  # all variances relative to the own one: then one division serves all weights
            a, b = v0 * share, v1 * share
            dd, zz, zd = a * b + a + b, b * g0 * g0 + a * g1 * g1, b * g0 + a * g1
            determinant = zz * dd - zd * zd
            per = ONE / determinant
            solved = (z0 > ZERO) & (z1 > ZERO) & agrees & (determinant > ZERO)
            store(select(solved, z0 - a * excess * (g1 * dd - zd) * per, ZERO), depth, at)
            store(select(solved, sqrt(own * a * b * dd * per), ZERO), depth_sigma, at)


@njit(**INLINE)
def is_occluded(phase: Any, own_x: Any, y: Any, own: OwnTable) -> bool:
    """Whether a phase that another camera sees instead of a point belongs to a surface that this camera sees before the point."""
    cells = own.table.cells
    row, column = int(y * (1.0 / LINES_PER_CELL)) + 1, int((phase - own.table.lowest) * own.table.per_rad) + 1
    if row < 1 or column < 1 or row >= cells.shape[0] - 1 or column >= cells.shape[1] - 1:
        return False
    held = cells[row, column]
    if held < 0 or (held & REPEATED) != 0:
        return False
    return bool(own.rectified[(held & PIXEL_MASK) >> ROW_SHIFT, held & COLUMN_MASK, 0] + own.x0 - own_x > OCCLUSION_PX)


@njit(**INLINE)
def observe_candidates(found: Candidates, row: int, column: int, phase: Any, ray_x: Any, ray_y: Any, observers: Any, seen: Seen) -> None:
    """Observe every candidate of a pixel with every other camera."""
    for c in range(len(observers)):
        observer = observers[c]
        for k in range(len(observers)):
            depth = found.depth[k, row, column]
            seen.sight[k, c] = ABSENT
            if depth <= 0:
                continue
            if c == k:
                seen.sight[k, c] = INTERPOLATED
                seen.values[EXCESS, k, c] = 0.0
                seen.values[GAIN, k, c], seen.values[VARIANCE, k, c] = found.gain[k, row, column], found.variance[k, row, column]
                continue
            one = observe(phase, ray_x, ray_y, depth, observer)
            seen.sight[k, c] = one.sight
            seen.values[EXCESS, k, c], seen.values[SLOPE, k, c], seen.values[GAIN, k, c] = one.excess, one.slope, one.gain
            seen.values[VARIANCE, k, c], seen.values[OWN_X, k, c], seen.values[LINE, k, c] = one.variance, one.own_x, one.y


@njit(**INLINE)
def excess_variance(seen: Seen, k: int, c: int, own: Any) -> Any:
    """Return the variance of the excess that camera c sees at the candidate of camera k; the noise of both phases moves that."""
    ratio = seen.values[GAIN, k, c] / seen.values[GAIN, k, k]
    return seen.values[VARIANCE, k, c] + own * (ratio - 1) ** 2 + seen.values[VARIANCE, k, k] * ratio**2


@njit(**INLINE)
def choose_candidate(seen: Seen, phase: Any, own: Any, tables: Any, limits: Limits) -> int:
    """Return the candidate that most cameras agree with and none contradicts, −1 for none; writes who agrees with which."""
    best, best_support = -1, 0
    for k in range(len(tables)):
        if seen.sight[k, k] != INTERPOLATED:
            continue
        support = 0
        for c in range(len(tables)):
            seen.agrees[k, c] = c == k
            support += c == k
            if c == k or seen.sight[k, c] != INTERPOLATED:
                continue
            excess = seen.values[EXCESS, k, c]
            if abs(excess) <= limits.sigmas * np.sqrt(excess_variance(seen, k, c, own)) + limits.px * abs(seen.values[SLOPE, k, c]):
                support += 1
                seen.agrees[k, c] = True
            elif not is_occluded(phase + excess, seen.values[OWN_X, k, c], seen.values[LINE, k, c], tables[c]):
                support = CONTRADICTION
        if support > best_support:
            best, best_support = k, support
    return best


@njit(**INLINE)
def solve_depth(seen: Seen, best: int, own: Any) -> Any:
    """Return the correction of a candidate's depth, its standard deviation (0 where there is no solution) and the cameras in it."""
    zz, zd, dd, rz, rd = 0.0, 0.0, 1.0 / (own + TINY), 0.0, 0.0
    cameras = 0
    for c in range(len(seen.agrees)):
        if seen.agrees[best, c]:
            excess, gain, weight = seen.values[EXCESS, best, c], seen.values[GAIN, best, c], 1.0 / (seen.values[VARIANCE, best, c] + TINY)
            zz += weight * gain * gain
            zd -= weight * gain
            dd += weight
            rz -= weight * gain * excess
            rd += weight * excess
            cameras |= 1 << c
    determinant = zz * dd - zd * zd
    if determinant <= 0:
        return 0.0, 0.0, cameras
    return (rz * dd - zd * rd) / determinant, np.sqrt(dd / determinant), cameras


@njit(**INLINE)
def sample_shifts(seen: Seen, own: Any, row: int, column: int, shifts: Any) -> None:
    """Note by how many pixels along the epipolar line other cameras see the candidates shifted, and the variance of it."""
    for k in range(len(shifts)):
        for c in range(len(shifts)):
            if c != k and seen.sight[k, c] == INTERPOLATED:
                slope = seen.values[SLOPE, k, c]
                shifts[k, row, column, 0] = seen.values[EXCESS, k, c] / slope
                shifts[k, row, column, 1] = excess_variance(seen, k, c, own) / slope**2


@njit(**INLINE)
def state_without_point(seen: Seen, found: Candidates, row: int, column: int) -> Any:
    """Return the state of a pixel none of whose candidates is left."""
    state = UNMATCHED
    for k in range(len(found.reason)):
        if found.reason[k, row, column] == AMBIGUOUS_MATCH:
            state = AMBIGUOUS
    for k in range(len(found.reason)):
        if seen.sight[k, k] == INTERPOLATED:
            state = CONTRADICTED
    return state


@njit(**INLINE)
def fuse_pixel(
    camera: Camera, found: Candidates, others: Others, limits: Limits, y: int, x: int, row: int, column: int, seen: Seen,
    out: DepthArrays, used: Any,
) -> None:  # fmt: skip
    """Choose the candidate of a pixel that no camera contradicts and most agree with, and solve for its depth with all that agree."""
    own = camera.sigma[y, x] * camera.sigma[y, x]
    out.depth[y, x], out.sigma[y, x], out.cameras[y, x] = ZERO, ZERO, 0
    best = choose_candidate(seen, camera.phase[y, x], own, others.tables, limits)
    if best < 0:
        out.state[y, x] = state_without_point(seen, found, row, column)
        return
    correction, sigma, cameras = solve_depth(seen, best, own)
    for c in range(len(used)):
        if seen.agrees[best, c] and found.depth[c, row, column] > 0:
            used[c][found.pixel[c, row, column]] = 1
    if sigma <= 0:
        out.state[y, x] = AMBIGUOUS
        return
    out.depth[y, x], out.sigma[y, x] = found.depth[best, row, column] + correction, sigma
    out.cameras[y, x], out.state[y, x] = cameras, VALID
    if len(used) == 1:
        out.pair_gain[y, x] = seen.values[GAIN, 0, 0]


@njit(**INLINE)
def accept_pairs(
    camera: Camera, found: Candidates, y: int, row: int, column_start: int, column_stop: int, out: DepthArrays, used: Any
) -> None:
    """Write state and cameras of the pixels of a row that `fuse_pairs` solved, and which pixels of the other cameras take part."""
    part = slice(column_start, column_stop)
    depth, state, cameras, skip = out.depth[y, part], out.state[y, part], out.cameras[y, part], camera.skip[y, part]
    for i in range(len(depth)):
        state[i] = skip[i]
    for i in range(len(depth)):
        cameras[i] = BOTH if depth[i] > ZERO else np.uint8(0)
    for k in range(len(used)):
        pixel, of_camera = found.pixel[k, row], used[k]
        for i in range(len(depth)):
            if depth[i] > ZERO:
                of_camera[np.uint32(pixel[i])] = 1


@njit(**ALLOCATING_LOOP)
def match_and_fuse(
    camera: Camera,
    others: Others,
    limits: Limits,
    sample: int,  # distance in pixels of the samples of shifts between the cameras
    row_start: int,
    row_stop: int,
    out: DepthArrays,
    used: Any,  # out per other camera (H · W,) uint8, 1 for its pixels that take part
    shifts: Any,  # out (M, rows of samples, columns of samples, 2) float32: shift in the others in px, and its variance; 0, 0 for none
    matched: Any,  # out (M,) int64, how many pixels were matched with each other camera
) -> None:
    """Match the rows of a band with every other camera and fuse the candidates, strip by strip: these stay in the second-level cache."""
    count, rows, width = len(others.partners), row_stop - row_start, camera.phase.shape[1]
    shape = (count, rows, STRIP + LANES)
    depth, gain, variance = np.empty(shape, np.float32), np.empty(shape, np.float32), np.empty(shape, np.float32)
    found = Candidates(depth, gain, variance, np.empty(shape, np.int32), np.empty(shape, np.uint8))
    seen = Seen(np.zeros((count, count), np.uint8), np.zeros((6, count, count)), np.zeros((count, count), np.bool_))
    matched[:] = 0
    first = 0
    while first < width:
        stop = first + STRIP if width - first >= STRIP + LANES else width  # no strip is narrower than a vector
        for k in range(count):
            of_one = Candidates(depth[k], gain[k], variance[k], found.pixel[k], found.reason[k])
            matched[k] += match(camera.flat_rays, camera.phase, camera.skip, others.partners[k], row_start, row_stop, first, stop, of_one)
        if count == 2:
            fuse_pairs(camera, found, others.px_per_mm, limits, row_start, row_stop, first, stop, out.depth, out.sigma)
        else:
            out.depth[row_start:row_stop, first:stop], out.sigma[row_start:row_stop, first:stop] = ZERO, ZERO
        for y in range(row_start, row_stop):
            row = y - row_start
            accept_pairs(camera, found, y, row, first, stop, out, used)
            sampled_row, skip, depth_row = y % sample == 0, camera.skip[y, first:stop], out.depth[y, first:stop]
            for i in range(stop - first):
                if skip[i] != 0 or (depth_row[i] > ZERO and not sampled_row):
                    continue
                x, sampled = first + i, sampled_row and (first + i) % sample == 0
                if depth_row[i] == ZERO or sampled:
                    ray_x, ray_y = camera.rays[y, x, 0], camera.rays[y, x, 1]
                    observe_candidates(found, row, i, camera.phase[y, x], ray_x, ray_y, others.observers, seen)
                    if sampled:
                        sample_shifts(seen, camera.sigma[y, x] ** 2, y // sample, x // sample, shifts)
                    fuse_pixel(camera, found, others, limits, y, x, row, i, seen, out, used)
        first = stop
