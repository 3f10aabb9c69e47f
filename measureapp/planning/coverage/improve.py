"""Local improvement of a choice: redundant viewpoints out, two replaced by one, one replaced by a better one."""

from __future__ import annotations

from itertools import combinations

import numpy as np

from measureapp.planning.coverage.greedy import STATION_COST, Goal
from measureapp.planning.coverage.value import Problem
from measureapp.progress import Progress

ROUNDS = 4
TINY = 1e-9
PROMISING = 60  # candidates that are examined in place of one
BEST = 4  # of them, those that are tried


def improve(problem: Problem, chosen: list[int], goal: Goal, progress: Progress) -> list[int]:
    """Return a choice that is not larger and covers what is required, by removals, 2-for-1 and 1-for-1 exchanges until nothing changes.

    An exchange keeps all viewpoints connected by overlaps if they were. With a fixed count only 1-for-1 exchanges are made.
    """
    best = list(chosen)
    for number in range(ROUNDS):
        progress.report(number, ROUNDS, f"{len(best)} viewpoints, exchanges")
        before = list(best)
        if goal.count is None:
            best = _without_redundant(problem, best, goal)
            best = _two_for_one(problem, best, goal, progress)
        best = _one_for_one(problem, best, goal)
        if best == before:
            break
    return best


def components(problem: Problem, chosen: list[int], overlap: float) -> int:
    """Return the number of groups that no overlap connects; two viewpoints are connected if one has ``overlap`` of its area in common."""
    groups = list(range(len(chosen)))
    seen = problem.weights[chosen] > 0.0
    common = (seen * problem.areas) @ seen.T.astype(float)
    own = np.diag(common)
    linked = common >= overlap * np.minimum.outer(own, own)
    for first, second in combinations(range(len(chosen)), 2):
        if linked[first, second] and groups[first] != groups[second]:
            old, new = groups[second], groups[first]
            groups = [new if group == old else group for group in groups]
    return len(set(groups))


def _acceptable(problem: Problem, changed: list[int], before: list[int], goal: Goal) -> bool:
    if not changed or problem.covered_area(problem.information(changed)) < _required(problem, before, goal) - TINY:
        return False
    return components(problem, changed, goal.overlap) <= components(problem, before, goal.overlap)


def _required(problem: Problem, chosen: list[int], goal: Goal) -> float:
    """Return the area that a change has to keep: the goal's, or what is covered if that is less."""
    return min(goal.area, problem.covered_area(problem.information(chosen)))


def _cost(problem: Problem, chosen: list[int]) -> float:
    return len(chosen) + STATION_COST * len(set(problem.station[chosen].tolist()))


def _without_redundant(problem: Problem, chosen: list[int], goal: Goal) -> list[int]:
    """Remove viewpoints that are not needed, the least valuable first."""
    best = list(chosen)
    values = {one: problem.total(best) - problem.total([other for other in best if other != one]) for one in best}
    for one in sorted(best, key=lambda candidate: (values[candidate], candidate)):
        without = [other for other in best if other != one]
        if _acceptable(problem, without, best, goal):
            best = without
    return best


def _two_for_one(problem: Problem, chosen: list[int], goal: Goal, progress: Progress) -> list[int]:
    """Replace pairs of viewpoints by one that suffices, until no pair can be."""
    best, tried = list(chosen), set[tuple[int, int]]()
    while True:
        pair = next((one for one in combinations(best, 2) if one not in tried), None)
        if pair is None:
            return best
        progress.check()
        tried.add(pair)
        rest = [one for one in best if one not in pair]
        covered = problem.covered_with(problem.information(rest))
        enough = np.flatnonzero(covered >= _required(problem, best, goal) - TINY)
        ordered = sorted(enough.tolist(), key=lambda one: (-covered[one], one))[:BEST]
        found = next((one for one in ordered if one not in rest and _acceptable(problem, [*rest, one], best, goal)), None)
        if found is not None:
            best = [*rest, found]


def _one_for_one(problem: Problem, chosen: list[int], goal: Goal) -> list[int]:
    """Replace each viewpoint by the candidate with the most value for its cost, if that is better and covers enough."""
    best = list(chosen)
    for one in chosen:
        rest = [other for other in best if other != one]
        information = problem.information(rest)
        stations = set(problem.station[rest].tolist())
        promising = np.argsort(-problem.covered_with(information), kind="stable")[:PROMISING].tolist()
        gains = {candidate: problem.gain(candidate, information) for candidate in {one, *promising} - set(rest)}
        price = STATION_COST * gains[one]
        values = {candidate: gain - price * (int(problem.station[candidate]) not in stations) for candidate, gain in gains.items()}
        for candidate in sorted(values, key=lambda each: (-values[each], each))[:BEST]:
            changed = [*rest, candidate]
            if values[candidate] <= values[one] + TINY:
                break
            if _acceptable(problem, changed, best, goal) and _cost(problem, changed) <= _cost(problem, best) + TINY:
                best = changed
                break
    return best
