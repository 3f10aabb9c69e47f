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
from measureapp.reconstruct.kernels.options import INLINE, LOOP
from measureapp.reconstruct.kernels.seen import BLANK, PARTLY, REPEATS, SEEN
from measureapp.reconstruct.kernels.slopes import BESIDE, SLOPE_X, SLOPE_Y, TORN, WHOLE

VALID, NO_PHASE, UNMATCHED, AMBIGUOUS, CONTRADICTED = (
    np.uint8(state)
    for state in (PointState.VALID, PointState.NO_PHASE, PointState.UNMATCHED, PointState.AMBIGUOUS, PointState.CONTRADICTED)
)
BOTH, NONE = np.uint8(3), np.uint8(0)
ZERO = np.float32(0)
OCCLUDES_PX = 16.0  # nearer by so much disparity, a surface seen instead of a point hides it


@njit(**INLINE)
def native_pixel(grid: Any, stride: Any, x: Any, y: Any) -> Any:
    """Return the image point (u, v) of a rectified one and its change with x, bilinear between the grid's nodes; (-1, -1) outside."""
    per_stride = 1.0 / stride
    gx = x * per_stride
    gy = y * per_stride
    if not (gx >= 0.0 and gy >= 0.0 and gy < grid.shape[0] - 1 and gx < grid.shape[1] - 1):
        return -1.0, -1.0, 0.0, 0.0
    i = int(gy)
    j = int(gx)
    a = gx - j
    b = gy - i
    u0 = (1 - b) * grid[i, j, 0] + b * grid[i + 1, j, 0]
    v0 = (1 - b) * grid[i, j, 1] + b * grid[i + 1, j, 1]
    du = (1 - b) * grid[i, j + 1, 0] + b * grid[i + 1, j + 1, 0] - u0
    dv = (1 - b) * grid[i, j + 1, 1] + b * grid[i + 1, j + 1, 1] - v0
    return u0 + a * du, v0 + a * dv, du * per_stride, dv * per_stride


@njit(**INLINE)
def look(phase: Any, sigma: Any, state: Any, pixels: Any, quad: Any, u: Any, v: Any) -> Any:
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
    if quad[i, j] == BESIDE and state[y, x] == 0 and (pixels[y, x, SLOPE_X] != 0 or pixels[y, x, SLOPE_Y] != 0):
        reach = abs(u - x) + abs(v - y)
        value = phase[y, x] + (u - x) * pixels[y, x, SLOPE_X] + (v - y) * pixels[y, x, SLOPE_Y]
        return SEEN, value, sigma[y, x] ** 2 * ((1 + reach) ** 2 + reach**2)
    if state[i, j] != 0 and state[i, j + 1] != 0 and state[i + 1, j] != 0 and state[i + 1, j + 1] != 0:
        return BLANK, 0.0, 0.0
    return PARTLY, 0.0, 0.0


@njit(**INLINE)
def see(own: Any, nx: Any, ny: Any, z: Any, other: Any) -> Any:
    """Look with another camera at the point at depth ``z`` of the ray (nx, ny) whose phase is ``own``.

    Returns (BLANK | SEEN | PARTLY, excess of the phase seen, its slope per rectified pixel along the epipolar line, change of the phase
    with z, variance, rectified x here + x0, rectified x there, rectified y).
    """
    phase, sigma, state, pixels, quad, turn, frame, there_frame, grid, stride, baseline = other
    rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
    per_rz, per_z = 1.0 / rz, 1.0 / z
    here = (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) * per_rz
    row = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) * per_rz - frame[2]
    shift = baseline * per_rz * per_z
    there = there_frame[0] * (here - shift) - there_frame[1]
    u, v, to_u, to_v = native_pixel(grid, stride, there, row)
    sight, value, noise = look(phase, sigma, state, pixels, quad, u, v)
    along = 0.0
    if sight == SEEN:
        j, k = int(u + 0.5), int(v + 0.5)
        along = pixels[k, j, SLOPE_X] * to_u + pixels[k, j, SLOPE_Y] * to_v
        if abs(along) < 1e-6:
            sight = PARTLY
    gain = along * there_frame[0] * shift * per_z
    return sight, value - own, along, gain, noise, here * frame[0], there, row


