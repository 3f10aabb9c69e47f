"""Compiled loops that look at points with other cameras: which candidate the cameras agree on, and the depth they give together.

A rectified pair is described to the kernels by ``turn`` (3, 3), rectified axes from the camera's, and ``frame``
(focal, x0, y0) with x_px = focal · x − x0, y_px = focal · y − y0; a ``grid`` (rows, columns, 2) of native pixels (x, y) at every
``stride``-th rectified pixel leads back to the image. Rows of both images of a pair are the same epipolar lines.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

from measureapp.data.point_state import PointState
from measureapp.reconstruct.kernels.binning import PLACE, REPEATED
from measureapp.reconstruct.kernels.options import INLINE, LOOP
from measureapp.reconstruct.kernels.seen import BLANK, PARTLY, REPEATS, SEEN
from measureapp.reconstruct.kernels.slopes import BESIDE, OWN_SIGMA, PHASE, SLOPE_X, SLOPE_Y, TORN, WHOLE

VALID, NO_PHASE, UNMATCHED, AMBIGUOUS, CONTRADICTED = (
    np.uint8(state)
    for state in (PointState.VALID, PointState.NO_PHASE, PointState.UNMATCHED, PointState.AMBIGUOUS, PointState.CONTRADICTED)
)
BOTH, NONE = np.uint8(3), np.uint8(0)
ZERO = np.float32(0)
EXCESS, ALONG, GAIN, NOISE, HERE, LINE = range(6)  # what is known of a candidate as another camera sees it
BLOCK = 64  # pixels of a row that are looked at together for one that is still open
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
def look(state: Any, pixels: Any, quad: Any, u: Any, v: Any) -> Any:
    """Return (BLANK | SEEN | PARTLY, phase, its variance): bilinear between four pixels of one surface; beside a hole, in the half of
    a border pixel, along the slope of that pixel.
    """
    if not (u >= 0.0 and v >= 0.0 and v < quad.shape[0] - 1 and u < quad.shape[1] - 1):
        return BLANK, 0.0, 0.0
    i = int(v)
    j = int(u)
    a = u - j
    b = v - i
    if quad[i, j] == WHOLE:
        above = pixels[i, j, PHASE] + a * (pixels[i, j + 1, PHASE] - pixels[i, j, PHASE])
        below = pixels[i + 1, j, PHASE] + a * (pixels[i + 1, j + 1, PHASE] - pixels[i + 1, j, PHASE])
        p, q, r, s = (1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b
        noise = (p * pixels[i, j, OWN_SIGMA]) ** 2 + (q * pixels[i, j + 1, OWN_SIGMA]) ** 2
        noise += (r * pixels[i + 1, j, OWN_SIGMA]) ** 2 + (s * pixels[i + 1, j + 1, OWN_SIGMA]) ** 2
        return SEEN, above + b * (below - above), noise
    if quad[i, j] == TORN:
        return PARTLY, 0.0, 0.0
    y = int(v + 0.5)
    x = int(u + 0.5)
    if quad[i, j] == BESIDE and state[y, x] == 0 and (pixels[y, x, SLOPE_X] != 0 or pixels[y, x, SLOPE_Y] != 0):
        reach = abs(u - x) + abs(v - y)
        value = pixels[y, x, PHASE] + (u - x) * pixels[y, x, SLOPE_X] + (v - y) * pixels[y, x, SLOPE_Y]
        return SEEN, value, pixels[y, x, OWN_SIGMA] ** 2 * ((1 + reach) ** 2 + reach**2)
    if state[i, j] != 0 and state[i, j + 1] != 0 and state[i + 1, j] != 0 and state[i + 1, j + 1] != 0:
        return BLANK, 0.0, 0.0
    return PARTLY, 0.0, 0.0


@njit(**INLINE)
def see(own: Any, nx: Any, ny: Any, z: Any, other: Any) -> Any:
    """Look with another camera at the point at depth ``z`` of the ray (nx, ny) whose phase is ``own``.

    Returns (BLANK | SEEN | PARTLY, excess of the phase seen, its slope per rectified pixel along the epipolar line, change of the phase
    with z, variance, rectified x here + x0, rectified x there, rectified y).
    """
    state, pixels, quad, turn, frame, there_frame, grid, stride, baseline = other
    rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
    per_rz, per_z = 1.0 / rz, 1.0 / z
    here = (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) * per_rz
    row = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) * per_rz - frame[2]
    shift = baseline * per_rz * per_z
    there = there_frame[0] * (here - shift) - there_frame[1]
    u, v, to_u, to_v = native_pixel(grid, stride, there, row)
    sight, value, noise = look(state, pixels, quad, u, v)
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


@njit(**INLINE)
def cover(z: Any, there: Any, covered: Any) -> None:
    """Note which pixels of another camera take part in the points of a row."""
    for x in range(len(z)):
        if z[x] > ZERO:
            covered[np.uint32(there[x])] = 1


@njit(**INLINE)
def take_over(z: Any, skip: Any, there: Any, fate: Any, bits: Any, covered: Any) -> None:
    """Write fate and cameras of the pixels of a row that `fuse_both` solved, and which pixels of both other cameras take part."""
    for x in range(len(z)):
        fate[x] = skip[x]
    solved = np.int32(0)
    for x in range(len(z)):
        solved += z[x] > ZERO
    for x in range(len(z)):
        bits[x] = BOTH if z[x] > ZERO else NONE
    if solved > 0:
        for k in range(len(covered)):
            cover(z, there[k], covered[k])


@njit(**INLINE)
def choose_single(z: Any, z_sigma: Any, bits: Any, skip: Any, sampled: Any, every: Any, column: int, singly: Any) -> int:
    """List the pixels of a row that are fused one by one: those not solved yet, and samples of all others; returns how many."""
    left = 0
    for first in range(0, len(z), BLOCK):
        z_part, skip_part = z[first : first + BLOCK], skip[first : first + BLOCK]
        some = sampled
        for i in range(len(z_part)):
            some |= (skip_part[i] == 0) & (z_part[i] == ZERO)
        if not some:
            continue
        for x in range(first, min(first + BLOCK, len(z))):
            if skip[x] == 0 and (z[x] == ZERO or (sampled and (column + x) % every == 0)):
                singly[left] = x
                left += 1
                z[x] = 0
                z_sigma[x] = 0
                bits[x] = 0
    return left


@njit(**INLINE)
def look_with_all(
    singly: Any, left: Any, rays: Any, phase: Any, depth: Any, gain: Any, variance: Any, others: Any, sights: Any, seen: Any
) -> None:
    """Look at every candidate of the chosen pixels of a row with every other camera; a candidate's own camera sees what it matched."""
    for c in range(len(others)):
        other = others[c]
        for k in range(len(others)):
            for i in range(left):
                x = singly[i]
                sights[k, c, i] = BLANK
                if depth[k, x] <= 0:
                    continue
                if c == k:
                    sights[k, c, i] = SEEN
                    seen[EXCESS, k, c, i], seen[GAIN, k, c, i], seen[NOISE, k, c, i] = 0.0, gain[k, x], variance[k, x]
                    continue
                sight, over, along, rise, noise, here, _there, line = see(phase[x], rays[x, 0], rays[x, 1], depth[k, x], other)
                sights[k, c, i] = sight
                seen[EXCESS, k, c, i], seen[ALONG, k, c, i], seen[GAIN, k, c, i] = over, along, rise
                seen[NOISE, k, c, i], seen[HERE, k, c, i], seen[LINE, k, c, i] = noise, here, line


