"""The order of viewpoints that spares motion: one visit per robot pose, table and guide between its viewpoints."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.data.plan import Viewpoint

ROUNDS = 500
STARTS = 6  # of the nearest-neighbour paths, those that are improved
MOST_PLACES = 4_000_000  # of all moves that are tried at once
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
    built = sorted((_nearest_neighbours(times_s, start) for start in range(count)), key=lambda path: path_time_s(path, times_s))
    moves = _moves(count)
    return min((_improved(path, times_s, moves) for path in built[:STARTS]), key=lambda path: path_time_s(path, times_s))


def _nearest_neighbours(times_s: FloatArray, start: int) -> list[int]:
    path, left = [start], np.ones(len(times_s), bool)
    left[start] = False
    while left.any():
        path.append(int(np.where(left, times_s[path[-1]], np.inf).argmin()))
        left[path[-1]] = False
    return path


def _improved(path: list[int], times_s: FloatArray, moves: IntArray) -> list[int]:
    """Apply the best 2-opt or Or-opt move until none shortens the path."""
    best = np.array(path)
    for _ in range(ROUNDS if len(moves) else 0):
        changed = best[moves]
        lengths = times_s[changed[:, :-1], changed[:, 1:]].sum(axis=1)
        shortest = int(lengths.argmin())
        if lengths[shortest] >= path_time_s(best.tolist(), times_s) - TINY_S:
            break
        best = changed[shortest]
    return [int(place) for place in best]


def _moves(count: int) -> IntArray:
    """Return permutations (M, count): one segment reversed, or up to three places moved elsewhere, not further than time allows."""
    reach = max(1, min(count, int(MOST_PLACES / 8 / max(count, 1) ** 2)))
    path = list(range(count))
    moves = [path[:i] + path[i : j + 1][::-1] + path[j + 1 :] for i in path for j in range(i + 1, min(count, i + reach + 1))]
    for length in (1, 2, 3):
        for i in range(count - length + 1):
            segment, rest = path[i : i + length], path[:i] + path[i + length :]
            moves += [rest[:j] + segment + rest[j:] for j in range(max(0, i - reach), min(len(rest), i + reach) + 1) if j != i]
    return np.array(moves, int).reshape(-1, count)


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
