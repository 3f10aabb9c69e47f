"""Compiled loops over a depth map: the plane through the surroundings of every point, and which points cannot be trusted.

Inverse depths are used, on a plane they are linear in the image; ``inverse`` (H + 2r, W + 2r) has a border of zeros, and zeros where
there is no point; it is followed by PIXELS numbers that hold anything. What one loop over a chunk of pixels leaves to the next stands in lanes of one scratch array.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np
from numba import njit

from measureapp.compiled.options import INLINE, LOOP
from measureapp.compiled.simd.elements import any_lane, broadcast, convert, maximum, minimum, select, sqrt
from measureapp.compiled.simd.memory import load, store
from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.constants import PIXELS
from measureapp.reconstruct.kernels.cubic import cubic
from measureapp.reconstruct.kernels.scratch import stack_float32, stack_uint8
from measureapp.reconstruct.kernels.streaming import write_row

CHUNK = 128
(INV, OWN, ROW_X, ROW_Y, Z, WU, WV, FITS, NX, NY, NZ, COSINE, OFF, FITTED, CODE) = (k * CHUNK for k in range(15))
SCRATCH = 15 * CHUNK
COUNTED = np.arange(CHUNK, dtype=np.float32)
ZERO, HALF, ONE, FOUR = np.float32(0), np.float32(0.5), np.float32(1), np.float32(4)
THIN = np.float32(1e-6)
SIGMAS = np.float32(8.0)
WHOLE = np.float32(25)  # places of a window
TINY = np.float32(1e-12)
NONE = np.uint8(0)
UNCERTAIN, FLYING, OUTLIER, GRAZING, PARTNER_GRAZING = (
    np.uint8(state)
    for state in (
        PointState.UNCERTAIN,
        PointState.FLYING,
        PointState.OUTLIER,
        PointState.GRAZING,
        PointState.PARTNER_GRAZING,
    )
)
ALONE, BY_PLANE, BY_CAMERA, BY_PARTNER = (np.float32(state) for state in (FLYING, OUTLIER, GRAZING, PARTNER_GRAZING))


@njit(**LOOP)
def invert(depth: Any, sigma: Any, max_sigma: Any, border: int, row_start: int, row_stop: int, inverse: Any, fate: Any) -> None:
    """Fill ``inverse`` with the points that are certain enough."""
    width = depth.shape[1]
    for y in range(row_start, row_stop):
        z_row, s_row, fate_row = depth[y], sigma[y], fate[y]
        out = inverse[y + border, border : border + width]
        for x in range(width):
            out[x] = ONE / z_row[x] if (z_row[x] > ZERO) & (s_row[x] <= max_sigma) else ZERO
        for x in range(width):
            fate_row[x] = UNCERTAIN if (z_row[x] > ZERO) & (s_row[x] > max_sigma) else fate_row[x]


@njit(**INLINE)
def row_of_whole(row: Any, at: int, half: int, border: int, inv: Any, far_near: Any, far_wide: Any) -> Any:
    """Sum a row of the windows of PIXELS as if all its places lay on their surfaces.

    Returns (by how much one of them does not, sum of the differences to the pixels, sum of these times the distance along the row).
    """
    a, b = load(row, at - border, PIXELS) - inv, load(row, at - half, PIXELS) - inv
    c = load(row, at, PIXELS) - inv
    e, f = load(row, at + half, PIXELS) - inv, load(row, at + border, PIXELS) - inv
    wide, near = maximum(abs(a), abs(f)), maximum(maximum(abs(b), abs(c)), abs(e))
    return maximum(wide - far_wide, near - far_near), a + b + c + e + f, np.float32(border) * (f - a) + np.float32(half) * (e - b)


@njit(**INLINE)
def sums_of_whole(inverse: Any, row: int, at: int, half: int, border: int, inv: Any, far_h: Any, far_r: Any) -> Any:
    """Sum the windows of PIXELS as if all their places lay on one surface, and say by how much one does not.

    Windows that no border and no depth step crosses, most of all, have the same places: only their values are summed.
    """
    worst_0, w_0, x_0 = row_of_whole(inverse[row - border], at, half, border, inv, far_r, far_r)
    worst_1, w_1, x_1 = row_of_whole(inverse[row - half], at, half, border, inv, far_h, far_r)
    worst_2, w_2, x_2 = row_of_whole(inverse[row], at, half, border, inv, far_h, far_r)
    worst_3, w_3, x_3 = row_of_whole(inverse[row + half], at, half, border, inv, far_h, far_r)
    worst_4, w_4, x_4 = row_of_whole(inverse[row + border], at, half, border, inv, far_r, far_r)
    worst = maximum(maximum(maximum(worst_0, worst_1), maximum(worst_2, worst_3)), worst_4)
    h, r = np.float32(half), np.float32(border)
    return worst, w_0 + w_1 + w_2 + w_3 + w_4, x_0 + x_1 + x_2 + x_3 + x_4, r * (w_4 - w_0) + h * (w_3 - w_1)


class Sums(NamedTuple):
    """Sums over the places of windows that lie on the surfaces of their pixels: of 1, x, y, x², x y, y², w, w x and w y.

    Here x and y are distances in px, and w differences in inverse depth to the pixel.
    """

    n: Any
    x: Any
    y: Any
    xx: Any
    xy: Any
    yy: Any
    w: Any
    wx: Any
    wy: Any


@njit(**INLINE)
def row_of_torn(row: Any, at: int, half: int, border: int, down: int, inv: Any, far_near: Any, far_wide: Any, sums: Sums) -> Sums:
    """Add a row of the windows of PIXELS, those places that lie on the surfaces of their pixels."""
    h, r, d = np.float32(half), np.float32(border), np.float32(down)
    a, b = load(row, at - border, PIXELS) - inv, load(row, at - half, PIXELS) - inv
    c = load(row, at, PIXELS) - inv
    e, f = load(row, at + half, PIXELS) - inv, load(row, at + border, PIXELS) - inv
    ma, mb, mc = within(a, far_wide), within(b, far_near), within(c, far_near)
    me, mf = within(e, far_near), within(f, far_wide)
    a, b, c, e, f = ma * a, mb * b, mc * c, me * e, mf * f
    count, x, w = ma + mb + mc + me + mf, r * (mf - ma) + h * (me - mb), a + b + c + e + f
    return Sums(
        sums.n + count,
        sums.x + x,
        sums.y + d * count,
        sums.xx + r * r * (mf + ma) + h * h * (me + mb),
        sums.xy + d * x,
        sums.yy + d * d * count,
        sums.w + w,
        sums.wx + r * (f - a) + h * (e - b),
        sums.wy + d * w,
    )


@njit(**INLINE)
def within(difference: Any, most: Any) -> Any:
    """Return 1 where a difference is at most so large, else 0."""
    return convert(abs(difference) <= most, np.float32)


@njit(**INLINE)
def sums_of_torn(inverse: Any, row: int, at: int, half: int, border: int, inv: Any, far_h: Any, far_r: Any) -> Sums:
    """Sum the windows of PIXELS over those places that lie on the surfaces of their pixels."""
    o = ZERO * inv
    sums = row_of_torn(inverse[row - border], at, half, border, -border, inv, far_r, far_r, Sums(o, o, o, o, o, o, o, o, o))
    sums = row_of_torn(inverse[row - half], at, half, border, -half, inv, far_h, far_r, sums)
    sums = row_of_torn(inverse[row], at, half, border, 0, inv, far_h, far_r, sums)
    sums = row_of_torn(inverse[row + half], at, half, border, half, inv, far_h, far_r, sums)
    return row_of_torn(inverse[row + border], at, half, border, border, inv, far_r, far_r, sums)


@njit(**INLINE)
def fit_torn(inverse: Any, row: int, at: int, half: int, border: int, inv: Any, z: Any, far_h: Any, far_r: Any) -> Any:
    """Return what `fit` does, of windows of which not all places lie on the surfaces of their pixels."""
    sums = sums_of_torn(inverse, row, at, half, border, inv, far_h, far_r)
    share = ONE / maximum(sums.n, ONE)
    sw = sums.w * z
    cxx, cxy, cyy = sums.xx - sums.x * sums.x * share, sums.xy - sums.x * sums.y * share, sums.yy - sums.y * sums.y * share
    cwx, cwy = sums.wx * z - sw * sums.x * share, sums.wy * z - sw * sums.y * share
    determinant = cxx * cyy - cxy * cxy
    enough = sums.n >= FOUR
    fits = enough & (determinant > THIN * (cxx + cyy) * (cxx + cyy))
    over = select(fits, ONE / maximum(determinant, TINY), ZERO)
    wu, wv = (cwx * cyy - cwy * cxy) * over, (cwy * cxx - cwx * cxy) * over
    off = select(fits, (sw - wu * sums.x - wv * sums.y) * share, ZERO)
    return wu, wv, off, convert(fits, np.float32), select(fits | ~enough, sums.n - ONE, ZERO)


@njit(**INLINE)
def fit(inverse: Any, row: int, at: int, half: int, border: int, inv: Any, noise: Any, per_px: Any) -> Any:
    """Fit planes to the windows of PIXELS from ``at`` of a row on.

    Returns (their slopes along x and y and their difference at the pixel, as shares of its inverse depth; 1 where there is a plane, else
    0; how many other places lie on it; the depth of the pixels).
    """
    h, r = np.float32(half), np.float32(border)
    z = ONE / maximum(inv, TINY)
    slack = SIGMAS * noise * inv * inv
    far_h, far_r = minimum(h * per_px * inv + slack, HALF * inv), minimum(r * per_px * inv + slack, HALF * inv)
    worst, w, wx, wy = sums_of_whole(inverse, row, at, half, border, inv, far_h, far_r)
    per_place, per_square = ONE / WHOLE, ONE / (np.float32(10) * (r * r + h * h))
    one = broadcast(ONE, PIXELS)
    made = wx * z * per_square, wy * z * per_square, w * z * per_place, one, one * (WHOLE - ONE)
    if any_lane(worst > ZERO):
        made = fit_torn(inverse, row, at, half, border, inv, z, far_h, far_r)
    wu, wv, off, fits, fitted = made
    return wu, wv, off, fits, fitted, z


@njit(**INLINE)
def any_above_zero(values: Any, begin: int, n: int) -> bool:
    """Whether one of n values from a lane's beginning on is above zero; behind them there are zeros."""
    some = False
    for i in range(begin, begin + n, PIXELS):
        some |= any_lane(load(values, i, PIXELS) > ZERO)
    return some


