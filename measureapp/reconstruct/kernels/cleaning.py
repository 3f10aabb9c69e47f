"""Compiled loops over a depth map: the plane through the surroundings of every point, and which points cannot be trusted.

Inverse depths are used, on a plane they are linear in the image; ``inverse`` (H + 2r, W + 2r) has a border of zeros, and zeros where
there is no point. Loops over arithmetic alone run on one scratch array at constant offsets, in SIMD instructions.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.cubic import cubic
from measureapp.reconstruct.kernels.options import INLINE, LOOP
from measureapp.reconstruct.kernels.past_caches import write_row
from measureapp.reconstruct.kernels.scratch import stack_float32

CHUNK = 128
(INV, Z, FAR_H, FAR_R, WORST, N, SX, SY, SXX, SXY, SYY, SW, SWX, SWY) = (k * CHUNK for k in range(14))
(NX, NY, NZ, COSINE, OFF, FITTED, ROW_X, ROW_Y, OWN, CODE, FITS, WU, WV) = (k * CHUNK for k in range(14, 27))
SCRATCH = 27 * CHUNK
ZERO, HALF, ONE, FOUR = np.float32(0), np.float32(0.5), np.float32(1), np.float32(4)
THIN = np.float32(1e-6)
SIGMAS = np.float32(8.0)
WHOLE = np.float32(25)  # places of a window
TINY = np.float32(1e-12)
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
def five(inverse: Any, row: int, start: int, half: int, border: int, n: int) -> Any:
    """Return n pixels of a row from ``start`` on, and those ±half and ±border beside them."""
    a, b, e, f = start - border, start - half, start + half, start + border
    return (
        inverse[row, a : a + n],
        inverse[row, b : b + n],
        inverse[row, start : start + n],
        inverse[row, e : e + n],
        inverse[row, f : f + n],
    )


@njit(**INLINE)
def sum_whole(s: Any, inverse: Any, row: int, start: int, half: int, border: int, n: int) -> None:
    """Sum the windows of n pixels as if all their places lay on one surface, and note in WORST by how much one does not."""
    h, r = np.float32(half), np.float32(border)
    for k in range(5):
        dv = (k - 2) // 2 * border if k in (0, 4) else (k - 2) * half
        d = np.float32(dv)
        outer = k in (0, 4)
        la, lb, lc, le, lf = five(inverse, row + dv, start, half, border, n)
        for i in range(n):
            inv, far_r = s[INV + i], s[FAR_R + i]
            far_h = far_r if outer else s[FAR_H + i]
            a, b, c, e, f = la[i] - inv, lb[i] - inv, lc[i] - inv, le[i] - inv, lf[i] - inv
            wide = max(abs(a), abs(f))
            near = max(max(abs(b), abs(c)), abs(e))  # noqa: PLW3301
            s[WORST + i] = max(max(wide - far_r, near - far_h), s[WORST + i])  # noqa: PLW3301
            w = a + b + c + e + f
            s[SW + i] += w
            s[SWX + i] += r * (f - a) + h * (e - b)
            s[SWY + i] += d * w


@njit(**INLINE)
def sum_torn(s: Any, inverse: Any, row: int, start: int, half: int, border: int, n: int) -> None:
    """Sum the windows of n pixels over those places that lie on the surface of the pixel."""
    h, r = np.float32(half), np.float32(border)
    for i in range(n):
        s[N + i], s[SX + i], s[SY + i] = ZERO, ZERO, ZERO
        s[SXX + i], s[SXY + i], s[SYY + i] = ZERO, ZERO, ZERO
        s[SW + i], s[SWX + i], s[SWY + i] = ZERO, ZERO, ZERO
    for k in range(5):
        dv = (k - 2) // 2 * border if k in (0, 4) else (k - 2) * half
        d = np.float32(dv)
        outer = k in (0, 4)
        la, lb, lc, le, lf = five(inverse, row + dv, start, half, border, n)
        for i in range(n):
            inv, far_r = s[INV + i], s[FAR_R + i]
            far_h = far_r if outer else s[FAR_H + i]
            a, b, c, e, f = la[i] - inv, lb[i] - inv, lc[i] - inv, le[i] - inv, lf[i] - inv
            ma = ONE if abs(a) <= far_r else ZERO
            mb = ONE if abs(b) <= far_h else ZERO
            mc = ONE if abs(c) <= far_h else ZERO
            me = ONE if abs(e) <= far_h else ZERO
            mf = ONE if abs(f) <= far_r else ZERO
            a, b, c, e, f = ma * a, mb * b, mc * c, me * e, mf * f
            count = ma + mb + mc + me + mf
            x = r * (mf - ma) + h * (me - mb)
            w = a + b + c + e + f
            s[N + i] += count
            s[SX + i] += x
            s[SY + i] += d * count
            s[SXX + i] += r * r * (mf + ma) + h * h * (me + mb)
            s[SXY + i] += d * x
            s[SYY + i] += d * d * count
            s[SW + i] += w
            s[SWX + i] += r * (f - a) + h * (e - b)
            s[SWY + i] += d * w


@njit(**INLINE)
def begin_windows(s: Any, middle: Any, noise: Any, per_px: Any, half: int, border: int, n: int) -> None:
    """Set the sums of n windows to those of whole ones, and how far from a pixel's depth its surface may lie at their places."""
    h, r = np.float32(half), np.float32(border)
    whole_xx = np.float32(5) * (r * r + r * r + h * h + h * h)
    for i in range(n):
        inv = middle[i]
        slack = SIGMAS * noise[i] * inv * inv
        s[INV + i] = inv
        s[OWN + i] = noise[i]
        s[Z + i] = ONE / max(inv, TINY)
        s[FAR_H + i] = min(h * per_px * inv + slack, HALF * inv)
        s[FAR_R + i] = min(r * per_px * inv + slack, HALF * inv)
        s[WORST + i] = ZERO
        s[N + i], s[SX + i], s[SY + i] = WHOLE, ZERO, ZERO
        s[SXX + i], s[SXY + i], s[SYY + i] = whole_xx, ZERO, whole_xx
        s[SW + i], s[SWX + i], s[SWY + i] = ZERO, ZERO, ZERO


