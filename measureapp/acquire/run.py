"""One run: viewpoint after viewpoint through its states, with pauses, second tries, and images that wait to be stored."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Callable
from datetime import UTC, datetime
from typing import Generic, TypeVar

from measureapp.acquire.control import PauseCause, PauseWanted, RunControl, Skipped
from measureapp.acquire.events import (
    AcquisitionEvent,
    RunPaused,
    RunResumed,
    ViewpointFailed,
    ViewpointQueued,
    ViewpointRetaken,
    ViewpointStarted,
    ViewpointStored,
)
from measureapp.acquire.run_states import CLOSED, ViewpointState
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Task, Visit
from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, FrameError, LimitError, MotionError, PlanError, StorageError
from measureapp.progress import PartOf, Progress

T = TypeVar("T")
OnEvent = Callable[[AcquisitionEvent], None]
TRIES = 3  # for a viewpoint whose images are refused, before it is put at the end of the run
PAUSE_POLL_S, HEARTBEAT_S = 0.1, 2.0


class Run(Generic[T]):
    """Takes a task through the viewpoints of a control, within one session of the rig."""

    def __init__(self, session: RigSession, task: Task[T], control: RunControl, on_event: OnEvent, progress: Progress) -> None:
        self.failures: dict[str, ViewpointFailed] = {}
        self._session, self._task, self._control, self._on_event, self._progress = session, task, control, on_event, progress
        self._tries: Counter[str] = Counter()
        self._started: dict[str, float] = {}  # of the monotonic clock
        self._approached: tuple[FlangePose, float, str] | None = None  # goals of robot and guide, and the time of the command

    def work(self) -> None:
        """Take all viewpoints. Raises as `Engine.run`."""
        self._task.prepare(self._session)
        while True:
            self._wait_while_paused()
            part = self._part()
            viewpoint = self._control.next_viewpoint()
            if viewpoint is None:
                return
            self._visit(viewpoint, part)

    def tell(self) -> None:
        """Send the events of all transitions since the last call."""
        for event in self._control.notices():
            self._on_event(event)

    def _part(self) -> Progress:
        """Return the progress of the next viewpoint."""
        now = self._control.snapshot()
        done = sum(state in CLOSED for state in now.viewpoints.values())
        total = max(1, done + len(now.waiting))
        return PartOf(self._progress, done / total, min(1.0, (done + 1) / total))

    # one viewpoint

    def _visit(self, viewpoint: Viewpoint, progress: Progress) -> None:
        """Take a viewpoint once, and say what becomes of it."""
        if viewpoint.id not in self._started:
            self._started[viewpoint.id] = time.monotonic()
            self._on_event(ViewpointStarted(viewpoint.id))
        self.tell()
        try:
            self._keep(viewpoint, self._take(viewpoint, progress))
        except Skipped:
            self._task.drop(viewpoint.id)
            self._close(viewpoint.id, ViewpointState.SKIPPED)
        except PauseWanted:
            self._task.drop(viewpoint.id)
            self._again(viewpoint.id, at_the_end=False)
        except (MotionError, DeviceLost):
            self._task.drop(viewpoint.id)
            raise
        except (DeviceError, PlanError) as error:  # without a path from here nothing moved: there may be one from elsewhere
            self._task.drop(viewpoint.id)
            self._refuse(viewpoint, error)
        except BaseException:
            self._task.drop(viewpoint.id)
            raise

    def _take(self, viewpoint: Viewpoint, progress: Progress) -> T:
        """Move, confirm, settle, capture, check."""
        session, name = self._session, viewpoint.id
        try:
            session.move_axes(viewpoint)
            self._enter(name, ViewpointState.CONFIRMING)
            readback = session.confirm_reached(viewpoint)
            self._enter(name, ViewpointState.SETTLING)
            if session.settle(viewpoint):
                readback = session.confirm_reached(viewpoint)
        except DeviceTimeout as error:  # unlike an image that does not arrive, nothing to try again
            raise MotionError(error.message, error.hint) from error
        self._enter(name, ViewpointState.CAPTURING)
        visit = Visit(name, readback, self._approach(viewpoint), viewpoint.exposures_us)
        result = self._task.take(session, visit, self._on_event, progress)
        self._enter(name, ViewpointState.CHECKING)
        session.confirm_still(name, readback)
        self._task.check(result)
        return result

    def _keep(self, viewpoint: Viewpoint, result: T) -> None:
        """Store the result; where that fails, pause and store the same one when the run is resumed."""
        self._enter(viewpoint.id, ViewpointState.STORING)
        while True:
            try:
                self._task.keep(result)
                break
            except StorageError as error:
                if not self._control.attended:
                    raise
                hint = f"The images of {viewpoint.id} are in memory; they are stored first when the run goes on."
                self._control.interrupt(PauseCause(error.message, f"{error.hint} {hint}".strip()))
                self._wait_while_paused()
        self._enter(viewpoint.id, ViewpointState.STORED)
        self.failures.pop(viewpoint.id, None)
        self._on_event(ViewpointStored(viewpoint.id, time.monotonic() - self._started[viewpoint.id]))
        self._forget(viewpoint.id)

    def _refuse(self, viewpoint: Viewpoint, error: DeviceError | PlanError) -> None:
        """Take a viewpoint again whose images or settings were refused: at once, then once at the end of the run; then it failed."""
        name, of_images = viewpoint.id, isinstance(error, FrameError | DeviceTimeout)
        self._tries[name] += 1
        if self._control.is_last_try(name) or isinstance(error, LimitError):
            self._fail(name, error)
        elif of_images and self._tries[name] < TRIES:
            if self._again(name, at_the_end=False):
                self._on_event(ViewpointRetaken(name, str(error)))
        elif isinstance(error, DeviceTimeout):
            raise DeviceLost(f"{name}: {error.message} It was tried {TRIES} times.", error.hint) from error
        elif self._again(name, at_the_end=True):
            self._on_event(ViewpointQueued(name, f"{error} It is tried once more at the end of the run."))

    def _fail(self, name: str, error: DeviceError | PlanError) -> None:
        has_images = self._close(name, ViewpointState.FAILED)
        self.failures[name] = ViewpointFailed(name, f"{error} The images stored before are kept." if has_images else str(error))
        self._on_event(self.failures[name])

    def _enter(self, name: str, state: ViewpointState) -> None:
        self._control.enter(name, state)
        self.tell()

    def _again(self, name: str, *, at_the_end: bool) -> bool:
        is_queued = self._control.again(name, at_the_end=at_the_end)
        if not is_queued:
            self._forget(name)
        self.tell()
        return is_queued

    def _close(self, name: str, state: ViewpointState) -> bool:
        has_images = self._control.close(name, state)
        self._forget(name)
        self.tell()
        return has_images

    def _forget(self, name: str) -> None:
        self._started.pop(name, None)
        self._tries.pop(name, None)

    def _approach(self, viewpoint: Viewpoint) -> str:
        """Return the time at which robot and guide were sent to ``viewpoint``; an unchanged goal does not move them."""
        goals = (viewpoint.flange, viewpoint.guide_mm)
        if self._approached is None or self._approached[:2] != goals:
            self._approached = (*goals, datetime.now(UTC).isoformat())
        return self._approached[2]

    # pauses

    def _wait_while_paused(self) -> None:
        """Wait for the end of a pause in a safe state; a device that is not ready keeps the run paused.

        Raises
        ------
        Skipped
            Images that wait to be stored are to be discarded.
        """
        self.tell()
        while (cause := self._control.reach_pause()) is not None:
            self._session.darken()
            self._on_event(RunPaused(cause.message, cause.hint))
            self._wait(cause)
            unready = self._session.unready()
            if not unready:
                self._on_event(RunResumed())
                return
            self._control.interrupt(PauseCause(unready, "Make it ready, then resume the run."))

    def _wait(self, cause: PauseCause) -> None:
        """Wait until the run is resumed; the devices are asked for their state now and then, so that connections last."""
        shown, next_beat = "", time.monotonic() + HEARTBEAT_S
        while not self._control.wait(PAUSE_POLL_S):
            self.tell()
            self._session.check()
            if time.monotonic() < next_beat:
                continue
            unready, next_beat = self._session.unready(), time.monotonic() + HEARTBEAT_S
            if unready != shown:
                shown = unready
                self._on_event(RunPaused(f"{cause.message} {unready}".strip(), cause.hint))
        self.tell()
