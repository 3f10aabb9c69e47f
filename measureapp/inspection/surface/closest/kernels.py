"""Closest point by a hierarchy of boxes: a compiled loop over query points, in double precision. Statement: `reference.closest_on_triangles`."""

from __future__ import annotations

from typing import Any

import numpy as np
from numba import njit

# Unlike the kernels of images no fastmath: differences of nearly equal numbers are what it is about.
EXACT: dict[str, Any] = {"nogil": True, "cache": True, "error_model": "numpy"}
STACK = 128  # nodes that wait: two per level suffice


@njit(inline="always", **EXACT)
def _box_squared(nodes: Any, node: int, x: float, y: float, z: float) -> float:
    """Return the squared distance of a point from a box."""
    dx = max(nodes[node, 0] - x, 0.0, x - nodes[node, 3])
    dy = max(nodes[node, 1] - y, 0.0, y - nodes[node, 4])
    dz = max(nodes[node, 2] - z, 0.0, z - nodes[node, 5])
    return dx * dx + dy * dy + dz * dz


@njit(inline="always", **EXACT)
def _on_triangle(t: Any, k: int, x: float, y: float, z: float) -> tuple[float, float]:
    """Return the weights of the second and third corner at the closest point (C. Ericson, Real-Time Collision Detection, 5.1.5)."""
    bx, by, bz, cx, cy, cz = t[k, 3], t[k, 4], t[k, 5], t[k, 6], t[k, 7], t[k, 8]
    px, py, pz = x - t[k, 0], y - t[k, 1], z - t[k, 2]
    d1, d2 = bx * px + by * py + bz * pz, cx * px + cy * py + cz * pz
    if d1 <= 0 and d2 <= 0:
        return 0.0, 0.0
    bb, bc, cc = t[k, 9], t[k, 10], t[k, 11]
    d3, d4 = d1 - bb, d2 - bc
    if d3 >= 0 and d4 <= d3:
        return 1.0, 0.0
    d5, d6 = d1 - bc, d2 - cc
    if d6 >= 0 and d5 <= d6:
        return 0.0, 1.0
    vc = d1 * d4 - d3 * d2
    if vc <= 0 and d1 >= 0 and d3 <= 0:
        return d1 / (d1 - d3), 0.0
    vb = d5 * d2 - d1 * d6
    if vb <= 0 and d2 >= 0 and d6 <= 0:
        return 0.0, d2 / (d2 - d6)
    va = d3 * d6 - d5 * d4
    if va <= 0 and d4 - d3 >= 0 and d5 - d6 >= 0:
        w = (d4 - d3) / ((d4 - d3) + (d5 - d6))
        return 1.0 - w, w
    total = va + vb + vc
    return vb / total, vc / total


@njit(inline="always", **EXACT)
def _squared(t: Any, k: int, v: float, w: float, x: float, y: float, z: float) -> float:
    """Return the squared distance of a point from the place with these weights in a triangle."""
    dx = t[k, 0] + v * t[k, 3] + w * t[k, 6] - x
    dy = t[k, 1] + v * t[k, 4] + w * t[k, 7] - y
    dz = t[k, 2] + v * t[k, 5] + w * t[k, 8] - z
    return dx * dx + dy * dy + dz * dz


@njit(**EXACT)
def search(points: Any, nodes: Any, references: Any, shapes: Any, start: int, stop: int, found: Any, weights: Any) -> None:
    """Find the closest triangle and the weights of its second and third corner, for the points ``start`` to ``stop``.

    Parameters
    ----------
    points : (N, 3) float64
    nodes : (2P, 6) boxes of a complete binary tree, root at 1, children of i at 2i and 2i + 1; the last P are its leaves
    references : (P · R,) triangles, R per leaf, in the order of the leaves
    shapes : (T, 12) first corner, both edges from it and their products
    found : (N,) int64, filled; beforehand a triangle likely to be near, which shortens the search, or -1
    weights : (N, 2), filled
    """
    waiting = np.empty(STACK, np.int64)
    least = np.empty(STACK)
    first_leaf = len(nodes) // 2
    leaf = len(references) // first_leaf
    for n in range(start, stop):
        x, y, z = points[n, 0], points[n, 1], points[n, 2]
        best, which, v, w = np.inf, found[n], 0.0, 0.0
        if which >= 0:
            v, w = _on_triangle(shapes, which, x, y, z)
            best = _squared(shapes, which, v, w, x, y, z)
        waiting[0], least[0], depth = 1, 0.0, 1
        while depth > 0:
            depth -= 1
            node = waiting[depth]
            if least[depth] >= best:
                continue
            while node < first_leaf:
                near, far = 2 * node, 2 * node + 1
                away, further = _box_squared(nodes, near, x, y, z), _box_squared(nodes, far, x, y, z)
                if further < away:
                    near, far, away, further = far, near, further, away
                if further < best:
                    waiting[depth], least[depth] = far, further
                    depth += 1
                if away >= best:
                    node = -1
                    break
                node = near
            if node < 0:
                continue
            for r in range((node - first_leaf) * leaf, (node - first_leaf + 1) * leaf):
                k = references[r]
                if k == which:
                    continue
                tv, tw = _on_triangle(shapes, k, x, y, z)
                squared = _squared(shapes, k, tv, tw, x, y, z)
                if squared < best:
                    best, which, v, w = squared, k, tv, tw
        found[n], weights[n, 0], weights[n, 1] = which, v, w
