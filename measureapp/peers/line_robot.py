"""Virtual robot with the line protocol of the driver `robot_generic_tcp`: one JSON object per line over TCP."""

from __future__ import annotations

import json
import socketserver
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform
from measureapp.peers.moving_axes import MovingAxes

VERSION = 1
LONGEST_LINE = 4096
RAMP_S = 0.3
REACH_MM = 700.0  # of the flange from the shoulder
SHOULDER_MM = np.array([0.0, 0.0, 400.0])
AT_ONCE = 1e-6
Message = dict[str, Any]


@dataclass
class LineFaults:
    """What goes wrong; each may be changed while the robot runs."""

    half_open: bool = False  # requests are read and never answered
    delay_before_s: Callable[[Message], float] = field(default=lambda _: 0.0)  # before a request is carried out
    delay_after_s: Callable[[Message], float] = field(default=lambda _: 0.0)  # after it, before the reply
    drops_reply: Callable[[Message], bool] = field(default=lambda _: False)  # the connection breaks instead of a reply
    changed: Callable[[bytes, Message], bytes] = field(default=lambda line, _: line)  # the line of a reply
    slice_s: float | None = None  # pause between single bytes of a reply
    pose_error_mm: float = 0.0  # the robot ends beside its goal
    frozen: RigidTransform | None = None  # the pose read back never changes
    forgets_done: bool = False  # a move never ends


class LineRobot:
    """The robot itself. Methods may be called from any thread.

    Parameters
    ----------
    time_scale : 1: moves last as long as in reality; 0: as short as possible
    on_rest : called with base_from_flange whenever the robot comes to rest
    """

    def __init__(self, time_scale: float = 1.0, on_rest: Callable[[RigidTransform], None] = lambda _: None) -> None:
        self.faults = LineFaults()
        self.version = VERSION
        self.fault = ""  # such as "emergency stop"; a person clears it
        self.mode = "automatic"
        self.moves: list[int] = []  # numbers of the moves that were begun
        self._scale, self._on_rest = max(time_scale, AT_ONCE), on_rest
        self._lock = threading.RLock()
        down = np.diag([1.0, -1.0, -1.0])
        self._start = self._goal = RigidTransform.from_parts(down, [450.0, 0.0, 500.0], "base", "flange")
        self._way = MovingAxes([1.0], [1.0], [1.0])
        self._last = self._done = 0

    def answer(self, request: Message) -> Message:
        """Carry out a request and return its reply."""
        known = {"hello": self._hello, "state": self._state, "pose": self._pose, "move": self._move, "stop": self._stop}
        with self._lock:
            action = known.get(str(request.get("do")))
            if action is None:
                return _refused("request", f"unknown request {request.get('do')!r}")
            try:
                return action(request)
            except (KeyError, TypeError, ValueError) as error:
                return _refused("request", f"{type(error).__name__}: {error}")

    def here(self) -> RigidTransform:
        """Return base_from_flange as read back."""
        with self._lock:
            return self._pose_at(float(self._way.positions()[0]))

    def _pose_at(self, share: float) -> RigidTransform:
        if self.faults.frozen is not None:
            return self.faults.frozen
        rotations = Rotation.from_matrix(np.stack([self._start.rotation, self._goal.rotation]))
        rotation = Slerp([0.0, 1.0], rotations)(min(1.0, share)).as_matrix()
        position = (1.0 - share) * self._start.translation_mm + share * self._goal.translation_mm
        return RigidTransform.from_parts(rotation, position, "base", "flange")

    def press_emergency_stop(self) -> None:
        """Press the emergency stop."""
        with self._lock:
            self._halt()
            self.fault = "emergency stop"

    def turn_key(self, mode: str) -> None:
        """Select "automatic" or "manual"."""
        with self._lock:
            self._halt()
            self.mode = mode

    def clear_fault(self) -> None:
        """Release the emergency stop and acknowledge it."""
        self.fault = ""

    def _hello(self, request: Message) -> Message:
        if request["version"] != self.version:
            return _refused("request", f"this robot speaks version {self.version}") | {"version": self.version}
        return {"ok": True, "version": self.version, "robot": "virtual line robot", "serial": "LR-1", "move": self._last}

    def _state(self, _request: Message) -> Message:
        moving = self._is_moving()
        word = "fault" if self.fault else "moving" if moving else "ready"
        return {"ok": True, "state": word, "mode": self.mode, "text": self.fault, "move": self._last, "done": self._done}

    def _pose(self, _request: Message) -> Message:
        here = self.here()
        return {
            "ok": True,
            "position_mm": [round(float(x), 5) for x in here.translation_mm],
            "quaternion_wxyz": [round(float(x), 9) for x in here.quaternion_wxyz],
        }

    def _move(self, request: Message) -> Message:
        number, position = int(request["move"]), np.array(request["position_mm"], float)
        goal = RigidTransform.from_quaternion(request["quaternion_wxyz"], position, "base", "flange")
        if number <= self._last:
            return _refused("number", f"move {number} is not newer than {self._last}")
        if self.fault or self.mode != "automatic":
            return _refused("state", self.fault or f"{self.mode} mode")
        if self._is_moving():
            return _refused("busy", f"move {self._last} has not ended")
        if float(np.linalg.norm(position - SHOULDER_MM)) > REACH_MM:
            return _refused("limit", "out of reach")
        self._last = number
        self.moves.append(number)
        self._begin(goal, number, float(request["speed_mm_per_s"]), float(request["speed_deg_per_s"]))
        return {"ok": True}

    def _begin(self, goal: RigidTransform, number: int, speed_mm_per_s: float, speed_deg_per_s: float) -> None:
        self._start = self.here()
        aside = RigidTransform.from_vector([0.0, 0.0, 0.0], [self.faults.pose_error_mm, 0.0, 0.0], "flange", "flange")
        self._goal = goal @ aside
        way = self._start.inverse() @ self._goal
        seconds = max(float(np.linalg.norm(way.translation_mm)) / speed_mm_per_s, float(np.degrees(way.angle_rad)) / speed_deg_per_s, 1e-3)
        speed = 1.0 / (seconds * self._scale)

        def rest(share: FloatArray) -> None:
            if share[0] >= 1.0 and not self.faults.forgets_done:
                self._done = number
            self._on_rest(self._pose_at(float(share[0])))

        self._way = MovingAxes([0.0], [speed], [speed / (RAMP_S * self._scale)], on_rest=rest)
        self._way.move([1.0])

    def _stop(self, request: Message) -> Message:
        self._halt()
        self._last = max(self._last, int(request.get("up_to", 0)))
        return {"ok": True}

    def _halt(self) -> None:
        if self._is_moving():
            self._way.stop()

    def _is_moving(self) -> bool:
        return self._way.is_moving


