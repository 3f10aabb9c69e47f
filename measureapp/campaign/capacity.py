"""How many computers a day's projects need, and what becomes scarce first: arithmetic, and a simulation of the queue.

The work of a project is that of one which was measured (`process PROJECT --profile --json`): a first task calibrates, each view is a task,
a last one stitches, measures and reports. Every task passes the scheduler, occupies a place on a computer, reads from the storage that all
share, computes, and writes. The storage serves all readers and writers at the same time with equal shares, none faster than one connection
(processor sharing: L. Kleinrock, Queueing Systems II, 1976, 4.4); places and scheduler serve in the order of arrival.
"""

from __future__ import annotations

import heapq
from collections import deque
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from typing import Any

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.errors import InputError

Then = Callable[[], None]
DAY_S = 86_400.0
TINY_S = 1e-9
FIRST, VIEWS, SUM = "calibration", "clouds", "whole"  # stages of a profile; all others belong to the last task
PROFILE = "Give the answer of `measureapp process PROJECT --profile --json`."


@dataclass(frozen=True, slots=True)
class Task:
    """What one task uses."""

    processor_s: float
    read_bytes: float
    written_bytes: float


@dataclass(frozen=True, slots=True)
class ProjectWork:
    """The tasks of a project, in phases: those of one run side by side, and the next one waits for all of them."""

    phases: tuple[tuple[Task, int], ...]  # (task, how many of it)
    memory_bytes: float  # of the largest task

    @property
    def tasks(self) -> int:
        """Number of tasks."""
        return sum(count for _, count in self.phases)

    @property
    def processor_s(self) -> float:
        """Processor time of all tasks."""
        return sum(count * task.processor_s for task, count in self.phases)

    @property
    def written_bytes(self) -> float:
        """What all tasks write."""
        return sum(count * task.written_bytes for task, count in self.phases)

    @property
    def traffic_bytes(self) -> float:
        """What all tasks read and write."""
        return sum(count * (task.read_bytes + task.written_bytes) for task, count in self.phases)


