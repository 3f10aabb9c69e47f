"""Late, lost, cut and invalid answers of the controller: rows N1-N3 of the list of faults to survive."""

from __future__ import annotations

import logging
import random
import time

import numpy as np
import pytest
from abb_cell import goal, orders, running, writes
from robot_requests import Background, until

from measureapp.errors import DeviceError, DeviceLost
from measureapp.peers.rws.arm import flange_pose

# N1-N3: the network


def test_n1_spikes_and_losses_make_moves_slower_and_never_wrong(caplog: pytest.LogCaptureFixture) -> None:
    chance = random.Random(3)
    with running(reply_timeout_s=0.1, loss_s=2.0) as (controller, robot), caplog.at_level(logging.WARNING):
        controller.faults.delay_after_s = lambda _: 0.4 if chance.random() < 0.02 else 0.0
        controller.faults.delay_before_s = lambda _: 0.4 if chance.random() < 0.01 else 0.0
        controller.faults.drops_answer = lambda _: chance.random() < 0.06
        controller.faults.drops_request = lambda _: chance.random() < 0.04
        for turn in range(15):
            robot.move_to(goal(4.0 * (turn % 4)), timeout_s=30.0)
            np.testing.assert_allclose(flange_pose(controller.machine.joints_deg()).matrix, goal(4.0 * (turn % 4)).matrix, atol=1e-2)
        assert orders(controller) == 15
    assert "no answer to" in caplog.text


def test_n1_a_spike_of_two_seconds_on_one_reply_does_not_end_a_move() -> None:
    with running() as (controller, robot):
        spikes = iter([2.0])
        controller.faults.delay_after_s = lambda request: next(spikes, 0.0) if "mm_answer" in request[1] else 0.0
        robot.move_to(goal(20.0), timeout_s=20.0)
        np.testing.assert_allclose(robot.pose().matrix, goal(20.0).matrix, atol=1e-2)


def test_n1_a_write_that_arrives_late_moves_nothing_again() -> None:
    with running(reply_timeout_s=0.1) as (controller, robot):
        late = iter([0.6])
        controller.faults.delay_before_s = lambda request: next(late, 0.0) if request[0] == "POST" and "mm_cmd" in request[1] else 0.0
        robot.move_to(goal(20.0), timeout_s=20.0)
        robot.move_to(goal(0.0), timeout_s=20.0)
        time.sleep(0.7)
        assert sum("mm_cmd" in path for path in writes(controller)) == 3
        np.testing.assert_allclose(robot.pose().matrix, goal(0.0).matrix, atol=1e-2)


@pytest.mark.timed
def test_n2_a_half_open_connection_is_lost_within_two_seconds() -> None:
    with running() as (controller, robot):
        controller.faults.half_open = True
        began = time.monotonic()
        with pytest.raises(DeviceLost, match="does not answer any more"):
            robot.pose()
        assert time.monotonic() - began < 2.0
        assert not robot.status().ready


@pytest.mark.timed
def test_n2_a_link_that_breaks_during_a_move_is_lost_within_two_seconds_and_latched() -> None:
    with running(time_scale=1.0) as (controller, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: orders(controller) == 1)
        broke_at = time.monotonic()
        controller.faults.half_open = True
        controller.server.break_connections()
        error = moving.wait()
        assert isinstance(error, DeviceLost)
        assert moving.ended_at - broke_at < 3.0  # 2 s and two attempts to stop, on a busy machine
        controller.faults.half_open = False
        with pytest.raises(DeviceLost):
            robot.move_to(goal(0.0), timeout_s=5.0)


def test_n2_connections_that_are_reset_are_opened_again() -> None:
    with running() as (controller, robot):
        controller.faults.calls_per_connection = 3
        for millimetres in (20.0, 10.0):
            robot.move_to(goal(millimetres), timeout_s=10.0)
        controller.server.break_connections()
        np.testing.assert_allclose(robot.pose().matrix, goal(10.0).matrix, atol=1e-2)


def test_n2_answers_in_single_bytes_are_understood() -> None:
    with running() as (controller, robot):
        controller.faults.slice_s = 0.0002
        robot.move_to(goal(20.0), timeout_s=60.0)
        np.testing.assert_allclose(robot.pose().matrix, goal(20.0).matrix, atol=1e-2)


def _with_body(body: bytes, length: int | None = None) -> bytes:
    head = f"HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nContent-Length: {len(body) if length is None else length}\r\n\r\n"
    return head.encode() + body


@pytest.mark.parametrize(
    "answer",
    [
        b"\x00\x01\x02 garbage\r\n\r\n",
        _with_body(b"<html>"),
        _with_body(b'{"_embedded":{"_state":[]}}'),
        _with_body(b"[" * 100_000),
        _with_body(b'{"_embedded":{"_state":[{"rax_1":"nan"}]}}'),
        _with_body(b'{"_embedded":{"_state":[{"rax_1":"x"}]}}'),
        _with_body(b"x" * (2 << 20)),
        _with_body(b"{}"),
        b"HTTP/1.1 302 Found\r\nLocation: http://127.0.0.1:1/\r\nContent-Length: 0\r\n\r\n",
    ],
    ids=["no HTTP", "HTML", "empty", "nested", "nan", "no number", "oversized", "no states", "redirect"],
)
def test_n3_an_invalid_answer_is_refused_and_the_next_one_counts(answer: bytes) -> None:
    with running() as (controller, robot):
        controller.faults.changed = lambda raw, request: answer if "jointtarget" in request[1] else raw
        with pytest.raises(DeviceError) as caught:
            robot.pose()
        assert not isinstance(caught.value, DeviceLost)
        assert caught.value.hint
        controller.faults.changed = lambda raw, _: raw
        np.testing.assert_allclose(robot.pose().matrix, goal(0.0).matrix[:, :], atol=2.0)


@pytest.mark.parametrize("body", [b"<html>", b"\xff\xfe\x00", b"{}"])
def test_n3_the_first_bytes_of_an_invalid_answer_are_shown(body: bytes) -> None:
    with running() as (controller, robot):
        controller.faults.changed = lambda raw, request: _with_body(body) if "jointtarget" in request[1] else raw
        with pytest.raises(DeviceError) as caught:
            robot.pose()
        assert body.hex(" ") in caught.value.message


def test_n3_an_answer_shorter_than_it_says_is_never_believed() -> None:
    with running() as (controller, robot):
        cut = lambda raw: _with_body(raw.partition(b"\r\n\r\n")[2][:-20], len(raw.partition(b"\r\n\r\n")[2]))  # noqa: E731
        controller.faults.changed = lambda raw, request: cut(raw) if "jointtarget" in request[1] else raw
        controller.faults.calls_per_connection = 1
        with pytest.raises(DeviceError):
            robot.pose()


def test_n3_an_invalid_answer_during_a_move_stops_the_robot() -> None:
    with running(time_scale=1.0) as (controller, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: orders(controller) == 1)
        controller.faults.changed = lambda raw, request: _with_body(b"<html>") if "mm_answer" in request[1] else raw
        assert isinstance(moving.wait(), DeviceError)
        assert not controller.machine.is_running()
        controller.faults.changed = lambda raw, _: raw