@njit(**INLINE)
def spread_of(seen: Any, k: Any, c: Any, i: Any, own: Any) -> Any:
    """Return the variance of what camera c sees in excess at the candidate of camera k, which has the noise of both phases in it."""
    ratio = seen[GAIN, k, c, i] / seen[GAIN, k, k, i]
    return seen[NOISE, k, c, i] + own * (ratio - 1) ** 2 + seen[NOISE, k, k, i] * ratio**2


@njit(**INLINE)
def best_candidate(i: Any, phase: Any, own: Any, sights: Any, seen: Any, tables: Any, limits: Any, agrees: Any) -> int:
    """Return the candidate that most cameras agree with and none contradicts, −1 for none; ``agrees`` (M, M): who agrees with which."""
    count = len(tables)
    sigmas, tolerance_px = limits
    best, best_support = -1, 0
    for k in range(count):
        if sights[k, k, i] != SEEN:
            continue
        support = 0
        for c in range(count):
            agrees[k, c] = c == k
            support += c == k
            if c == k or sights[k, c, i] != SEEN:
                continue
            excess, slope = seen[EXCESS, k, c, i], seen[ALONG, k, c, i]
            if abs(excess) <= sigmas * np.sqrt(spread_of(seen, k, c, i, own)) + tolerance_px * abs(slope):
                support += 1
                agrees[k, c] = True
            elif not hidden(phase + excess, seen[HERE, k, c, i], seen[LINE, k, c, i], *tables[c]):
                support = -100
        if support > best_support:
            best_support = support
            best = k
    return best


@njit(**INLINE)
def note_shifts(i: Any, own: Any, sights: Any, seen: Any, shifts: Any, row: Any, column: Any) -> None:
    """Note where other cameras see the phases of the candidates, in px along the epipolar line, and the variance of it."""
    count = len(shifts)
    for k in range(count):
        for c in range(count):
            if c == k or sights[k, c, i] != SEEN:
                continue
            slope = seen[ALONG, k, c, i]
            shifts[k, row, column, 0] = seen[EXCESS, k, c, i] / slope
            shifts[k, row, column, 1] = spread_of(seen, k, c, i, own) / slope**2


