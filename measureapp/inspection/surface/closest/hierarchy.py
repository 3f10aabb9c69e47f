"""Hierarchy of boxes around the triangles of a mesh."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray, in_bands
from measureapp.compiled.selection import use_reference
from measureapp.inspection.surface.closest.boxes import References, box_references
from measureapp.inspection.surface.closest.reference import closest_on_triangles

LEAF = 2  # references per leaf
BITS = 21  # of each coordinate in a Morton code
SPREAD = ((32, 0x1F00000000FFFF), (16, 0x1F0000FF0000FF), (8, 0x100F00F00F00F00F), (4, 0x10C30C30C30C30C3), (2, 0x1249249249249249))


class TriangleHierarchy:
    """Closest points of triangles (T, 3, 3): a complete binary tree of boxes over slices of them, in Morton order."""

    def __init__(self, corners_mm: FloatArray) -> None:
        corners = np.ascontiguousarray(corners_mm, dtype=np.float64)
        edges = corners[:, 1:] - corners[:, :1]
        products = np.einsum("tid,tjd->tij", edges, edges).reshape(-1, 4)[:, [0, 1, 3]]
        self._shapes = np.ascontiguousarray(np.concatenate([corners[:, 0], edges.reshape(-1, 6), products], axis=1))
        self._nodes, self._references = _build_tree(box_references(corners))

    def closest(self, points_mm: FloatArray, near: IntArray | None = None) -> tuple[IntArray, FloatArray]:
        """Return the closest triangle (N,) to each point (N, 3), and the barycentric coordinates (N, 3) of the closest point in it.

        Parameters
        ----------
        near : (N,), triangles that were closest before the points moved a little: the answer is the same, and sooner found
        """
        from measureapp.inspection.surface.closest.kernels import search

        if use_reference():
            return closest_on_triangles(points_mm, self._shapes[:, :9].reshape(-1, 3, 3))
        points = np.array(points_mm, dtype=np.float64, order="C")  # a copy: for read-only points the kernel would be compiled once more
        found = np.full(len(points), -1, np.int64) if near is None else near.astype(np.int64)
        weights = np.empty((len(points), 2))
        in_bands(
            lambda start, stop: search(points, self._nodes, self._references, self._shapes, start, stop, found, weights),
            len(points),
        )
        return found, np.column_stack([1 - weights.sum(axis=1), weights])


def _build_tree(boxes: References) -> tuple[FloatArray, IntArray]:
    """Return the nodes (2P, 6) and the triangles (P · LEAF,) of their leaves; the last box is repeated up to a power of two."""
    order = np.argsort(_morton_codes((boxes.low_mm + boxes.high_mm) / 2))
    leaves = 1 << max(int(np.ceil(np.log2(len(order) / LEAF))), 0)
    order = np.concatenate([order, np.repeat(order[-1:], leaves * LEAF - len(order))])
    nodes = np.empty((2 * leaves, 6))
    nodes[leaves:, :3] = boxes.low_mm[order].reshape(leaves, LEAF, 3).min(axis=1)
    nodes[leaves:, 3:] = boxes.high_mm[order].reshape(leaves, LEAF, 3).max(axis=1)
    while leaves > 1:
        pairs = nodes[leaves : 2 * leaves].reshape(-1, 2, 6)
        leaves //= 2
        nodes[leaves : 2 * leaves, :3] = pairs[:, :, :3].min(axis=1)
        nodes[leaves : 2 * leaves, 3:] = pairs[:, :, 3:].max(axis=1)
    return nodes, boxes.triangles[order]


def _morton_codes(places_mm: FloatArray) -> IntArray:
    """Return the interleaved bits (N,) of the three coordinates, which neighbours share mostly."""
    low = places_mm.min(axis=0)
    extent = max(float((places_mm.max(axis=0) - low).max()), 1e-300)
    cells = ((places_mm - low) * ((2**BITS - 1) / extent)).astype(np.uint64)
    codes = np.zeros(len(places_mm), np.uint64)
    for axis in range(3):
        codes |= _spread(cells[:, axis]) << np.uint64(axis)
    return codes


def _spread(bits: IntArray) -> IntArray:
    """Insert two zero bits after each of the lowest 21 bits."""
    for shift, mask in SPREAD:
        bits = (bits | (bits << np.uint64(shift))) & np.uint64(mask)
    return bits
