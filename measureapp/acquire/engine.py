"""One engine runs any plan on any rig."""

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
    """Where finished stacks go, and who may begin with one before it is complete."""

    def exposure_taken(self, taken: ExposureTaken) -> None:
        """Hear that all images of one exposure are there; must return quickly, because the rig waits."""

    def drop(self, viewpoint_id: str) -> None:
        """Hear that a viewpoint failed or was cancelled: what was begun with its exposures is void."""

    def store(self, stack: FringeStack) -> None:
        """Keep ``stack`` for good; raises StorageError."""


class Engine:
    """Runs plans on one rig and gives the stacks to a sink.

    A device that fails ends its viewpoint, and the run goes on with the next; an axis that does not arrive, or a full
    disk, ends the run, because going on would not be safe or would lose data.
    """

    def __init__(self, rig: Rig, sink: Sink) -> None:
        self._rig = rig
        self._sink = sink
        self._approached: tuple[FlangePose, float, str] | None = None  # goals of robot and guide, and when they were given

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
        plan : whose reach was checked
        pattern_images : (patterns, height, width) uint8, as the projector shows them
        on_event : hears everything; `RunEnded` last, always
        progress : also the point of cancellation
        stored : ids of viewpoints that lie on disk already

        Raises
        ------
        DeviceTimeout, StorageError, Cancelled
            After `RunEnded` was sent and all devices were stopped.
        """
        waiting = [viewpoint for viewpoint in plan if viewpoint.id not in stored]
        self._approached = None  # between runs anything may move it
        on_event(RunStarted(plan.name, tuple(viewpoint.id for viewpoint in waiting)))
        try:
            self._rig.projector.load(pattern_images)
            for index, viewpoint in enumerate(waiting):
                part = PartOf(progress, index / len(waiting), (index + 1) / len(waiting))
                self._take(viewpoint, plan, on_event, part)
        except Cancelled:
            self._stop(on_event, RunEnded("cancelled", "Stopped on request; what was stored is kept."))
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
            self._approached = None  # it may have moved
            self._sink.drop(viewpoint.id)
            on_event(ViewpointFailed(viewpoint.id, str(error)))
            return
        self._sink.store(stack)
        on_event(ViewpointStored(viewpoint.id, time.monotonic() - start))

    def _approach(self, viewpoint: Viewpoint) -> str:
        """Return when robot and guide were sent to where they stand at ``viewpoint``: goals that they have already move nothing."""
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
