"""The line protocol: its words on the wire, and what the driver does when robot or network fail."""

from __future__ import annotations

import json
import random
import socket
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest
from robot_requests import Background, Stalls, connect_robot, until

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, LimitError, MotionError
from measureapp.geometry.transform import RigidTransform
from measureapp.peers.line_robot import LineRobot, line_robot
from measureapp.progress import Cancelled

ORIGIN = RigidTransform.from_parts(np.diag([1.0, -1.0, -1.0]), [450.0, 0.0, 500.0], "base", "flange")
FAST = {"host": "127.0.0.1", "poll_s": 0.02, "reads_apart_s": 0.02}


def goal(millimetres: float) -> RigidTransform:
    return ORIGIN @ RigidTransform.from_vector([0.05, 0.0, 0.02], [0.0, 0.0, -millimetres], "flange", "flange")


@contextmanager
def running(time_scale: float = 0.0, **settings: Any) -> Iterator[tuple[LineRobot, Any]]:
    with line_robot(time_scale=time_scale) as (peer, port):
        robot = connect_robot("robot_generic_tcp", port=port, **{**FAST, **settings})
        try:
            yield peer, robot
        finally:
            robot.close()


@contextmanager
def scripted(replies: dict[str, list[bytes]]) -> Iterator[tuple[int, list[Any]]]:
    """A server that says for each kind of request what it is told to, and notes what it was asked."""
    asked: list[Any] = []
    closing = threading.Event()
    listener = socket.create_server(("127.0.0.1", 0))
    listener.settimeout(0.05)

    def talk(connection: socket.socket) -> None:
        connection.settimeout(0.05)
        buffer = b""
        while not closing.is_set():
            try:
                part = connection.recv(4096)
            except TimeoutError:
                continue
            except OSError:
                return
            if not part:
                return
            buffer += part
            while b"\n" in buffer:
                line, _, buffer = buffer.partition(b"\n")
                request = json.loads(line)
                asked.append(request)
                known = replies[request["do"]]
                reply = known.pop(0) if len(known) > 1 else known[0]
                connection.sendall(reply.replace(b"$ID", str(request["id"]).encode()))

    def accept() -> None:
        talking = []
        while not closing.is_set():
            try:
                connection, _ = listener.accept()
            except TimeoutError:
                continue
            talking.append((connection, threading.Thread(target=talk, args=(connection,))))
            talking[-1][1].start()
        for connection, thread in talking:
            thread.join()
            connection.close()

    accepting = threading.Thread(target=accept)
    accepting.start()
    try:
        yield listener.getsockname()[1], asked
    finally:
        closing.set()
        accepting.join()
        listener.close()


HELLO = b'{"id":$ID,"ok":true,"version":1,"robot":"R","serial":"7","move":41}\n'
READY = b'{"id":$ID,"ok":true,"state":"ready","mode":"automatic","text":"","move":42,"done":42}\n'
POSE = b'{"id":$ID,"ok":true,"position_mm":[450,0,500],"quaternion_wxyz":[0,1,0,0]}\n'
DONE = b'{"id":$ID,"ok":true}\n'
SOUND = {"hello": [HELLO], "state": [READY], "pose": [POSE], "move": [DONE], "stop": [DONE]}


def test_the_session_of_the_readme_is_spoken_word_by_word() -> None:
    with scripted({name: list(lines) for name, lines in SOUND.items()}) as (port, asked):
        robot = connect_robot("robot_generic_tcp", port=port, **FAST)
        robot.move_to(ORIGIN, timeout_s=5.0)
        robot.stop()
        robot.close()
    assert asked[0]["do"] == "hello"
    assert asked[0]["version"] == 1
    move = next(request for request in asked if request["do"] == "move")
    assert move["move"] == 42  # one more than the robot said hello with
    assert move["position_mm"] == [450.0, 0.0, 500.0]
    assert move["quaternion_wxyz"] == [0.0, 1.0, 0.0, 0.0]
    assert {"speed_mm_per_s": 150.0, "speed_deg_per_s": 30.0}.items() <= move.items()
    assert asked[-1] == {"id": 2, "do": "stop", "up_to": 42}


@pytest.mark.parametrize(
    ("error", "kind"),
    [("limit", LimitError), ("state", MotionError), ("busy", DeviceError), ("request", DeviceError), ("new", DeviceError)],
)
def test_a_refused_move_names_the_robots_reason(error: str, kind: type[DeviceError]) -> None:
    refusal = b'{"id":$ID,"ok":false,"error":"%s","text":"joint 3 at 71 deg"}\n' % error.encode()
    with scripted({**SOUND, "move": [refusal]}) as (port, _):
        robot = connect_robot("robot_generic_tcp", port=port, **FAST)
        with pytest.raises(kind, match="joint 3 at 71 deg"):
            robot.move_to(ORIGIN, timeout_s=5.0)
        robot.close()


