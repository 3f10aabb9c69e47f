"""Rejection of points of a depth map by the plane through their neighbours, with SIMD vectors.

Planes are fitted to inverse depths, which are linear in the image on a plane.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.simd.elements import any_lane, convert, maximum, minimum, select, sqrt
from measureapp.compiled.simd.memory import load, load_records, store
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.structures import LANES, Surface, cubic

CHUNK = 128  # columns; for each of them it is noted whether points were removed
LANE_NUMBERS = np.arange(LANES, dtype=np.float32)
STEP_SIGMAS = np.float32(8.0)  # depth step between neighbours of one surface beyond its slope, in standard deviations
MAX_STEP_SHARE = np.float32(0.5)  # of the depth
MIN_PLACES = np.float32(4)
MIN_SPREAD = np.float32(1e-6)  # least determinant of the places' scatter relative to its squared trace; below they are on a line
TINY = np.float32(1e-12)
ZERO, ONE = np.float32(0), np.float32(1)
UNCERTAIN = np.uint8(PointState.UNCERTAIN)
FLYING, OUTLIER, GRAZING, PARTNER_GRAZING = (
    np.float32(state) for state in (PointState.FLYING, PointState.OUTLIER, PointState.GRAZING, PointState.PARTNER_GRAZING)
)


class Criteria(NamedTuple):
    """Limits of rejection, float32."""

    min_neighbours: Any
    outlier_sigmas: Any  # distance to the plane, in standard deviations
    outlier_share: Any  # plus this share of the depth
    min_cosine: Any  # of the incidence
    min_partner_cosine: Any  # of the incidence on another camera
    centres: Any  # (M, 3) of the other cameras


class Sums(NamedTuple):
    """Sums over the places of a window on the surface of its pixel, at (x, y) px from it and with inverse depth w relative to it."""

    n: Any
    x: Any
    y: Any
    xx: Any
    xy: Any
    yy: Any
    w: Any
    wx: Any
    wy: Any


class Plane(NamedTuple):
    """Plane through the window of every pixel of a group."""

    normal_x: Any
    normal_y: Any
    normal_z: Any
    cosine: Any  # between normal and viewing ray
    offset: Any  # mm, of the pixel's point from the plane, along z
    neighbours: Any


@njit(**LOOP)
def invert_depth(depth: Any, sigma: Any, max_sigma: Any, radius: int, row_start: int, row_stop: int, inverse: Any, state: Any) -> None:
    """Write the inverse depths of points that are precise enough into ``inverse``, which has a border of ``radius``."""
    width = depth.shape[1]
    for y in range(row_start, row_stop):
        z, noise, states, out = depth[y], sigma[y], state[y], inverse[y + radius, radius : radius + width]
        for x in range(width):
            out[x] = ONE / z[x] if (z[x] > ZERO) & (noise[x] <= max_sigma) else ZERO
        for x in range(width):
            states[x] = UNCERTAIN if (z[x] > ZERO) & (noise[x] > max_sigma) else states[x]


@njit(**INLINE)
def sum_window(surface: Surface, at: int, inverse: Any, near_limit: Any, far_limit: Any) -> Sums:
    """Sum over 5 x 5 places of the windows of a group, those within the depth limits; places at most half the radius away have their own."""
    far, near, width = surface.radius, max(1, surface.radius // 2), surface.inverse.shape[1]
    o = ZERO * inverse
    sums = Sums(o, o, o, o, o, o, o, o, o)
    for dy in (-far, -near, 0, near, far):
        for dx in (-far, -near, 0, near, far):
            w = load(surface.inverse, at + dy * width + dx, LANES) - inverse
            limit = far_limit if abs(dx) == far or abs(dy) == far else near_limit
            one = convert(abs(w) <= limit, np.float32)
            x, y, w = np.float32(dx) * one, np.float32(dy) * one, w * one
            sums = Sums(
                sums.n + one,
                sums.x + x,
                sums.y + y,
                sums.xx + np.float32(dx) * x,
                sums.xy + np.float32(dx) * y,
                sums.yy + np.float32(dy) * y,
                sums.w + w,
                sums.wx + np.float32(dx) * w,
                sums.wy + np.float32(dy) * w,
            )
    return sums


@njit(**INLINE)
def fit_plane(surface: Surface, y: int, x: int) -> Plane:
    """Fit planes to the windows of LANES pixels by least squares; without one, the normal is the viewing ray's."""
    at, r = y * surface.sigma.shape[1] + x, surface.radius
    centre = (y + r) * surface.inverse.shape[1] + x + r
    inverse = load(surface.inverse, centre, LANES)
    depth = ONE / maximum(inverse, TINY)
    slack, step = STEP_SIGMAS * load(surface.sigma, at, LANES) * inverse * inverse, surface.step_per_px * inverse
    near, far, most = np.float32(max(1, r // 2)), np.float32(r), MAX_STEP_SHARE * inverse
    sums = sum_window(surface, centre, inverse, minimum(near * step + slack, most), minimum(far * step + slack, most))

    share = ONE / maximum(sums.n, ONE)
    w = sums.w * depth
    xx, xy, yy = sums.xx - sums.x * sums.x * share, sums.xy - sums.x * sums.y * share, sums.yy - sums.y * sums.y * share
    wx, wy = sums.wx * depth - w * sums.x * share, sums.wy * depth - w * sums.y * share
    determinant = xx * yy - xy * xy
    enough = sums.n >= MIN_PLACES
    fits = enough & (determinant > MIN_SPREAD * (xx + yy) * (xx + yy))
    scale = select(fits, ONE / maximum(determinant, TINY), ZERO)
    w_u, w_v = (wx * yy - wy * xy) * scale, (wy * xx - wx * xy) * scale
    offset = select(fits, (w - w_u * sums.x - w_v * sums.y) * share, ZERO)

    u0, per_u, v0, per_v = surface.unit
    s, t = (load(LANE_NUMBERS, 0, LANES) + (np.float32(x) - u0)) * per_u, (np.float32(y) - v0) * per_v
    x_u, x_v = cubic(surface.jacobian[0], s, t), cubic(surface.jacobian[1], s, t)
    y_u, y_v = cubic(surface.jacobian[2], s, t), cubic(surface.jacobian[3], s, t)
    per_area = ONE / (x_u * y_v - x_v * y_u)
    ray_x, ray_y = load_records(surface.rays, 2 * at, LANES, 2)
    p, q, ahead = (w_u * y_v - w_v * y_u) * per_area, (w_v * x_u - w_u * x_v) * per_area, ONE + offset
    c = ahead - p * ray_x - q * ray_y
    length, ray_length = ONE / sqrt(p * p + q * q + c * c), ONE / sqrt(ONE + ray_x * ray_x + ray_y * ray_y)
    sign = select(ahead > ZERO, -length, length)
    return Plane(
        select(fits, sign * p, -ray_length * ray_x),
        select(fits, sign * q, -ray_length * ray_y),
        select(fits, sign * c, -ray_length),
        select(fits, abs(ahead) * length * ray_length, ONE),
        offset * depth,
        select(fits | ~enough, sums.n - ONE, ZERO),
    )


@njit(**INLINE)
def find_reason(surface: Surface, plane: Plane, cameras: Any, criteria: Criteria, y: int, x: int) -> Any:
    """Return the first reason against each point of a group, 0 for none."""
    at, r = y * surface.sigma.shape[1] + x, surface.radius
    inverse = load(surface.inverse, (y + r) * surface.inverse.shape[1] + x + r, LANES)
    depth = ONE / maximum(inverse, TINY)
    ray_x, ray_y = load_records(surface.rays, 2 * at, LANES, 2)
    takes_part = load(cameras, at, LANES)
    reason = ZERO * depth
    for k in range(len(criteria.centres)):
        to_x, to_y, to_z = criteria.centres[k, 0] - ray_x * depth, criteria.centres[k, 1] - ray_y * depth, criteria.centres[k, 2] - depth
        along = plane.normal_x * to_x + plane.normal_y * to_y + plane.normal_z * to_z
        least = criteria.min_partner_cosine * criteria.min_partner_cosine * (to_x * to_x + to_y * to_y + to_z * to_z)
        grazing = (along < ZERO) | (along * along < least)
        reason = select(grazing & ((takes_part & np.uint8(1 << k)) != np.uint8(0)), PARTNER_GRAZING, reason)
    reason = select(plane.cosine < criteria.min_cosine, GRAZING, reason)
    allowed = criteria.outlier_sigmas * load(surface.sigma, at, LANES) + criteria.outlier_share * depth
    reason = select(abs(plane.offset) * plane.cosine > allowed, OUTLIER, reason)
    reason = select(plane.neighbours < criteria.min_neighbours, FLYING, reason)
    return select(inverse > ZERO, reason, ZERO)


@njit(**INLINE)
def store_normals(plane: Plane, normals: Any, at: int) -> None:
    """Write the normals of a group."""
    store(plane.normal_x, normals[0], at)
    store(plane.normal_y, normals[1], at)
    store(plane.normal_z, normals[2], at)


@njit(**LOOP)
def reject_points(
    surface: Surface,
    cameras: Any,  # (H, W) uint8, bit i: the i-th other camera takes part
    criteria: Criteria,
    row_start: int,
    row_stop: int,
    state: Any,  # in and out (H, W) uint8 of PointState
    normals: Any,  # out (3, H, W) float32, in the camera's frame, towards it
    removed: Any,  # out (H, chunks) uint8, 1 where a chunk of a row has rejected points
) -> None:
    """Fit a plane to the window of every pixel and reject points with the first reason that applies."""
    width = surface.sigma.shape[1]
    for y in range(row_start, row_stop):
        removed[y] = 0
        for first in range(0, width, LANES):
            x = min(first, width - LANES)  # some pixels twice
            inverse = load(surface.inverse, (y + surface.radius) * surface.inverse.shape[1] + x + surface.radius, LANES)
            if not any_lane(inverse > ZERO):
                continue
            plane = fit_plane(surface, y, x)
            reason = find_reason(surface, plane, cameras, criteria, y, x)
            store_normals(plane, normals, y * width + x)
            if any_lane(reason > ZERO):
                at = y * width + x
                store(select(reason > ZERO, convert(reason, np.uint8), load(state, at, LANES)), state, at)
                removed[y, x // CHUNK], removed[y, (x + LANES - 1) // CHUNK] = 1, 1


@njit(**LOOP)
def refit_normals(surface: Surface, removed: Any, row_start: int, row_stop: int, normals: Any) -> None:
    """Fit the planes again whose windows lost points: ``removed`` (H, chunks) says where."""
    height, width = surface.sigma.shape
    for y in range(row_start, row_stop):
        for chunk in range(removed.shape[1]):
            touched = False
            for v in range(max(y - surface.radius, 0), min(y + surface.radius + 1, height)):
                for k in range(max(chunk - 1, 0), min(chunk + 2, removed.shape[1])):
                    touched |= removed[v, k] != 0
            if touched:
                for first in range(chunk * CHUNK, min((chunk + 1) * CHUNK, width), LANES):
                    x = min(first, width - LANES)
                    store_normals(fit_plane(surface, y, x), normals, y * width + x)
