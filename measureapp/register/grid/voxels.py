"""Voxel sums, accumulated view by view so that all points are never in memory at once."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray

CHUNK = 262_144
GROWTH = 1.3  # in place: no second copy while it grows


class VoxelSums:
    """Sums of rows by key; the order of the points changes them by rounding only."""

    def __init__(self, width: int) -> None:
        self._width = width
        self._clear()

    def _clear(self) -> None:
        self._keys, self._sums = np.empty(0, np.int64), np.zeros((0, self._width))
        self._table = np.full(2, -1, np.int32)  # of entries by key, its length a power of two
        self._entries = 0

    def add(self, keys: IntArray, values: FloatArray) -> None:
        """Add ``values`` (N, width) to the sums of ``keys`` (N,)."""
        from measureapp.register.grid.kernels import add_to_voxels

        for start in range(0, len(keys), CHUNK):
            part = slice(start, start + CHUNK)
            self._make_room(len(keys[part]))
            rows = np.ascontiguousarray(values[part], np.float64)
            self._entries = add_to_voxels(keys[part], rows, self._table, self._keys, self._sums, self._entries)

    def pop_sorted(self) -> tuple[IntArray, FloatArray]:
        """Return the keys in ascending order and their sums, which are then no longer held here."""
        keys, sums = self._keys[: self._entries], self._sums[: self._entries]
        self._clear()
        order = np.argsort(keys)
        for column in range(self._width):  # in place: the sums are the largest of all arrays of a stitching
            sums[:, column] = sums[order, column]
        return keys[order], sums

    def _make_room(self, more: int) -> None:
        from measureapp.register.grid.kernels import rehash

        needed = self._entries + more
        if needed > len(self._keys):
            grown = max(needed, int(GROWTH * len(self._keys)))
            self._keys.resize(grown, refcheck=False)
            self._sums.resize((grown, self._width), refcheck=False)
        if 2 * needed > len(self._table):
            self._table = np.full(1 << int(np.ceil(np.log2(3 * needed))), -1, np.int32)
            rehash(self._keys[: self._entries], self._table)
