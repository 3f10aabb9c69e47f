"""Control of a run from other threads: pause, resume, skip and retake."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from measureapp.acquire.events import AcquisitionEvent, ViewpointEntered, ViewpointQueued, ViewpointSkipped
from measureapp.acquire.run_states import (
    ACTIVE,
    CLOSED,
    RunState,
    ViewpointState,
    check_run_transition,
    check_viewpoint_transition,
)
from measureapp.data.plan import Viewpoint
from measureapp.errors import InputError


@dataclass(frozen=True, slots=True)
class PauseCause:
    """Why a run is paused, and what to do or to press."""

    message: str
    hint: str


BY_USER = PauseCause("Paused by the user.", "Resume the run to go on.")


@dataclass(frozen=True, slots=True)
class RunSnapshot:
    """A run at one moment, for display."""

    state: RunState
    cause: PauseCause | None  # while pausing or paused
    viewpoint_id: str | None  # the one that is being taken
    waiting: tuple[str, ...]  # those still to be taken, in order
    viewpoints: Mapping[str, ViewpointState]


class Skipped(Exception):
    """Ends the present viewpoint without a result; within `acquire` only."""


class PauseWanted(Exception):
    """Ends the present viewpoint, which is taken from its beginning after the pause; within `acquire` only."""


class RunControl:
    """Pauses, resumes and reorders one run from any thread; without Qt.

    Pass a new one to every run. Requests return at once and take effect where the rig is safe: between two moves of axes, two patterns,
    or two viewpoints. A request that makes no sense raises InputError in words and changes nothing.

    Parameters
    ----------
    attended : somebody can resume the run. Images that cannot be stored then pause it, and resuming stores the very same images;
        otherwise they end it.
    """

    def __init__(self, *, attended: bool = True) -> None:
        self.attended = attended
        self._changed = threading.Condition()
        self._state = RunState.IDLE
        self._cause: PauseCause | None = None
        self._plan: dict[str, Viewpoint] = {}
        self._states: dict[str, ViewpointState] = {}
        self._queue: deque[str] = deque()
        self._present: str | None = None
        self._skip_present = False
        self._with_images: set[str] = set()
        self._last_try: set[str] = set()
        self._notices: list[AcquisitionEvent] = []

    # for people, from any thread

    @property
    def state(self) -> RunState:
        """State of the run."""
        return self._state

    def snapshot(self) -> RunSnapshot:
        """Return the run at this moment."""
        with self._changed:
            return RunSnapshot(self._state, self._cause, self._present, tuple(self._queue), dict(self._states))

    def pause(self) -> None:
        """Pause as soon as the rig is safe; a viewpoint under way is taken from its beginning afterwards.

        The projector is then dark, nothing moves, and the rig is kept. No effect on a paused run.

        Raises
        ------
        InputError
            The run has not started, or has ended.
        """
        with self._changed:
            self._refuse_unless_running()
            if self._state is RunState.RUNNING:
                self._become(RunState.PAUSING, BY_USER)

    def resume(self) -> None:
        """Go on after a pause; images that could not be stored are stored first. No effect on a running run.

        The run stays paused, with the cause in its event and snapshot, while a device is not ready. Raises InputError as `pause`.
        """
        with self._changed:
            self._refuse_unless_running()
            if self._state is not RunState.RUNNING:
                self._become(RunState.RUNNING, None)

    def skip(self, viewpoint_id: str | None = None) -> None:
        """Skip a viewpoint: the one named, or the present one, or while paused the next one. Its images are not stored.

        A viewpoint whose images wait for space on the disk can be skipped, too: they are then discarded.

        Raises
        ------
        InputError
            The run has no such viewpoint, it is not waiting or under way, or the run is not running.
        """
        with self._changed:
            self._refuse_unless_running()
            chosen = viewpoint_id or self._present or next(iter(self._queue), None)
            if chosen is None:
                raise InputError("No viewpoint is left to be skipped.")
            state = self._state_of(chosen)
            if state is ViewpointState.WAITING:
                self._queue.remove(chosen)
                self._close(chosen, ViewpointState.SKIPPED)
            elif state in ACTIVE and (state is not ViewpointState.STORING or self._state is RunState.PAUSED):
                self._skip_present = True
            else:
                raise InputError(f"Viewpoint {chosen} cannot be skipped: it is {state}.", "Skip a viewpoint that is still to be taken.")
            self._changed.notify_all()

    def retake(self, viewpoint_id: str) -> None:
        """Take a viewpoint again at the end of the run; its present images are replaced only when the new ones are stored.

        No effect on one that is waiting already.

        Raises
        ------
        InputError
            The run has no such viewpoint, it is being taken, or the run is not running.
        """
        with self._changed:
            self._refuse_unless_running()
            state = self._state_of(viewpoint_id)
            if state in ACTIVE:
                raise InputError(f"Viewpoint {viewpoint_id} is being taken.", "Wait until it is stored.")
            if state in CLOSED:
                self._last_try.discard(viewpoint_id)
                self._enter(viewpoint_id, ViewpointState.WAITING)
                self._queue.append(viewpoint_id)
                self._notices.append(ViewpointQueued(viewpoint_id, "It is taken again at the end of the run."))

    # for the engine, from its thread

    def begin(self, viewpoints: Iterable[Viewpoint], stored: Iterable[Viewpoint] = ()) -> None:
        """Start the run; ``stored`` are further viewpoints with images, which can be taken again. Raises InputError when used before."""
        with self._changed:
            if self._state is not RunState.IDLE:
                raise InputError("The control of a run cannot be used for another one.", "Start the run again.")
            for viewpoint in viewpoints:
                self._plan[viewpoint.id] = viewpoint
                self._states[viewpoint.id] = ViewpointState.WAITING
                self._queue.append(viewpoint.id)
            for viewpoint in stored:
                self._with_images.add(viewpoint.id)
                if viewpoint.id not in self._plan:
                    self._plan[viewpoint.id] = viewpoint
                    self._states[viewpoint.id] = ViewpointState.STORED
            self._become(RunState.RUNNING, None)

    def next_viewpoint(self) -> Viewpoint | None:
        """Return the next viewpoint, which the axes now move to; None when all were taken, and the run has ended."""
        with self._changed:
            self._present, self._skip_present = None, False
            if not self._queue:
                self._become(RunState.ENDED, None)
                return None
            self._present = self._queue.popleft()
            self._enter(self._present, ViewpointState.MOVING)
            return self._plan[self._present]

    def enter(self, viewpoint_id: str, state: ViewpointState) -> None:
        """Note a transition. Raises Skipped where the images of a viewpoint to be skipped would be stored."""
        with self._changed:
            if state is ViewpointState.STORING and self._skip_present:
                raise Skipped
            self._enter(viewpoint_id, state)
            if state is ViewpointState.STORED:
                self._with_images.add(viewpoint_id)
                self._present = None

    def close(self, viewpoint_id: str, state: ViewpointState) -> bool:
        """End the present viewpoint without new images; return whether earlier ones remain."""
        with self._changed:
            self._present, self._skip_present = None, False
            return self._close(viewpoint_id, state)

    def again(self, viewpoint_id: str, *, at_the_end: bool) -> bool:
        """Queue the present viewpoint again: next, or at the end of the run for one last try; return False where it is skipped instead."""
        with self._changed:
            skips, self._present, self._skip_present = self._skip_present, None, False
            if skips:
                self._close(viewpoint_id, ViewpointState.SKIPPED)
                return False
            self._enter(viewpoint_id, ViewpointState.WAITING)
            if at_the_end:
                self._last_try.add(viewpoint_id)
                self._queue.append(viewpoint_id)
            else:
                self._queue.appendleft(viewpoint_id)
            return True

    def is_last_try(self, viewpoint_id: str) -> bool:
        """Whether a viewpoint was put at the end because it failed."""
        return viewpoint_id in self._last_try

    def checkpoint(self) -> None:
        """Raise Skipped or PauseWanted where the present viewpoint is to end; the rig is safe here."""
        if self._skip_present:
            raise Skipped
        if self._state is RunState.PAUSING:
            raise PauseWanted

    def interrupt(self, cause: PauseCause) -> None:
        """Pause for a cause other than the user's wish, which replaces the present cause."""
        with self._changed:
            if self._state is RunState.RUNNING:
                self._become(RunState.PAUSING, cause)
            else:
                self._cause = cause

    def reach_pause(self) -> PauseCause | None:
        """The rig is safe: return the cause of the pause, or None where the request was withdrawn meanwhile."""
        with self._changed:
            if self._state is RunState.PAUSING:
                self._become(RunState.PAUSED, self._cause)
            return self._cause if self._state is RunState.PAUSED else None

    def wait(self, timeout_s: float) -> bool:
        """Wait for the end of a pause; return whether it is over. Raises Skipped when images that wait to be stored are to be discarded."""
        with self._changed:
            if self._state is RunState.PAUSED and not self._skip_present:
                self._changed.wait(timeout_s)
            if self._skip_present:
                self._skip_present = False
                raise Skipped
            return self._state is not RunState.PAUSED

    def notices(self) -> tuple[AcquisitionEvent, ...]:
        """Return the events of all transitions since the last call, in order."""
        with self._changed:
            found, self._notices = tuple(self._notices), []
            return found

    def end(self) -> None:
        """End the run however it ended; a viewpoint under way has no result."""
        with self._changed:
            if self._present is not None and self._states[self._present] in ACTIVE:
                self._enter(self._present, ViewpointState.WAITING)
            self._present = None
            if self._state is not RunState.ENDED:
                self._become(RunState.ENDED, None)

    # with the lock held

    def _become(self, state: RunState, cause: PauseCause | None) -> None:
        check_run_transition(self._state, state)
        self._state, self._cause = state, cause
        self._changed.notify_all()

    def _enter(self, viewpoint_id: str, state: ViewpointState) -> None:
        check_viewpoint_transition(viewpoint_id, self._states[viewpoint_id], state)
        self._states[viewpoint_id] = state
        self._notices.append(ViewpointEntered(viewpoint_id, state))

    def _close(self, viewpoint_id: str, state: ViewpointState) -> bool:
        has_images = viewpoint_id in self._with_images
        self._enter(viewpoint_id, ViewpointState.KEPT if has_images else state)
        if state is ViewpointState.SKIPPED:
            self._notices.append(ViewpointSkipped(viewpoint_id))
        return has_images

    def _state_of(self, viewpoint_id: str) -> ViewpointState:
        if viewpoint_id not in self._states:
            raise InputError(f"The run has no viewpoint {viewpoint_id!r}.", "Name a viewpoint of the plan.")
        return self._states[viewpoint_id]

    def _refuse_unless_running(self) -> None:
        if self._state is RunState.IDLE:
            raise InputError("The run has not started yet.", "Wait until it moves.")
        if self._state is RunState.ENDED:
            raise InputError("The run has ended.", "Start it again to take further viewpoints.")