class _Server(socketserver.ThreadingTCPServer):
    daemon_threads = False
    allow_reuse_address = True

    def __init__(self, robot: LineRobot) -> None:
        super().__init__(("127.0.0.1", 0), _Connection)
        self.robot = robot
        self.closing = threading.Event()


class _Connection(socketserver.BaseRequestHandler):
    server: _Server

    def handle(self) -> None:
        """Answer line by line until the client leaves or the robot is closed."""
        self.request.settimeout(0.05)
        buffer = b""
        while not self.server.closing.is_set():
            try:
                part = self.request.recv(LONGEST_LINE)
            except TimeoutError:
                continue
            except OSError:
                return
            if not part:
                return
            buffer += part
            while b"\n" in buffer:
                line, _, buffer = buffer.partition(b"\n")
                if not self._serve(line):
                    return

    def _serve(self, line: bytes) -> bool:
        """Answer one line; return whether the connection goes on."""
        faults, closing = self.server.robot.faults, self.server.closing
        try:
            request = json.loads(line)
            number = int(request["id"])
        except (ValueError, KeyError, TypeError):
            return self._send(b'{"id":0,"ok":false,"error":"request","text":"no JSON object with an id"}\n')
        if faults.half_open:
            return True
        closing.wait(faults.delay_before_s(request))
        reply = {"id": number, **self.server.robot.answer(request)}
        closing.wait(faults.delay_after_s(request))
        if faults.drops_reply(request):
            return False
        return self._send(faults.changed(json.dumps(reply).encode() + b"\n", request))

    def _send(self, line: bytes) -> bool:
        pause_s = self.server.robot.faults.slice_s
        parts = [line] if pause_s is None else [line[index : index + 1] for index in range(len(line))]
        try:
            for part in parts:
                self.request.sendall(part)
                if pause_s is not None:
                    time.sleep(pause_s)
        except OSError:
            return False
        return True


@contextmanager
def line_robot(*, time_scale: float = 0.0, on_rest: Callable[[RigidTransform], None] = lambda _: None) -> Iterator[tuple[LineRobot, int]]:
    """Run a virtual line robot on a free port of the loopback interface; yield it and the port."""
    robot = LineRobot(time_scale, on_rest)
    with _Server(robot) as server:
        thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02}, name="virtual line robot")
        thread.start()
        try:
            yield robot, int(server.server_address[1])
        finally:
            server.closing.set()
            server.shutdown()
            thread.join()


def _refused(error: str, text: str) -> Message:
    return {"ok": False, "error": error, "text": text}
