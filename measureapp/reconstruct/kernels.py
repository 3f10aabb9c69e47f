"""Compiled loops of matching, checking, fusing and cleaning; each works on a band of rows and releases the interpreter.

A rectified pair is described to the kernels by ``turn`` (3, 3), rectified axes from the camera's, and ``frame``
(focal, x0, y0) with x_px = focal · x − x0, y_px = focal · y − y0; a ``grid`` (rows, columns, 2) of native pixels (x, y) at every
``stride``-th rectified pixel leads back to the image. Rows of both images of a pair are the same epipolar lines.
"""
# One loop over pixels cannot be cut into functions without leaving SIMD code.
# ruff: noqa: PLR0912, PLR0915, PLR1714, PLW3301

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

ITERATIONS = 8
SLOPE_REACH = 3.0  # rectified pixels to either side over which the phase slope is taken
SLOPE_SIGMAS = 4.0  # a slope below this many of its standard deviations is no slope: the phase does not tell where the point is
CONVERGED_PX = 0.02
BLANK, SEEN, PARTLY = 0, 1, 2
BORROWED = np.uint8(255)  # state of a hole beside valid pixels whose phase continues theirs


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def continue_borders(
    phase: Any,
    sigma: Any,
    state: Any,
    step: Any,
    row_start: int,
    row_stop: int,
    new_phase: Any,  # out (H, W) float32
    new_sigma: Any,  # out (H, W) float32
    new_state: Any,  # out (H, W) uint8
) -> None:
    """Continue the phase by one pixel into the holes, along straight lines, so that the outer half of border pixels can be interpolated."""
    height, width = phase.shape
    for y in range(row_start, row_stop):
        for x in range(width):
            new_phase[y, x] = phase[y, x]
            new_sigma[y, x] = sigma[y, x]
            new_state[y, x] = state[y, x]
            if state[y, x] == 0:
                continue
            total = 0.0
            noise = 0.0
            count = 0
            for dy in range(-1, 2):
                for dx in range(-1, 2):
                    v, u = y + 2 * dy, x + 2 * dx
                    if (dx == 0 and dy == 0) or v < 0 or u < 0 or v >= height or u >= width:
                        continue
                    if state[y + dy, x + dx] == 0 and state[v, u] == 0 and abs(phase[v, u] - phase[y + dy, x + dx]) < step:
                        total += 2.0 * phase[y + dy, x + dx] - phase[v, u]
                        noise += 4.0 * sigma[y + dy, x + dx] ** 2 + sigma[v, u] ** 2
                        count += 1
            if count:
                new_phase[y, x] = total / count
                new_sigma[y, x] = np.sqrt(noise) / count
                new_state[y, x] = BORROWED


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
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


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def sample(phase: Any, sigma: Any, state: Any, step: Any, u: Any, v: Any) -> Any:
    """Return (BLANK | SEEN | PARTLY, phase, variance), bilinear between four pixels within ``step`` of each other.

    The nearest pixel must be valid, the others at least borrowed.
    """
    i = int(np.floor(v))
    j = int(np.floor(u))
    if i < 0 or j < 0 or i + 1 >= phase.shape[0] or j + 1 >= phase.shape[1]:
        return BLANK, 0.0, 0.0
    if (state[i, j] + state[i, j + 1]) + (state[i + 1, j] + state[i + 1, j + 1]) != 0:
        holes = 0
        blanks = 0
        for k in range(4):
            here = state[i + k // 2, j + k % 2]
            blanks += here != 0
            holes += here != 0 and here != BORROWED
        if holes or state[int(v + 0.5), int(u + 0.5)] != 0:
            return (BLANK if blanks == 4 else PARTLY), 0.0, 0.0
    p, q, r, s = phase[i, j], phase[i, j + 1], phase[i + 1, j], phase[i + 1, j + 1]
    if max(max(p, q), max(r, s)) - min(min(p, q), min(r, s)) > step:
        return PARTLY, 0.0, 0.0
    a = u - j
    b = v - i
    wp, wq, wr, ws = (1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b
    variance = (wp * sigma[i, j]) ** 2 + (wq * sigma[i, j + 1]) ** 2 + (wr * sigma[i + 1, j]) ** 2 + (ws * sigma[i + 1, j + 1]) ** 2
    return SEEN, wp * p + wq * q + wr * r + ws * s, variance


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def fill_table(
    grid: Any,
    stride: Any,
    width: int,
    phase: Any,
    sigma: Any,
    state: Any,
    step: Any,  # largest phase step between neighbours
    lowest: Any,  # phase of bin 0
    per_rad: Any,  # bins per radian
    row_start: int,
    row_stop: int,
    first: Any,  # out (rows, bins) int16, first rectified column whose segment holds the bin's phase, -1 for none
    last: Any,  # out (rows, bins) int16, last one
) -> None:
    """Sort the segments between neighbours of every rectified row into bins of the phase; linear in the width."""
    bins = first.shape[1]
    for row in range(row_start, row_stop):
        for k in range(bins):
            first[row, k] = -1
            last[row, k] = -1
        before = 0.0
        known = False
        for x in range(width):
            u, v = native_pixel(grid, stride, float(x), float(row))
            seen, value, _ = sample(phase, sigma, state, step, u, v)
            if seen == SEEN and known and abs(value - before) < step:
                low = max(0, int((min(value, before) - lowest) * per_rad))
                high = min(bins - 1, int((max(value, before) - lowest) * per_rad))
                for k in range(low, high + 1):
                    if first[row, k] < 0:
                        first[row, k] = x
                    last[row, k] = x
            known = seen == SEEN
            before = value


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def direction_at(grid: Any, stride: Any, x: Any, y: Any) -> Any:
    """Return the image point of a rectified one and how it moves per rectified pixel along the row: (u, v, du, dv)."""
    u, v = native_pixel(grid, stride, x, y)
    right, below = native_pixel(grid, stride, x + 1.0, y)
    return u, v, right - u, below - v


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def slope_along(phase: Any, sigma: Any, state: Any, step: Any, u: Any, v: Any, du: Any, dv: Any) -> Any:
    """Return (known, radians per rectified pixel) along the row: the central difference over the widest reach that is one surface.

    A wide one is less noisy; near a border it is taken over single pixels, at the border one-sided.
    """
    wide_right, high, _ = sample(phase, sigma, state, step, u + SLOPE_REACH * du, v + SLOPE_REACH * dv)
    wide_left, low, _ = sample(phase, sigma, state, step, u - SLOPE_REACH * du, v - SLOPE_REACH * dv)
    if wide_right == SEEN and wide_left == SEEN:
        here, middle, _ = sample(phase, sigma, state, step, u, v)
        if here == SEEN and abs(high + low - 2.0 * middle) < 0.2 * abs(high - low):
            return True, (high - low) / (2.0 * SLOPE_REACH)
    right, high, _ = sample(phase, sigma, state, step, u + du, v + dv)
    left, low, _ = sample(phase, sigma, state, step, u - du, v - dv)
    if right == SEEN and left == SEEN:
        return True, (high - low) / 2.0
    here, middle, _ = sample(phase, sigma, state, step, u, v)
    if here == SEEN and right == SEEN:
        return True, high - middle
    if here == SEEN and left == SEEN:
        return True, middle - low
    return False, 0.0


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def solve_row(grid: Any, stride: Any, phase: Any, sigma: Any, state: Any, step: Any, wanted: Any, x: Any, y: Any) -> Any:
    """Find where the row has the phase ``wanted``, from ``x`` on; returns (found, x, slope, variance)."""
    u, v, du, dv = direction_at(grid, stride, x, y)
    if u < 0:
        return False, x, 0.0, 0.0
    known, slope = slope_along(phase, sigma, state, step, u, v, du, dv)
    if not known or abs(slope) < 1e-6:
        return False, x, 0.0, 0.0
    gone = 0.0
    for _ in range(ITERATIONS):
        seen, value, variance = sample(phase, sigma, state, step, u + gone * du, v + gone * dv)
        if seen != SEEN:
            return False, x, 0.0, 0.0
        move = (wanted - value) / slope
        if abs(move) < CONVERGED_PX:
            return True, x + gone + move, slope, variance
        gone += min(2.0, max(-2.0, move))
    return False, x, 0.0, 0.0


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def match(
    rays: Any,  # (H, W, 2) float32, normalised image coordinates of the camera
    phase: Any,
    state: Any,
    turn: Any,
    frame: Any,  # of this camera
    first_here: Any,
    last_here: Any,
    other_frame: Any,
    grid: Any,  # of the other camera
    stride: Any,
    other_phase: Any,
    other_sigma: Any,
    other_state: Any,
    first: Any,
    last: Any,
    lowest: Any,
    per_rad: Any,
    step: Any,
    baseline: Any,
    row_start: int,
    row_stop: int,
    depth: Any,  # out (rows, W) float32, z in the camera's frame, 0 for none
    gain: Any,  # out (rows, W) float32, change of the other camera's phase with z, rad/mm
    variance: Any,  # out (rows, W) float32, of the other camera's phase
) -> Any:
    """Match pixels by their phase along the epipolar line; returns how many were matched, unmatched and ambiguous.

    Ambiguous: the phase occurs at more than one place of the epipolar line, in either camera.
    """
    matched = 0
    unmatched = 0
    ambiguous = 0
    bins = first.shape[1]
    for y in range(row_start, row_stop):
        for x in range(phase.shape[1]):
            out = y - row_start
            depth[out, x] = 0
            gain[out, x] = 0
            variance[out, x] = 0
            if state[y, x] != 0:
                continue
            nx = rays[y, x, 0]
            ny = rays[y, x, 1]
            rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
            here = (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) / rz
            row = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) / rz - frame[2]
            k = int((phase[y, x] - lowest) * per_rad)
            r = int(np.floor(row + 0.5))
            if r < 0 or r >= first.shape[0] or k < 0 or k >= bins:
                unmatched += 1
                continue
            if first[r, k] < 0:
                if k + 1 < bins and first[r, k + 1] >= 0:
                    k += 1
                elif k > 0 and first[r, k - 1] >= 0:
                    k -= 1
                else:
                    unmatched += 1
                    continue
            a = first[r, k]
            b = last[r, k]
            start = (a + b) / 2.0 - 0.5 if b - a <= 2 else a - 0.5
            found, there, slope, noise = solve_row(grid, stride, other_phase, other_sigma, other_state, step, phase[y, x], start, row)
            if not found:
                unmatched += 1
                continue
            if abs(slope) * SLOPE_REACH * np.sqrt(2.0) < SLOPE_SIGMAS * np.sqrt(noise):
                ambiguous += 1
                continue
            slack = 4.0 + 2.0 / (per_rad * abs(slope))
            own = frame[0] * here - frame[1]
            repeated = b - a > slack
            if first_here[r, k] >= 0:
                repeated |= abs(first_here[r, k] - own) > slack or abs(last_here[r, k] - own) > slack
            if repeated:
                ambiguous += 1
                continue
            parallax = here - (there + other_frame[1]) / other_frame[0]
            if parallax <= 0:
                unmatched += 1
                continue
            z = baseline / parallax / rz
            depth[out, x] = z
            gain[out, x] = slope * other_frame[0] * baseline / (rz * z * z)
            variance[out, x] = noise
            matched += 1
    return matched, unmatched, ambiguous


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def observe(
    rays: Any,
    phase: Any,
    turn: Any,
    frame: Any,
    other_frame: Any,
    grid: Any,
    stride: Any,
    other_phase: Any,
    other_sigma: Any,
    other_state: Any,
    step: Any,
    baseline: Any,
    depth: Any,  # (rows, W) float32
    row_start: int,
    row_stop: int,
    seen: Any,  # out (rows, W) uint8
    excess: Any,  # out (rows, W) float32, phase of the other camera at the point minus the pixel's own
    shift: Any,  # out (rows, W) float32, the same as a shift along the epipolar line in rectified pixels
    gain: Any,  # out (rows, W) float32
    variance: Any,  # out (rows, W) float32
) -> None:
    """Look at points of this camera with another one."""
    for y in range(row_start, row_stop):
        for x in range(phase.shape[1]):
            out = y - row_start
            seen[out, x] = BLANK
            excess[out, x] = 0
            shift[out, x] = 0
            gain[out, x] = 0
            variance[out, x] = 0
            z = depth[out, x]
            if z <= 0:
                continue
            nx = rays[y, x, 0]
            ny = rays[y, x, 1]
            rz = turn[2, 0] * nx + turn[2, 1] * ny + turn[2, 2]
            here = (turn[0, 0] * nx + turn[0, 1] * ny + turn[0, 2]) / rz
            row = frame[0] * (turn[1, 0] * nx + turn[1, 1] * ny + turn[1, 2]) / rz - frame[2]
            there = other_frame[0] * (here - baseline / (rz * z)) - other_frame[1]
            u, v, du, dv = direction_at(grid, stride, there, row)
            look, value, noise = sample(other_phase, other_sigma, other_state, step, u, v)
            if look == SEEN:
                known, slope = slope_along(other_phase, other_sigma, other_state, step, u, v, du, dv)
                if not known or abs(slope) < 1e-6:
                    look = PARTLY
                else:
                    excess[out, x] = value - phase[y, x]
                    shift[out, x] = excess[out, x] / slope
                    gain[out, x] = slope * other_frame[0] * baseline / (rz * z * z)
                    variance[out, x] = noise
            seen[out, x] = look


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def fuse(
    sigma: Any,  # (rows, W) float32, of this camera's phase
    depth: Any,  # (M, rows, W) float32, candidates, one per other camera
    gain: Any,  # (M, M, rows, W) float32, [candidate, camera]
    variance: Any,  # (M, M, rows, W)
    excess: Any,  # (M, M, rows, W)
    shift: Any,  # (M, M, rows, W)
    seen: Any,  # (M, M, rows, W) uint8
    sigmas: Any,
    tolerance_px: Any,
    z: Any,  # out (rows, W) float32
    z_sigma: Any,  # out (rows, W) float32
    bits: Any,  # out (rows, W) uint8, bit i: camera i of the others takes part
) -> int:
    """Choose the candidate no camera contradicts and most agree with; the depth is the least-squares solution of all that agree.

    Unknowns are z and the projector's true phase; one equation per camera. Returns how many pixels were contradicted.
    """
    count, rows, width = depth.shape
    contradicted = 0
    for y in range(rows):
        for x in range(width):
            z[y, x] = 0
            z_sigma[y, x] = 0
            bits[y, x] = 0
            best = -1
            best_support = 0
            tried = False
            own = sigma[y, x] * sigma[y, x]
            for k in range(count):
                if depth[k, y, x] <= 0:
                    continue
                tried = True
                support = 1
                for c in range(count):
                    if c == k or seen[k, c, y, x] != SEEN:
                        continue
                    slope = abs(excess[k, c, y, x] / shift[k, c, y, x]) if shift[k, c, y, x] != 0 else 0.0
                    ratio = gain[k, c, y, x] / gain[k, k, y, x]
                    noise = variance[k, c, y, x] + own * (ratio - 1) ** 2 + variance[k, k, y, x] * ratio**2
                    limit = sigmas * np.sqrt(noise) + tolerance_px * slope
                    if abs(excess[k, c, y, x]) > limit:
                        support = -100
                    else:
                        support += 1
                if support > best_support:
                    best_support = support
                    best = k
            if best < 0:
                contradicted += tried
                continue
            zz = 0.0
            zd = 0.0
            dd = 1.0 / (own + 1e-20)
            rz = 0.0
            rd = 0.0
            for c in range(count):
                if c != best and seen[best, c, y, x] != SEEN:
                    continue
                weight = 1.0 / (variance[best, c, y, x] + 1e-20)
                g = gain[best, c, y, x]
                e = excess[best, c, y, x]
                zz += weight * g * g
                zd -= weight * g
                dd += weight
                rz -= weight * g * e
                rd += weight * e
                bits[y, x] |= np.uint8(1 << c)
            determinant = zz * dd - zd * zd
            if determinant <= 0:
                continue
            z[y, x] = depth[best, y, x] + (rz * dd - zd * rd) / determinant
            z_sigma[y, x] = np.sqrt(dd / determinant)
    return contradicted


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def fit_planes(
    rays: Any,
    depth: Any,  # (H, W) float32, 0 for none
    sigma: Any,  # (H, W) float32, of the depth
    spacing: Any,  # pixel spacing on the plane z = 1
    steepest: Any,  # tangent of the largest incidence
    radius: int,
    stride: int,
    row_start: int,
    row_stop: int,
    normals: Any,  # out (H, W, 3) float32, unit, towards the camera
    residual: Any,  # out (H, W) float32, depth minus that of the local plane
    neighbours: Any,  # out (H, W) uint8
) -> None:
    """Fit a plane to the window of every point; on a plane the inverse depth is linear in the normalised coordinates."""
    height, width = depth.shape
    for y in range(row_start, row_stop):
        for x in range(width):
            neighbours[y, x] = 0
            residual[y, x] = 0
            normals[y, x, 0] = 0
            normals[y, x, 1] = 0
            normals[y, x, 2] = -1
            z = depth[y, x]
            if z <= 0:
                continue
            x0 = rays[y, x, 0]
            y0 = rays[y, x, 1]
            n = 0.0
            sx = sy = sxx = sxy = syy = sw = swx = swy = 0.0
            for v in range(y - radius, y + radius + 1, stride):
                if v < 0 or v >= height:
                    continue
                for u in range(x - radius, x + radius + 1, stride):
                    if u < 0 or u >= width or depth[v, u] <= 0:
                        continue
                    reach = max(abs(u - x), abs(v - y))
                    if abs(depth[v, u] - z) > reach * spacing * z * steepest + 4.0 * (sigma[v, u] + sigma[y, x]):
                        continue
                    dx = (rays[v, u, 0] - x0) / spacing
                    dy = (rays[v, u, 1] - y0) / spacing
                    w = z / depth[v, u] - 1.0
                    n += 1.0
                    sx += dx
                    sy += dy
                    sxx += dx * dx
                    sxy += dx * dy
                    syy += dy * dy
                    sw += w
                    swx += w * dx
                    swy += w * dy
            neighbours[y, x] = max(0, int(n) - 1)
            if n < 4:
                continue
            cxx = sxx - sx * sx / n
            cxy = sxy - sx * sy / n
            cyy = syy - sy * sy / n
            determinant = cxx * cyy - cxy * cxy
            if determinant <= 1e-6 * (cxx + cyy) * (cxx + cyy):
                neighbours[y, x] = 0
                continue
            cwx = swx - sw * sx / n
            cwy = swy - sw * sy / n
            p = (cwx * cyy - cwy * cxy) / determinant
            q = (cwy * cxx - cwx * cxy) / determinant
            middle = (sw - p * sx - q * sy) / n
            residual[y, x] = z * middle
            p /= spacing
            q /= spacing
            c = 1.0 + middle - p * x0 - q * y0
            length = np.sqrt(p * p + q * q + c * c)
            sign = -1.0 if p * x0 + q * y0 + c > 0 else 1.0
            normals[y, x, 0] = sign * p / length
            normals[y, x, 1] = sign * q / length
            normals[y, x, 2] = sign * c / length


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def root_of(parent: Any, index: int) -> int:
    """Return the representative of a pixel's island, shortening the way to it."""
    while parent[index] != index:
        parent[index] = parent[parent[index]]
        index = parent[index]
    return index


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def island_sizes(depth: Any, sigma: Any, spacing: Any, steepest: Any, size: Any) -> None:
    """Write into ``size`` (H, W) int32 how many points hang together with each, over neighbours without a depth step."""
    height, width = depth.shape
    parent = np.arange(height * width).astype(np.int32)
    for y in range(height):
        for x in range(width):
            z = depth[y, x]
            if z <= 0:
                continue
            for side in range(2):
                v = y - 1 if side else y
                u = x if side else x - 1
                if v < 0 or u < 0 or depth[v, u] <= 0:
                    continue
                if abs(depth[v, u] - z) <= spacing * z * steepest + 4.0 * (sigma[v, u] + sigma[y, x]):
                    a = root_of(parent, y * width + x)
                    b = root_of(parent, v * width + u)
                    if a != b:
                        parent[max(a, b)] = min(a, b)
    tally = np.zeros(height * width, np.int32)
    for y in range(height):
        for x in range(width):
            if depth[y, x] > 0:
                tally[root_of(parent, y * width + x)] += 1
    for y in range(height):
        for x in range(width):
            size[y, x] = tally[root_of(parent, y * width + x)] if depth[y, x] > 0 else 0


@njit(nogil=True, cache=True, fastmath=True, error_model="numpy")
def resample(
    phase: Any,
    sigma: Any,
    state: Any,
    step: Any,
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
            seen, value, variance = sample(phase, sigma, state, step, u, v)
            new_phase[y, x] = value
            new_sigma[y, x] = np.sqrt(variance)
            new_state[y, x] = 0
            if seen != SEEN:  # the reason of the nearest pixel
                i = int(np.floor(v + 0.5))
                j = int(np.floor(u + 0.5))
                inside = 0 <= i < state.shape[0] and 0 <= j < state.shape[1]
                new_state[y, x] = state[i, j] if inside and state[i, j] != 0 and state[i, j] != BORROWED else hole
