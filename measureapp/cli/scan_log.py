"""What `scan` records of a run, for its answer."""

from __future__ import annotations

import time
from collections.abc import Callable
from math import ceil
from typing import Any

from measureapp.acquire.events import (
    AcquisitionEvent,
    RunEnded,
    RunPaused,
    RunStarted,
    ViewpointEntered,
    ViewpointFailed,
    ViewpointQueued,
    ViewpointRetaken,
    ViewpointSkipped,
    ViewpointStored,
)
from measureapp.acquire.run_states import ViewpointState
from measureapp.acquire.time_left import RunClock, planned_seconds
from measureapp.cli.outcome import exposures_line, report_warnings
from measureapp.cli.reply import say
from measureapp.data.plan import ScanPlan
from measureapp.data.rig import RigDescription
from measureapp.pipeline.events import Event, ExposuresChosen, PartElsewhere, ValidityKnown, ViewFailed

STATES = {
    ViewpointState.STORED: "stored",
    ViewpointState.KEPT: "stored",
    ViewpointState.SKIPPED: "skipped",
    ViewpointState.FAILED: "failed",
}


class ScanLog:
    """State of every viewpoint of a plan: missing, skipped, failed (device error) or stored, with the reason if it has no points.

    Parameters
    ----------
    wait : waits until a person wants a paused run to go on, and resumes it
    """

    def __init__(self, plan: ScanPlan, rig: RigDescription, wait: Callable[[], None] = lambda: None) -> None:
        self._wait = wait
        self._clock = RunClock(planned_seconds(plan, tuple(plan), rig))
        self.states: dict[str, dict[str, Any]] = {viewpoint.id: {"state": "stored"} for viewpoint in plan}
        self.ended = RunEnded("done")

    def note(self, event: Event) -> None:
        """Record one event of the run."""
        if isinstance(event, AcquisitionEvent):
            self._clock.receive(event, time.monotonic())
        match event:
            case ExposuresChosen():
                say(exposures_line(event))
            case ValidityKnown():
                report_warnings(event)
            case PartElsewhere():
                say(event.sentence)
            case RunPaused():
                say(f"Paused: {event.message} {event.hint}".rstrip())
                self._wait()
            case RunEnded():
                self._end(event)
            case _:
                self._note_viewpoint(event)

    def _note_viewpoint(self, event: Event) -> None:
        match event:
            case RunStarted():
                self.states |= {viewpoint_id: {"state": "missing"} for viewpoint_id in event.viewpoint_ids}
            case ViewpointEntered():
                self.states[event.viewpoint_id]["state"] = STATES.get(event.state, "missing")
            case ViewpointStored():
                self.states[event.viewpoint_id] = {"state": "stored", "seconds": event.seconds}
                say(f"{event.viewpoint_id}: stored{self._left()}")
            case ViewpointSkipped():
                say(f"{event.viewpoint_id}: skipped")
            case ViewpointQueued():
                say(f"{event.viewpoint_id}: {event.reason}")
            case ViewpointRetaken():
                say(f"{event.viewpoint_id}: taken again. {event.reason}")
            case ViewpointFailed() | ViewFailed():
                self.states[event.viewpoint_id]["reason"] = event.reason
                say(f"{event.viewpoint_id}: {event.reason}")

    def _end(self, event: RunEnded) -> None:
        self.ended = event
        if event.reason == "done" and event.message:
            say(event.message)
        elif event.reason != "done" and event.kept:
            say(f"{event.kept} Run the same command with --resume.")

    def _left(self) -> str:
        """Return the time left, as the end of a line; empty at the end."""
        left = self._clock.left(time.monotonic())
        return f"; {duration(left.expected_s)} left, {duration(left.bound_s)} at most" if left.expected_s else ""


def duration(seconds: float) -> str:
    """Return a duration for a person.

    >>> duration(8.2), duration(95.0), duration(4000.0)
    ('9 s', '1 min 35 s', '1 h 7 min')
    """
    whole = ceil(seconds)
    if whole < 60:
        return f"{whole} s"
    minutes = ceil(whole / 60)
    return f"{whole // 60} min {whole % 60} s" if whole < 3600 else f"{minutes // 60} h {minutes % 60} min"
