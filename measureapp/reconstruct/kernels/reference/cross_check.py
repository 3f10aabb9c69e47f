"""NumPy statements of the checks of points by cameras that did not measure them."""

from __future__ import annotations

import cv2
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.cross_check import AGREES, DIFFERS, EDGE_PX, MAX_DISPARITY_SLOPE, SILENT, USED_RADIUS_PX, Votes
from measureapp.reconstruct.kernels.fuse import TINY, Camera
from measureapp.reconstruct.kernels.reference.fuse import solve_depth
from measureapp.reconstruct.kernels.reference.reproject import interpolate_phase, native_pixel, observe, project, slopes_at
from measureapp.reconstruct.kernels.structures import ABSENT, INTERPOLATED, MIN_SLOPE, DepthArrays, Limits, Observer, Pair


def mark_used(
    state: IntArray, used: IntArray, sample: int, sampled: int, otherwise: int, row_start: int, row_stop: int, marked: IntArray
) -> None:
    """Mark pixels without a phase, and those within USED_RADIUS_PX of one that takes part in a point."""
    size = 2 * USED_RADIUS_PX + 1
    near = cv2.dilate(np.asarray(used), np.ones((size, size), np.uint8))
    near[::sample, ::sample] = used[::sample, ::sample] * sampled
    measured = np.where(near != 0, PointState.SEEN_BY_ANOTHER, otherwise)
    without_phase = np.where(state == PointState.RIM, PointState.RIM, PointState.NO_PHASE)
    marked[row_start:row_stop] = np.where(state == 0, measured, without_phase)[row_start:row_stop]


def is_occluded(
    rays: FloatArray,
    depth: FloatArray,
    pair: Pair,
    axis: FloatArray,
    other_rays: FloatArray,
    other_depth: FloatArray,
    other_state: IntArray,
) -> BoolArray:
    """Whether a surface that the other camera measured occludes points (N,) from it: follows their lines of sight pixel by pixel."""
    height, width = other_depth.shape
    at = project(rays, depth, pair)
    disparity = pair.other_frame[0] * at.disparity
    result, active = np.zeros(len(depth), np.bool_), np.arange(len(depth))
    last_behind, since = np.zeros(len(depth)), np.zeros(len(depth))
    for step in range(width + height):
        if not len(active):
            break
        u, v, _u_x, _v_x = native_pixel(pair.other_grid, pair.stride, at.x[active] - step, at.y[active])
        i, j = (v + 0.5).astype(int), (u + 0.5).astype(int)
        inside = (u >= 0) & (v >= 0) & (j < width) & (i < height)
        active, i, j = active[inside], i[inside], j[inside]
        since[active] += 1
        measured = (other_depth[i, j] > 0) & (other_state[i, j] == PointState.VALID)
        z = other_depth[i, j] * (np.column_stack([other_rays[i, j], np.ones(len(i))]) @ axis)
        behind = np.where(measured, pair.other_frame[0] * pair.baseline / np.where(measured, z, 1) - disparity[active] - step, np.inf)
        emerged = measured & (behind <= 0)
        least = MAX_DISPARITY_SLOPE * since[active] + EDGE_PX
        if step == 0:  # a point that is not clearly behind a surface is not occluded by it
            emerged = ~measured | (behind <= EDGE_PX)
        else:
            before = last_behind[active]
            result[active] = emerged & (before - behind > least) & (before > least)
        last_behind[active] = np.where(measured, behind, last_behind[active])
        since[active] = np.where(measured, 0, since[active])
        active = active[~emerged]
    return result


