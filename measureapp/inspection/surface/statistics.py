"""Statistics of a deviation from the nominal: the numbers that legend, window, report and JSON show."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial import cKDTree

from measureapp.arrays import BoolArray, FloatArray, IntArray
from measureapp.data.mesh import Mesh
from measureapp.inspection.measured_points import sample_mesh
from measureapp.inspection.surface.deviation import COVERAGE_SAMPLES, Deviation, search_tree
from measureapp.inspection.surface.deviation_index import SAME_SIDE, DeviationIndex
from measureapp.inspection.surface.ray_distances import REACH_MM
from measureapp.inspection.surface.round_numbers import round_up

RANGE_PERCENTILE = 99.5  # of the absolute deviations: a scale never follows single extremes
AGREEING, AMONG = 5, 12  # least number of agreeing neighbours of an extreme, among the nearest ones
AGREE_SIGMAS = 4.0
REACH_SPACINGS = 4.0  # greatest distance of those neighbours, in point spacings
FIRST_CANDIDATES = 512
FAR_REACH = 5.0  # search distances within which a point that is too far still belongs to a place
SMALLEST_RANGE_MM = 1e-3


@dataclass(frozen=True, slots=True, eq=False)
class Extreme:
    """An extreme deviation that its neighbours confirm."""

    value_mm: float
    point_mm: FloatArray  # (3,), in the nominal's frame
    neighbours: int  # number of neighbours that agree
    index: int  # of the point in the deviation


@dataclass(frozen=True, slots=True)
class NoData:
    """Parts of the nominal's area without a deviation, by their reason."""

    not_seen: float
    filled: float  # closed by the surface reconstruction
    too_far: float  # measured farther from the nominal than the search distance

    @property
    def total(self) -> float:
        """Share of the area without a deviation."""
        return self.not_seen + self.filled + self.too_far


@dataclass(frozen=True, slots=True, eq=False)
class DeviationStatistics:
    """Statistics of one deviation."""

    points: int  # within the search distance
    lost: int  # farther than the search distance
    search_mm: float
    mean_mm: float
    rms_mm: float
    p95_mm: float  # of the absolute deviations
    tolerance_mm: tuple[float, float] | None
    range_mm: tuple[float, float]  # ends of the colour scale
    below: float  # shares of the points
    inside: float
    above: float
    no_data: NoData  # shares of the nominal's area
    minimum: Extreme | None  # None where no extreme is confirmed
    maximum: Extreme | None
    all_points_mm: tuple[float, float] | None = None  # smallest and greatest deviation of all points, also lost and unconfirmed ones


def compute_statistics(
    found: Deviation,
    nominal: Mesh,
    *,
    tolerance_mm: tuple[float, float] | None = None,
    range_mm: tuple[float, float] | None = None,
    search_mm: float = 2.0,
    surface: Mesh | None = None,
    index: DeviationIndex | None = None,
) -> DeviationStatistics:
    """Compute the statistics of a deviation.

    Parameters
    ----------
    tolerance_mm : lower and upper tolerance; None: the ends of the range count as limits
    range_mm : ends of the colour scale; None: the default range
    search_mm : points farther from the nominal are lost, and counted
    surface : measured surface in the nominal's frame with its filled vertices; None where there is none
    index : neighbours, if prepared already
    """
    index = index or DeviationIndex(found)
    within = np.abs(found.distances_mm) <= search_mm
    distances = found.distances_mm[within]
    if range_mm is None:
        high = default_range_mm(distances, tolerance_mm)
        range_mm = (-high, high)
    lower, upper = tolerance_mm or range_mm
    count = max(len(distances), 1)
    below, above = float(np.count_nonzero(distances < lower)) / count, float(np.count_nonzero(distances > upper)) / count
    return DeviationStatistics(
        len(distances),
        int(np.count_nonzero(~within)),
        search_mm,
        float(distances.mean()) if len(distances) else 0.0,
        float(np.sqrt(np.mean(distances**2))) if len(distances) else 0.0,
        float(np.percentile(np.abs(distances), 95)) if len(distances) else 0.0,
        tolerance_mm,
        range_mm,
        below,
        float(np.count_nonzero((distances >= lower) & (distances <= upper))) / count,
        above,
        find_no_data(found, nominal, search_mm, surface, index),
        find_extreme(index, search_mm, sign=-1.0),
        find_extreme(index, search_mm, sign=1.0),
        (found.min_mm, found.max_mm) if len(found.distances_mm) else None,
    )