@dataclass(frozen=True, slots=True)
class Cluster:
    """Computers that share a storage and a scheduler."""

    machines: int
    cores: int  # of a machine
    memory_bytes: float  # of a machine
    storage_bytes_s: float  # of all computers together
    connection_bytes_s: float  # of one task
    scheduler_s: float  # of a task

    def places(self, work: ProjectWork) -> int:
        """Return how many tasks run at the same time. Raises InputError where the memory of a machine does not hold one."""
        on_each = min(self.cores, int(self.memory_bytes // work.memory_bytes))
        if on_each < 1:
            raise InputError(
                f"A task needs {work.memory_bytes / 2**30:.1f} GiB, a machine has {self.memory_bytes / 2**30:.1f} GiB.",
                "Give machines with more memory.",
            )
        return self.machines * on_each


@dataclass(frozen=True, slots=True)
class Day:
    """What happened to the projects of a day."""

    projects: int
    latency_s: FloatArray  # (projects,) from arrival to report
    ended_s: float  # when the last one was done, after the start of the day
    busy: Mapping[str, float]  # resource -> share of the time until then in which it was used


def work_of(answer: Mapping[str, Any], name: str) -> ProjectWork:
    """Return the work of a project from the answer of ``process PROJECT --profile --json``. Raises InputError where ``name`` is none."""
    try:
        stages, views = answer["profile"], len(answer["views"])
        if not views:
            raise ValueError("no views")
        uses = {name: (float(one["processor_s"]), 1e6 * one["read_mb"], 1e6 * one["written_mb"]) for name, one in stages.items()}
        memory = max(1e6 * float(one["peak_memory_mb"]) for one in stages.values())
        view = Task(*(value / views for value in uses[VIEWS]))
        rest = [use for name, use in uses.items() if name not in (FIRST, VIEWS, SUM)]
        first = ((Task(*uses[FIRST]), 1),) if FIRST in uses else ()
        return ProjectWork((*first, (view, views), (Task(*map(sum, zip(*rest, strict=True))), 1)), memory)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise InputError(f"{name} is not the profile of a project.", PROFILE) from error


def most_per_day(work: ProjectWork, cluster: Cluster) -> dict[str, float]:
    """Return how many projects a day each resource could serve if the others were without end; the least is what becomes scarce first."""
    traffic = work.traffic_bytes
    occupied = work.processor_s + traffic / min(cluster.connection_bytes_s, cluster.storage_bytes_s)
    return {
        "processors": cluster.places(work) * DAY_S / max(occupied, 1e-9),
        "storage": cluster.storage_bytes_s * DAY_S / max(traffic, 1e-9),
        "scheduler": DAY_S / max(work.tasks * cluster.scheduler_s, 1e-12),
    }


def arrivals(projects: int, hours: float, seed: int) -> FloatArray:
    """Return when projects arrive (projects,), s: independently of each other, within some hours of a day."""
    return np.sort(np.random.default_rng(seed).uniform(0.0, 3600.0 * hours, projects))


def simulate(work: ProjectWork, cluster: Cluster, arrive_s: FloatArray) -> Day:
    """Simulate the queue of projects that arrive at some times (N,), until the last one is done. Raises InputError as `Cluster.places`."""
    run = _Run(work, cluster)
    done = run.until_empty(arrive_s)
    ended = max(float(done.max(initial=0.0)), TINY_S)
    busy = {
        "processors": run.occupied_s / (cluster.places(work) * ended),
        "storage": run.storage.served_bytes / (cluster.storage_bytes_s * ended),
        "scheduler": len(arrive_s) * work.tasks * cluster.scheduler_s / ended,
    }
    return Day(len(arrive_s), done - arrive_s, ended, busy)


def fewest_machines(work: ProjectWork, cluster: Cluster, arrive_s: FloatArray, within_s: float, percent: float) -> int:
    """Return how many machines it takes for a share of the projects to be done within a time.

    Raises
    ------
    InputError
        No number of machines does: a project alone takes longer, or storage or scheduler are too slow.
    """

    def late_s(machines: int) -> float:
        return float(np.percentile(simulate(work, replace(cluster, machines=machines), arrive_s).latency_s, percent))

    most = len(arrive_s) * max(count for _, count in work.phases)  # a place for every task
    if late_s(most) > within_s:
        raise InputError(
            f"However many machines there are, {percent:g} % of the projects take up to {late_s(most):.0f} s, longer than {within_s:.0f} s.",
            "Allow more time, or give a faster storage.",
        )
    low, high = 0, 1
    while late_s(high) > within_s:
        low, high = high, 2 * high
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if late_s(middle) > within_s else (low, middle)
    return high


class _SharedStorage:
    """Requests that share a bandwidth equally, in virtual time: a request ends when that has moved on by its bytes."""

    def __init__(self, total: float, each: float) -> None:
        self._total, self._each = total, each
        self._now = self._virtual = self.served_bytes = 0.0
        self._waiting: list[tuple[float, int, Then]] = []
        self._number = 0

    def _rate(self) -> float:
        return min(self._each, self._total / len(self._waiting))

    def next_s(self) -> float:
        """When the next request ends."""
        return self._now + max(self._waiting[0][0] - self._virtual, 0.0) / self._rate() if self._waiting else np.inf

    def advance(self, now: float) -> None:
        """Move on to a time before which no request ends."""
        if self._waiting:
            step = self._rate() * (now - self._now)
            self._virtual += step
            self.served_bytes += step * len(self._waiting)
        self._now = now

    def add(self, size: float, then: Then) -> None:
        """Start a request."""
        self._number += 1
        heapq.heappush(self._waiting, (self._virtual + size, self._number, then))

    def pop(self) -> Then:
        """Return what follows the request that ended."""
        return heapq.heappop(self._waiting)[2]


class _Run:
    """One simulation: a clock, and what happens next."""

    def __init__(self, work: ProjectWork, cluster: Cluster) -> None:
        self._work, self._scheduler_s, self._free = work, cluster.scheduler_s, cluster.places(work)
        self._queue: deque[Then] = deque()
        self._timers: list[tuple[float, int, Then]] = []
        self._number = 0
        self._scheduler_free = self._now = self.occupied_s = 0.0
        self.storage = _SharedStorage(cluster.storage_bytes_s, cluster.connection_bytes_s)

    def until_empty(self, arrive_s: FloatArray) -> FloatArray:
        """Return when each project was done (N,)."""
        done = np.zeros(len(arrive_s))
        for number, moment in enumerate(arrive_s):
            self._after(float(moment), partial(self._project, number, done))
        while True:
            timer, stored = self._timers[0][0] if self._timers else np.inf, self.storage.next_s()
            self._now = min(timer, stored)
            if self._now == np.inf:
                return done
            self.storage.advance(self._now)
            then = heapq.heappop(self._timers)[2] if timer <= stored else self.storage.pop()
            then()

    def _project(self, number: int, done: FloatArray, phase: int = 0) -> None:
        if phase == len(self._work.phases):
            done[number] = self._now
            return
        task, count = self._work.phases[phase]
        left = [count]

        def one_less() -> None:
            left[0] -= 1
            if not left[0]:
                self._project(number, done, phase + 1)

        for _ in range(count):
            self._submit(task, one_less)

    def _submit(self, task: Task, then: Then) -> None:
        """Send a task through the scheduler to a free place."""
        self._scheduler_free = max(self._scheduler_free, self._now) + self._scheduler_s
        self._after(self._scheduler_free - self._now, partial(self._occupy, partial(self._start, task, then)))

    def _occupy(self, start: Then) -> None:
        if self._free:
            self._free -= 1
            start()
        else:
            self._queue.append(start)

    def _start(self, task: Task, then: Then) -> None:
        began = self._now

        def compute() -> None:
            self._after(task.processor_s, partial(self.storage.add, task.written_bytes, leave))

        def leave() -> None:
            self.occupied_s += self._now - began
            if self._queue:
                self._queue.popleft()()
            else:
                self._free += 1
            then()

        self.storage.add(task.read_bytes, compute)

    def _after(self, seconds: float, then: Then) -> None:
        self._number += 1
        heapq.heappush(self._timers, (self._now + seconds, self._number, then))