@np.errstate(divide="ignore", invalid="ignore")
def keep_new(
    camera: Camera, observer: Observer, axis: FloatArray, other_rays: FloatArray, other_depth: FloatArray, other_state: IntArray,
    limits: Limits, sample: int, row_start: int, row_stop: int, out: DepthArrays, shifts: FloatArray,
) -> None:  # fmt: skip
    """Keep only points around which an earlier camera has no phase, or that a surface occludes from it."""
    y, x = np.nonzero(out.depth[row_start:row_stop] > 0)
    y += row_start
    depth, rays, own = out.depth[y, x].astype(np.float64), camera.rays[y, x], camera.sigma[y, x].astype(np.float64) ** 2
    seen = observe(camera.phase[y, x].astype(np.float64), rays, depth, observer)
    covariance = own * seen.gain / out.pair_gain[y, x] if len(out.pair_gain) else 0.0
    variance = seen.variance + own + (seen.gain * out.sigma[y, x]) ** 2 - 2 * covariance
    measured = seen.sight == INTERPOLATED
    differs = measured & (np.abs(seen.excess) > limits.sigmas * np.sqrt(variance) + limits.px * np.abs(seen.slope))
    dropped = seen.sight != ABSENT
    doubted = np.flatnonzero(dropped & (differs | ~measured))
    if len(doubted) and other_depth.size:
        dropped[doubted] &= ~is_occluded(rays[doubted], depth[doubted], observer.pair, axis, other_rays, other_depth, other_state)
    out.depth[y[dropped], x[dropped]] = 0
    out.state[y[dropped], x[dropped]] = np.where(differs, PointState.CONTRADICTED, PointState.SEEN_BY_ANOTHER)[dropped]
    sampled = dropped & measured & (y % sample == 0) & (x % sample == 0)
    values = np.stack([seen.excess / seen.slope, variance / seen.slope**2], axis=-1)
    shifts[y[sampled] // sample, x[sampled] // sample] = values[sampled]


@np.errstate(divide="ignore", invalid="ignore")
def _vote(
    rays: FloatArray, depth: FloatArray, sigma: FloatArray, phase: FloatArray, variance: FloatArray, observer: Observer, limits: Limits
) -> Votes:
    """Compare the orthogonal phases of points (N,) with what one camera measures at their images."""
    pair, at = observer.pair, project(rays, depth, observer.pair)
    sight, value, noise = interpolate_phase(observer.image, at.u, at.v)
    below_u, below_v, _u_x, _v_x = native_pixel(pair.other_grid, pair.stride, at.x, at.y + 1.0)
    slope_x, slope_y = slopes_at(observer.image, at.u, at.v).T
    along = slope_x * at.u_x + slope_y * at.v_x
    across = slope_x * (below_u - at.u) + slope_y * (below_v - at.v)
    noise = noise + (along * pair.other_frame[0] * at.disparity / depth * sigma) ** 2
    excess, spread, steepness = value - phase, noise + variance, np.hypot(along, across)
    differs = np.abs(excess) > limits.sigmas * np.sqrt(spread) + limits.px * steepness
    silent = (sight != INTERPOLATED) | (np.abs(across) < MIN_SLOPE)
    verdict = np.where(silent, SILENT, np.where(differs, DIFFERS, AGREES))
    return Votes(verdict, value, noise, steepness, at.u, at.v, excess / across, spread / across**2)


def check_orthogonal(
    camera: Camera, own: tuple[FloatArray, FloatArray, IntArray], places: IntArray, observers: tuple[Observer, ...],
    orthogonal: tuple[Observer, ...], widths: IntArray, limits: Limits, sample: int, row_start: int, row_stop: int, out: DepthArrays,
    used: tuple[IntArray, ...], set_aside: BoolArray, shifts: FloatArray,
) -> None:  # fmt: skip
    """Let the cameras of the points vote on them with the phases of their orthogonal fringes."""
    part = slice(row_start, row_stop)
    y, x = np.nonzero((out.depth[part] > 0) & (own[2][part] == 0))
    y += row_start
    depth, rays, cameras = out.depth[y, x].astype(np.float64), camera.rays[y, x], out.cameras[y, x]
    phase, variance = own[0][y, x].astype(np.float64), own[1][y, x].astype(np.float64) ** 2
    votes = [_vote(rays, depth, out.sigma[y, x], phase, variance, observer, limits) for observer in orthogonal]
    verdict = np.stack([np.where(cameras >> place & 1, vote.verdict, SILENT) for place, vote in zip(places, votes, strict=True)])
    for k, vote in enumerate(votes):
        sampled = (verdict[k] != SILENT) & (y % sample == 0) & (x % sample == 0)
        shifts[k, y[sampled] // sample, x[sampled] // sample] = np.stack([vote.shift, vote.shift_variance], axis=-1)[sampled]
    agree, differ = 1 + (verdict == AGREES).sum(axis=0), (verdict == DIFFERS).sum(axis=0)
    kept = cameras & ~((verdict == DIFFERS) * (1 << places[:, None])).sum(axis=0).astype(np.uint8)

    outvoted = (differ > 0) & (agree >= 2) & (agree > differ)
    better, sigma, gain = _solve_again(camera, y, x, depth, kept, observers)
    solved = outvoted & (sigma > 0)
    theirs = (differ > 0) & ~outvoted & (agree == 1) & _others_agree(votes, verdict, limits)
    out.cameras[y[outvoted], x[outvoted]] = kept[outvoted]
    out.depth[y[solved], x[solved]], out.sigma[y[solved], x[solved]] = better[solved], sigma[solved]
    if len(out.pair_gain):
        out.pair_gain[y[solved], x[solved]] = gain[solved]
    set_aside[y[theirs], x[theirs]] = True
    for k, place in enumerate(places):
        released = (outvoted | theirs) & (verdict[k] == DIFFERS)
        _release_pixels(used[place].reshape(-1, widths[place]), votes[k].u[released], votes[k].v[released])
    dropped = (differ > 0) & ~solved
    out.depth[y[dropped], x[dropped]], out.sigma[y[dropped], x[dropped]] = 0, 0
    out.state[y[dropped], x[dropped]] = PointState.CONTRADICTED


def _others_agree(votes: list[Votes], verdict: IntArray, limits: Limits) -> BoolArray:
    """Whether two of the cameras that differ from this one agree with each other."""
    result = np.zeros(verdict.shape[1], np.bool_)
    for k, one in enumerate(votes):
        for m, other in enumerate(votes[:k]):
            limit = limits.sigmas * np.sqrt(one.variance + other.variance) + limits.px * np.maximum(one.steepness, other.steepness)
            result |= (verdict[k] == DIFFERS) & (verdict[m] == DIFFERS) & (np.abs(one.phase - other.phase) <= limit)
    return result


def _release_pixels(used: IntArray, u: FloatArray, v: FloatArray) -> None:
    """Release the pixels of a camera around some places."""
    height, width = used.shape
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            i, j = (v + 0.5).astype(int) + dy, (u + 0.5).astype(int) + dx
            inside = (i >= 0) & (j >= 0) & (i < height) & (j < width)
            used[i[inside], j[inside]] = 0


def _solve_again(
    camera: Camera, y: IntArray, x: IntArray, depth: FloatArray, cameras: IntArray, observers: tuple[Observer, ...]
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Solve for the depths with the given cameras alone; returns depth, standard deviation (0 for none), gain of the last camera."""
    phase, own = camera.phase[y, x].astype(np.float64), camera.sigma[y, x].astype(np.float64) ** 2
    seen = [observe(phase, camera.rays[y, x], depth, observer) for observer in observers]
    takes_part = np.stack([(cameras >> c & 1 != 0) & (one.sight == INTERPOLATED) for c, one in enumerate(seen)])
    weight = np.where(takes_part, 1 / (np.stack([one.variance for one in seen]) + TINY), 0.0)
    correction, sigma = solve_depth(weight, np.stack([one.gain for one in seen]), np.stack([one.excess for one in seen]), own)
    gain = np.zeros(len(y))
    for chosen, one in zip(takes_part, seen, strict=True):
        gain = np.where(chosen, one.gain, gain)
    return depth + correction, np.where(takes_part.any(axis=0), sigma, 0), gain
