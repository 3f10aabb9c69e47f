"""Acquisition engine: runs one task at every viewpoint of a list, on any rig."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from datetime import UTC, datetime
from typing import TypeVar

from measureapp.acquire.events import (
    AcquisitionEvent,
    RunEnded,
    RunStarted,
    ViewpointFailed,
    ViewpointRetaken,
    ViewpointStarted,
    ViewpointStored,
)
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Task, Visit
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, FrameError, MeasureError, MotionError
from measureapp.progress import Cancelled, PartOf, Progress

T = TypeVar("T")
OnEvent = Callable[[AcquisitionEvent], None]
TRIES = 3  # for a viewpoint whose images are refused


class Engine:
    """Takes one task through viewpoints: move, confirm by read-back, take, check that nothing moved, keep.

    Images that are damaged or contradict each other are taken again; a device that refuses a setting ends the viewpoint, and the run
    continues with the next one. An axis that does not reach its goal, a device that does not answer, or a full disk ends the run:
    every device is stopped, because continuing would be unsafe or lose data.
    """

    def __init__(self, rig: Rig) -> None:
        self._rig = rig
        self._approached: tuple[FlangePose, float, str] | None = None  # goals of robot and guide, and the time of the command

    def run(
        self, name: str, viewpoints: Sequence[Viewpoint], task: Task[T], on_event: OnEvent, progress: Progress
    ) -> tuple[ViewpointFailed, ...]:
        """Run ``task`` at every viewpoint and return those that failed.

        Parameters
        ----------
        viewpoints : must be within the rig's limits, see `check_reach`
        on_event : receives all events; `RunEnded` is always the last one
        progress : also the cancellation point, while devices are waited for, too

        Raises
        ------
        DeviceTimeout, MotionError, DeviceLost, StorageError, Cancelled
            After all devices were stopped and `RunEnded` was sent; so is every other exception.
        """
        self._approached = None  # the robot may have been moved between runs
        failed = []

        def work(session: RigSession) -> None:
            task.prepare(session)
            for index, viewpoint in enumerate(viewpoints):
                part = PartOf(progress, index / len(viewpoints), (index + 1) / len(viewpoints))
                failure = self._visit(session, viewpoint, task, on_event, part)
                if failure is not None:
                    failed.append(failure)
                    on_event(failure)

        on_event(RunStarted(name, tuple(viewpoint.id for viewpoint in viewpoints)))
        self._hold(work, on_event, progress)
        return tuple(failed)

    def run_here(self, name: str, task: Task[T], on_event: OnEvent, progress: Progress) -> None:
        """Run ``task`` once where the axes are; nothing moves. Raises FrameError or DeviceError where `run` skips a viewpoint."""

        def work(session: RigSession) -> None:
            task.prepare(session)
            before = session.readback()
            result = task.take(session, Visit(name, before), on_event, progress)
            session.confirm_still(name, before)
            task.keep(result)

        on_event(RunStarted(name, (name,)))
        self._hold(work, on_event, progress)

    def _hold(self, work: Callable[[RigSession], None], on_event: OnEvent, progress: Progress) -> None:
        """Do the work in a session of the rig, and send `RunEnded` however it ends."""
        session = RigSession(self._rig, progress)
        ended = RunEnded("done")
        try:
            with session:
                work(session)
                ended = RunEnded("done", session.link_warnings())
        except (Cancelled, KeyboardInterrupt):
            ended = RunEnded("cancelled", f"Stopped: {self._rig.latch.reason or 'cancelled by the user.'} What was stored is kept.")
            raise
        except MeasureError as error:
            ended = RunEnded("failed", str(error))
            raise
        except BaseException as error:
            ended = RunEnded("failed", f"{type(error).__name__}: {error}")
            raise
        finally:
            on_event(RunEnded(ended.reason, f"{ended.message} {session.stop_report}".strip()))

    def _visit(
        self, session: RigSession, viewpoint: Viewpoint, task: Task[T], on_event: OnEvent, progress: Progress
    ) -> ViewpointFailed | None:
        """Take one viewpoint, again where its images are refused; return the failure, if it failed."""
        started = time.monotonic()
        on_event(ViewpointStarted(viewpoint.id))
        for attempt in range(1, TRIES + 1):
            try:
                result = self._take(session, viewpoint, task, on_event, progress)
            except (FrameError, DeviceTimeout) as error:
                task.drop(viewpoint.id)
                if attempt == TRIES:
                    return _give_up(viewpoint, error)
                on_event(ViewpointRetaken(viewpoint.id, str(error)))
            except (MotionError, DeviceLost):
                task.drop(viewpoint.id)
                raise
            except DeviceError as error:
                task.drop(viewpoint.id)
                return ViewpointFailed(viewpoint.id, str(error))
            except BaseException:
                task.drop(viewpoint.id)
                raise
            else:
                task.keep(result)
                on_event(ViewpointStored(viewpoint.id, time.monotonic() - started))
                return None
        return None

    def _take(self, session: RigSession, viewpoint: Viewpoint, task: Task[T], on_event: OnEvent, progress: Progress) -> T:
        try:
            readback = session.move_to(viewpoint)
        except DeviceTimeout as error:  # unlike an image that does not arrive, nothing to try again
            raise MotionError(error.message, error.hint) from error
        visit = Visit(viewpoint.id, readback, self._approach(viewpoint))
        result = task.take(session, visit, on_event, progress)
        session.confirm_still(viewpoint.id, readback)
        return result

    def _approach(self, viewpoint: Viewpoint) -> str:
        """Return the time at which robot and guide were sent to ``viewpoint``; an unchanged goal does not move them."""
        goals = (viewpoint.flange, viewpoint.guide_mm)
        if self._approached is None or self._approached[:2] != goals:
            self._approached = (*goals, datetime.now(UTC).isoformat())
        return self._approached[2]


def _give_up(viewpoint: Viewpoint, error: DeviceError) -> ViewpointFailed:
    """Return the failure of a viewpoint after its last try. Raises DeviceLost where images do not arrive at all."""
    if isinstance(error, DeviceTimeout):
        raise DeviceLost(f"{viewpoint.id}: {error.message} It was tried {TRIES} times.", error.hint) from error
    return ViewpointFailed(viewpoint.id, str(error))


def run_once(rig: Rig, name: str, viewpoint: Viewpoint | None, task: Task[T], progress: Progress) -> None:
    """Run ``task`` at one viewpoint, or where the axes are. Raises DeviceError where it fails."""
    if viewpoint is None:
        Engine(rig).run_here(name, task, lambda _: None, progress)
        return
    for failure in Engine(rig).run(name, (viewpoint,), task, lambda _: None, progress):
        raise DeviceError(failure.reason)
