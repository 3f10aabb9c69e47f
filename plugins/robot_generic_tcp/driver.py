"""Robots with the line protocol: absolute poses, numbered moves, a stop on a connection of its own."""

from __future__ import annotations

import logging
import os
import re
import socket
import threading
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager

import numpy as np

from measureapp.data.rig import RobotDescription
from measureapp.devices.attempt import Stops
from measureapp.devices.request import DeviceRequest
from measureapp.devices.status import DeviceStatus
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, LimitError, MotionError
from measureapp.geometry.transform import RigidTransform
from measureapp.progress import Cancelled

from .link import LineLink, Message, Unanswered, numbers, whole
from .settings import LineRobotSettings

VERSION = 1
STATES = ("ready", "moving", "fault")
FIRST_POLL_S = 0.02
STOP_TIMEOUT_S = 0.3
RAMPS_S = 1.0
INSIDE_MM = 1e-6
_log = logging.getLogger(__name__)


class LineRobotDriver:
    """The robot; built by `connect`."""

    def __init__(self, name: str, description: RobotDescription, settings: LineRobotSettings, links: tuple[LineLink, LineLink]) -> None:
        self.name = name
        self._description, self._settings = description, settings
        self._link, self._stop_link = links
        self._stops = Stops()
        self._moving = threading.Lock()
        self._fault: DeviceError | None = None
        self._identity, self._number = self._hello(self._link)
        self._hello(self._stop_link)

    def pose(self) -> RigidTransform:
        """Read base_from_flange back from the robot. Raises DeviceError."""
        reply = self._link.read("pose")
        position, quaternion = numbers(self._link, reply, "position_mm", 3), np.array(numbers(self._link, reply, "quaternion_wxyz", 4))
        length = float(np.linalg.norm(quaternion))
        if abs(length - 1.0) > 1e-3:
            raise DeviceError(f"{self.name}: the quaternion read back has length {length:g}.", "Correct the robot's program.")
        return RigidTransform.from_quaternion(quaternion / length, position, "base", "flange")

    def move_to(self, base_from_flange: RigidTransform, *, timeout_s: float) -> None:
        """Move and wait until settled.

        Raises
        ------
        LimitError
            Before anything moves.
        DeviceTimeout
            It did not settle in time; the robot was stopped.
        MotionError
            The robot stopped, refused or left automatic mode; latched until it is connected again.
        DeviceLost
            The robot does not answer any more.
        """
        if not self._moving.acquire(blocking=False):
            raise DeviceError(f"{self.name} is moving already.", "Wait until the move has ended.")
        try:
            if self._fault is not None:
                raise self._fault
            self._check_reach(base_from_flange)
            self._move(base_from_flange, time.monotonic() + timeout_s, self._stops.count)
        except (DeviceLost, MotionError) as error:
            self._fault = self._fault or error
            raise
        finally:
            self._moving.release()

    def status(self) -> DeviceStatus:
        """Read the state, for display."""
        try:
            state = self._state()
            x, y, z = self.pose().translation_mm
        except DeviceError as error:
            return DeviceStatus(False, error.message, error.hint, self._identity)
        text = f"{state['state']}, {state.get('mode', 'unknown')} mode, flange at {x:.1f} {y:.1f} {z:.1f} mm"
        if self._fault is not None:
            return DeviceStatus(False, f"{text}. {self._fault.message}", self._fault.hint, self._identity)
        ready = state["state"] != "fault" and state.get("mode") == "automatic"
        return DeviceStatus(ready, text, "" if ready else state.get("text") or "Select automatic mode at the robot.", self._identity)

    def stop(self) -> None:
        """Stop now, from any thread; a waiting `move_to` then raises Cancelled. Raises DeviceLost when the stop is not confirmed."""
        self._stops.stop()
        for _ in range(2):
            try:
                self._stop_link.send("stop", up_to=self._number)
                return
            except Unanswered as error:
                _log.warning("%s: the stop was not answered: %s", self.name, error)
        raise DeviceLost(f"{self.name} does not confirm the stop.", "Press the emergency stop.")

    def close(self) -> None:
        """Stop a move and close both connections. Harmless when repeated."""
        if self._moving.locked():
            self._quiet_stop()
        self._link.close()
        self._stop_link.close()

    def _hello(self, link: LineLink) -> tuple[str, int]:
        client = f"MeasureApp {re.sub(r'[^A-Za-z0-9.-]', '-', socket.gethostname())}/{os.getpid()}"
        reply = link.read("hello", version=VERSION, client=client)
        if reply.get("version") != VERSION:
            raise DeviceError(
                f"The robot at {link.place} speaks version {reply.get('version')!r} of the line protocol; this program speaks {VERSION}.",
                "Install the fitting version of the robot's program.",
            )
        return f"{reply.get('robot', 'unknown robot')}, serial number {reply.get('serial', 'unknown')}", whole(link, reply, "move")

    def _move(self, goal: RigidTransform, end: float, stops: int) -> None:
        start = self.pose()
        self._require_ready(self._state())
        with self._stopped_on_failure(stops):
            self._stops.wait(0.0, stops)
            self._number += 1
            self._order(goal, self._number)
            end = min(end, time.monotonic() + 1.5 * self._predicted_s(start, goal) + 2.0)
            self._wait_until_done(self._number, end, stops)
            self._wait_until_at_rest(goal, end, stops)

    def _order(self, goal: RigidTransform, number: int) -> None:
        """Order a move, once; without a reply, the state tells whether it was accepted."""
        order: Message = {
            "move": number,
            "position_mm": [round(float(value), 6) for value in goal.translation_mm],
            "quaternion_wxyz": [round(float(value), 10) for value in goal.quaternion_wxyz],
            "speed_mm_per_s": self._settings.speed_mm_per_s,
            "speed_deg_per_s": self._settings.speed_deg_per_s,
        }
        try:
            self._link.send("move", **order)
        except Unanswered as error:
            _log.warning("%s: no reply to move %d: reading the state back", self.name, number)
            if whole(self._link, self._state(), "move") != number:
                raise MotionError(
                    f"{self.name}: it is unknown whether move {number} was accepted; the robot was stopped.",
                    "Check the network, then connect again.",
                ) from error

    def _wait_until_done(self, number: int, end: float, stops: int) -> None:
        poll_s = min(FIRST_POLL_S, self._settings.poll_s)
        while True:
            self._stops.wait(poll_s, stops)
            poll_s = min(2.0 * poll_s, self._settings.poll_s)
            state = self._state()
            self._require_ready(state)
            if whole(self._link, state, "done") == number:
                return
            if state["state"] == "ready" and whole(self._link, self._state(), "done") != number:
                raise MotionError(f"{self.name} stopped before it reached its goal.", "Find the cause at the robot, then connect again.")
            if time.monotonic() > end:
                raise DeviceTimeout(
                    f"{self.name} has not reached its goal in time; it was stopped.", "Check its speed and what is in its way."
                )

    def _wait_until_at_rest(self, goal: RigidTransform, end: float, stops: int) -> None:
        settings, before = self._settings, self.pose()
        while True:
            self._stops.wait(settings.reads_apart_s, stops)
            here = self.pose()
            if _is_near(before, here, settings.rest_mm, settings.rest_deg):
                break
            if time.monotonic() > end:
                raise DeviceTimeout(f"{self.name} does not come to rest at its goal.", "Check the load and the brakes.")
            before = here
        if not _is_near(here, goal, settings.goal_mm, settings.goal_deg):
            off = here.inverse() @ goal
            raise MotionError(
                f"{self.name} came to rest {np.linalg.norm(off.translation_mm):.2f} mm and {np.degrees(off.angle_rad):.3f}° off its goal.",
                "Check for a collision or a protective stop, then connect again.",
            )

    def _state(self) -> Message:
        state = self._link.read("state")
        if state.get("state") not in STATES:
            raise DeviceError(f"{self.name} reports the unknown state {state.get('state')!r}.", f"Known are {', '.join(STATES)}.")
        return state

    def _require_ready(self, state: Message) -> None:
        if state["state"] == "fault" or state.get("mode") != "automatic":
            raise MotionError(
                f"{self.name} was stopped: {state.get('text') or state['state']}, {state.get('mode', 'unknown')} mode. "
                "Its pose is unknown until it is read back.",
                "Remove the cause at the robot, select automatic mode, then connect again.",
            )

    def _check_reach(self, goal: RigidTransform) -> None:
        robot = self._description
        reach = float(np.linalg.norm(goal.translation_mm - np.array(robot.shoulder_mm)))
        if not robot.min_reach_mm - INSIDE_MM <= reach <= robot.max_reach_mm + INSIDE_MM:
            raise LimitError(
                f"{self.name}: a flange position {reach:.0f} mm from the shoulder is outside {robot.min_reach_mm:g}…{robot.max_reach_mm:g} mm.",
                "Choose a goal inside the limits; nothing was moved.",
            )

    def _predicted_s(self, start: RigidTransform, goal: RigidTransform) -> float:
        way = start.inverse() @ goal
        path_s = float(np.linalg.norm(way.translation_mm)) / self._settings.speed_mm_per_s
        return max(path_s, float(np.degrees(way.angle_rad)) / self._settings.speed_deg_per_s) + RAMPS_S

    @contextmanager
    def _stopped_on_failure(self, stops: int) -> Iterator[None]:
        """Stop the robot at any exception whatever, also after `stop`: the order may have been on its way when that was called."""
        try:
            yield
        except LimitError:
            raise
        except BaseException as error:
            was_stopped = self._stops.count != stops
            self._quiet_stop()
            if was_stopped and not isinstance(error, Cancelled | DeviceLost):
                raise Cancelled from error  # what a stop causes is no fault
            raise

    def _quiet_stop(self) -> None:
        try:
            self.stop()
        except DeviceError as error:
            _log.warning("%s", error)


def connect(request: DeviceRequest) -> LineRobotDriver:
    """Open both connections and compare versions; moves nothing. Raises DeviceError."""
    settings = request.settings
    assert isinstance(settings, LineRobotSettings)
    with ExitStack() as undo:
        link = LineLink(settings.host, settings.port, settings.reply_timeout_s, settings.loss_s)
        undo.callback(link.close)
        stop = LineLink(settings.host, settings.port, min(STOP_TIMEOUT_S, settings.reply_timeout_s), settings.loss_s)
        undo.callback(stop.close)
        robot = LineRobotDriver(request.rig.robot.model, request.rig.robot, settings, (link, stop))
        undo.pop_all()
        return robot


def _is_near(one: RigidTransform, other: RigidTransform, millimetres: float, degrees: float) -> bool:
    off = one.inverse() @ other
    return float(np.linalg.norm(off.translation_mm)) < millimetres and float(np.degrees(off.angle_rad)) < degrees
