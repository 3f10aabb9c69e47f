"""Compiled kernels of pairwise registration: nearest neighbours, correspondences and normal equations."""

from __future__ import annotations

from typing import NamedTuple

import numba
import numpy as np

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.register.grid.kernels import BITS, EMPTY, MULTIPLIER, OFFSET

NONE = -1


class SortedPoints(NamedTuple):
    """Points sorted by the cells of a `CellIndex`, as kernels take them."""

    points: FloatArray  # (M, 3)
    normals: FloatArray  # (M, 3)
    edge: float
    keys: IntArray
    starts: IntArray
    table: IntArray


class MatchLimits(NamedTuple):
    """Limits of corresponding points."""

    search: float  # largest distance
    least_agreement: float  # cosine between the normals
    sideways: float  # largest offset along the surface


@numba.njit(cache=True, nogil=True)
def _cell(x: int, y: int, z: int, keys: IntArray, table: IntArray) -> int:
    """Return the index of a cell; -1 when it is empty. The key is that of ``voxel_keys`` with face 0."""
    field = (np.int64(1) << BITS) - 1
    key = ((y + OFFSET) & field) << (2 * BITS) | ((z + OFFSET) & field) << BITS | ((x + OFFSET) & field)
    mask = len(table) - 1
    slot = (key * MULTIPLIER >> 20) & mask
    while table[slot] != EMPTY:
        if keys[table[slot]] == key:
            return table[slot]
        slot = (slot + 1) & mask
    return NONE


@numba.njit(cache=True, nogil=True)
def _gap(x: float, cell: int, edge: float) -> float:
    """Return the distance of a coordinate from a cell; zero inside."""
    return max(cell * edge - x, x - (cell + 1) * edge, 0.0)


@numba.njit(cache=True, nogil=True)
def _squared_length(x: float, y: float, z: float) -> float:
    return x * x + y * y + z * z


@numba.njit(cache=True, nogil=True)
def find_nearest(x: float, y: float, z: float, target: SortedPoints, search: float) -> tuple[np.int64, float]:
    """Nearest-neighbour search: return the index of the nearest point within ``search`` (-1: none) and its squared distance.

    Shells of cells are searched outwards until no further cell can contain a nearer point.
    """
    points, edge, starts = target.points, target.edge, target.starts
    i, j, k = np.int64(np.floor(x / edge)), np.int64(np.floor(y / edge)), np.int64(np.floor(z / edge))
    margin = min(x - i * edge, (i + 1) * edge - x, y - j * edge, (j + 1) * edge - y, z - k * edge, (k + 1) * edge - z)
    best, found = search * search, np.int64(NONE)
    for shell in range(int(np.ceil(search / edge)) + 1):
        reach = margin + (shell - 1) * edge
        if shell > 0 and reach * reach >= best:
            break
        for a in range(i - shell, i + shell + 1):
            for b in range(j - shell, j + shell + 1):
                inside = abs(a - i) < shell and abs(b - j) < shell
                for c in range(k - shell, k + shell + 1, 2 * shell if inside else 1):
                    gap = _squared_length(_gap(x, a, edge), _gap(y, b, edge), _gap(z, c, edge))
                    if gap >= best:
                        continue
                    cell = _cell(a, b, c, target.keys, target.table)
                    if cell == NONE:
                        continue
                    for n in range(starts[cell], starts[cell + 1]):
                        dx, dy, dz = points[n, 0] - x, points[n, 1] - y, points[n, 2] - z
                        square = dx * dx + dy * dy + dz * dz
                        if square < best:
                            best, found = square, np.int64(n)
    return found, best


@numba.njit(cache=True, nogil=True)
def find_interior(cloud: SortedPoints, least: int, same_face: float, offset: float) -> BoolArray:
    """Return which points have neighbours of their own face on all sides, within the radius of one ``edge``.

    These are at least ``least`` neighbours and half of all, with their centroid closer than ``offset`` of their mean distance.
    """
    points, normals, edge, starts = cloud.points, cloud.normals, cloud.edge, cloud.starts
    inner = np.zeros(len(points), np.bool_)
    firsts, ends = np.empty(27, np.int64), np.empty(27, np.int64)
    for own in range(len(cloud.keys)):
        first = starts[own]
        i, j, k = (
            np.int64(np.floor(points[first, 0] / edge)),
            np.int64(np.floor(points[first, 1] / edge)),
            np.int64(np.floor(points[first, 2] / edge)),
        )
        around = 0  # neighbouring cells, found once for all points of a cell
        for a in range(i - 1, i + 2):
            for b in range(j - 1, j + 2):
                for c in range(k - 1, k + 2):
                    cell = _cell(a, b, c, cloud.keys, cloud.table)
                    if cell != NONE:
                        firsts[around], ends[around] = starts[cell], starts[cell + 1]
                        around += 1
        for p in range(first, starts[own + 1]):
            x, y, z = points[p]
            count, same, reach, sx, sy, sz = 0, 0, 0.0, 0.0, 0.0, 0.0
            for part in range(around):
                for n in range(firsts[part], ends[part]):
                    dx, dy, dz = points[n, 0] - x, points[n, 1] - y, points[n, 2] - z
                    square = dx * dx + dy * dy + dz * dz
                    if n == p or square > edge * edge:
                        continue
                    count += 1
                    reach += np.sqrt(square)
                    agreement = normals[p, 0] * normals[n, 0] + normals[p, 1] * normals[n, 1] + normals[p, 2] * normals[n, 2]
                    if agreement > same_face:
                        same += 1
                        sx, sy, sz = sx + dx, sy + dy, sz + dz
            inner[p] = same >= least and 2 * same >= count and np.sqrt(sx * sx + sy * sy + sz * sz) < offset * reach
    return inner


