"""Voxel sums, accumulated view by view so that all points are never in memory at once."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray

CHUNK = 262_144


class VoxelSums:
    """Sums of rows by key; the order of the points changes them by rounding only."""

    def __init__(self, width: int) -> None:
        self._keys = np.empty(CHUNK, np.int64)
        self._sums = np.zeros((CHUNK, width))
        self._table = np.full(4 * CHUNK, -1, np.int64)
        self._entries = 0

    def add(self, keys: IntArray, values: FloatArray) -> None:
        """Add ``values`` (N, width) to the sums of ``keys`` (N,)."""
        from measureapp.register.grid.kernels import add_to_voxels

        for start in range(0, len(keys), CHUNK):
            part = slice(start, start + CHUNK)
            self._make_room(len(keys[part]))
            rows = np.ascontiguousarray(values[part], np.float64)
            self._entries = add_to_voxels(keys[part], rows, self._table, self._keys, self._sums, self._entries)

    def sorted(self) -> tuple[IntArray, FloatArray]:
        """Return the keys in ascending order and their sums."""
        order = np.argsort(self._keys[: self._entries])
        return self._keys[order], self._sums[order]

    def _make_room(self, more: int) -> None:
        from measureapp.register.grid.kernels import rehash

        needed = self._entries + more
        if needed > len(self._keys):
            grown = max(needed, 2 * len(self._keys))
            self._keys = np.concatenate([self._keys, np.empty(grown - len(self._keys), np.int64)])
            self._sums = np.concatenate([self._sums, np.zeros((grown - len(self._sums), self._sums.shape[1]))])
        if 2 * needed > len(self._table):
            self._table = np.full(1 << int(np.ceil(np.log2(4 * needed))), -1, np.int64)
            rehash(self._keys[: self._entries], self._table)
