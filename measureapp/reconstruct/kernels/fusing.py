"""Compiled loops that look at points with other cameras: which candidate the cameras agree on, and the depth they give together.

A rectified pair is described to the kernels by ``turn`` (3, 3), rectified axes from the camera's, and ``frame``
(focal, x0, y0) with x_px = focal · x − x0, y_px = focal · y − y0; a ``grid`` (rows, columns, 2) of native pixels (x, y) at every
``stride``-th rectified pixel leads back to the image. Rows of both images of a pair are the same epipolar lines.
"""
# One loop over pixels cannot be cut into functions without leaving SIMD code.
# ruff: noqa: PLR0912, PLR0915

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.binning import PLACE, REPEATED
from measureapp.reconstruct.kernels.seen import BLANK, PARTLY, REPEATS, SEEN
from measureapp.reconstruct.kernels.slopes import BESIDE, TORN, WHOLE

VALID, NO_PHASE, UNMATCHED, AMBIGUOUS, CONTRADICTED = (
    np.uint8(state)
    for state in (PointState.VALID, PointState.NO_PHASE, PointState.UNMATCHED, PointState.AMBIGUOUS, PointState.CONTRADICTED)
)
CHUNK = 512
(Z0, G0, V0, Z1, G1, V1, STEP, OWN, FUSED, SPREAD) = (k * CHUNK for k in range(10))
SCRATCH = 10 * CHUNK
ZERO, ONE, TINY = np.float32(0), np.float32(1), np.float32(1e-20)
OCCLUDES_PX = 16.0  # nearer by so much disparity, a surface seen instead of a point hides it


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def native_pixel(grid: Any, stride: Any, x: Any, y: Any) -> Any:
    """Return the image point (x, y) of a rectified one, bilinear between the grid's nodes; (-1, -1) outside."""
    gx = x / stride
    gy = y / stride
    i = int(np.floor(gy))
    j = int(np.floor(gx))
    if i < 0 or j < 0 or i + 1 >= grid.shape[0] or j + 1 >= grid.shape[1]:
        return -1.0, -1.0
    a = gx - j
    b = gy - i
    u = (1 - b) * ((1 - a) * grid[i, j, 0] + a * grid[i, j + 1, 0]) + b * ((1 - a) * grid[i + 1, j, 0] + a * grid[i + 1, j + 1, 0])
    v = (1 - b) * ((1 - a) * grid[i, j, 1] + a * grid[i, j + 1, 1]) + b * ((1 - a) * grid[i + 1, j, 1] + a * grid[i + 1, j + 1, 1])
    return u, v


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def look(phase: Any, sigma: Any, state: Any, slope: Any, quad: Any, u: Any, v: Any) -> Any:
    """Return (BLANK | SEEN | PARTLY, phase, its variance): bilinear between four pixels of one surface; beside a hole, in the half of
    a border pixel, along the slope of that pixel.
    """
    if not (u >= 0.0 and v >= 0.0 and v < phase.shape[0] - 1 and u < phase.shape[1] - 1):
        return BLANK, 0.0, 0.0
    i = int(v)
    j = int(u)
    a = u - j
    b = v - i
    if quad[i, j] == WHOLE:
        above = phase[i, j] + a * (phase[i, j + 1] - phase[i, j])
        below = phase[i + 1, j] + a * (phase[i + 1, j + 1] - phase[i + 1, j])
        p, q, r, s = (1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b
        noise = (p * sigma[i, j]) ** 2 + (q * sigma[i, j + 1]) ** 2 + (r * sigma[i + 1, j]) ** 2 + (s * sigma[i + 1, j + 1]) ** 2
        return SEEN, above + b * (below - above), noise
    if quad[i, j] == TORN:
        return PARTLY, 0.0, 0.0
    y = int(v + 0.5)
    x = int(u + 0.5)
    if quad[i, j] == BESIDE and state[y, x] == 0 and (slope[y, x, 0] != 0 or slope[y, x, 1] != 0):
        reach = abs(u - x) + abs(v - y)
        value = phase[y, x] + (u - x) * slope[y, x, 0] + (v - y) * slope[y, x, 1]
        return SEEN, value, sigma[y, x] ** 2 * ((1 + reach) ** 2 + reach**2)
    if state[i, j] != 0 and state[i, j + 1] != 0 and state[i + 1, j] != 0 and state[i + 1, j + 1] != 0:
        return BLANK, 0.0, 0.0
    return PARTLY, 0.0, 0.0


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def see(own: Any, nx: Any, ny: Any, z: Any, other: Any) -> Any:
    """Look with another camera at the point at depth ``z`` of the ray (nx, ny) whose phase is ``own``.

    Returns (BLANK | SEEN | PARTLY, excess of the phase seen, its slope per rectified pixel along the epipolar line, change of the phase
    with z, variance, rectified x here + x0, rectified x there, rectified y).
    """
    phase, sigma, state, slope, quad, turn, frame, there_frame, grid, stride, baseline = other
    rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
    here = (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) / rz
    row = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) / rz - frame[2]
    there = there_frame[0] * (here - baseline / (rz * z)) - there_frame[1]
    u, v = native_pixel(grid, stride, there, row)
    sight, value, noise = look(phase, sigma, state, slope, quad, u, v)
    along = 0.0
    if sight == SEEN:
        right, below = native_pixel(grid, stride, there + 1.0, row)
        j, k = int(u + 0.5), int(v + 0.5)
        along = slope[k, j, 0] * (right - u) + slope[k, j, 1] * (below - v)
        if abs(along) < 1e-6:
            sight = PARTLY
    gain = along * there_frame[0] * baseline / (rz * z * z)
    return sight, value - own, along, gain, noise, here * frame[0], there, row


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def hidden(wanted: Any, here: Any, row: Any, repeats: Any, lines: Any, frame: Any, lowest: Any, per_rad: Any) -> bool:
    """Whether the phase ``wanted``, seen by another camera instead of a point, belongs to a surface that this camera sees before it."""
    r = int(row * 0.5) + 1
    k = int((wanted - lowest) * per_rad) + 1
    if r < 1 or k < 1 or r >= repeats.shape[0] - 1 or k >= repeats.shape[1] - 1:
        return False
    held = repeats[r, k]
    if held < 0 or (held & REPEATED) != 0:
        return False
    nearer = lines[(held & PLACE) >> 16, held & 0xFFFF, 0] + frame[1] - here
    return bool(nearer > OCCLUDES_PX)


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def other_step(other: Any) -> Any:
    """Return (c0, c1, c2): (c0 · nx + c1 · ny + c2) · z is the share of the depth z that shifts a point by a pixel in the other camera."""
    turn, there_frame, baseline = other[5], other[7], other[10]
    scale = 1.0 / (there_frame[0] * baseline)
    return np.float32(turn[2, 0] * scale), np.float32(turn[2, 1] * scale), np.float32(turn[2, 2] * scale)


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy", forceinline=True)
def fuse_both(
    s: Any, step: Any, sigmas: Any, tolerance_px: Any, rays: Any, sigma: Any, depth: Any, gain: Any, variance: Any, z: Any, z_sigma: Any
) -> None:
    """Fuse the pixels of a row that two other cameras matched, where the depths agree; z stays 0 elsewhere."""
    c0, c1, c2 = step
    sigmas2, tolerance = np.float32(sigmas * sigmas), np.float32(tolerance_px)
    for first in range(0, len(sigma), CHUNK):
        n = min(CHUNK, len(sigma) - first)
        ray, own_row = rays[2 * first : 2 * (first + n)], sigma[first : first + n]
        for i in range(n):
            s[STEP + i] = c0 * ray[2 * i] + c1 * ray[2 * i + 1] + c2
        for i in range(n):
            s[OWN + i] = own_row[i]
        for k in range(2):
            z_row, g_row, v_row = depth[k, first : first + n], gain[k, first : first + n], variance[k, first : first + n]
            lane = s[k * 3 * CHUNK : (k * 3 + 3) * CHUNK]
            for i in range(n):
                lane[i] = z_row[i]
            for i in range(n):
                lane[CHUNK + i] = g_row[i]
            for i in range(n):
                lane[2 * CHUNK + i] = v_row[i]
        for i in range(n):
            z0, z1, g0, g1, v0, v1 = s[Z0 + i], s[Z1 + i], s[G0 + i], s[G1 + i], s[V0 + i], s[V1 + i]
            own = s[OWN + i] * s[OWN + i]
            excess = g1 * (z0 - z1)
            ratio = g1 / g0
            spread = v1 + own * (ratio - ONE) * (ratio - ONE) + v0 * ratio * ratio
            limit = np.sqrt(sigmas2 * spread) + tolerance * abs(g1) * z1 * z1 * s[STEP + i]
            w0, w1, w = ONE / (v0 + TINY), ONE / (v1 + TINY), ONE / (own + TINY)
            dd = w + w0 + w1
            zz = w0 * g0 * g0 + w1 * g1 * g1
            zd = w0 * g0 + w1 * g1
            per = ONE / (zz * dd - zd * zd)
            agree = (z0 > ZERO) & (z1 > ZERO) & (abs(excess) <= limit) & (per > ZERO)
            s[FUSED + i] = z0 - w1 * excess * (g1 * dd - zd) * per if agree else ZERO
            s[SPREAD + i] = np.sqrt(dd * per) if agree else ZERO
        z_out, sigma_out = z[first : first + n], z_sigma[first : first + n]
        for i in range(n):
            z_out[i] = s[FUSED + i]
        for i in range(n):
            sigma_out[i] = s[SPREAD + i]


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def fuse(
    rays: Any,
    phase: Any,
    sigma: Any,
    skip: Any,  # (H, W) uint8, 0 for pixels to fuse, else their fate
    depth: Any,  # (M, rows, W) float32, candidates, one per other camera
    gain: Any,  # (M, rows, W) float32
    variance: Any,  # (M, rows, W) float32
    there: Any,  # (M, rows, W) int32
    reason: Any,  # (M, rows, W) uint8
    others: Any,  # per other camera: what `see` needs of it
    tables: Any,  # per other camera: (table of this camera, its lines, its frame, lowest, per_rad)
    sigmas: Any,
    tolerance_px: Any,
    sample: int,  # every so many pixels the shifts between the cameras are noted
    row_start: int,
    row_stop: int,
    z: Any,  # out (H, W) float32
    z_sigma: Any,  # out (H, W) float32
    bits: Any,  # out (H, W) uint8, bit i: camera i of the others takes part
    fate: Any,  # out (H, W) uint8 of PointState
    covered: Any,  # out per other camera (H · W,) uint8, 1 for its pixels that take part
    shifts: Any,  # out (M, rows of samples, columns of samples, 2) float32, shift in the others in px and its variance; 0, 0 for none
) -> None:
    """Choose the candidate no camera contradicts and most agree with; the depth is the least-squares solution of all that agree.

    Unknowns are z and the projector's true phase; one equation per camera.
    """
    count = len(others)
    width = phase.shape[1]
    g = np.zeros((count, count))
    noise = np.zeros((count, count))
    e = np.zeros((count, count))
    agrees = np.zeros((count, count), np.bool_)
    s = np.zeros(SCRATCH, np.float32)
    step = other_step(others[count - 1])
    for y in range(row_start, row_stop):
        row = y - row_start
        if count == 2:
            fuse_both(s, step, sigmas, tolerance_px, rays[y].ravel(), sigma[y], depth[:, row], gain[:, row], variance[:, row], z[y], z_sigma[y])
        else:
            z[y] = 0
        fate_row, skip_row, bits_row = fate[y], skip[y], bits[y]
        for x in range(width):
            fate_row[x] = skip_row[x]
        for x in range(width):
            bits_row[x] = 3
        for x in range(width):
            noted = y % sample == 0 and x % sample == 0
            if z[y, x] > 0 and not noted:
                covered[0][there[0, row, x]] = 1
                covered[count - 1][there[count - 1, row, x]] = 1
                continue
            z[y, x] = 0
            z_sigma[y, x] = 0
            bits[y, x] = 0
            if skip[y, x] != 0:
                continue
            own = sigma[y, x] * sigma[y, x]
            best, best_support, tried = -1, 0, False
            for k in range(count):
                if depth[k, row, x] <= 0:
                    continue
                tried = True
                support = 1
                g[k, k], noise[k, k], e[k, k] = gain[k, row, x], variance[k, row, x], 0.0
                agrees[k, k] = True
                for c in range(count):
                    if c == k:
                        continue
                    agrees[k, c] = False
                    sight, excess, along, g[k, c], noise[k, c], here, _xt, yt = see(
                        phase[y, x], rays[y, x, 0], rays[y, x, 1], depth[k, row, x], others[c]
                    )
                    if sight != SEEN:
                        continue
                    e[k, c] = excess
                    ratio = g[k, c] / g[k, k]
                    spread = noise[k, c] + own * (ratio - 1) ** 2 + noise[k, k] * ratio**2
                    if noted:
                        shifts[k, y // sample, x // sample, 0] = excess / along
                        shifts[k, y // sample, x // sample, 1] = spread / along**2
                    if abs(excess) <= sigmas * np.sqrt(spread) + tolerance_px * abs(along):
                        support += 1
                        agrees[k, c] = True
                    elif not hidden(phase[y, x] + excess, here, yt, *tables[c]):
                        support = -100
                if support > best_support:
                    best_support = support
                    best = k
            if best < 0:
                fate[y, x] = UNMATCHED
                for k in range(count):
                    if reason[k, row, x] == REPEATS:
                        fate[y, x] = AMBIGUOUS
                if tried:
                    fate[y, x] = CONTRADICTED
                continue
            zz, zd, dd = 0.0, 0.0, 1.0 / (own + 1e-20)
            rz, rd = 0.0, 0.0
            taking = 0
            for c in range(count):
                if not agrees[best, c]:
                    continue
                weight = 1.0 / (noise[best, c] + 1e-20)
                zz += weight * g[best, c] * g[best, c]
                zd -= weight * g[best, c]
                dd += weight
                rz -= weight * g[best, c] * e[best, c]
                rd += weight * e[best, c]
                taking |= 1 << c
                if depth[c, row, x] > 0:
                    covered[c][there[c, row, x]] = 1
            determinant = zz * dd - zd * zd
            if determinant <= 0:
                fate[y, x] = AMBIGUOUS
                continue
            z[y, x] = depth[best, row, x] + (rz * dd - zd * rd) / determinant
            z_sigma[y, x] = np.sqrt(dd / determinant)
            bits[y, x] = taking
            fate[y, x] = VALID


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def observe(
    rays: Any,
    phase: Any,
    depth: Any,  # (H, W) float32, 0 for none
    other: Any,  # what `see` needs of the other camera
    row_start: int,
    row_stop: int,
    seen: Any,  # out (rows, W) uint8
    excess: Any,  # out (rows, W) float32, phase of the other camera at the point minus the pixel's own
    shift: Any,  # out (rows, W) float32, the same as a shift along the epipolar line in rectified pixels
    variance: Any,  # out (rows, W) float32, of the other camera's phase
) -> None:
    """Look at points of this camera with another one."""
    for y in range(row_start, row_stop):
        for x in range(phase.shape[1]):
            out = y - row_start
            seen[out, x] = BLANK
            if depth[y, x] <= 0:
                continue
            sight, over, along, _gain, noise, _here, _xt, _yt = see(phase[y, x], rays[y, x, 0], rays[y, x, 1], depth[y, x], other)
            seen[out, x] = sight
            if sight == SEEN:
                excess[out, x] = over
                shift[out, x] = over / along
                variance[out, x] = noise


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def resample(
    phase: Any,
    sigma: Any,
    state: Any,
    slope: Any,
    quad: Any,
    native: Any,  # (rows, columns, 2) float32, where to take the pixels from, (x, y)
    row_start: int,
    row_stop: int,
    new_phase: Any,  # out (rows, columns) float32
    new_sigma: Any,  # out (rows, columns) float32
    new_state: Any,  # out (rows, columns) uint8, that of the nearest pixel, or `hole`
    hole: int,
) -> None:
    """Take a phase map to another grid, bilinear where all four pixels are valid and of one surface."""
    for y in range(row_start, row_stop):
        for x in range(new_phase.shape[1]):
            u = native[y, x, 0]
            v = native[y, x, 1]
            seen, value, noise = look(phase, sigma, state, slope, quad, u, v)
            new_phase[y, x] = value
            new_sigma[y, x] = np.sqrt(noise)
            new_state[y, x] = 0
            if seen != SEEN:  # the reason of the nearest pixel
                i = int(np.floor(v + 0.5))
                j = int(np.floor(u + 0.5))
                inside = 0 <= i < state.shape[0] and 0 <= j < state.shape[1]
                new_state[y, x] = state[i, j] if inside and state[i, j] != 0 else hole
