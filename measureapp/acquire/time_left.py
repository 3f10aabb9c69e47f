"""How long a run still takes: from the plan, and from how long its first viewpoints took."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import sqrt

import numpy as np

from measureapp.acquire.events import (
    AcquisitionEvent,
    RunEnded,
    RunPaused,
    RunResumed,
    RunStarted,
    ViewpointEntered,
    ViewpointStored,
)
from measureapp.acquire.run_states import ACTIVE, CLOSED, ViewpointState
from measureapp.data.plan import ScanPlan, Viewpoint
from measureapp.data.rig import RigDescription
from measureapp.data.scan_cost import viewpoint_time_s
from measureapp.planning.travel import travel_times_s

OVERHEAD_S = 1.0  # of a viewpoint: read-backs, storing
FIRST_WEIGHT = 6.0  # of the first viewpoint among the later ones: a few slow ones at the beginning must not double what was said
MOST_SLOW = 3.0  # times the usual duration; a viewpoint that took longer counts as one that took that long
MARGIN_FIRST, MARGIN_BEFORE = 0.5, 1.0  # share added to the bound after one viewpoint, and before any
SCATTER = 0.7  # of single viewpoints in the bound, in usual viewpoints; that of a sum grows with the square root of their number
LEAST_LEFT = 0.1  # of a viewpoint that takes longer than expected


@dataclass(frozen=True, slots=True)
class TimeLeft:
    """Seconds until a run ends."""

    expected_s: float
    bound_s: float  # rarely exceeded


def planned_seconds(plan: ScanPlan, viewpoints: Sequence[Viewpoint], rig: RigDescription) -> dict[str, float]:
    """Return how long each viewpoint is expected to take with its move from the one before; no more than a beginning for `RunClock`.

    The robot's moves are those of its flange: no inverse kinematics, which would take longer than the caller may.
    """
    moves = [0.0, *(float(travel_times_s(pair, rig, None)[0, 1]) for pair in pairwise(viewpoints))]
    return {
        viewpoint.id: OVERHEAD_S + move_s + viewpoint_time_s(plan, viewpoint, rig)
        for viewpoint, move_s in zip(viewpoints, moves, strict=True)
    }


class RunClock:
    """Follows the events of a run and says how long it still takes; reads no clock itself.

    What later viewpoints take is the planned duration times the mean ratio of those taken, in which the first one has the weight of
    several and single slow ones are limited. The bound adds a margin that shrinks as viewpoints are taken, and the scatter of single
    viewpoints, of which some are slow. It grows by less than half where viewpoints are slow at random, but not where a run is paused, or viewpoints are taken
    again.

    Parameters
    ----------
    planned_s : expected duration of every viewpoint of the plan, such as `planned_seconds`
    """

    def __init__(self, planned_s: Mapping[str, float]) -> None:
        self._planned_s = dict(planned_s)
        self._states: dict[str, ViewpointState] = dict.fromkeys(planned_s, ViewpointState.WAITING)
        self._ratios: list[float] = []
        self._began_s: float | None = None  # of the present viewpoint
        self._present: str | None = None
        self._paused_at_s: float | None = None
        self._ended = False

    def receive(self, event: AcquisitionEvent, now_s: float) -> None:
        """Note an event that came at ``now_s``, in seconds of any clock that never runs back."""
        match event:
            case RunStarted():  # of which some viewpoints may be stored already
                wanted = set(event.viewpoint_ids)
                self._states = {name: ViewpointState.WAITING if name in wanted else ViewpointState.STORED for name in self._states}
            case ViewpointEntered():
                self._enter(event.viewpoint_id, event.state, now_s)
            case ViewpointStored():
                self._store(event.viewpoint_id, now_s)
            case RunPaused():
                self._paused_at_s = now_s if self._paused_at_s is None else self._paused_at_s
            case RunResumed():
                if self._paused_at_s is not None and self._began_s is not None:
                    self._began_s += now_s - self._paused_at_s
                self._paused_at_s = None
            case RunEnded():
                self._ended = True

    def _enter(self, name: str, state: ViewpointState, now_s: float) -> None:
        self._states[name] = state
        if state is ViewpointState.MOVING and name != self._present:
            self._present, self._began_s = name, now_s
        elif state not in ACTIVE and state is not ViewpointState.STORED and name == self._present:
            self._present = self._began_s = None

    def _store(self, name: str, now_s: float) -> None:
        if name == self._present and self._began_s is not None and self._planned_s.get(name, 0.0) > 0.0:
            self._ratios.append((now_s - self._began_s) / self._planned_s[name])
        self._present = self._began_s = None

    def left(self, now_s: float) -> TimeLeft:
        """Return the time left at ``now_s``; without pauses to come."""
        names = [] if self._ended else [name for name, state in self._states.items() if state not in CLOSED]
        if not names:
            return TimeLeft(0.0, 0.0)
        ratio = self._ratio()
        now_s = now_s if self._paused_at_s is None else self._paused_at_s
        spent_s = 0.0 if self._began_s is None else now_s - self._began_s
        margin = 1.0 + (MARGIN_FIRST / sqrt(len(self._ratios)) if self._ratios else MARGIN_BEFORE)
        usual_s = ratio * float(np.mean([self._planned_s.get(name, 0.0) for name in names]))
        expected, bound = 0.0, (1.0 + SCATTER * sqrt(len(names))) * usual_s
        for name in names:
            whole_s = ratio * self._planned_s.get(name, 0.0)
            done_s = spent_s if name == self._present else 0.0
            expected += max(whole_s - done_s, LEAST_LEFT * whole_s)
            bound += max(margin * whole_s - done_s, LEAST_LEFT * whole_s)
        return TimeLeft(expected, bound)

    def _ratio(self) -> float:
        """Return the mean of the ratios of actual to planned durations; 1 before there is one."""
        if not self._ratios:
            return 1.0
        usual = float(np.median(self._ratios))
        limited = [min(ratio, MOST_SLOW * usual) for ratio in self._ratios[1:]]
        return (FIRST_WEIGHT * self._ratios[0] + sum(limited)) / (FIRST_WEIGHT + len(limited))
