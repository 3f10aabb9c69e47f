"""Scan engine: runs any plan on any rig."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection
from datetime import UTC, datetime
from typing import Protocol

from measureapp.acquire.capture import ExposureTaken, capture_stack
from measureapp.acquire.events import Event, RunEnded, RunStarted, ViewpointFailed, ViewpointStarted, ViewpointStored
from measureapp.arrays import ImageArray
from measureapp.data.fringe import FringeStack
from measureapp.data.plan import FlangePose, ScanPlan, Viewpoint
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, DeviceTimeout, MeasureError
from measureapp.progress import Cancelled, PartOf, Progress


class Sink(Protocol):
    """Consumer of the images of a scan."""

    def exposure_taken(self, taken: ExposureTaken) -> None:
        """Accept all images of one exposure; must return quickly, because the rig waits."""

    def drop(self, viewpoint_id: str) -> None:
        """Discard the exposures of a viewpoint that failed or was cancelled."""

    def store(self, stack: FringeStack) -> None:
        """Store ``stack`` permanently; raises StorageError."""


class Engine:
    """Runs scan plans on one rig and passes the stacks to a sink.

    A device error ends the viewpoint and the run continues with the next one; an axis that times out, or a full disk, ends the
    run, because continuing would be unsafe or lose data.
    """

    def __init__(self, rig: Rig, sink: Sink) -> None:
        self._rig = rig
        self._sink = sink
        self._approached: tuple[FlangePose, float, str] | None = None  # goals of robot and guide, and the time of the command

    def run(
        self,
        plan: ScanPlan,
        pattern_images: ImageArray,
        on_event: Callable[[Event], None],
        progress: Progress,
        stored: Collection[str] = (),
    ) -> None:
        """Take every viewpoint of ``plan`` that is not among ``stored``.

        Parameters
        ----------
        plan : must be within the rig's limits, see `check_reach`
        pattern_images : (patterns, height, width) uint8, images of the projector
        on_event : receives all events; `RunEnded` is always the last one
        progress : also the cancellation point
        stored : ids of viewpoints that are stored already

        Raises
        ------
        DeviceTimeout, StorageError, Cancelled
            After `RunEnded` was sent and all devices were stopped.
        """
        waiting = [viewpoint for viewpoint in plan if viewpoint.id not in stored]
        self._approached = None  # the robot may have been moved between runs
        on_event(RunStarted(plan.name, tuple(viewpoint.id for viewpoint in waiting)))
        try:
            self._rig.projector.load(pattern_images)
            for index, viewpoint in enumerate(waiting):
                part = PartOf(progress, index / len(waiting), (index + 1) / len(waiting))
                self._take(viewpoint, plan, on_event, part)
        except Cancelled:
            self._stop(on_event, RunEnded("cancelled", "Stopped on request; stored viewpoints are kept."))
            raise
        except MeasureError as error:
            self._stop(on_event, RunEnded("failed", str(error)))
            raise
        on_event(RunEnded("done"))

    def _take(self, viewpoint: Viewpoint, plan: ScanPlan, on_event: Callable[[Event], None], progress: Progress) -> None:
        start = time.monotonic()
        on_event(ViewpointStarted(viewpoint.id))
        try:
            stack = capture_stack(self._rig, viewpoint, plan, on_event, progress, self._sink.exposure_taken, self._approach(viewpoint))
        except (DeviceTimeout, Cancelled):
            self._sink.drop(viewpoint.id)
            raise
        except DeviceError as error:
            self._approached = None  # the robot may have moved
            self._sink.drop(viewpoint.id)
            on_event(ViewpointFailed(viewpoint.id, str(error)))
            return
        self._sink.store(stack)
        on_event(ViewpointStored(viewpoint.id, time.monotonic() - start))

    def _approach(self, viewpoint: Viewpoint) -> str:
        """Return the time at which robot and guide were sent to ``viewpoint``; an unchanged goal does not move them."""
        goals = (viewpoint.flange, viewpoint.guide_mm)
        if self._approached is None or self._approached[:2] != goals:
            self._approached = (*goals, datetime.now(UTC).isoformat())
        return self._approached[2]

    def _stop(self, on_event: Callable[[Event], None], ended: RunEnded) -> None:
        try:
            self._rig.stop_all()
        except DeviceError as error:
            ended = RunEnded(ended.reason, f"{ended.message} {error}")
        on_event(ended)