@njit(**INLINE)
def greatest(values: Any, n: int) -> Any:
    """Return the greatest of the first n values, at least zero."""
    found = ZERO
    for i in range(n):
        found = max(found, values[i])
    return found


@njit(**INLINE)
def planes_of_chunk(
    s: Any, inverse: Any, sigma: Any, rays: Any, to_rays: Any, to_unit: Any, per_px: Any, border: Any, y: int, first: int, n: int
) -> bool:
    """Fit planes to the windows of n pixels of a row: leaves the normal, its cosine to the ray, the distance to the plane in ``s``.

    Windows that no border and no depth step crosses, most of all, have the same places: only their values are summed. False: no points.
    """
    half = max(1, border // 2)
    start = border + first
    middle = inverse[y + border, start : start + n]
    if greatest(middle, n) == ZERO:
        return False
    begin_windows(s, middle, sigma[y, first : first + n], per_px, half, border, n)
    sum_whole(s, inverse, y + border, start, half, border, n)
    if greatest(s[WORST : WORST + n], n) > ZERO:
        sum_torn(s, inverse, y + border, start, half, border, n)
    ray = rays[y, 2 * first : 2 * (first + n)]
    u0, per_u, v0, per_v = to_unit
    x_u, x_v, y_u, y_v = to_rays
    t = (np.float32(y) - v0) * per_v
    for i in range(n):
        z = s[Z + i]
        count = max(s[N + i], ONE)
        share = ONE / count
        sx, sy, sw = s[SX + i], s[SY + i], s[SW + i] * z
        cxx, cxy, cyy = s[SXX + i] - sx * sx * share, s[SXY + i] - sx * sy * share, s[SYY + i] - sy * sy * share
        cwx, cwy = s[SWX + i] * z - sw * sx * share, s[SWY + i] * z - sw * sy * share
        determinant = cxx * cyy - cxy * cxy
        enough = ONE if s[N + i] >= FOUR else ZERO
        spans = ONE if determinant > THIN * (cxx + cyy) * (cxx + cyy) else ZERO
        fits = enough * spans
        over = fits / max(determinant, TINY)
        wu, wv = (cwx * cyy - cwy * cxy) * over, (cwy * cxx - cwx * cxy) * over
        s[FITS + i], s[WU + i], s[WV + i] = fits, wu, wv
        s[OFF + i] = fits * (sw - wu * sx - wv * sy) * share
        s[FITTED + i] = (s[N + i] - ONE) * max(fits, ONE - enough)
    for i in range(n):
        us = (np.float32(np.int32(first + i)) - u0) * per_u
        a, b, c, d = cubic(x_u, us, t), cubic(x_v, us, t), cubic(y_u, us, t), cubic(y_v, us, t)
        wu, wv, off, fits = s[WU + i], s[WV + i], s[OFF + i], s[FITS + i]
        per_area = ONE / (a * d - b * c)
        p, q = (wu * d - wv * c) * per_area, (wv * a - wu * b) * per_area
        x, y0 = ray[2 * i], ray[2 * i + 1]
        ahead = ONE + off
        w = ahead - p * x - q * y0
        length = ONE / np.sqrt(p * p + q * q + w * w)
        towards = ONE / np.sqrt(ONE + x * x + y0 * y0)
        sign = (-length if ahead > ZERO else length) * fits
        own = (ONE - fits) * towards
        s[ROW_X + i], s[ROW_Y + i] = x, y0
        s[NX + i] = sign * p - own * x
        s[NY + i] = sign * q - own * y0
        s[NZ + i] = sign * w - own
        s[COSINE + i] = fits * abs(ahead) * length * towards + ONE - fits
        s[OFF + i] = off * s[Z + i]
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
    s = stack_float32(SCRATCH)
    for y in range(row_start, row_stop):
        for first in range(0, width, CHUNK):
            n = min(CHUNK, width - first)
            removed[y, first // CHUNK] = False
            if not planes_of_chunk(s, inverse, sigma, rays, to_rays, to_unit, per_px, border, y, first, n):
                continue
            taking, verdict = bits[y, first : first + n], fate[y, first : first + n]
            for i in range(n):
                s[CODE + i] = ZERO
            for c in range(len(centres)):
                c0, c1, c2 = centres[c, 0], centres[c, 1], centres[c, 2]
                for i in range(n):
                    z = s[Z + i]
                    dx, dy, dz = c0 - s[ROW_X + i] * z, c1 - s[ROW_Y + i] * z, c2 - z
                    along = s[NX + i] * dx + s[NY + i] * dy + s[NZ + i] * dz
                    grazes = (along < ZERO) | (along * along < partner2 * (dx * dx + dy * dy + dz * dz))
                    part = ((np.int32(taking[i]) >> np.int32(c)) & np.int32(1)) != 0
                    s[CODE + i] = BY_PARTNER if grazes & part else s[CODE + i]
            for i in range(n):
                code = BY_CAMERA if s[COSINE + i] < cosine else s[CODE + i]
                code = BY_PLANE if abs(s[OFF + i]) * s[COSINE + i] > sigmas * s[OWN + i] + edge * s[Z + i] else code
                code = ALONE if s[FITTED + i] < least else code
                s[CODE + i] = code if s[INV + i] > ZERO else ZERO
            for i in range(n):
                code = np.int32(s[CODE + i])
                verdict[i] = np.uint8(code) if code != 0 else verdict[i]
            worst = ZERO
            for i in range(n):
                worst = max(worst, s[CODE + i])
            removed[y, first // CHUNK] = worst > ZERO
            for k in range(3):
                write_row(s[NX + k * CHUNK : NX + k * CHUNK + n], normals[k, y, first : first + n])
