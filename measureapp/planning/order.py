"""The order of viewpoints that spares motion: one visit per robot pose, table and guide between its viewpoints."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.data.plan import Viewpoint

ROUNDS = 50
TINY_S = 1e-9


def shortest_order(viewpoints: Sequence[Viewpoint], times_s: FloatArray) -> list[int]:
    """Return the order of viewpoints, as indices, that takes the least time; each robot pose is visited once.

    Viewpoints of one pose are ordered first, then the poses, each of which may be run through in both directions: an open path of an
    asymmetric travelling salesman, by nearest neighbours from every start, then 2-opt and Or-opt until neither shortens it.

    Parameters
    ----------
    times_s : (V, V), from row to column
    """
    stations: dict[object, list[int]] = {}
    for place, viewpoint in enumerate(viewpoints):
        stations.setdefault(viewpoint.flange, []).append(place)
    paths = [[members[step] for step in _path(times_s[np.ix_(members, members)])] for members in stations.values()]
    links = np.array([[_shortest_link(times_s, one, other) for other in paths] for one in paths])
    order = [paths[step] for step in _path(links)]
    return [place for path in _directed(times_s, order) for place in path]


def path_time_s(order: Sequence[int], times_s: FloatArray) -> float:
    """Return the time of a path through all places of ``order``."""
    steps = np.asarray(order, int)
    return float(times_s[steps[:-1], steps[1:]].sum())


def _path(times_s: FloatArray) -> list[int]:
    """Return a short open path through all places."""
    count = len(times_s)
    starts = range(count) if count <= 60 else range(0, count, count // 60)
    return min((_improved(_nearest_neighbours(times_s, start), times_s) for start in starts), key=lambda path: path_time_s(path, times_s))


def _nearest_neighbours(times_s: FloatArray, start: int) -> list[int]:
    path, left = [start], sorted(set(range(len(times_s))) - {start})
    while left:
        following = min(left, key=lambda place: (times_s[path[-1], place], place))
        path.append(following)
        left.remove(following)
    return path


def _improved(path: list[int], times_s: FloatArray) -> list[int]:
    """Apply 2-opt and Or-opt moves, whichever comes first, until none shortens the path."""
    best, best_s = path, path_time_s(path, times_s)
    for _ in range(ROUNDS):
        before_s = best_s
        for changed in _neighbours_of(best):
            time_s = path_time_s(changed, times_s)
            if time_s < best_s - TINY_S:
                best, best_s = changed, time_s
        if best_s >= before_s - TINY_S:
            break
    return best


def _neighbours_of(path: list[int]) -> list[list[int]]:
    """Return the paths with one segment reversed, or with up to three places moved elsewhere."""
    count = len(path)
    turned = [path[:i] + path[i : j + 1][::-1] + path[j + 1 :] for i in range(count) for j in range(i + 1, count)]
    moved = []
    for length in (1, 2, 3):
        for i in range(count - length + 1):
            segment, rest = path[i : i + length], path[:i] + path[i + length :]
            moved += [rest[:j] + segment + rest[j:] for j in range(len(rest) + 1) if j != i]
    return turned + moved


def _shortest_link(times_s: FloatArray, one: list[int], other: list[int]) -> float:
    """Return the time from one end of a station to the nearer end of another."""
    if one is other:
        return 0.0
    return float(min(times_s[end, start] for end in (one[0], one[-1]) for start in (other[0], other[-1])))


def _directed(times_s: FloatArray, paths: list[list[int]]) -> list[list[int]]:
    """Return the stations in their order, each in the direction that makes the whole path shortest (dynamic programming)."""
    ways = [(path, path[::-1]) for path in paths]
    costs: list[tuple[float, list[list[int]]]] = [(0.0, [way]) for way in ways[0]]
    for options in ways[1:]:
        costs = [
            min(((cost + float(times_s[done[-1][-1], way[0]]), [*done, way]) for cost, done in costs), key=lambda entry: entry[0])
            for way in options
        ]
    return min(costs, key=lambda entry: entry[0])[1]
