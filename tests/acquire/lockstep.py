"""A run of the engine in lockstep with a test: every move, image, check, store and wait of a pause happens when the test says so."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from acquire.fake_rig import HEIGHT, WIDTH, Cell, fake_rig

from measureapp.acquire.control import RunControl
from measureapp.acquire.engine import Engine
from measureapp.acquire.events import AcquisitionEvent, RunEnded
from measureapp.acquire.session import RigSession
from measureapp.acquire.task import Visit
from measureapp.data.plan import Viewpoint
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, FrameError, LimitError, PlanError, StorageError
from measureapp.progress import Cancelled

WATCHDOG_S = 60.0  # nothing waits; only a deadlock takes longer
POINTS = {"robot": "move", "left": "trigger"}  # devices whose calls are points


class Deadlock(AssertionError):
    """The engine neither reached a point nor ended."""


class Lockstep:
    """Where the engine waits for the test."""

    def __init__(self) -> None:
        self._changed = threading.Condition()
        self.at: str | None = None  # the point at which the engine waits
        self._outcome: str | None = None
        self._aborted = self.ended = False
        self.follows = True  # False: the engine runs through

    def point(self, name: str) -> str:
        """Wait until the test goes on, and return what is to happen; for the engine's threads."""
        with self._changed:
            if not self.follows:
                return "ok"
            self.at = name
            self._changed.notify_all()
            if not self._changed.wait_for(lambda: self._outcome is not None or self._aborted or not self.follows, WATCHDOG_S):
                raise Deadlock(f"the test left the engine at {name}")
            outcome, self.at, self._outcome = self._outcome, None, None
            if outcome is None and self._aborted:
                raise Cancelled
            return outcome or "ok"

    def go(self, outcome: str) -> None:
        """Let the engine go on from its point, and wait for the next one; for the test."""
        with self._changed:
            assert self.at is not None
            self._outcome = outcome
            self._changed.notify_all()
            self._changed.wait_for(lambda: self._outcome is None, WATCHDOG_S)
        self.reach()

    def reach(self) -> None:
        """Wait until the engine is at a point, or has ended."""
        with self._changed:
            if not self._changed.wait_for(lambda: self.ended or (self.at is not None and not self._aborted), WATCHDOG_S):
                raise Deadlock("the engine reached no point and did not end")

    def abort(self) -> None:
        """Cancel what waits; as the stop of a device."""
        with self._changed:
            self._aborted = True
            self._changed.notify_all()

    def end(self) -> None:
        with self._changed:
            self.ended, self.at = True, None
            self._changed.notify_all()

    def let_go(self) -> None:
        with self._changed:
            self.follows = False
            self._changed.notify_all()


class SteppedControl(RunControl):
    """A control whose pause is waited for in lockstep."""

    def __init__(self, steps: Lockstep) -> None:
        super().__init__()
        self._steps = steps

    def wait(self, timeout_s: float) -> bool:
        if super().wait(0.0):
            return True
        if not self._steps.follows:
            return super().wait(timeout_s)
        self._steps.point("paused")
        return super().wait(0.0)


@dataclass
class Stored:
    """What is on the disk: the number of the take of every viewpoint."""

    takes: dict[str, int] = field(default_factory=dict)
    taken: int = 0


class SteppedTask:
    def __init__(self, steps: Lockstep, disk: Stored) -> None:
        self.steps, self.disk = steps, disk
        self.dropped: list[str] = []

    def prepare(self, session: RigSession) -> None:
        pass

    def take(self, session: RigSession, visit: Visit, on_event: Callable[[AcquisitionEvent], None], progress: object) -> tuple[str, int]:
        assert len(list(session.shots((0, 1), (1_000,)))) == 2
        self.disk.taken += 1
        return visit.viewpoint_id, self.disk.taken

    def check(self, result: tuple[str, int]) -> None:
        if self.steps.point("check") == "contradiction":
            raise FrameError("The images contradict each other.", "Check the projector.")

    def keep(self, result: tuple[str, int]) -> None:
        outcome = self.steps.point("store")
        if outcome == "full":
            raise StorageError("The disk is full.", "Free some space.")
        if outcome == "bug":
            raise ValueError("a bug")
        self.disk.takes[result[0]] = result[1]

    def drop(self, viewpoint_id: str) -> None:
        self.dropped.append(viewpoint_id)


class SteppedRun:
    """One run on a thread of its own."""

    def __init__(self, viewpoints: tuple[Viewpoint, ...], stored: tuple[Viewpoint, ...], disk: Stored) -> None:
        self.steps, self.disk = Lockstep(), disk
        self.control = SteppedControl(self.steps)
        self.events: list[AcquisitionEvent] = []
        self.error: BaseException | None = None
        self.cancelled = False
        self.cell = Cell(fault=self._fault)
        self.cell.image = lambda camera, exposure_us, pattern: np.zeros((HEIGHT, WIDTH), np.uint8)  # type: ignore[method-assign]
        self.rig = fake_rig(self.cell)
        self._ready = DeviceStatus(True, "ready")
        self.rig.robot.status = lambda: self._ready  # type: ignore[method-assign]
        genuine = self.rig.robot.stop

        def stop() -> None:
            self.steps.abort()
            genuine()

        self.rig.robot.stop = stop  # type: ignore[method-assign]
        self.task = SteppedTask(self.steps, disk)
        self._thread = threading.Thread(target=self._work, args=(viewpoints, stored), name="engine under test")
        self._thread.start()
        self.steps.reach()

    def ready(self, is_ready: bool) -> None:
        """Let the robot be ready, or not."""
        self._ready = DeviceStatus(is_ready, "ready" if is_ready else "its door is open.", "" if is_ready else "Close it.")

    def close(self) -> None:
        """End the run and its thread."""
        self.cancelled = True
        self.steps.let_go()
        self._thread.join(WATCHDOG_S)
        assert not self._thread.is_alive()

    # progress

    def report(self, done: float, total: float, note: str = "") -> None:
        self.check()

    def check(self) -> None:
        if self.cancelled:
            raise Cancelled

    def _work(self, viewpoints: tuple[Viewpoint, ...], stored: tuple[Viewpoint, ...]) -> None:
        try:
            Engine(self.rig).run("stepped", viewpoints, self.task, self.events.append, self, self.control, stored)
        except BaseException as error:
            self.error = error
        finally:
            self.rig.close()
            self.steps.end()

    def _fault(self, device: str, call: int) -> str:
        if device not in POINTS:
            return ""
        outcome = self.steps.point(POINTS[device])
        if outcome == "refused":
            raise DeviceError(f"{device} refuses.", "Choose another setting.")
        if outcome == "limit":
            raise LimitError(f"{device} cannot go there.", "Choose another goal.")
        if outcome == "no path":
            raise PlanError("There is no path from here.", "Start elsewhere.")
        return "" if outcome == "ok" else outcome

    @property
    def ended(self) -> RunEnded | None:
        return next((event for event in self.events if isinstance(event, RunEnded)), None)
