"""Drawing of triangles into a depth buffer, a compiled loop: for long narrow triangles many times faster than a ray per pixel."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

EXACT: dict[str, Any] = {"nogil": True, "cache": True, "error_model": "numpy"}


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
        if doubled == 0.0:
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
