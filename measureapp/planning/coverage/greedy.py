"""Lazy greedy choice of viewpoints: the most value for its cost, each overlapping what was chosen before."""

from __future__ import annotations

import heapq
from dataclasses import dataclass

import numpy as np

from measureapp.planning.coverage.value import Problem
from measureapp.progress import Progress

LEAST_GAIN = 1e-9
STATION_COST = 0.3  # of a new robot pose, in viewpoints


@dataclass(frozen=True, slots=True)
class Goal:
    """When the choice ends."""

    area: float  # share of all areas that suffices; see `Problem.covered_area`
    count: int | None = None  # exactly that many viewpoints, whatever the area
    overlap: float = 0.2  # share of its area that a viewpoint has in common with those chosen before

    def reached(self, problem: Problem, chosen: list[int]) -> bool:
        """Return whether the chosen candidates suffice."""
        if self.count is not None:
            return len(chosen) >= self.count
        return bool(chosen) and problem.covered_area(problem.information(chosen)) >= self.area - 1e-12


def choose(problem: Problem, goal: Goal, progress: Progress) -> list[int]:
    """Choose candidates until the goal is reached or nothing adds to the value.

    Gains only shrink while the choice grows (the value is submodular), so an old gain is an upper bound: a candidate whose fresh ratio of
    gain to cost is still the largest is the best of all, and only few are computed anew [1]_. Of equals, the first candidate is chosen. A
    candidate without enough overlap waits until it has some; if all wait, the one with the most overlap is chosen.

    References
    ----------
    .. [1] M. Minoux, Optimization Techniques, LNCIS 7, 234-243, 1978.
    """
    queue = _Queue(problem)
    information = np.zeros(len(problem.areas))
    chosen: list[int] = []
    while not goal.reached(problem, chosen):
        progress.report(problem.covered_area(information), max(goal.area, 1e-9), f"{len(chosen)} viewpoints chosen")
        best = queue.pop(information, goal.overlap if chosen else 0.0)
        if best is None:
            break
        chosen.append(best)
        information += problem.weights[best]
        queue.open(int(problem.station[best]))
    return chosen


class _Queue:
    """Candidates by upper bounds of their ratio of gain to cost."""

    def __init__(self, problem: Problem) -> None:
        self._problem = problem
        self._opened: set[int] = set()
        none = np.zeros(len(problem.areas))
        self._gains = [problem.gain(one, none) for one in range(len(problem.rows))]
        self._taken = [False] * len(self._gains)
        self._fill()

    def open(self, station: int) -> None:
        """Note that a robot pose is in use: further views from it cost less, so that their bounds rise."""
        if station not in self._opened:
            self._opened.add(station)
            self._fill()

    def pop(self, information: np.ndarray, overlap: float) -> int | None:
        """Remove and return the candidate with the largest ratio; None if none has a gain."""
        seen = information > 0.0
        waiting: list[tuple[float, int]] = []
        best = None
        while self._heap and best is None:
            _, candidate = heapq.heappop(self._heap)
            self._gains[candidate] = self._problem.gain(candidate, information)
            if self._gains[candidate] <= LEAST_GAIN:
                continue
            entry = (-self._ratio(candidate), candidate)
            if self._heap and entry > self._heap[0]:
                heapq.heappush(self._heap, entry)
            elif self._problem.overlap(candidate, seen) < overlap:
                waiting.append(entry)
            else:
                best = candidate
        if best is None and waiting:
            best = max(waiting, key=lambda entry: (self._problem.overlap(entry[1], seen), -entry[0], -entry[1]))[1]
        for entry in waiting:
            if entry[1] != best:
                heapq.heappush(self._heap, entry)
        if best is not None:
            self._taken[best] = True
        return best

    def _ratio(self, candidate: int) -> float:
        cost = 1.0 if int(self._problem.station[candidate]) in self._opened else 1.0 + STATION_COST
        return self._gains[candidate] / cost

    def _fill(self) -> None:
        self._heap = [(-self._ratio(one), one) for one, taken in enumerate(self._taken) if not taken and self._gains[one] > LEAST_GAIN]
        heapq.heapify(self._heap)
