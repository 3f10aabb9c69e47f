"""Checks of points by cameras that did not measure them: surfaces measured already, occlusion, and orthogonal fringes."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import ALLOCATING_LOOP, INLINE, LOOP
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.fuse import TINY, Camera
from measureapp.reconstruct.kernels.reproject import interpolate_phase, native_pixel, observe, project
from measureapp.reconstruct.kernels.structures import (
    ABSENT,
    INTERPOLATED,
    MIN_SLOPE,
    SLOPE_X,
    SLOPE_Y,
    VALID,
    DepthArrays,
    Limits,
    Observer,
    Pair,
)

NO_PHASE, CONTRADICTED, SEEN_BY_ANOTHER, RIM = (
    np.uint8(state) for state in (PointState.NO_PHASE, PointState.CONTRADICTED, PointState.SEEN_BY_ANOTHER, PointState.RIM)
)
USED_RADIUS_PX = 2  # gaps between the pixels that take part in points of another camera
MAX_DISPARITY_SLOPE = 3.0  # px per px along an epipolar line, on one surface
EDGE_PX = 4.0  # uncertainty of the disparity at depth discontinuities
SILENT, AGREES, DIFFERS = 0, 1, 2


class Votes(NamedTuple):
    """What every camera with orthogonal fringes says about a point, (K,) each."""

    verdict: Any  # SILENT | AGREES | DIFFERS
    phase: Any
    variance: Any
    steepness: Any  # of the phase per pixel in any direction
    u: Any
    v: Any
    shift: Any  # px across the epipolar line
    shift_variance: Any


@njit(**LOOP)
def mark_used(
    state: Any,  # (H, W) uint8, 0 for pixels with a phase
    used: Any,  # (H, W) uint8, 1 for pixels that take part in points of another camera
    sample: int,  # at samples so many pixels apart only the pixel itself counts, or none where `sampled` is 0
    sampled: Any,  # uint8, 1 or 0
    otherwise: Any,  # uint8, written for all other pixels
    row_start: int,
    row_stop: int,
    marked: Any,  # out (H, W) uint8: NO_PHASE, RIM, SEEN_BY_ANOTHER or `otherwise`
) -> None:
    """Mark pixels without a phase, and those within USED_RADIUS_PX of one that takes part in a point."""
    height, width = state.shape
    for y in range(row_start, row_stop):
        out = marked[y]
        out[:] = np.uint8(0)
        for v in range(max(y - USED_RADIUS_PX, 0), min(y + USED_RADIUS_PX + 1, height)):
            for shift in range(-USED_RADIUS_PX, USED_RADIUS_PX + 1):
                low, high = max(-shift, 0), width - max(shift, 0)
                target, source = out[low:high], used[v, low + shift : high + shift]
                for x in range(high - low):
                    target[x] |= source[x]
        if y % sample == 0:
            for x in range(0, width, sample):
                out[x] = used[y, x] & sampled
        states = state[y]
        for x in range(width):
            measured = SEEN_BY_ANOTHER if out[x] != 0 else otherwise
            without_phase = RIM if states[x] == RIM else NO_PHASE
            out[x] = measured if states[x] == VALID else without_phase


@njit(**INLINE)
def is_occluded(ray_x: Any, ray_y: Any, depth: Any, pair: Pair, axis: Any, other_rays: Any, other_depth: Any, other_state: Any) -> bool:
    """Whether a surface that the other camera measured occludes the point at a depth of a ray from it.

    The line of sight is followed from the point, behind that surface, towards its own camera. In the other camera's rectified image it
    runs along a row, nearer by a pixel of disparity with every pixel. Where it emerges from behind the surface at a depth discontinuity,
    far in front of the surface beyond, the point is occluded from the other camera alone. Where it would have to pierce the surface, whose
    disparity changes little from pixel to pixel, or leaves the image without emerging, the point is wrong.
    """
    height, width = other_depth.shape
    focal_baseline = pair.other_frame[0] * pair.baseline
    point = project(ray_x, ray_y, depth, pair)
    disparity = pair.other_frame[0] * point.disparity
    last_behind, since = 0.0, 0.0  # distance behind the surface where that was last measured, and how many pixels ago
    for step in range(width + height):
        u, v, _u_x, _v_x = native_pixel(pair.other_grid, pair.stride, point.x - step, point.y)
        i, j = int(v + 0.5), int(u + 0.5)
        if u < 0 or v < 0 or j >= width or i >= height:
            return False
        since += 1.0
        if other_depth[i, j] <= 0 or other_state[i, j] != VALID:
            if step == 0:
                return False
            continue
        z = other_depth[i, j] * (axis[0] * other_rays[i, j, 0] + axis[1] * other_rays[i, j, 1] + axis[2])
        behind = focal_baseline / z - disparity - step
        if step == 0 and behind <= EDGE_PX:
            return False
        if behind <= 0:
            least = MAX_DISPARITY_SLOPE * since + EDGE_PX
            return bool(last_behind - behind > least and last_behind > least)
        last_behind, since = behind, 0.0
    return False


@njit(**LOOP)
def keep_new(
    camera: Camera,
    observer: Observer,  # the earlier camera
    axis: Any,  # (3,) rectified depth of the earlier camera's ray (x, y, 1)
    other_rays: Any,  # (H, W, 2) of the earlier camera
    other_depth: Any,  # (H, W) its depth map; (0, 0) for none
    other_state: Any,
    limits: Limits,
    sample: int,  # distance in pixels of the samples of shifts
    row_start: int,
    row_stop: int,
    out: DepthArrays,  # in and out
    shifts: Any,  # out (rows of samples, columns of samples, 2) float32, shift in the earlier camera in px and its variance; 0, 0 for none
) -> None:
    """Keep only points around which an earlier camera has no phase, or that a surface occludes from it.

    The depth of a point has the noise of the pixel's own phase in it, as the excess that the earlier camera sees has: they are correlated.
    For a point of two cameras the covariance is known.
    """
    has_gain = len(out.pair_gain) > 0
    for y in range(row_start, row_stop):
        for x in range(out.depth.shape[1]):
            depth = out.depth[y, x]
            if depth <= 0:
                continue
            ray_x, ray_y = camera.rays[y, x, 0], camera.rays[y, x, 1]
            seen = observe(camera.phase[y, x], ray_x, ray_y, depth, observer)
            if seen.sight == ABSENT:
                continue
            own = float(camera.sigma[y, x]) ** 2
            covariance = own * seen.gain / out.pair_gain[y, x] if has_gain else 0.0
            variance = seen.variance + own + (seen.gain * out.sigma[y, x]) ** 2 - 2 * covariance
            measured = seen.sight == INTERPOLATED
            differs = measured and abs(seen.excess) > limits.sigmas * np.sqrt(variance) + limits.px * abs(seen.slope)
            if (differs or not measured) and is_occluded(ray_x, ray_y, depth, observer.pair, axis, other_rays, other_depth, other_state):
                continue
            out.state[y, x], out.depth[y, x] = CONTRADICTED if differs else SEEN_BY_ANOTHER, np.float32(0)
            if measured and y % sample == 0 and x % sample == 0:
                shifts[y // sample, x // sample, 0] = seen.excess / seen.slope
                shifts[y // sample, x // sample, 1] = variance / seen.slope**2


@njit(**INLINE)
def vote(
    ray_x: Any, ray_y: Any, depth: Any, sigma: Any, phase: Any, variance: Any, observer: Observer, limits: Limits, k: int, votes: Votes
) -> None:
    """Compare the orthogonal phase of a point with what the k-th camera measures at its image."""
    votes.verdict[k] = SILENT
    pair = observer.pair
    at = project(ray_x, ray_y, depth, pair)
    sight, value, noise = interpolate_phase(observer.image, at.u, at.v)
    if sight != INTERPOLATED:
        return
    below_u, below_v, _u_x, _v_x = native_pixel(pair.other_grid, pair.stride, at.x, at.y + 1.0)
    i, j = int(at.v + 0.5), int(at.u + 0.5)
    slope_x, slope_y = observer.image.records[i, j, SLOPE_X], observer.image.records[i, j, SLOPE_Y]
    along = slope_x * at.u_x + slope_y * at.v_x
    across = slope_x * (below_u - at.u) + slope_y * (below_v - at.v)
    if abs(across) < MIN_SLOPE:
        return
    noise += (along * pair.other_frame[0] * at.disparity / depth * sigma) ** 2
    excess, spread, steepness = value - phase, noise + variance, np.hypot(along, across)
    votes.phase[k], votes.variance[k], votes.steepness[k], votes.u[k], votes.v[k] = value, noise, steepness, at.u, at.v
    votes.shift[k], votes.shift_variance[k] = excess / across, spread / across**2
    votes.verdict[k] = DIFFERS if abs(excess) > limits.sigmas * np.sqrt(spread) + limits.px * steepness else AGREES


@njit(**INLINE)
def others_agree(votes: Votes, limits: Limits) -> bool:
    """Whether two of the cameras that differ from this one agree with each other."""
    for k in range(len(votes.verdict)):
        for m in range(k):
            if votes.verdict[k] == DIFFERS and votes.verdict[m] == DIFFERS:
                limit = limits.sigmas * np.sqrt(votes.variance[k] + votes.variance[m])
                if abs(votes.phase[k] - votes.phase[m]) <= limit + limits.px * max(votes.steepness[k], votes.steepness[m]):
                    return True
    return False


@njit(**INLINE)
def release_pixels(votes: Votes, places: Any, used: Any, widths: Any) -> None:
    """Release the pixels of the cameras that differ, so that other points can take them."""
    for k in range(len(places)):
        if votes.verdict[k] != DIFFERS:
            continue
        width, of_camera = widths[places[k]], used[places[k]]
        i, j, height = int(votes.v[k] + 0.5), int(votes.u[k] + 0.5), len(of_camera) // width
        for v in range(max(i - 1, 0), min(i + 2, height)):
            for u in range(max(j - 1, 0), min(j + 2, width)):
                of_camera[v * width + u] = 0


@njit(**INLINE)
def solve_again(phase: Any, sigma: Any, ray_x: Any, ray_y: Any, depth: Any, cameras: Any, observers: Any) -> Any:
    """Solve for the depth with the given cameras alone, one least-squares step from the old depth.

    Returns (whether they determine it, depth, its standard deviation, gain of the last of them).
    """
    zz, zd, dd, rz, rd, gain = 0.0, 0.0, 1.0 / (float(sigma) ** 2 + TINY), 0.0, 0.0, 0.0
    for c in range(len(observers)):
        if (cameras >> c) & 1 == 0:
            continue
        seen = observe(phase, ray_x, ray_y, depth, observers[c])
        if seen.sight != INTERPOLATED:
            continue
        gain, weight = seen.gain, 1.0 / (seen.variance + TINY)
        zz += weight * gain * gain
        zd -= weight * gain
        dd += weight
        rz -= weight * gain * seen.excess
        rd += weight * seen.excess
    determinant = zz * dd - zd * zd
    if not determinant > 0:
        return False, 0.0, 0.0, 0.0
    return True, depth + (rz * dd - zd * rd) / determinant, np.sqrt(dd / determinant), gain


@njit(**ALLOCATING_LOOP)
def check_orthogonal(
    camera: Camera,
    own: Any,  # (phase, sigma, state) of this camera's orthogonal fringes
    places: Any,  # (K,) int64, the other cameras with orthogonal fringes
    observers: Any,  # per other camera
    orthogonal: Any,  # per one of the K: observer with its orthogonal fringes
    widths: Any,  # (M,) int64 of the other cameras' images
    limits: Limits,
    sample: int,
    row_start: int,
    row_stop: int,
    out: DepthArrays,  # in and out
    used: Any,  # in and out per other camera (H · W,) uint8, 0 for its pixels that take part no longer
    set_aside: Any,  # out (H, W) bool: the others agree against this camera
    shifts: Any,  # out (K, rows of samples, columns of samples, 2) float32: px across the epipolar line, and its variance
) -> None:
    """Let the cameras of a point vote on it with the phases of their orthogonal fringes.

    A camera that differs from this one is taken out where another one agrees with this one, and the depth is solved again. Where two
    others agree with each other against this one, the point is theirs and set aside here. Otherwise there is no point.
    """
    count = len(places)
    values = np.zeros((7, count))
    votes = Votes(np.zeros(count, np.int64), values[0], values[1], values[2], values[3], values[4], values[5], values[6])
    for y in range(row_start, row_stop):
        for x in range(out.depth.shape[1]):
            depth = float(out.depth[y, x])
            if depth <= 0 or own[2][y, x] != VALID:
                continue
            ray_x, ray_y, cameras = camera.rays[y, x, 0], camera.rays[y, x, 1], out.cameras[y, x]
            agree, differ, kept = 1, 0, cameras
            for k in range(count):
                votes.verdict[k] = SILENT
                if (cameras >> places[k]) & 1 != 0:
                    vote(ray_x, ray_y, depth, out.sigma[y, x], own[0][y, x], float(own[1][y, x]) ** 2, orthogonal[k], limits, k, votes)
                if votes.verdict[k] == DIFFERS:
                    differ, kept = differ + 1, kept & ~np.uint8(1 << places[k])
                agree += votes.verdict[k] == AGREES
                if votes.verdict[k] != SILENT and y % sample == 0 and x % sample == 0:
                    shifts[k, y // sample, x // sample, 0] = votes.shift[k]
                    shifts[k, y // sample, x // sample, 1] = votes.shift_variance[k]
            if differ == 0:
                continue
            if agree >= 2 and agree > differ:
                out.cameras[y, x] = kept
                release_pixels(votes, places, used, widths)
                solved, better, sigma, gain = solve_again(camera.phase[y, x], camera.sigma[y, x], ray_x, ray_y, depth, kept, observers)
                if solved:
                    out.depth[y, x], out.sigma[y, x] = better, sigma
                    if len(out.pair_gain) > 0:
                        out.pair_gain[y, x] = gain
                    continue
            elif agree == 1 and others_agree(votes, limits):
                set_aside[y, x] = True
                release_pixels(votes, places, used, widths)
            out.depth[y, x], out.sigma[y, x], out.state[y, x] = 0, 0, CONTRADICTED
