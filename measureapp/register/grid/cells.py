"""Cell index: points sorted by grid cell, for neighbour searches in compiled kernels."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Self

import numpy as np

from measureapp.arrays import FloatArray, IntArray


@dataclass(frozen=True, slots=True, eq=False)
class CellIndex:
    """Start of each cell's points in an array sorted by cell."""

    edge_mm: float
    keys: IntArray  # (C,), of the occupied cells
    starts: IntArray  # (C + 1,), points starts[c] … starts[c + 1] - 1 are in cell c
    table: IntArray  # hash table of the keys; its length is a power of two

    @classmethod
    def build(cls, points_mm: FloatArray, edge_mm: float) -> tuple[Self, IntArray]:
        """Return the index of points (M, 3), and the order (M,) that sorts them for it."""
        from measureapp.register.grid.kernels import rehash, voxel_keys

        keys = voxel_keys(np.ascontiguousarray(points_mm), np.zeros(len(points_mm), np.uint8), edge_mm)
        order = np.argsort(keys, kind="stable")
        occupied, starts = np.unique(keys[order], return_index=True)
        table = np.full(1 << int(np.ceil(np.log2(max(4 * len(occupied), 2)))), -1, np.int64)
        rehash(occupied, table)
        return cls(edge_mm, occupied, np.append(starts, len(keys)).astype(np.int64), table), order