@njit(**INLINE)
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
    z: Any,  # in and out (H, W) float32, what `fuse_both` made, else 0
    z_sigma: Any,  # in and out (H, W) float32
    bits: Any,  # out (H, W) uint8, bit i: camera i of the others takes part
    fate: Any,  # out (H, W) uint8 of PointState
    pair_gain: Any,  # out (H, W) float32 with one other camera: change of its phase with z, rad/mm; (0, 0) with more
    covered: Any,  # out per other camera (H · W,) uint8, 1 for its pixels that take part
    shifts: Any,  # out (M, rows of samples, columns of samples, 2) float32, shift in the others in px and its variance; 0, 0 for none
) -> None:
    """Choose the candidate no camera contradicts and most agree with; the depth is the least-squares solution of all that agree.

    Unknowns are z and the projector's true phase; one equation per camera.
    """
    count = len(others)
    width = phase.shape[1]
    agrees = np.zeros((count, count), np.bool_)
    singly = np.zeros(width, np.int32)
    sights = np.zeros((count, count, width), np.uint8)
    e, along, g = np.zeros((count, count, width)), np.zeros((count, count, width)), np.zeros((count, count, width))
    noise, here, line = np.zeros((count, count, width)), np.zeros((count, count, width)), np.zeros((count, count, width))
    for y in range(row_start, row_stop):
        row = y - row_start
        fate_row, skip_row, bits_row, z_row = fate[y], skip[y], bits[y], z[y]
        for x in range(width):
            fate_row[x] = skip_row[x]
        for x in range(width):
            bits_row[x] = BOTH if z_row[x] > ZERO else NONE
        sampled = y % sample == 0
        first_there, last_there = there[0, row], there[count - 1, row]
        first_covered, last_covered = covered[0], covered[count - 1]
        for x in range(width):
            if z_row[x] > ZERO:
                first_covered[first_there[x]] = 1
                last_covered[last_there[x]] = 1
        left = 0
        for x in range(width):
            if skip_row[x] == 0 and (z_row[x] == ZERO or (sampled and x % sample == 0)):
                singly[left] = x
                left += 1
                z[y, x] = 0
                z_sigma[y, x] = 0
                bits[y, x] = 0
        for c in range(count):
            other = others[c]
            for k in range(count):
                for i in range(left):
                    x = singly[i]
                    sights[k, c, i] = BLANK
                    if depth[k, row, x] <= 0:
                        continue
                    if c == k:
                        sights[k, c, i], e[k, c, i] = SEEN, 0.0
                        g[k, c, i], noise[k, c, i] = gain[k, row, x], variance[k, row, x]
                    else:
                        seen = see(phase[y, x], rays[y, x, 0], rays[y, x, 1], depth[k, row, x], other)
                        sights[k, c, i], e[k, c, i], along[k, c, i], g[k, c, i], noise[k, c, i], here[k, c, i], _xt, line[k, c, i] = seen
        for i in range(left):
            x = singly[i]
            noted = sampled and x % sample == 0
            own = sigma[y, x] * sigma[y, x]
            best, best_support, tried = -1, 0, False
            for k in range(count):
                if depth[k, row, x] <= 0:
                    continue
                tried = True
                support = 0
                for c in range(count):
                    agrees[k, c] = c == k
                    support += c == k
                    if c == k or sights[k, c, i] != SEEN:
                        continue
                    excess, slope = e[k, c, i], along[k, c, i]
                    ratio = g[k, c, i] / g[k, k, i]
                    spread = noise[k, c, i] + own * (ratio - 1) ** 2 + noise[k, k, i] * ratio**2
                    if noted:
                        shifts[k, y // sample, x // sample, 0] = excess / slope
                        shifts[k, y // sample, x // sample, 1] = spread / slope**2
                    if abs(excess) <= sigmas * np.sqrt(spread) + tolerance_px * abs(slope):
                        support += 1
                        agrees[k, c] = True
                    elif not hidden(phase[y, x] + excess, here[k, c, i], line[k, c, i], *tables[c]):
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
                weight = 1.0 / (noise[best, c, i] + 1e-20)
                zz += weight * g[best, c, i] * g[best, c, i]
                zd -= weight * g[best, c, i]
                dd += weight
                rz -= weight * g[best, c, i] * e[best, c, i]
                rd += weight * e[best, c, i]
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
            if count == 1:
                pair_gain[y, x] = g[0, 0, i]


@njit(**LOOP)
def observe(
    rays: Any,
    phase: Any,
    sigma: Any,
    depth: Any,  # (H, W) float32, 0 for none
    z_sigma: Any,
    pair_gain: Any,  # (H, W) float32, of the points, see `fuse`; (0, 0) for points of more than two cameras
    other: Any,  # what `see` needs of the other camera
    row_start: int,
    row_stop: int,
    seen: Any,  # out (rows, W) uint8
    excess: Any,  # out (rows, W) float32, phase of the other camera at the point minus the pixel's own
    shift: Any,  # out (rows, W) float32, the same as a shift along the epipolar line in rectified pixels
    variance: Any,  # out (rows, W) float32, of the excess
) -> None:
    """Look at points of this camera with another one that took no part in them.

    The depth of a point has the noise of the pixel's own phase in it, as the excess has: they are not independent. Of a point of two
    cameras it is known by how much.
    """
    known = len(pair_gain) > 0
    for y in range(row_start, row_stop):
        for x in range(phase.shape[1]):
            out = y - row_start
            seen[out, x] = BLANK
            if depth[y, x] <= 0:
                continue
            sight, over, along, gain, noise, _here, _xt, _yt = see(phase[y, x], rays[y, x, 0], rays[y, x, 1], depth[y, x], other)
            seen[out, x] = sight
            if sight == SEEN:
                own = float(sigma[y, x]) ** 2
                of_depth = (gain * z_sigma[y, x]) ** 2
                common = 2 * own * gain / pair_gain[y, x] if known else 0.0
                excess[out, x] = over
                shift[out, x] = over / along
                variance[out, x] = noise + own + of_depth - common


@njit(**LOOP)
def resample(
    phase: Any,
    sigma: Any,
    state: Any,
    pixels: Any,
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
            seen, value, noise = look(phase, sigma, state, pixels, quad, u, v)
            new_phase[y, x] = value
            new_sigma[y, x] = np.sqrt(noise)
            new_state[y, x] = 0
            if seen != SEEN:  # the reason of the nearest pixel
                i = int(np.floor(v + 0.5))
                j = int(np.floor(u + 0.5))
                inside = 0 <= i < state.shape[0] and 0 <= j < state.shape[1]
                new_state[y, x] = state[i, j] if inside and state[i, j] != 0 else hole
