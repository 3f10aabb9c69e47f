"""What `scan` records of a run, for its answer."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from measureapp.acquire.events import (
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
from measureapp.cli.outcome import exposures_line, report_warnings
from measureapp.cli.reply import say
from measureapp.data.plan import ScanPlan
from measureapp.pipeline.events import Event, ExposuresChosen, ValidityKnown, ViewFailed

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

    def __init__(self, plan: ScanPlan, wait: Callable[[], None] = lambda: None) -> None:
        self._wait = wait
        self.states: dict[str, dict[str, Any]] = {viewpoint.id: {"state": "stored"} for viewpoint in plan}
        self.ended = RunEnded("done")

    def note(self, event: Event) -> None:
        """Record one event of the run."""
        match event:
            case ExposuresChosen():
                say(exposures_line(event))
            case ValidityKnown():
                report_warnings(event)
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
                say(f"{event.viewpoint_id}: stored")
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
