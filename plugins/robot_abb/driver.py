"""ABB robots by Robot Web Services: joint moves through the mailbox of MeasureApp.mod."""

from __future__ import annotations

import atexit
import logging
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.devices.attempt import Stops
from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, MotionError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Cancelled

from .arm import Arm
from .controller import Controller
from .egm import PoseStream
from .login import Login, open_login
from .mailbox import FAILED, REFUSED, Answer, Identity, own_name
from .motion import predicted_s
from .settings import AbbSettings
from .stopping import StopLadder

BEAT_S = 2.0  # a program whose heart does not beat for so long is dead
FIRST_POLL_S = 0.02
NEW_MESSAGES = 5
_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Parts:
    """What the robot is made of."""

    main: Login
    stop: Login
    identity: Identity
    arm: Arm
    stream: PoseStream | None


class AbbRobot:
    """The robot; built by `connect`."""

    def __init__(self, name: str, settings: AbbSettings, parts: Parts) -> None:
        self.name = name
        self._settings, self._arm, self._stream, self._identity = settings, parts.arm, parts.stream, parts.identity
        self._main, self._stop_login = parts.main, parts.stop
        self._controller, self._mailbox = parts.main.controller, parts.main.mailbox
        self._ladder = StopLadder(parts.stop.controller, parts.stop.mailbox)
        self._stops = Stops()
        self._moving = threading.Lock()
        self._started_for: int | None = None  # count of stops when this connection started the program; another count: start it again
        self._log_mark = 0  # number of the newest message of the event log that is known
        self._fault: DeviceError | None = None
        self._is_closed = False
        parts.main.on_renewed(self._check_identity)
        atexit.register(self.close)

    def pose(self) -> RigidTransform:
        """Read base_from_flange back from the controller.

        Raises
        ------
        DeviceLost
            The controller does not answer, another one answers, or the pose stream is stale.
        MotionError
            The pose does not fit the joints.
        """
        before = self._controller.joints_deg()
        pose = self._controller.pose()
        after = self._stream.latest().joints_deg if self._stream is not None else self._controller.joints_deg()
        if float(np.max(np.abs(after - before))) < self._settings.rest_deg:  # a moving arm has no two read-backs that fit each other
            self._check_model(pose, after)
        return pose

    def joints_rad(self) -> FloatArray:
        """Read the joint angles back, (6,). Raises DeviceError."""
        return np.deg2rad(self._controller.joints_deg())

    def move_to(self, base_from_flange: RigidTransform, *, timeout_s: float) -> None:
        """Move to a pose, in the configuration that `driven` chooses, and wait until settled; raises as `move_joints`."""
        self._run(lambda present_deg: self._arm.joints_for(base_from_flange, present_deg), timeout_s)

    def move_joints(self, goal_rad: FloatArray, *, timeout_s: float) -> None:
        """Move every joint to its angle (6,), all in proportion, and wait until settled.

        Raises
        ------
        LimitError
            Before anything moves: out of reach, beyond a joint's limit, at a singularity.
        DeviceTimeout
            It did not settle in time; the robot was stopped.
        MotionError
            The controller stopped, refused, or left its operating mode; latched until the robot is connected again.
        DeviceLost
            The controller does not answer any more, or has been restarted.
        """
        goal_deg = np.rad2deg(goal_rad)
        self._arm.check_limits(goal_deg)
        self._run(lambda _: goal_deg, timeout_s)

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        identity = self._identity.words
        try:
            situation = self._controller.situation()
            x, y, z = self.pose().translation_mm
            text = f"{situation.words}, flange at {x:.1f} {y:.1f} {z:.1f} mm"
        except DeviceError as error:
            return DeviceStatus(False, error.message, error.hint, identity)
        if self._fault is not None:
            return DeviceStatus(False, f"{text}. {self._fault.message}", self._fault.hint, identity)
        return DeviceStatus(situation.may_move, text, "" if situation.may_move else situation.remedy or "Switch the motors on.", identity)

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `move_to` then raises Cancelled. Raises DeviceLost when no stop is confirmed."""
        self._stops.stop()
        self._ladder.stop()

    def close(self) -> None:
        """Stop a move, release the robot and log out. Harmless when repeated."""
        if self._is_closed:
            return
        self._is_closed = True
        atexit.unregister(self.close)
        with ExitStack() as closing:
            if self._stream is not None:
                closing.callback(self._stream.close)
            closing.callback(self._stop_login.close)
            closing.callback(self._main.close)
            if self._moving.locked():
                self._stops.stop()
                self._quietly(self._ladder.stop)
            if not isinstance(self._fault, DeviceLost):
                self._quietly(self._mailbox.release)

    def _run(self, goal_deg_from: Callable[[FloatArray], FloatArray], timeout_s: float) -> None:
        if not self._moving.acquire(blocking=False):
            raise DeviceError(f"{self.name} is moving already.", "Wait until the move has ended.")
        try:
            if self._fault is not None:
                raise self._fault
            self._move(goal_deg_from, time.monotonic() + timeout_s, self._stops.count)
        except (DeviceLost, MotionError) as error:
            self._fault = self._fault or error
            raise
        finally:
            self._moving.release()

    def _move(self, goal_deg_from: Callable[[FloatArray], FloatArray], end: float, stops: int) -> None:
        present_deg = self._controller.joints_deg()
        goal_deg = goal_deg_from(present_deg)
        self._mailbox.claim()
        self._ladder.keep_alive(self._settings.loss_s)
        with self._stopped_on_failure(stops):
            self._make_ready(stops)
            number = self._order(goal_deg, end, stops)
            prediction_s = self._predicted_s(present_deg, goal_deg)
            end = min(end, time.monotonic() + 1.5 * prediction_s + 2.0)
            self._wait_until_done(number, end, stops)
            self._wait_until_at_rest(goal_deg, end, stops)
            self._check_model(self._controller.pose(), self._controller.joints_deg())

    def _make_ready(self, stops: int) -> None:
        """Start the program afresh after connecting and after every stop of our own; what others stopped is a fault."""
        if self._started_for == stops:
            self._require_unchanged(self._mailbox.answer())
            return
        self._log_mark = max((message.number for message in self._controller.messages()), default=0)
        self._check_identity()
        settings = self._settings
        self._mailbox.start(settings.switch_motors_on, settings.settle_s, lambda seconds: self._stops.wait(seconds, stops))
        self._started_for = stops

    def _order(self, goal_deg: FloatArray, end: float, stops: int) -> int:
        if time.monotonic() > end:
            raise DeviceTimeout(f"{self.name} was not ready to move in time.", "Allow more time for the move.")
        speeds = self._settings.speed_mm_per_s, self._settings.speed_deg_per_s
        return self._mailbox.order(goal_deg, *speeds, lambda seconds: self._stops.wait(seconds, stops))

    def _wait_until_done(self, number: int, end: float, stops: int) -> None:
        beat, beat_at, poll_s = -1, time.monotonic(), min(FIRST_POLL_S, self._settings.poll_s)
        while True:
            self._stops.wait(poll_s, stops)
            poll_s = min(2.0 * poll_s, self._settings.poll_s)
            answer = self._mailbox.answer()
            self._require_unchanged(answer)
            if answer.done == number:
                return
            now = time.monotonic()
            if answer.beat != beat:
                beat, beat_at = answer.beat, now
            if now - beat_at > BEAT_S:
                raise MotionError(
                    f"{self.name}: the program in the controller hangs.", "Read the event log on the FlexPendant, then connect again."
                )
            if now > end:
                raise DeviceTimeout(
                    f"{self.name} has not reached its goal in time; it was stopped.",
                    "Check the speed set on the FlexPendant and that nothing is in the robot's way.",
                )

    def _require_unchanged(self, answer: Answer) -> None:
        """Raise MotionError unless motors, operating mode and program are as they were at the start."""
        situation = self._controller.situation()
        if not situation.may_move or not situation.running or self._mailbox.was_restarted(answer):
            raise self._stopped(self._mailbox.was_restarted(answer))
        if answer.state in (REFUSED, FAILED):
            what = "refused the order" if answer.state == REFUSED else f"failed with error {answer.error}"
            raise MotionError(f"{self.name}: the program in the controller {what}.", "Read the event log on the FlexPendant.")

    def _stopped(self, restarted: bool) -> MotionError:
        situation = self._controller.situation()  # again: what changes together was read one after the other
        titles = [message.title for message in self._controller.messages(self._log_mark)[:NEW_MESSAGES] if message.kind > 1]
        reason = f" The controller reports: {'; '.join(titles)}." if titles else ""
        again = " Its program was started again by somebody else." if restarted and situation.running else ""
        return MotionError(
            f"{self.name} was stopped: {situation.words}.{again}{reason} Its pose is unknown until it is read back.",
            situation.remedy or "Find the cause, check that nothing is in the robot's way, then connect again.",
        )

    def _wait_until_at_rest(self, goal_deg: FloatArray, end: float, stops: int) -> None:
        before = self._controller.joints_deg()
        while True:
            self._stops.wait(self._settings.reads_apart_s, stops)
            now_deg = self._controller.joints_deg()
            if float(np.max(np.abs(now_deg - before))) < self._settings.rest_deg:
                break
            if time.monotonic() > end:
                raise DeviceTimeout(f"{self.name} does not come to rest at its goal.", "Check the load and the brakes.")
            before = now_deg
        off = np.abs(now_deg - goal_deg)
        if float(np.max(off)) > self._settings.goal_deg:
            axis = int(np.argmax(off))
            raise MotionError(
                f"{self.name} came to rest away from its goal: joint {axis + 1} at {now_deg[axis]:.3f}° instead of {goal_deg[axis]:.3f}°.",
                "Check for a collision or a protective stop, then connect again.",
            )

    @contextmanager
    def _stopped_on_failure(self, stops: int) -> Iterator[None]:
        """Stop the robot at any exception whatever, unless `stop` has done so."""
        try:
            yield
        except BaseException as error:
            self._started_for = None
            if self._stops.count == stops:
                self._quietly(self._ladder.stop_unheard if isinstance(error, DeviceLost) else self._ladder.stop)
            elif not isinstance(error, DeviceLost):
                self._quietly(self._ladder.forget_move)  # again: while mastership was held for an order, the stop could not do it
            if self._stops.count != stops and not isinstance(error, Cancelled | DeviceLost):
                raise Cancelled from error  # what a stop causes is no fault
            raise

    def _check_model(self, pose: RigidTransform, joints_deg: FloatArray) -> None:
        off = self._arm.pose(joints_deg).inverse() @ pose
        distance = float(np.linalg.norm(off.translation_mm))
        if distance > self._settings.model_mm or off.angle_rad * 500.0 > self._settings.model_mm:
            raise MotionError(
                f"{self.name}: the controller's pose is {distance:.2f} mm and {np.degrees(off.angle_rad):.3f}° off the one of its joints.",
                "Check the kinematic model in the robot's settings, tool0 and the base frame; if the robot is moving, wait.",
            )

    def _check_identity(self) -> None:
        """Refuse another controller or program than that of the connection; called before a start, and when the login was forgotten."""
        try:
            found = self._mailbox.identity()
            what = "" if found == self._identity else f"{found.words} instead of {self._identity.words}"
        except DeviceLost:
            raise
        except DeviceError as error:
            what = error.message
        if what:
            self._fault = DeviceLost(
                f"{self.name}: another controller or program answers now: {what}", "Check what has changed, then connect again."
            )
            raise self._fault

    def _predicted_s(self, from_deg: FloatArray, to_deg: FloatArray) -> float:
        ratio = self._controller.speed_ratio()
        return self._settings.settle_s + predicted_s(
            self._arm, from_deg, to_deg, self._settings.speed_mm_per_s, self._settings.speed_deg_per_s, ratio
        )

    def _quietly(self, action: Callable[[], None]) -> None:
        try:
            action()
        except DeviceError as error:
            _log.warning("%s: %s", self.name, error)


def connect(request: DeviceRequest) -> AbbRobot:
    """Log in twice (for moves and for stops), check controller, program and kinematic model, and reserve the robot; moves nothing.

    Raises
    ------
    DeviceError
        Naming what was found and what was expected. Everything opened so far is closed again.
    """
    settings = request.settings
    assert isinstance(settings, AbbSettings)
    name = request.rig.robot.model
    arm = Arm.read(settings.arm, settings.joint_margin_deg)
    with ExitStack() as undo:
        main = undo.enter_context(open_login(settings, own_name(), settings.reply_timeout_s, settings.loss_s))
        identity = main.mailbox.identity()
        _check_system(identity, settings)
        stop = undo.enter_context(open_login(settings, own_name(), min(0.3, settings.reply_timeout_s), min(0.3, settings.loss_s)))
        stream = PoseStream(settings.egm_port) if settings.egm_port is not None else None
        if stream is not None:
            undo.callback(stream.close)
        robot = AbbRobot(name, settings, Parts(main, stop, identity, arm, stream))
        undo.callback(atexit.unregister, robot.close)
        _check_arm(name, arm, main.controller, settings)
        try:
            main.mailbox.claim()
        except DeviceError as error:
            _log.warning("%s is connected for reading only: %s", name, error)
        undo.pop_all()
        return robot


def _check_system(identity: Identity, settings: AbbSettings) -> None:
    if settings.system_id and identity.system_id.strip("{}").lower() != settings.system_id.strip("{}").lower():
        raise DeviceError(
            f"The controller at {settings.address} is system {identity.system_id}; the settings expect {settings.system_id}.",
            "Check the address, or correct system_id in the robot's settings.",
        )


def _check_arm(name: str, arm: Arm, controller: Controller, settings: AbbSettings) -> None:
    joints_deg = controller.joints_deg()
    off = arm.pose(joints_deg).inverse() @ controller.pose()
    distance = float(np.linalg.norm(off.translation_mm))
    if distance > settings.model_mm and np.allclose(controller.joints_deg(), joints_deg, atol=0.01):
        raise DeviceError(
            f"{name}: the controller's pose is {distance:.1f} mm off the one of kinematic model {settings.arm!r} for the same joints.",
            "Choose the model of this arm in the robot's settings; check tool0 and the base frame in the controller.",
        )
