"""Acquisition engine: runs one task at every viewpoint of a list, on any rig."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

from measureapp.acquire.control import RunControl
from measureapp.acquire.events import AcquisitionEvent, RunEnded, RunStarted, ViewpointFailed
from measureapp.acquire.motion import checked
from measureapp.acquire.run import Run
from measureapp.acquire.run_states import ViewpointState
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Task, Visit
from measureapp.data.plan import Viewpoint
from measureapp.devices.rig import Rig
from measureapp.errors import DeviceError, MeasureError
from measureapp.progress import Cancelled, Progress

T = TypeVar("T")
OnEvent = Callable[[AcquisitionEvent], None]
MOST_NAMED = 8  # viewpoints in a message


class Engine:
    """Takes one task through viewpoints: move, confirm by read-back, settle, capture, check, store.

    Images that are damaged or contradict each other are taken again at once; a viewpoint that stays refused is tried once more at the
    end of the run, and then reported. An axis that does not reach its goal or a device that does not answer ends the run: every device is
    stopped, because continuing would be unsafe. Images that cannot be stored pause an attended run, and end any other.
    """

    def __init__(self, rig: Rig) -> None:
        self._rig = rig

    def run(
        self,
        name: str,
        viewpoints: Sequence[Viewpoint],
        task: Task[T],
        on_event: OnEvent,
        progress: Progress,
        control: RunControl | None = None,
        stored: Sequence[Viewpoint] = (),
    ) -> tuple[ViewpointFailed, ...]:
        """Run ``task`` at every viewpoint and return those that failed.

        Parameters
        ----------
        viewpoints : must be within the rig's limits, see `check_reach`
        on_event : receives all events; `RunEnded` is always the last one
        progress : also the cancellation point, while devices are waited for, too
        control : pauses, resumes, skips and retakes from other threads; a new one for every run
        stored : further viewpoints whose images are stored already, which can be taken again

        Raises
        ------
        DeviceTimeout, MotionError, DeviceLost, StorageError, Cancelled
            After all devices were stopped and `RunEnded` was sent; so is every other exception.
        InputError
            The control was used before; nothing was sent.
        """
        control = control or RunControl(attended=False)
        control.begin(viewpoints, stored)
        session = RigSession(self._rig, progress, control.checkpoint)
        run = Run(session, task, control, on_event, progress)

        def left() -> str:
            control.end()
            run.tell()
            return _left(control)

        on_event(RunStarted(name, tuple(viewpoint.id for viewpoint in viewpoints)))
        self._hold(session, run.work, on_event, left, lambda: _stored(control))
        return tuple(run.failures.values())

    def run_here(self, name: str, task: Task[T], on_event: OnEvent, progress: Progress) -> None:
        """Run ``task`` once where the axes are; nothing moves. Raises FrameError or DeviceError where `run` skips a viewpoint."""
        session = RigSession(self._rig, progress)

        def work() -> None:
            task.prepare(session)
            before = session.readback()
            result = task.take(session, Visit(name, before), on_event, progress)
            session.confirm_still(name, before)
            task.check(result)
            task.keep(result)

        on_event(RunStarted(name, (name,)))
        self._hold(session, work, on_event, lambda: "", tuple)

    def _hold(
        self,
        session: RigSession,
        work: Callable[[], None],
        on_event: OnEvent,
        left: Callable[[], str],
        stored: Callable[[], tuple[str, ...]],
    ) -> None:
        """Do the work in a session of the rig, and send `RunEnded` however it ends, with what is ``left`` to be done."""
        ended = RunEnded("done")
        try:
            with session:
                work()
                ended = RunEnded("done", session.link_warnings())
        except (Cancelled, KeyboardInterrupt):
            ended = RunEnded("cancelled", f"Stopped: {self._rig.latch.reason or 'cancelled by the user.'}")
            raise
        except MeasureError as error:
            ended = RunEnded("failed", str(error))
            raise
        except BaseException as error:
            ended = RunEnded("failed", f"{type(error).__name__}: {error}.")
            raise
        finally:
            remaining = left()
            message = " ".join(part for part in (ended.message, session.stop_report, remaining) if part)
            on_event(RunEnded(ended.reason, message, stored(), remaining))


def _stored(control: RunControl) -> tuple[str, ...]:
    """Return the viewpoints that are stored."""
    return tuple(name for name, state in control.snapshot().viewpoints.items() if state is ViewpointState.STORED)


def _left(control: RunControl) -> str:
    """Return what is kept of a run, what is missing, and what to do; empty where everything is stored."""
    states = control.snapshot().viewpoints
    missing = [name for name, state in states.items() if state not in (ViewpointState.STORED, ViewpointState.KEPT)]
    if not missing:
        return ""
    named = ", ".join(missing[:MOST_NAMED]) + (", …" if len(missing) > MOST_NAMED else "")
    kept = len(states) - len(missing)
    return f"{kept} of {len(states)} viewpoints are stored and kept; not {named}. Continue the run to take the missing ones."


def run_once(rig: Rig, name: str, viewpoint: Viewpoint | None, task: Task[T], progress: Progress) -> None:
    """Run ``task`` at one viewpoint, or where the axes are. Raises DeviceError where it fails.

    A rig without checked paths gets those around an empty table.
    """
    if viewpoint is None:
        Engine(rig).run_here(name, task, lambda _: None, progress)
        return
    for failure in Engine(rig if rig.paths is not None else checked(rig, None)).run(name, (viewpoint,), task, lambda _: None, progress):
        raise DeviceError(failure.reason)
