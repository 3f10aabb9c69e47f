"""Filters of points: what stands alone, what lies outside of a box or beyond a plane, what hangs together with little.

Each returns the mask of the points that stay and looks at places only, so that neither the points' order nor the unit of length matters.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.errors import RegistrationError
from measureapp.progress import NoProgress, Progress

AT_ONCE = 200_000  # points between two occasions to cancel
ISLAND_CELLS = 3.0  # in spacings: points in touching cells of this size hang together


def _refuse_too_few(points_mm: FloatArray, neighbours: int) -> None:
    if len(points_mm) <= neighbours:
        raise RegistrationError(
            f"Of {len(points_mm)} points none has {neighbours} neighbours.", "Give a larger cloud, or ask for fewer neighbours."
        )


def _distances(points_mm: FloatArray, ranks: list[int], most_mm: float, progress: Progress) -> FloatArray:
    """Return the distance of every point to its neighbours of these ranks (1: the point itself), infinite beyond ``most_mm``."""
    progress.report(0, 1, "ordering the points")
    tree, found = cKDTree(points_mm), np.empty((len(points_mm), len(ranks)))
    for start in range(0, len(points_mm), AT_ONCE):
        progress.report(start, len(points_mm), "looking at neighbours")
        part = slice(start, start + AT_ONCE)
        found[part] = tree.query(points_mm[part], ranks, distance_upper_bound=most_mm, workers=-1)[0]
    return found


def statistical(
    points_mm: FloatArray,
    neighbours: int = 20,
    sigmas: float = 2.0,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> BoolArray:
    """Return which points have a mean distance to their neighbours within ``sigmas`` standard deviations of the cloud's mean [1]_.

    Raises
    ------
    RegistrationError
        There are not more points than neighbours asked for.

    References
    ----------
    .. [1] R. B. Rusu et al., Robotics and Autonomous Systems 56(11), 927-941, 2008.
    """
    _refuse_too_few(points_mm, neighbours)
    mean = _distances(points_mm, list(range(2, neighbours + 2)), np.inf, progress).mean(axis=1)
    return np.asarray(mean <= mean.mean() + sigmas * mean.std())


def crowded(
    points_mm: FloatArray,
    radius_mm: float,
    least: int,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> BoolArray:
    """Return which points have at least ``least`` others within a radius; raises RegistrationError as `statistical`."""
    _refuse_too_few(points_mm, least)
    return np.asarray(np.isfinite(_distances(points_mm, [least + 1], float(np.nextafter(radius_mm, np.inf)), progress)[:, 0]))


def in_box(points_mm: FloatArray, low_mm: FloatArray, high_mm: FloatArray) -> BoolArray:
    """Return which points lie in a box along the axes, its sides included."""
    return np.asarray(((points_mm >= low_mm) & (points_mm <= high_mm)).all(axis=1))


def above_plane(points_mm: FloatArray, normal: FloatArray, offset_mm: float) -> BoolArray:
    """Return which points lie on the side of the plane ``n · p = offset`` that its normal (of any length) shows to, or in it."""
    length = float(np.linalg.norm(normal))
    if not length > 0:
        raise RegistrationError("A plane with the normal 0 0 0 has no sides.", "Give the direction of the side to keep.")
    return np.asarray(points_mm @ (np.asarray(normal) / length) >= offset_mm)


def in_large_patches(points_mm: FloatArray, spacing_mm: float, least_mm2: float) -> BoolArray:
    """Return which points belong to a connected patch of at least ``least_mm2``, each standing for a square of the spacing."""
    if len(points_mm) == 0:
        return np.zeros(0, np.bool_)
    index = np.floor(points_mm / (ISLAND_CELLS * spacing_mm)).astype(np.int64)
    index -= index.min(axis=0)
    extent = index.max(axis=0) + 3
    flat = (index[:, 0] * extent[1] + index[:, 1]) * extent[2] + index[:, 2]
    cells, inverse = np.unique(flat, return_inverse=True)
    rows, columns = [], []
    for step in _half_neighbours(extent):
        place = np.searchsorted(cells, cells + step)
        place[place == len(cells)] = 0
        found = np.flatnonzero(cells[place] == cells + step)
        rows.append(found)
        columns.append(place[found])
    i, j = np.concatenate(rows), np.concatenate(columns)
    _, label = connected_components(coo_matrix((np.ones(len(i), np.int8), (i, j)), (len(cells), len(cells))), directed=False)
    sizes = np.bincount(label[inverse])
    return np.asarray(sizes[label[inverse]] * spacing_mm**2 >= least_mm2)


def _half_neighbours(extent: IntArray) -> list[int]:
    """Return the flat steps to 13 of the 26 neighbours of a cell; the others come by symmetry."""
    steps = [(x * extent[1] + y) * extent[2] + z for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)]
    return [int(step) for step in steps if step > 0]