@pytest.mark.parametrize(
    "line",
    [
        b"HTTP/1.1 400 Bad Request\n",
        b"\xff\xfe\x00\x01\n",
        b"{}\n",
        b'{"id":$ID,"ok":"yes"}\n',
        b'{"id":999,"ok":true}\n',
        b'{"id":$ID,"ok":true,"position_mm":[1,2],"quaternion_wxyz":[1,0,0,0]}\n',
        b'{"id":$ID,"ok":true,"position_mm":[1,2,NaN],"quaternion_wxyz":[1,0,0,0]}\n',
        b'{"id":$ID,"ok":true,"position_mm":[1,2,"3"],"quaternion_wxyz":[1,0,0,0]}\n',
        b"[" * 3000 + b"\n",
        b"x" * 5000,
    ],
)
def test_an_invalid_reply_is_refused_with_its_bytes(line: bytes) -> None:
    with scripted({**SOUND, "pose": [line, POSE]}) as (port, _):
        robot = connect_robot("robot_generic_tcp", port=port, **FAST)
        with pytest.raises(DeviceError, match=r"invalid \(.*\): [0-9a-f]{2} [0-9a-f]{2}"):
            robot.pose()
        np.testing.assert_allclose(robot.pose().translation_mm, [450.0, 0.0, 500.0])  # on a fresh connection
        robot.close()


def test_another_version_is_refused_by_name() -> None:
    with line_robot() as (peer, port):
        peer.version = 2
        with pytest.raises(DeviceError, match="version 2"):
            connect_robot("robot_generic_tcp", port=port, **FAST)


@pytest.mark.timed
def test_nobody_at_the_address_is_told_within_two_seconds() -> None:
    with socket.create_server(("127.0.0.1", 0)) as free:
        port = free.getsockname()[1]
    began = time.monotonic()
    with pytest.raises(DeviceLost, match=str(port)):
        connect_robot("robot_generic_tcp", port=port, **FAST)
    assert time.monotonic() - began < 2.0


def test_a_move_ends_at_its_goal_as_read_back() -> None:
    with running() as (peer, robot):
        for millimetres in (20.0, 50.0, 0.0):
            robot.move_to(goal(millimetres), timeout_s=10.0)
            np.testing.assert_allclose(robot.pose().matrix, goal(millimetres).matrix, atol=1e-4)
        assert peer.moves == [1, 2, 3]
        assert robot.status().ready


def test_a_pose_out_of_reach_is_refused_before_anything_is_sent() -> None:
    with running() as (peer, robot):
        far = RigidTransform.from_parts(np.eye(3), [5000.0, 0.0, 0.0], "base", "flange")
        with pytest.raises(LimitError):
            robot.move_to(far, timeout_s=10.0)
        assert peer.moves == []


def test_a_move_that_takes_too_long_is_stopped() -> None:
    with running(time_scale=1.0) as (peer, robot):
        with pytest.raises(DeviceTimeout):
            robot.move_to(goal(100.0), timeout_s=0.05)
        before = peer.here()
        time.sleep(0.1)
        np.testing.assert_array_equal(peer.here().matrix, before.matrix)


@pytest.mark.timed
def test_a_stop_takes_effect_within_200_ms_a_hundred_times() -> None:
    latest = 0.0
    with Stalls() as stalls, running(time_scale=1.0) as (peer, robot):
        for turn in range(100):
            moving = Background(
                lambda: robot.move_to(goal(200.0 if np.allclose(peer.here().matrix, ORIGIN.matrix) else 0.0), timeout_s=30.0)
            )
            until(lambda: len(peer.moves) > turn)  # noqa: B023
            time.sleep(random.Random(turn).uniform(0.0, 0.05))
            began = time.monotonic()
            robot.stop()
            at_rest = peer.here()
            assert isinstance(moving.wait(), Cancelled)
            latest = max(latest, moving.ended_at - began - stalls.within(began, moving.ended_at))
            np.testing.assert_array_equal(peer.here().matrix, at_rest.matrix)
    assert latest < 0.2


@pytest.mark.timed
def test_a_stop_is_not_held_up_by_a_call_that_waits_for_its_reply() -> None:
    with running(time_scale=1.0, reply_timeout_s=1.5) as (peer, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: bool(peer.moves))
        peer.faults.delay_after_s = lambda request: 1.0 if request["do"] in ("state", "pose") else 0.0
        time.sleep(0.1)
        began = time.monotonic()
        robot.stop()
        assert time.monotonic() - began < 0.2
        peer.faults.delay_after_s = lambda _: 0.0
        assert isinstance(moving.wait(), Cancelled)


