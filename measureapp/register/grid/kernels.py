"""Compiled kernels: voxel keys, and sums per voxel in a hash table."""

from __future__ import annotations

import numba
import numpy as np

from measureapp.arrays import FloatArray, IntArray

MULTIPLIER = np.int64(-7046029254386353131)  # 2^64 / golden ratio, as a signed number
EMPTY = np.int64(-1)
OFFSET = 1 << 19  # voxel indices run from -2^19 to 2^19 - 1
BITS = 20


@numba.njit(cache=True, nogil=True)
def voxel_keys(points: FloatArray, faces: IntArray, voxel: float) -> IntArray:
    """Return one key per point from its face and its voxel: (f, u, v, w) from the highest bits, w along the axis of face f."""
    keys = np.empty(len(points), np.int64)
    for i in range(len(points)):
        axis = faces[i] >> 1
        key = np.int64(faces[i])
        for step in range(3):
            index = np.int64(np.floor(points[i, (axis + 1 + step) % 3] / voxel)) + OFFSET
            key = (key << BITS) | (index & ((1 << BITS) - 1))
        keys[i] = key
    return keys


@numba.njit(cache=True, nogil=True)
def dominant_faces(normals: FloatArray) -> IntArray:
    """Return 2·axis + (component < 0) of each normal's largest component."""
    faces = np.empty(len(normals), np.uint8)
    for i in range(len(normals)):
        x, y, z = abs(normals[i, 0]), abs(normals[i, 1]), abs(normals[i, 2])
        axis = 0 if x >= y and x >= z else (1 if y >= z else 2)
        faces[i] = 2 * axis + (1 if normals[i, axis] < 0 else 0)
    return faces


@numba.njit(cache=True, nogil=True)
def facing_rows(
    points: FloatArray, normals: FloatArray, sigma: FloatArray, voxel: float, least_cosine: float
) -> tuple[IntArray, FloatArray]:
    """Return voxel keys (K,) and rows (K, 8) to be summed, for the points viewed at less than a limiting angle.

    A row is 1, the point, its normal, its variance; the points are in the camera's frame.
    """
    keys, rows = np.empty(len(points), np.int64), np.empty((len(points), 8))
    count, field = 0, (np.int64(1) << BITS) - 1
    for i in range(len(points)):
        x, y, z = points[i]
        n0, n1, n2 = np.float64(normals[i, 0]), np.float64(normals[i, 1]), np.float64(normals[i, 2])
        if abs(n0 * x + n1 * y + n2 * z) <= least_cosine * max(np.sqrt(x * x + y * y + z * z), 1e-9):
            continue
        u, v, w = np.int64(np.floor(y / voxel)), np.int64(np.floor(z / voxel)), np.int64(np.floor(x / voxel))
        keys[count] = ((u + OFFSET) & field) << (2 * BITS) | ((v + OFFSET) & field) << BITS | ((w + OFFSET) & field)
        row = rows[count]
        row[0], row[1], row[2], row[3], row[4], row[5], row[6] = 1.0, x, y, z, n0, n1, n2
        row[7] = np.float64(sigma[i]) * np.float64(sigma[i])
        count += 1
    return keys[:count], rows[:count]


@numba.njit(cache=True, nogil=True)
def rehash(keys: IntArray, table: IntArray) -> None:
    """Enter all keys into an empty table (its length a power of two)."""
    mask = len(table) - 1
    for entry in range(len(keys)):
        slot = (keys[entry] * MULTIPLIER >> 20) & mask
        while table[slot] != EMPTY:
            slot = (slot + 1) & mask
        table[slot] = entry


@numba.njit(cache=True, nogil=True)
def add_to_voxels(new_keys: IntArray, values: FloatArray, table: IntArray, keys: IntArray, sums: FloatArray, entries: int) -> int:
    """Add each row of ``values`` to the sums of its key; returns the new number of entries."""
    mask = len(table) - 1
    for i in range(len(new_keys)):
        key = new_keys[i]
        slot = (key * MULTIPLIER >> 20) & mask
        while table[slot] != EMPTY and keys[table[slot]] != key:
            slot = (slot + 1) & mask
        entry = table[slot]
        if entry == EMPTY:
            entry = entries
            table[slot] = entry
            keys[entry] = key
            entries += 1
        for k in range(values.shape[1]):
            sums[entry, k] += values[i, k]
    return entries