@numba.njit(cache=True, nogil=True)
def match_points(
    points: FloatArray, normals: FloatArray, stride: int, rotation: FloatArray, shift: FloatArray, target: SortedPoints, limits: MatchLimits
) -> tuple[IntArray, IntArray, FloatArray, float]:
    """Find corresponding points of a source (moved by rotation and shift) and a sorted target.

    Returns
    -------
    own, other : (K,) indices of source and target points
    rows : (K, 7), moved source point, unit mean normal, distance from the target along it
    disagreement : mean square of half the difference of the normals, along each of their two tangents
    """
    most = (len(points) + stride - 1) // stride
    own, other, rows = np.empty(most, np.int64), np.empty(most, np.int64), np.empty((most, 7))
    count, disagreement = 0, 0.0
    for p in range(0, len(points), stride):
        moved = (
            rotation[0, 0] * points[p, 0] + rotation[0, 1] * points[p, 1] + rotation[0, 2] * points[p, 2] + shift[0],
            rotation[1, 0] * points[p, 0] + rotation[1, 1] * points[p, 1] + rotation[1, 2] * points[p, 2] + shift[1],
            rotation[2, 0] * points[p, 0] + rotation[2, 1] * points[p, 1] + rotation[2, 2] * points[p, 2] + shift[2],
        )
        q, square = find_nearest(moved[0], moved[1], moved[2], target, limits.search)
        if q == NONE:
            continue
        agreement, length, across = 0.0, 0.0, 0.0
        for c in range(3):
            turned = rotation[c, 0] * normals[p, 0] + rotation[c, 1] * normals[p, 1] + rotation[c, 2] * normals[p, 2]
            agreement += turned * target.normals[q, c]
            both = turned + target.normals[q, c]
            rows[count, 3 + c] = both
            length += both * both
            across += (moved[c] - target.points[q, c]) * both
        length = np.sqrt(length)
        if agreement <= limits.least_agreement:
            continue
        across /= length
        if square - across * across >= limits.sideways * limits.sideways:
            continue
        for c in range(3):
            rows[count, c] = moved[c]
            rows[count, 3 + c] /= length
        rows[count, 6] = across
        own[count], other[count] = p, q
        disagreement += (2 - 2 * agreement) / 8
        count += 1
    return own[:count].copy(), other[:count].copy(), rows[:count].copy(), disagreement / max(count, 1)


@numba.njit(cache=True, nogil=True)
def normal_equations(
    arm: FloatArray, normal: FloatArray, residual: FloatArray, weight: FloatArray, tilt: float
) -> tuple[FloatArray, FloatArray]:
    """Return the normal matrix (6, 6) and right side (6,) of point-to-plane distances, about the origin of ``arm``.

    Errors of the normals (standard deviation ``tilt``, rad) make a plane appear to constrain motion along itself. This bias is
    subtracted from the matrix: ``tilt``² times the same sum with both tangents in place of the normal.
    """
    matrix, right, j = np.zeros((6, 6)), np.zeros(6), np.empty(6)
    whole = np.zeros((6, 6))
    square = tilt * tilt
    for i in range(len(arm)):
        w = weight[i]
        if w == 0:
            continue
        x, y, z = arm[i]
        n0, n1, n2 = normal[i]
        j[0], j[1], j[2] = n0, n1, n2
        j[3], j[4], j[5] = y * n2 - z * n1, z * n0 - x * n2, x * n1 - y * n0
        for a in range(6):
            wa = w * j[a]
            right[a] -= wa * residual[i]
            for b in range(a, 6):
                matrix[a, b] += wa * j[b]
        # sum over the normal and both tangents
        whole[0, 0] += w
        whole[0, 4] += w * z
        whole[0, 5] -= w * y
        whole[1, 3] -= w * z
        whole[1, 5] += w * x
        whole[2, 3] += w * y
        whole[2, 4] -= w * x
        whole[3, 3] += w * (y * y + z * z)
        whole[3, 4] -= w * x * y
        whole[3, 5] -= w * x * z
        whole[4, 4] += w * (x * x + z * z)
        whole[4, 5] -= w * y * z
        whole[5, 5] += w * (x * x + y * y)
    whole[1, 1] = whole[2, 2] = whole[0, 0]
    for a in range(6):
        for b in range(a, 6):
            matrix[a, b] = (1 + square) * matrix[a, b] - square * whole[a, b]
            matrix[b, a] = matrix[a, b]
    return matrix, right
