"""What `scan` records of a run, for its answer."""

from __future__ import annotations

from typing import Any

from measureapp.acquire.events import RunEnded, RunStarted, ViewpointFailed, ViewpointRetaken, ViewpointStarted, ViewpointStored
from measureapp.cli.outcome import exposures_line, report_warnings
from measureapp.cli.reply import say
from measureapp.data.plan import ScanPlan
from measureapp.pipeline.events import Event, ExposuresChosen, ValidityKnown, ViewFailed


class ScanLog:
    """State of every viewpoint of a plan: missing, failed (device error) or stored, with the reason if it has no points."""

    def __init__(self, plan: ScanPlan) -> None:
        self.states: dict[str, dict[str, Any]] = {viewpoint.id: {"state": "stored"} for viewpoint in plan}
        self.ended = RunEnded("done")

    def note(self, event: Event) -> None:
        """Record one event of the run."""
        if isinstance(event, ExposuresChosen):
            say(exposures_line(event))
        elif isinstance(event, ValidityKnown):
            report_warnings(event)
        elif isinstance(event, RunStarted):
            for viewpoint_id in event.viewpoint_ids:
                self.states[viewpoint_id] = {"state": "missing"}
        elif isinstance(event, ViewpointStarted):
            self.states[event.viewpoint_id] = {"state": "failed"}
        elif isinstance(event, ViewpointStored):
            self.states[event.viewpoint_id] |= {"state": "stored", "seconds": event.seconds}
            say(f"{event.viewpoint_id}: stored")
        elif isinstance(event, ViewpointRetaken):
            say(f"{event.viewpoint_id}: taken again. {event.reason}")
        elif isinstance(event, ViewpointFailed | ViewFailed):
            self.states[event.viewpoint_id]["reason"] = event.reason
            say(f"{event.viewpoint_id}: {event.reason}")
        elif isinstance(event, RunEnded):
            self.ended = event
            if event.reason == "done" and event.message:
                say(event.message)
