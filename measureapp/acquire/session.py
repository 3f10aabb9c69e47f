"""The one hand on a rig: whatever moves an axis or triggers a camera goes through a session."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from datetime import UTC, datetime
from types import TracebackType
from typing import TypeVar

from measureapp.acquire.device_call import call_device
from measureapp.acquire.motion import confirm_reached, confirm_still, legs_to
from measureapp.acquire.states import read_states
from measureapp.acquire.stopping import abort
from measureapp.arrays import ImageArray
from measureapp.data.conditions import Conditions
from measureapp.data.fringe import AxisReadback
from measureapp.data.leg import Leg
from measureapp.data.plan import Viewpoint
from measureapp.devices.camera import Camera, RendersImages
from measureapp.devices.head import HardwareHead, Head, Shot, SoftwareHead
from measureapp.devices.head_timing import frame_timeout_s
from measureapp.devices.projector import DARK, TriggeringProjector
from measureapp.devices.rig import Rig
from measureapp.devices.robot import JointRobot
from measureapp.errors import DeviceError, MeasureError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Cancelled, NoProgress, Progress

BY_USER = "cancelled by the user."
READ_TIMEOUT_S = 4.0
LOAD_TIMEOUT_S = 120.0
SETTLE_POLL_S = 0.05
T = TypeVar("T")
STEPS_OF_A_SHOT = 4  # a shot waits for a pattern, the exposure of the next one, and images on their way


class RigSession:
    """Moves the axes and takes images of one rig; a context manager that stops every device on any exception whatever.

    A stop latches, unless its cause was only that images were unfit or could not be stored: no session starts on the rig before
    `acquire.stopping.reset`. Calls that wait for a device end at once when the
    progress is cancelled; `abort` does the same from any thread.

    Raises
    ------
    DeviceError
        On entering, while the rig is stopped or used by another session.
    """

    def __init__(self, rig: Rig, progress: Progress | None = None, checkpoint: Callable[[], None] = lambda: None) -> None:
        self.rig = rig
        self.checkpoint = checkpoint  # may end the work between two moves or two images, by an exception
        self.stop_report = ""  # devices that did not confirm the stop
        self._progress = progress or NoProgress()
        self._aborted = threading.Event()

    def __enter__(self) -> RigSession:
        """Take hold of the rig."""
        self.rig.latch.check()
        if not self.rig.in_use.acquire(blocking=False):
            raise DeviceError(
                f"The rig {self.rig.description.name} is in use by another task.", "Wait until that has finished, or stop it."
            )
        return self

    def __exit__(self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None) -> None:
        """Stop everything after an exception; switch the light off in any case."""
        try:
            if error is not None:
                self.stop_report = abort(self.rig, _reason_of(error), latch=_doubts_the_rig(error))
            else:
                self.darken()
        finally:
            self.rig.in_use.release()

    def darken(self) -> None:
        """Switch the light off; a projector that fails to is reported at the end."""
        try:
            self.call("The projector", lambda: self.rig.projector.show(DARK, timeout_s=READ_TIMEOUT_S), READ_TIMEOUT_S)
        except DeviceError as error:  # all that was wanted is done
            self.stop_report = f"The light could not be switched off: {error}"

    def abort(self, reason: str) -> None:
        """Stop every device now, from any thread, and latch the stop."""
        self.stop_report = abort(self.rig, reason)
        self._aborted.set()

    # axes

    def move_to(self, viewpoint: Viewpoint) -> AxisReadback:
        """Move table, guide and robot to ``viewpoint`` one after the other, let them settle, and return the confirmed read-back.

        Raises
        ------
        LimitError
            A goal lies outside the limits of an axis, which did not move.
        DeviceTimeout, MotionError, DeviceLost
            An axis did not reach its goal, or its controller failed.
        Cancelled
            From the progress; every axis was stopped.
        """
        self.move_axes(viewpoint)
        readback = self.confirm_reached(viewpoint)
        return self.confirm_reached(viewpoint) if self.settle(viewpoint) else readback

    def move_axes(self, viewpoint: Viewpoint) -> None:
        """Move one axis after the other, on the checked path if the rig has paths; raises as `move_to`, but does not read back."""
        for leg in legs_to(viewpoint, self.rig, self.readback):
            if leg.axis == "table":
                self.move_table(leg.goal.table_rad)
            elif leg.axis == "guide":
                self.move_guide(leg.goal.guide_mm)
            else:
                self._move_arm(leg)

    def confirm_reached(self, viewpoint: Viewpoint) -> AxisReadback:
        """Return the read-back of every axis. Raises MotionError where one is away from its goal."""
        readback = self.readback()
        confirm_reached(viewpoint, readback, self.rig.description.motion)
        return readback

    def settle(self, viewpoint: Viewpoint) -> bool:
        """Wait as long as the viewpoint or else the rig states; return whether that takes time."""
        settle_s = self.rig.description.motion.settle_s if viewpoint.settle_s is None else viewpoint.settle_s
        end = time.monotonic() + settle_s
        while (left_s := end - time.monotonic()) > 0:
            self.check()
            self.checkpoint()
            self._aborted.wait(min(left_s, SETTLE_POLL_S))
        return settle_s > 0

    def move_table(self, goal_rad: float) -> None:
        """Turn the table alone; raises as `move_to`, but does not read back."""
        self._move("The rotary table", lambda limit_s: self.rig.table.move_to(goal_rad, timeout_s=limit_s))

    def move_guide(self, goal_mm: float) -> None:
        """Move the guide alone; raises as `move_to`, but does not read back."""
        self._move("The linear guide", lambda limit_s: self.rig.guide.move_to(goal_mm, timeout_s=limit_s))

    def _move_arm(self, leg: Leg) -> None:
        robot, goal_rad = self.rig.robot, leg.joints_rad
        if goal_rad is None or not isinstance(robot, JointRobot):
            self.move_robot(leg.goal.base_from_flange)
        else:
            self._move("The robot", lambda limit_s: robot.move_joints(goal_rad, timeout_s=limit_s))

    def move_robot(self, base_from_flange: RigidTransform) -> None:
        """Move the robot alone; raises as `move_to`, but does not read back."""
        self._move("The robot", lambda limit_s: self.rig.robot.move_to(base_from_flange, timeout_s=limit_s))

    def home(self) -> None:
        """Let table and guide find their reference positions, one after the other; raises as `move_to`."""
        self._move("The rotary table", lambda limit_s: self.rig.table.home(timeout_s=limit_s))
        self._move("The linear guide", lambda limit_s: self.rig.guide.home(timeout_s=limit_s))

    def _move(self, what: str, move: Callable[[float], None]) -> None:
        self.checkpoint()
        limit_s = self.rig.description.motion.move_timeout_s
        self.call(what, lambda: move(limit_s), limit_s)

    def readback(self) -> AxisReadback:
        """Read every axis back."""
        return self.call("A controller", self.rig.readback, READ_TIMEOUT_S)

    def confirm_still(self, viewpoint_id: str, before: AxisReadback) -> None:
        """Raise MotionError when an axis has moved since ``before``."""
        confirm_still(viewpoint_id, before, self.readback(), self.rig.description.motion)

    # head

    def load(self, images: ImageArray) -> None:
        """Load the projector's images, (patterns, height, width) uint8."""
        self.call("The projector", lambda: self.rig.projector.load(images), LOAD_TIMEOUT_S)

    def shots(self, patterns: Sequence[int], exposures_us: Sequence[int], cameras: Collection[str] | None = None) -> Iterator[Shot]:
        """Take the patterns at every exposure, with all cameras or those named; a pattern that was taken again comes last.

        Raises
        ------
        FrameError, DeviceTimeout, DeviceLost, DeviceError
            As `Head.prepare` and `Head.acquire`.
        Cancelled
            From the progress; every device was stopped.
        """
        self.checkpoint()
        used = {name: camera for name, camera in self.rig.cameras.items() if cameras is None or name in cameras}
        head = self._head(min(patterns), used)
        within_s = STEPS_OF_A_SHOT * max(frame_timeout_s(camera, max(exposures_us)) for camera in used.values()) + rendering_s(
            used.values()
        )
        self.call("A camera", lambda: head.prepare(patterns, exposures_us), READ_TIMEOUT_S * len(exposures_us))
        waiting, missing = head.acquire(), len(patterns) * len(exposures_us)
        try:
            while (shot := self.call("The measuring head", lambda: next(waiting, None), within_s)) is not None:
                yield shot
                missing -= 1
                if missing > 0:  # a complete sequence is not thrown away
                    self.checkpoint()
        finally:
            with suppress(ValueError):  # a call that was given up still runs it, and ends it itself
                waiting.close()

    def _head(self, lowest_pattern: int, cameras: Mapping[str, Camera]) -> Head:
        """Return the head in the rig's way of synchronisation; uniform light and darkness are no images that a projector could play."""
        projector = self.rig.projector
        if self.rig.description.head.sequence == "software" or lowest_pattern < 0:
            return SoftwareHead(cameras, projector)
        if not isinstance(projector, TriggeringProjector):
            raise DeviceError(
                f"{projector.name} cannot trigger cameras, as the hardware sequence of {self.rig.description.name} needs.",
                'Set sequence = "software" in [head] of the rig description.',
            )
        return HardwareHead(cameras, projector)

    def place_on_table(self, thing: str) -> None:
        """Request an object by name ("board", "part") and return when it is on the table."""
        self.rig.place_on_table(thing)

    def conditions(self) -> Conditions:
        """Read the present time, temperature, serial numbers and lens settings."""
        return read_conditions(self.rig)

    def link_warnings(self) -> str:
        """Return which cameras had many packets sent again since they were connected; empty if none, or where a camera does not tell."""
        found = []
        for name, camera in self.rig.cameras.items():
            with suppress(DeviceError):  # the images are complete: nothing that a counter could change
                warning = self.call("A camera", camera.statistics, READ_TIMEOUT_S).warning
                found += [f"Camera {name}: {warning}."] if warning else []
        return " ".join(found)

    def unready(self) -> str:
        """Read the state of every device; return which are not ready and why, empty if all are."""
        unready = [state for state in read_states(self.rig) if not state.status.ready]
        return " ".join(f"{state.name} ({state.kind}) is not ready: {state.status.text} {state.status.remedy}".strip() for state in unready)

    def check(self) -> None:
        """Raise Cancelled when the user has cancelled, or the rig was stopped."""
        self._progress.check()
        if self.rig.latch.reason:
            raise Cancelled

    def call(self, what: str, function: Callable[[], T], within_s: float) -> T:
        """Make a call of a driver that may last ``within_s``; raises what it raises, DeviceLost, or Cancelled after stopping everything."""
        self.check()
        return call_device(what, function, within_s, self.check, lambda: self.abort(BY_USER))


def rendering_s(cameras: Iterable[Camera]) -> float:
    """Return how long cameras that compute their images may take for one each; 0 for real ones."""
    return sum(camera.longest_rendering_s for camera in cameras if isinstance(camera, RendersImages))


def read_conditions(rig: Rig) -> Conditions:
    """Read the present time, temperature, serial numbers and lens settings; nothing moves."""
    return rig.conditions(datetime.now(UTC).isoformat(timespec="milliseconds"))


def _doubts_the_rig(error: BaseException) -> bool:
    """Whether a person has to look at the rig: not where only the images were unfit, or could not be stored."""
    return isinstance(error, DeviceError) or not isinstance(error, MeasureError)


def _reason_of(error: BaseException) -> str:
    if isinstance(error, (Cancelled, KeyboardInterrupt)):
        return BY_USER
    return str(error) or type(error).__name__
