"""A scan that is quick: takes the place of the pipeline in tests of pages and controllers."""

from __future__ import annotations

import threading

from measureapp.acquire import events as e
from measureapp.acquire.control import RunControl
from measureapp.acquire.run_states import ViewpointState
from measureapp.pipeline import events as p


class QuickRun:
    """Takes the place of the pipeline: waits at the gate in each viewpoint, and obeys its control like the engine."""

    def __init__(self, view_of) -> None:
        self.requests, self.helds, self.gate, self.view_of = [], [], threading.Event(), view_of
        self.error, self.controls, self.before = None, [], threading.Event()
        self.outcome = None  # the images are not processed
        self.before.set()  # what comes before the scan is done

    def scan_into_project(self, request, on_event, progress, control, held):
        self.requests.append(request)
        self.helds.append(held)
        self.controls.append(control)
        while not self.before.wait(0.01):
            progress.check()
        control.begin(tuple(request.plan))
        on_event(e.RunStarted(request.plan.name, tuple(viewpoint.id for viewpoint in request.plan)))
        try:
            while (viewpoint := control.next_viewpoint()) is not None:
                self._take(viewpoint.id, on_event, progress, control)
        finally:
            control.end()
            on_event(e.RunEnded("done"))
        if self.error is not None:
            raise self.error
        return self.outcome

    def _take(self, name, on_event, progress, control: RunControl) -> None:
        for state in ("moving", "confirming", "settling", "capturing"):
            if state != "moving":
                control.enter(name, ViewpointState(state))
            on_event(e.ViewpointEntered(name, ViewpointState(state)))
        while not self.gate.wait(0.01):
            progress.check()
        if control.state == "pausing":
            cause = control.reach_pause()
            on_event(e.RunPaused(cause.message, cause.hint))
            while not control.wait(0.01):
                progress.check()
            on_event(e.RunResumed())
        for state in ("checking", "storing", "stored"):
            control.enter(name, ViewpointState(state))
        on_event(e.ViewpointStored(name, 0.1))
        on_event(p.ViewReady(self.view_of(name)))
