"""Drawing of triangles into a depth buffer and of what its pixels show: compiled loops, many times faster than a ray per pixel."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

EXACT: dict[str, Any] = {"nogil": True, "cache": True, "error_model": "numpy"}
OUTLINE_SHADE = 0.45


@njit(inline="always", **EXACT)
def _crossing(xa: float, ya: float, xb: float, yb: float, row: float) -> float:
    """Return where the edge between two corners crosses a row; the same for both triangles of an edge, so that nothing shows between them."""
    if yb < ya or (yb == ya and xb < xa):
        xa, ya, xb, yb = xb, yb, xa, ya
    return xa + (row - ya) / (yb - ya) * (xb - xa)


@njit(**EXACT)
def draw_triangles(corners: Any, triangles: Any, depth: Any, shown: Any, weights: Any) -> None:
    """Draw triangles into a depth buffer: each pixel whose centre lies in a triangle shows the nearest one.

    Parameters
    ----------
    corners : (V, 3) column, row and depth of each vertex; pixel (0, 0) has its centre at (0, 0)
    triangles : (T, 3)
    depth : (H, W) float64, infinite at first; filled with the depths of what is seen
    shown : (H, W) int64, filled with the triangle seen
    weights : (H, W, 3), filled with the barycentric coordinates of the pixel's centre in it
    """
    height, width = depth.shape
    for t in range(len(triangles)):
        i, j, k = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        xi, yi, xj, yj, xk, yk = corners[i, 0], corners[i, 1], corners[j, 0], corners[j, 1], corners[k, 0], corners[k, 1]
        doubled = (xj - xi) * (yk - yi) - (xk - xi) * (yj - yi)
        if doubled == 0.0 or np.ceil(min(xi, xj, xk)) > np.floor(max(xi, xj, xk)):  # flat, or between two columns as most of a fine mesh
            continue
        first, last = max(int(np.ceil(min(yi, yj, yk))), 0), min(int(np.floor(max(yi, yj, yk))), height - 1)
        for row in range(first, last + 1):
            left, right = np.inf, -np.inf
            for xa, ya, xb, yb in ((xi, yi, xj, yj), (xj, yj, xk, yk), (xk, yk, xi, yi)):
                if ya != yb and min(ya, yb) <= row <= max(ya, yb):
                    x = _crossing(xa, ya, xb, yb, row)
                    left, right = min(left, x), max(right, x)
            if left > right:
                continue
            for column in range(max(int(np.ceil(left)), 0), min(int(np.floor(right)), width - 1) + 1):
                b = ((column - xi) * (yk - yi) - (xk - xi) * (row - yi)) / doubled
                c = ((xj - xi) * (row - yi) - (column - xi) * (yj - yi)) / doubled
                a = 1.0 - b - c
                away = a * corners[i, 2] + b * corners[j, 2] + c * corners[k, 2]
                if away < depth[row, column]:
                    depth[row, column], shown[row, column] = away, t
                    weights[row, column, 0], weights[row, column, 1], weights[row, column, 2] = a, b, c


@njit(**EXACT)
def interpolate(values: Any, triangles: Any, pixels: Any, shown: Any, weights: Any, made: Any) -> None:
    """Interpolate values of vertices at the pixels that show a mesh.

    Parameters
    ----------
    values : (V, K)
    triangles : (T, 3)
    pixels : (N,) flat indices of the pixels
    shown, weights : (H·W,) and (H·W, 3), as drawn
    made : (N, K), filled
    """
    for n in range(len(pixels)):
        pixel = pixels[n]
        t, a, b, c = shown[pixel], weights[pixel, 0], weights[pixel, 1], weights[pixel, 2]
        i, j, k = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        for channel in range(values.shape[1]):
            made[n, channel] = a * values[i, channel] + b * values[j, channel] + c * values[k, channel]


@njit(**EXACT)
def smooth_normals(vertices: Any, triangles: Any, sums: Any, normals: Any) -> None:
    """Compute normals at the corners of triangles, smoothed over neighbours that face the same way.

    Parameters
    ----------
    vertices, triangles : (V, 3) and (T, 3)
    sums : (V, 3, 3) zeros, filled with Σ area · n nᵀ of the triangles at a vertex
    normals : (3T, 3), filled; of the corners of one triangle after the other
    """
    own, cross = np.empty(3), np.empty((len(triangles), 3))
    for t in range(len(triangles)):
        i, j, k = triangles[t, 0], triangles[t, 1], triangles[t, 2]
        bx, by, bz = vertices[j, 0] - vertices[i, 0], vertices[j, 1] - vertices[i, 1], vertices[j, 2] - vertices[i, 2]
        cx, cy, cz = vertices[k, 0] - vertices[i, 0], vertices[k, 1] - vertices[i, 1], vertices[k, 2] - vertices[i, 2]
        cross[t, 0], cross[t, 1], cross[t, 2] = by * cz - bz * cy, bz * cx - bx * cz, bx * cy - by * cx
        doubled = max(np.sqrt(cross[t, 0] ** 2 + cross[t, 1] ** 2 + cross[t, 2] ** 2), 1e-12)
        for corner in range(3):
            v = triangles[t, corner]
            for row in range(3):
                for column in range(3):
                    sums[v, row, column] += cross[t, row] * cross[t, column] / doubled
    for t in range(len(triangles)):
        doubled = max(np.sqrt(cross[t, 0] ** 2 + cross[t, 1] ** 2 + cross[t, 2] ** 2), 1e-12)
        for corner in range(3):
            v, squared = triangles[t, corner], 0.0
            for row in range(3):
                own[row] = (sums[v, row, 0] * cross[t, 0] + sums[v, row, 1] * cross[t, 1] + sums[v, row, 2] * cross[t, 2]) / doubled
                squared += own[row] ** 2
            length = max(np.sqrt(squared), 1e-30)
            for row in range(3):
                normals[3 * t + corner, row] = own[row] / length


@njit(**EXACT)
def first_of_blocks(pixels: Any, width: int, size: int, number: Any, first: Any) -> int:
    """Number the blocks of ``size`` × ``size`` pixels that hold any of ``pixels``; return how many there are.

    Parameters
    ----------
    pixels : (N,) flat indices of pixels in a picture of ``width``, ascending
    number : (N,), filled with the number of each pixel's block
    first : (N,), its start filled with the place in ``pixels`` of each block's first pixel
    """
    of_column = np.full(width // size + 1, -1)
    found, row_of_blocks = 0, -1
    for n in range(len(pixels)):
        row, column = pixels[n] // width // size, pixels[n] % width // size
        if row != row_of_blocks:
            of_column[:] = -1
            row_of_blocks = row
        if of_column[column] < 0:
            of_column[column] = found
            first[found] = n
            found += 1
        number[n] = of_column[column]
    return found


@njit(**EXACT)
def average(colours: Any, shade: Any, depth: Any, jump: float, far: float, size: int, picture: Any) -> None:
    """Average blocks of ``size`` × ``size`` pixels into a picture of 8 bits, with outlines where the depth jumps, on white.

    Parameters
    ----------
    colours, shade : (N, 3) in 0…1 and (N,) of the pixels with a finite depth, row by row
    depth : (H, W)
    jump : difference in depth to a neighbour that is an outline's
    far : depth of the background
    picture : (H/size, W/size, 3) uint8, filled
    """
    height, width = depth.shape
    n = 0
    for row in range(height // size):
        sums = np.zeros((width // size, 3))
        for r in range(row * size, (row + 1) * size):
            for c in range(width):
                hit = np.isfinite(depth[r, c])
                away = depth[r, c] if hit else far
                outline = False
                for down, across in ((-1, 0), (1, 0), (0, -1), (0, 1)):
                    if 0 <= r + down < height and 0 <= c + across < width:
                        beside = depth[r + down, c + across]
                        outline |= (beside if np.isfinite(beside) else far) - away > jump
                light = OUTLINE_SHADE if outline else 1.0
                for channel in range(3):
                    sums[c // size, channel] += light * colours[n, channel] * shade[n] if hit else light
                n += hit
        for column in range(width // size):
            for channel in range(3):
                picture[row, column, channel] = min(max(np.rint(sums[column, channel] / size**2 * 255), 0), 255)


@njit(**EXACT)
def mean_of_facing(away: Any, near: Any, normals: Any, towards: Any, values: Any, facing: float, blur: float, means: Any) -> None:
    """Average values of neighbours that face the same way, weighted by 1 / (blur + distance).

    Parameters
    ----------
    away, near : (N, K) distances and indices of neighbours, nearest first; infinite where there is no further one
    normals, values : (M, 3) and (M,) of the neighbours
    towards : (N, 3) normals of the places; of neighbours that count, the cosine to it is above ``facing``
    means : (N,), filled; NaN where no neighbour counts
    """
    for n in range(len(near)):
        total, weights = 0.0, 0.0
        for k in range(near.shape[1]):
            if not np.isfinite(away[n, k]):
                break
            m = near[n, k]
            if normals[m, 0] * towards[n, 0] + normals[m, 1] * towards[n, 1] + normals[m, 2] * towards[n, 2] > facing:
                weight = 1.0 / (blur + away[n, k])
                total += weight * values[m]
                weights += weight
        means[n] = total / weights if weights > 0.0 else np.nan
