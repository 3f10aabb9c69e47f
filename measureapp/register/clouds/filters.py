"""Point filters: statistical and radius outlier removal, box, half-space, and removal of isolated patches.

Each returns the mask of the points to keep. Only positions are used: the result depends neither on the order of the points nor on the
unit of length.
"""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.errors import RegistrationError
from measureapp.progress import NoProgress, Progress

CHUNK = 200_000  # points between two cancellation points
COMPONENT_CELLS = 3.0  # in point spacings: edge of the cells whose 26-neighbourhood defines connectivity


def _refuse_too_few(points_mm: FloatArray, neighbours: int) -> None:
    if len(points_mm) <= neighbours:
        raise RegistrationError(
            f"A cloud of {len(points_mm)} points has no point with {neighbours} neighbours.", "Use a larger cloud or fewer neighbours."
        )


def _neighbour_distances(points_mm: FloatArray, ranks: list[int], most_mm: float, progress: Progress) -> FloatArray:
    """Return the distances (N, R) to the neighbours of these ranks (1: the point itself); infinite beyond ``most_mm``."""
    progress.report(0, 1, "building the search tree")
    tree, found = cKDTree(points_mm), np.empty((len(points_mm), len(ranks)))
    for start in range(0, len(points_mm), CHUNK):
        progress.report(start, len(points_mm), "searching neighbours")
        part = slice(start, start + CHUNK)
        found[part] = tree.query(points_mm[part], ranks, distance_upper_bound=most_mm, workers=-1)[0]
    return found


def statistical_inliers(
    points_mm: FloatArray,
    neighbours: int = 20,
    sigmas: float = 2.0,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> BoolArray:
    """Statistical outlier removal: keep points whose mean neighbour distance is at most the cloud's mean plus ``sigmas`` deviations [1]_.

    Raises
    ------
    RegistrationError
        The cloud has no more points than ``neighbours``.

    References
    ----------
    .. [1] R. B. Rusu et al., Robotics and Autonomous Systems 56(11), 927-941, 2008.
    """
    _refuse_too_few(points_mm, neighbours)
    mean = _neighbour_distances(points_mm, list(range(2, neighbours + 2)), np.inf, progress).mean(axis=1)
    return np.asarray(mean <= mean.mean() + sigmas * mean.std())


def radius_inliers(
    points_mm: FloatArray,
    radius_mm: float,
    least: int,
    progress: Progress = NoProgress(),  # noqa: B008 - stateless
) -> BoolArray:
    """Radius outlier removal: keep points with at least ``least`` others within a radius; raises as `statistical_inliers`."""
    _refuse_too_few(points_mm, least)
    return np.asarray(np.isfinite(_neighbour_distances(points_mm, [least + 1], float(np.nextafter(radius_mm, np.inf)), progress)[:, 0]))


def in_box(points_mm: FloatArray, low_mm: FloatArray, high_mm: FloatArray) -> BoolArray:
    """Return which points lie in an axis-aligned box, boundary included."""
    return np.asarray(((points_mm >= low_mm) & (points_mm <= high_mm)).all(axis=1))


def above_plane(points_mm: FloatArray, normal: FloatArray, offset_mm: float) -> BoolArray:
    """Return which points lie in the half-space ``n · p ≥ offset``; ``normal`` is normalised first."""
    length = float(np.linalg.norm(normal))
    if not length > 0:
        raise RegistrationError("The plane normal is 0 0 0.", "Give the direction of the side to keep.")
    return np.asarray(points_mm @ (np.asarray(normal) / length) >= offset_mm)


def in_large_components(points_mm: FloatArray, spacing_mm: float, least_mm2: float) -> BoolArray:
    """Connected components of the occupied cells: keep points of patches of at least ``least_mm2``; a point counts ``spacing_mm``²."""
    if len(points_mm) == 0:
        return np.zeros(0, np.bool_)
    index = np.floor(points_mm / (COMPONENT_CELLS * spacing_mm)).astype(np.int64)
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
    """Return the flat index steps to 13 of the 26 neighbours of a cell; the others follow by symmetry."""
    steps = [(x * extent[1] + y) * extent[2] + z for x in (-1, 0, 1) for y in (-1, 0, 1) for z in (-1, 0, 1)]
    return [int(step) for step in steps if step > 0]