def default_range_mm(distances_mm: FloatArray, tolerance_mm: tuple[float, float] | None = None) -> float:
    """Return the end of the symmetrical colour scale: twice the tolerance, or the 99.5 % percentile rounded up, whichever is greater.

    >>> default_range_mm(np.linspace(-0.07, 0.07, 1000)), default_range_mm(np.zeros(3), (-0.1, 0.2))
    (0.1, 0.4)
    """
    spread = round_up(float(np.percentile(np.abs(distances_mm), RANGE_PERCENTILE))) if len(distances_mm) else 0.0
    wanted = 0.0 if tolerance_mm is None else 2 * max(abs(limit) for limit in tolerance_mm)
    return max(spread, wanted, SMALLEST_RANGE_MM)


def find_extreme(index: DeviationIndex, search_mm: float, *, sign: float) -> Extreme | None:
    """Return the greatest (``sign`` 1) or smallest (-1) deviation that at least five of its nearest neighbours confirm.

    A neighbour confirms it if it is on the same side of the part, and its deviation is as extreme within four standard deviations of
    the noise. Single stray points are thus never reported.
    """
    found = index.found
    values = np.where(np.abs(found.distances_mm) <= search_mm, sign * found.distances_mm, -np.inf)
    start, count = 0, min(FIRST_CANDIDATES, len(values))
    while start < len(values):
        some = _greatest(values, start + count)[start:]
        some = some[np.isfinite(values[some])]
        if len(some) == 0:
            return None
        agreeing = _count_agreeing(index, some, values)
        good = np.flatnonzero(agreeing >= AGREEING)
        if len(good):
            best = some[good[0]]
            return Extreme(float(found.distances_mm[best]), np.array(found.points_mm[best]), int(agreeing[good[0]]), int(best))
        start, count = start + count, 2 * count
    return None


def _greatest(values: FloatArray, count: int) -> IntArray:
    """Return the indices of the greatest values in order, without sorting all the others: a second where there are millions."""
    least = np.partition(values, len(values) - count)[len(values) - count] if count < len(values) else -np.inf
    some: IntArray = np.flatnonzero(values >= least)
    return some[np.argsort(-values[some], kind="stable")][:count]


def _count_agreeing(index: DeviationIndex, some: IntArray, values: FloatArray) -> IntArray:
    """Return how many neighbours of points ``some`` have values as extreme."""
    found = index.found
    reach = REACH_SPACINGS * index.spacing_mm
    near, weights = index.neighbours(found.points_mm[some], found.nominal_normals[some], AMONG + 1, reach)
    agrees = (weights > 0) & (near != some[:, None]) & (values[near] >= values[some][:, None] - AGREE_SIGMAS * index.noise_mm)
    return np.asarray(agrees.sum(axis=1))


def find_no_data(found: Deviation, nominal: Mesh, search_mm: float, surface: Mesh | None, index: DeviationIndex) -> NoData:
    """Return the parts of the nominal's area without a deviation: filled, measured too far away, or not seen."""
    sampled = sample_mesh(nominal, COVERAGE_SAMPLES)
    places = sampled.points_mm
    if len(places) == 0 or sampled.normals is None:
        return NoData(0.0, 0.0, 0.0)
    far = np.flatnonzero(np.abs(found.distances_mm) > search_mm)
    without = len(far) and search_mm < REACH_MM  # beyond, distances are those of the closest point: a far one is near no place
    tree = search_tree(np.delete(found.points_mm, far, axis=0)) if without else index.tree
    left = np.flatnonzero(~np.isfinite(tree.query(places, distance_upper_bound=search_mm, workers=-1)[0]))
    too_far = np.zeros(len(left), np.bool_)
    if len(far) and len(left):
        away, near = cKDTree(found.points_mm[far]).query(places[left], distance_upper_bound=FAR_REACH * search_mm)
        known = np.flatnonzero(np.isfinite(away))
        facing = found.nominal_normals[far[near[known]]]
        too_far[known] = np.einsum("nd,nd->n", facing, sampled.normals[left[known]]) > SAME_SIDE
    filled = ~too_far & _is_filled(places[left], surface, search_mm)
    not_seen = ~too_far & ~filled
    counts = (int(np.count_nonzero(some)) for some in (not_seen, filled, too_far))
    return NoData(*(count / len(places) for count in counts))


def _is_filled(places_mm: FloatArray, surface: Mesh | None, search_mm: float) -> BoolArray:
    if surface is None or surface.measured is None or bool(np.all(surface.measured)):
        return np.zeros(len(places_mm), np.bool_)
    away, _ = cKDTree(surface.vertices_mm[~surface.measured]).query(places_mm, distance_upper_bound=search_mm)
    return np.asarray(np.isfinite(away))