@njit(**INLINE)
def load_points(s: Any, middle: Any, n: int) -> bool:
    """Take the inverse depths of n pixels of a row into their lane, and zeros behind them; returns whether there are points."""
    for i in range(n):
        s[INV + i] = middle[i]
    for i in range(n, min(n + PIXELS, CHUNK)):
        s[INV + i] = ZERO
    return any_above_zero(s, INV, n)


@njit(**INLINE)
def load_rays(s: Any, noise: Any, ray: Any, n: int) -> None:
    """Take the noise and the rays of n pixels of a row into the lanes, and zeros behind them."""
    for i in range(n):
        s[OWN + i] = noise[i]
    for i in range(n):
        s[ROW_X + i], s[ROW_Y + i] = ray[2 * i], ray[2 * i + 1]
    for i in range(n, min(n + PIXELS, CHUNK)):
        s[OWN + i], s[ROW_X + i], s[ROW_Y + i] = ZERO, ZERO, ZERO


@njit(**INLINE)
def planes_of_chunk(
    s: Any, inverse: Any, sigma: Any, rays: Any, to_rays: Any, to_unit: Any, per_px: Any, border: Any, y: int, first: int, n: int
) -> bool:
    """Fit planes to the windows of n pixels of a row: leaves the normal, its cosine to the ray, the distance to the plane in ``s``.

    False: no points.
    """
    half = max(1, border // 2)
    start = border + first
    if not load_points(s, inverse[y + border, start : start + n], n):
        return False
    load_rays(s, sigma[y, first : first + n], rays[y, 2 * first : 2 * (first + n)], n)
    u0, per_u, v0, per_v = to_unit
    x_u, x_v, y_u, y_v = to_rays
    t = (np.float32(y) - v0) * per_v
    for i in range(0, n, PIXELS):
        inv, noise = load(s, INV + i, PIXELS), load(s, OWN + i, PIXELS)
        wu, wv, off, fits, fitted, z = fit(inverse, y + border, start + i, half, border, inv, noise, per_px)
        store(wu, s, WU + i)
        store(wv, s, WV + i)
        store(off, s, OFF + i)
        store(fits, s, FITS + i)
        store(fitted, s, FITTED + i)
        store(z, s, Z + i)
    for i in range(0, n, PIXELS):
        us = (load(COUNTED, i, PIXELS) + (np.float32(first) - u0)) * per_u
        a, b, c, d = cubic(x_u, us, t), cubic(x_v, us, t), cubic(y_u, us, t), cubic(y_v, us, t)
        wu, wv, off, fits = load(s, WU + i, PIXELS), load(s, WV + i, PIXELS), load(s, OFF + i, PIXELS), load(s, FITS + i, PIXELS)
        per_area = ONE / (a * d - b * c)
        p, q = (wu * d - wv * c) * per_area, (wv * a - wu * b) * per_area
        x, y0 = load(s, ROW_X + i, PIXELS), load(s, ROW_Y + i, PIXELS)
        ahead = ONE + off
        w = ahead - p * x - q * y0
        length = ONE / sqrt(p * p + q * q + w * w)
        towards = ONE / sqrt(ONE + x * x + y0 * y0)
        there, sign = fits > ZERO, select(ahead > ZERO, -length, length)
        store(select(there, sign * p, -towards * x), s, NX + i)
        store(select(there, sign * q, -towards * y0), s, NY + i)
        store(select(there, sign * w, -towards), s, NZ + i)
        store(select(there, abs(ahead) * length * towards, ONE), s, COSINE + i)
        store(off * load(s, Z + i, PIXELS), s, OFF + i)
    return True


@njit(**LOOP)
def judge(
    inverse: Any,
    sigma: Any,  # (H, W) float32, of the depth
    rays: Any,  # (H, 2 W) float32
    to_rays: Any,  # four cubic polynomials: ∂x/∂u, ∂x/∂v, ∂y/∂u, ∂y/∂v of `rays`
    to_unit: Any,
    per_px: Any,  # float32, largest depth step between neighbours of one surface, as a share of the depth
    border: int,  # radius of the window
    limits: Any,  # (least neighbours, outlier sigmas, outlier share of the depth, least cosine, least cosine for a partner), float32
    centres: Any,  # (M, 3) float32, of the other cameras
    bits: Any,  # (H, W) uint8, which of them take part
    row_start: int,
    row_stop: int,
    fate: Any,  # in and out (H, W) uint8 of PointState
    normals: Any,  # out (3, H, W) float32, of the planes, in the camera's frame; anything in chunks without a point
    removed: Any,  # out (H, chunks) uint8, 1 where points of a chunk of a row are not trusted
) -> None:
    """Give points that cannot be trusted the first reason that applies, from the plane through the window of each."""
    width = sigma.shape[1]
    least, sigmas, edge, cosine, partner_cosine = limits
    partner2 = partner_cosine * partner_cosine
    s, t = stack_float32(SCRATCH), stack_uint8(CHUNK)
    for y in range(row_start, row_stop):
        for first in range(0, width, CHUNK):
            n = min(CHUNK, width - first)
            removed[y, first // CHUNK] = False
            if not planes_of_chunk(s, inverse, sigma, rays, to_rays, to_unit, per_px, border, y, first, n):
                continue
            taking, verdict = bits[y, first : first + n], fate[y, first : first + n]
            for i in range(n):
                t[i] = taking[i]
            for i in range(0, n, PIXELS):
                x, y0, z = load(s, ROW_X + i, PIXELS), load(s, ROW_Y + i, PIXELS), load(s, Z + i, PIXELS)
                nx, ny, nz = load(s, NX + i, PIXELS), load(s, NY + i, PIXELS), load(s, NZ + i, PIXELS)
                code = ZERO * z
                for c in range(len(centres)):
                    dx, dy, dz = centres[c, 0] - x * z, centres[c, 1] - y0 * z, centres[c, 2] - z
                    along = nx * dx + ny * dy + nz * dz
                    grazes = (along < ZERO) | (along * along < partner2 * (dx * dx + dy * dy + dz * dz))
                    part = (load(t, i, PIXELS) & np.uint8(1 << c)) != NONE
                    code = select(grazes & part, BY_PARTNER, code)
                slant = load(s, COSINE + i, PIXELS)
                code = select(slant < cosine, BY_CAMERA, code)
                apart = abs(load(s, OFF + i, PIXELS)) * slant
                code = select(apart > sigmas * load(s, OWN + i, PIXELS) + edge * z, BY_PLANE, code)
                code = select(load(s, FITTED + i, PIXELS) < least, ALONE, code)
                store(select(load(s, INV + i, PIXELS) > ZERO, code, ZERO), s, CODE + i)
            for i in range(n):
                code = np.int32(s[CODE + i])
                verdict[i] = np.uint8(code) if code != 0 else verdict[i]
            removed[y, first // CHUNK] = any_above_zero(s, CODE, n)
            for k in range(3):
                write_row(s[NX + k * CHUNK : NX + k * CHUNK + n], normals[k, y, first : first + n])