@njit(**INLINE)
def why_none(i: Any, x: Any, sights: Any, reason: Any) -> Any:
    """Return the fate of a pixel without a candidate that is left."""
    fate = UNMATCHED
    for k in range(len(reason)):
        if reason[k, x] == REPEATS:
            fate = AMBIGUOUS
    for k in range(len(reason)):
        if sights[k, k, i] == SEEN:
            fate = CONTRADICTED
    return fate


@njit(**INLINE)
def solve(i: Any, own: Any, agrees: Any, best: Any, seen: Any) -> Any:
    """Return what to add to the depth of a candidate, its standard deviation (0 where there is no solution) and the cameras in it."""
    zz, zd, dd = 0.0, 0.0, 1.0 / (own + 1e-20)
    rz, rd = 0.0, 0.0
    taking = 0
    for c in range(len(agrees)):
        if not agrees[best, c]:
            continue
        excess, gain = seen[EXCESS, best, c, i], seen[GAIN, best, c, i]
        weight = 1.0 / (seen[NOISE, best, c, i] + 1e-20)
        zz += weight * gain * gain
        zd -= weight * gain
        dd += weight
        rz -= weight * gain * excess
        rd += weight * excess
        taking |= 1 << c
    determinant = zz * dd - zd * zd
    if determinant <= 0:
        return 0.0, 0.0, taking
    return (rz * dd - zd * rd) / determinant, np.sqrt(dd / determinant), taking


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def fuse(
    rays: Any,
    phase: Any,
    sigma: Any,
    skip: Any,  # (H, W) uint8, 0 for pixels to fuse, else their fate
    found: Any,  # what `match` found, (M, rows, columns) each, one per other camera: depth, gain, variance, there, reason
    others: Any,  # per other camera: what `see` needs of it
    tables: Any,  # per other camera: (table of this camera, its lines, its frame, lowest, per_rad)
    limits: Any,  # (standard deviations, px along the epipolar line) that cameras may differ
    sample: int,  # every so many pixels the shifts between the cameras are noted
    row_start: int,
    row_stop: int,
    column_start: int,
    column_stop: int,
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
    depth, gain, variance, there, reason = found
    count, columns = len(others), column_stop - column_start
    agrees = np.zeros((count, count), np.bool_)
    singly = np.zeros(columns, np.int32)
    sights, seen = np.zeros((count, count, columns), np.uint8), np.zeros((6, count, count, columns))
    part = slice(column_start, column_stop)
    for y in range(row_start, row_stop):
        row = y - row_start
        take_over(z[y, part], skip[y, part], there[:, row], fate[y, part], bits[y, part], covered)
        sampled = y % sample == 0
        left = choose_single(z[y, part], z_sigma[y, part], bits[y, part], skip[y, part], sampled, sample, column_start, singly)
        look_with_all(singly, left, rays[y, part], phase[y, part], depth[:, row], gain[:, row], variance[:, row], others, sights, seen)
        for i in range(left):
            at = singly[i]
            x = column_start + at
            own = sigma[y, x] * sigma[y, x]
            if sampled and x % sample == 0:
                note_shifts(i, own, sights, seen, shifts, y // sample, x // sample)
            best = best_candidate(i, phase[y, x], own, sights, seen, tables, limits, agrees)
            if best < 0:
                fate[y, x] = why_none(i, at, sights, reason[:, row])
                continue
            step, deviation, taking = solve(i, own, agrees, best, seen)
            for c in range(count):
                if agrees[best, c] and depth[c, row, at] > 0:
                    covered[c][there[c, row, at]] = 1
            if deviation <= 0:
                fate[y, x] = AMBIGUOUS
                continue
            z[y, x] = depth[best, row, at] + step
            z_sigma[y, x] = deviation
            bits[y, x] = taking
            fate[y, x] = VALID
            if count == 1:
                pair_gain[y, x] = seen[GAIN, 0, 0, i]


@njit(**LOOP)
def resample(
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
            seen, value, noise = look(state, pixels, quad, u, v)
            new_phase[y, x] = value
            new_sigma[y, x] = np.sqrt(noise)
            new_state[y, x] = 0
            if seen != SEEN:  # the reason of the nearest pixel
                i = int(np.floor(v + 0.5))
                j = int(np.floor(u + 0.5))
                inside = 0 <= i < state.shape[0] and 0 <= j < state.shape[1]
                new_state[y, x] = state[i, j] if inside and state[i, j] != 0 else hole