@pytest.mark.parametrize(
    ("happens", "words"),
    [(LineRobot.press_emergency_stop, "emergency stop"), (lambda peer: peer.turn_key("manual"), "manual mode")],
    ids=["emergency stop", "manual mode"],
)
def test_a_fault_during_a_move_latches_until_the_robot_is_connected_again(happens: Callable[[LineRobot], None], words: str) -> None:
    with running(time_scale=1.0) as (peer, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: bool(peer.moves))
        happens(peer)
        error = moving.wait()
        assert isinstance(error, MotionError)
        assert words in str(error)
        peer.clear_fault()
        peer.turn_key("automatic")
        with pytest.raises(MotionError, match=words):
            robot.move_to(goal(10.0), timeout_s=5.0)
        assert len(peer.moves) == 1
        assert not robot.status().ready


def test_a_closed_robot_is_not_connected_again_by_asking_it() -> None:
    with running() as (_, robot):
        robot.close()
        assert not robot.status().ready
        with pytest.raises(DeviceLost, match="was closed"):
            robot.pose()


def test_a_robot_that_ends_beside_its_goal_is_an_error() -> None:
    with running() as (peer, robot):
        peer.faults.pose_error_mm = 0.5
        with pytest.raises(MotionError, match=r"0\.50 mm"):
            robot.move_to(goal(20.0), timeout_s=10.0)


def test_a_frozen_read_back_is_no_arrival() -> None:
    with running() as (peer, robot):
        peer.faults.frozen = robot.pose()
        with pytest.raises(MotionError, match="off its goal"):
            robot.move_to(goal(20.0), timeout_s=10.0)


@pytest.mark.timed
def test_a_move_that_never_ends_is_over_after_one_and_a_half_times_its_prediction() -> None:
    with running() as (peer, robot):
        peer.faults.forgets_done = True
        began = time.monotonic()
        with pytest.raises((DeviceTimeout, MotionError)):
            robot.move_to(goal(1.0), timeout_s=60.0)
        assert time.monotonic() - began < 5.0


@pytest.mark.timed
def test_a_half_open_connection_is_lost_within_two_seconds() -> None:
    with running() as (peer, robot):
        peer.faults.half_open = True
        began = time.monotonic()
        with pytest.raises(DeviceLost):
            robot.pose()
        assert time.monotonic() - began < 2.0
        assert not robot.status().ready


@pytest.mark.timed
def test_a_link_that_breaks_during_a_move_is_lost_within_two_seconds_and_latched() -> None:
    with running(time_scale=1.0) as (peer, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: bool(peer.moves))
        broke_at = time.monotonic()
        peer.faults.half_open = True
        assert isinstance(moving.wait(), DeviceLost)
        assert moving.ended_at - broke_at < 2.0
        peer.faults.half_open = False
        with pytest.raises(DeviceLost):
            robot.move_to(goal(0.0), timeout_s=5.0)


def test_replies_in_single_bytes_are_understood() -> None:
    with running() as (peer, robot):
        peer.faults.slice_s = 0.0005
        robot.move_to(goal(20.0), timeout_s=20.0)
        np.testing.assert_allclose(robot.pose().matrix, goal(20.0).matrix, atol=1e-4)


def test_spikes_and_losses_make_moves_slower_and_never_wrong() -> None:
    chance = random.Random(7)
    with running(reply_timeout_s=0.1, loss_s=2.0) as (peer, robot):
        peer.faults.delay_after_s = lambda _: 0.3 if chance.random() < 0.05 else 0.0
        peer.faults.drops_reply = lambda _: chance.random() < 0.1
        unknown = 0
        for turn in range(20):
            wanted = goal(5.0 * (turn % 5))
            try:
                robot.move_to(wanted, timeout_s=20.0)
            except DeviceError:
                unknown += 1
                peer.faults.delay_after_s, peer.faults.drops_reply = (lambda _: 0.0), (lambda _: False)
                break
            np.testing.assert_allclose(peer.here().matrix, wanted.matrix, atol=1e-4)
        assert peer.moves == sorted(set(peer.moves))
        assert unknown == 0


def test_a_late_order_is_void_after_a_stop() -> None:
    with running(reply_timeout_s=0.1) as (peer, robot):
        peer.faults.delay_before_s = lambda request: 0.5 if request["do"] == "move" else 0.0
        with pytest.raises(MotionError, match="unknown"):
            robot.move_to(goal(20.0), timeout_s=10.0)
        time.sleep(0.6)
        assert peer.moves == []
