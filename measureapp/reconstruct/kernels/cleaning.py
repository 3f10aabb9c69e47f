"""Compiled loops over a depth map: local planes and islands."""
# One loop over pixels cannot be cut into functions without leaving SIMD code.
# ruff: noqa: PLR0915

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit


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
