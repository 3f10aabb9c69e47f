"""Faults of controller, cell and network, each injected at the virtual controller: rows R1-R7 and N1-N4 of the list of faults to survive."""

from __future__ import annotations

import json
import logging
import os
import random
import socket
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from abb_cell import connect, goal, orders, running, writes
from robot_requests import Background, plugin_module, until

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, MotionError
from measureapp.peers.rws import VirtualController, virtual_controller
from measureapp.peers.rws.arm import flange_pose
from measureapp.peers.rws.machine import Machine
from measureapp.resources import resource

MODULE = Path(resource("rapid/MeasureApp.mod")).read_text(encoding="ascii")


# R1: session limit


def test_r1_a_full_controller_is_told_with_its_number_of_sessions() -> None:
    with virtual_controller(session_limit=0) as controller, pytest.raises(DeviceError, match=r"503.*about 70.*wait 5 minutes"):
        connect(controller)


def test_r1_a_session_that_becomes_free_is_waited_for_with_growing_pauses() -> None:
    with virtual_controller(session_limit=2) as controller:
        strangers = [controller.sessions.open(), controller.sessions.open()]
        connecting = Background(lambda: connect(controller, login_patience_s=5.0).close())
        time.sleep(0.4)
        for stranger in strangers:
            controller.sessions.end(stranger.key)
        assert connecting.wait() is None
        assert len(controller.server.requests) > 0


def test_r1_a_limit_that_allows_only_the_first_of_two_logins_leaves_none_behind() -> None:
    with virtual_controller(session_limit=1) as controller:
        with pytest.raises(DeviceError, match="503"):
            connect(controller)
        assert controller.sessions.active == {}


def test_r1_an_expired_session_is_opened_again_and_the_move_goes_on() -> None:
    with running() as (controller, robot):
        robot.move_to(goal(5.0), timeout_s=10.0)
        controller.sessions.end_all()
        robot.move_to(goal(8.0), timeout_s=10.0)
        assert len(controller.sessions.active) == 2
        assert controller.sessions.opened == 4


def test_r1_logins_of_a_program_that_crashed_are_closed_at_the_next_start() -> None:
    crashing = (
        "import os, sys; sys.path[:0] = ['tests']\n"
        "from robot_requests import connect_robot\n"
        "connect_robot('robot_abb', address=sys.argv[1]); os._exit(9)\n"
    )
    with virtual_controller() as controller:
        done = subprocess.run(
            [sys.executable, "-c", crashing, controller.url], check=False, timeout=60, env={**os.environ, "PYTHONPATH": "."}
        )
        assert done.returncode == 9
        assert len(controller.sessions.active) == 2
        robot = connect(controller)
        assert len(controller.sessions.active) == 2
        robot.move_to(goal(2.0), timeout_s=10.0)  # the crashed program's claim is void, too
        robot.close()
        assert controller.sessions.active == {}


def test_r1_a_program_that_forgets_to_close_logs_out_at_its_end() -> None:
    forgetful = "import sys; sys.path[:0] = ['tests']\nfrom robot_requests import connect_robot\nr = connect_robot('robot_abb', address=sys.argv[1])\n"
    with virtual_controller() as controller:
        subprocess.run([sys.executable, "-c", forgetful, controller.url], check=True, timeout=60, env={**os.environ, "PYTHONPATH": "."})
        assert controller.sessions.opened == 2
        assert controller.sessions.active == {}


# R2: calls that are refused


def test_r2_mastership_held_by_another_client_is_named_and_not_retried() -> None:
    with running() as (controller, robot):
        stranger = controller.sessions.open()
        stranger.application = "RobotStudio"
        controller.sessions.masters["rapid"] = stranger.key
        with pytest.raises(MotionError, match=r"403.*RobotStudio.*motors on, automatic mode") as caught:
            robot.move_to(goal(5.0), timeout_s=10.0)
        assert caught.value.hint
        assert sum("action=request" in path for path in writes(controller)) == 2  # of connecting, and this one
        controller.sessions.masters.clear()


def test_r2_a_controller_that_demands_mastership_gets_it_for_the_writes_alone() -> None:
    with running() as (controller, robot):
        controller.cell.implicit_mastership = False
        robot.move_to(goal(5.0), timeout_s=10.0)
        assert controller.sessions.masters == {}


@pytest.mark.parametrize("status", [400, 403, 409])
def test_r2_a_refused_start_shows_state_and_reason_and_is_not_repeated(status: int) -> None:
    with running() as (controller, robot):
        error = json.dumps({"_embedded": {"status": {"code": -1073442803, "msg": "Operation not allowed"}}}).encode()
        head = f"HTTP/1.1 {status} X\r\nContent-Type: application/json\r\nContent-Length: {len(error)}\r\n\r\n".encode()
        controller.faults.changed = lambda raw, request: head + error if "action=start" in request[1] else raw
        controller.machine.program.start = lambda: None  # type: ignore[method-assign]
        with pytest.raises(MotionError, match=rf"{status}, code -1073442803.*Operation not allowed.*program stopped"):
            robot.move_to(goal(5.0), timeout_s=10.0)
        assert sum("action=start" in path for path in writes(controller)) == 1
        assert controller.sessions.masters == {}


@pytest.mark.parametrize("where", ["mm_order", "mm_cmd", "action=start", "action=resetpp"])
def test_r2_mastership_is_released_wherever_a_call_fails(where: str) -> None:
    with running() as (controller, robot):
        controller.faults.drops_request = lambda request: request[0] == "POST" and where in request[1]
        with pytest.raises(DeviceError):
            robot.move_to(goal(5.0), timeout_s=10.0)
        controller.faults.drops_request = lambda _: False
        assert controller.sessions.masters == {}


# R3, R4: somebody stops the robot


@pytest.mark.parametrize(
    ("happens", "words"),
    [
        (Machine.press_emergency_stop, ("emergency stop", "Emergency stop state", "press the motors-on button")),
        (Machine.open_guard, ("guard is open", "Safety guard stop", "Close the guard")),
        (lambda machine: machine.turn_key("MANR"), ("manual mode with reduced speed", "Turn the key to automatic")),
        (Machine.switch_motors_off, ("motors off",)),
        (lambda machine: machine.stop_program("50204: Motion supervision"), ("program stopped", "Motion supervision")),
    ],
    ids=["R4 emergency stop", "guard", "R3 manual mode", "R3 motors off", "collision"],
)
def test_r3_r4_a_stopped_robot_stays_latched_until_it_is_connected_again(
    happens: Callable[[Machine], None], words: tuple[str, ...]
) -> None:
    with running(time_scale=1.0) as (controller, robot):
        machine = controller.machine
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: orders(controller) == 1)
        time.sleep(0.1)
        happens(machine)
        at_rest = machine.joints_deg()
        error = moving.wait()
        assert isinstance(error, MotionError)
        assert all(word in str(error) for word in (*words, "unknown until it is read back"))
        assert not robot.status().ready
        _make_well(machine)
        with pytest.raises(MotionError, match="was stopped"):
            robot.move_to(goal(0.0), timeout_s=10.0)
        np.testing.assert_array_equal(machine.joints_deg(), at_rest)  # nothing resumes by itself
        np.testing.assert_allclose(robot.pose().matrix, flange_pose(at_rest).matrix, atol=1e-3)  # the read-back works
        robot.close()
        again = connect(controller)
        np.testing.assert_array_equal(machine.joints_deg(), at_rest)
        again.stop()
        again.close()


def _make_well(machine: Machine) -> None:
    machine.release_emergency_stop()
    machine.reset_emergency_stop()
    machine.turn_key("AUTO")


@pytest.mark.parametrize("released", [False, True])
def test_r4_motors_are_not_switched_on_from_an_emergency_stop(released: bool) -> None:
    with running() as (controller, robot):
        controller.machine.press_emergency_stop()
        if released:
            controller.machine.release_emergency_stop()
        with pytest.raises(MotionError, match=r"emergency stop.*motors-on button"):
            robot.move_to(goal(5.0), timeout_s=10.0)
        assert not any("setctrlstate" in path for path in writes(controller))


def test_a_program_that_somebody_stopped_between_two_moves_is_not_started_again() -> None:
    with running() as (controller, robot):
        robot.move_to(goal(5.0), timeout_s=10.0)
        controller.machine.stop_program("10125: Program stopped")
        with pytest.raises(MotionError, match=r"was stopped.*Program stopped"):
            robot.move_to(goal(0.0), timeout_s=10.0)
        assert orders(controller) == 1


def test_a_program_that_somebody_started_again_is_noticed() -> None:
    with running() as (controller, robot):
        robot.move_to(goal(5.0), timeout_s=10.0)
        with controller.machine.lock:
            controller.machine.program.stop()
            controller.machine.program.reset_pointer()
            controller.machine.program.start()
        with pytest.raises(MotionError, match="started again by somebody else"):
            robot.move_to(goal(0.0), timeout_s=10.0)


def test_a_program_whose_heart_does_not_beat_is_not_used() -> None:
    with running() as (controller, robot):
        controller.machine.program.beats = False
        with pytest.raises(MotionError, match="no heartbeat"):
            robot.move_to(goal(5.0), timeout_s=10.0)
        assert orders(controller) == 0


# R5: the pose stream


def test_r5_a_pose_stream_that_stands_still_is_a_loss() -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    messages = pytest.importorskip(
        "abb_robot_client._egm_protobuf.egm_pb2", reason="needs the package abb-robot-client (pip install abb-robot-client)"
    )
    with running(egm_port=port) as (controller, robot), socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
        with pytest.raises(DeviceLost, match="has not begun"):
            robot.pose()

        def send(counter: int) -> None:
            message = messages.EgmRobot()
            message.header.seqno, message.header.mtype = counter, 2
            message.feedBack.joints.joints.extend(controller.machine.joints_deg())
            pose = flange_pose(controller.machine.joints_deg())
            for name, value in zip("xyz", pose.translation_mm, strict=True):
                setattr(message.feedBack.cartesian.pos, name, value)
            for index, value in enumerate(pose.quaternion_wxyz):
                setattr(message.feedBack.cartesian.orient, f"u{index}", value)
            sender.sendto(message.SerializeToString(), ("127.0.0.1", port))

        send(1)
        until(lambda: robot._stream._latest is not None)
        robot.pose()
        for _ in range(12):  # messages come, the counter stands
            send(1)
            time.sleep(0.05)
        with pytest.raises(DeviceLost, match="stale"):
            robot.pose()
        send(2)
        until(lambda: robot._stream._latest.counter == 2)
        robot.pose()


# R6 belongs to registration: a slipped flange shows in the clouds alone. What the controller itself knows is refused here.


def test_r6_a_robot_that_ends_away_from_its_goal_is_an_error() -> None:
    with running() as (controller, robot):
        controller.machine.program.goal_error_deg = np.array([0.2, 0, 0, 0, 0, 0])
        with pytest.raises(MotionError, match="joint 1 at"):
            robot.move_to(goal(5.0), timeout_s=10.0)


def test_r6_a_pose_that_does_not_fit_the_joints_is_refused() -> None:
    with running() as (controller, robot):
        controller.machine.robtarget_offset_mm = 2.0
        with pytest.raises(MotionError, match=r"2\.00 mm"):
            robot.pose()
        with pytest.raises(MotionError, match=r"2\.00 mm"):
            robot.move_to(goal(5.0), timeout_s=10.0)


def test_a_frozen_read_back_is_no_arrival() -> None:
    with running() as (controller, robot):
        controller.machine.frozen_deg = controller.machine.joints_deg()
        with pytest.raises(MotionError, match="away from its goal"):
            robot.move_to(goal(50.0), timeout_s=10.0)


def test_done_while_the_arm_still_creeps_is_waited_out() -> None:
    with running() as (controller, robot):
        robot.move_to(goal(5.0), timeout_s=10.0)
        controller.machine.creep_deg, controller.machine.creep_s = 0.5, 0.6
        began = time.monotonic()
        robot.move_to(goal(6.0), timeout_s=10.0)
        assert time.monotonic() - began > 0.5
        np.testing.assert_allclose(robot.pose().matrix, goal(6.0).matrix, atol=1e-2)


def test_an_arm_that_never_comes_to_rest_is_a_timeout() -> None:
    with running() as (controller, robot):
        controller.machine.creep_deg, controller.machine.creep_s = 100.0, 60.0
        with pytest.raises(DeviceTimeout, match="does not come to rest"):
            robot.move_to(goal(6.0), timeout_s=1.5)


# R7: the controller restarts


@pytest.mark.parametrize(
    ("changes", "kind", "words"),
    [
        ({}, MotionError, "motors off"),
        ({"system_id": "{other}"}, DeviceLost, "{other}"),
        ({"module_text": MODULE.replace('"MM 1.0"', '"MM 9.9"')}, DeviceLost, "MM 9.9"),
    ],
    ids=["same system", "other system", "other program"],
)
def test_r7_a_restart_during_a_move_is_never_driven_through(changes: dict[str, str], kind: type[DeviceError], words: str) -> None:
    with running(time_scale=1.0) as (controller, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: orders(controller) == 1)
        time.sleep(0.1)
        controller.reboot(**changes)
        error = moving.wait()
        assert isinstance(error, kind)
        assert words in str(error)
        at_rest = controller.machine.joints_deg()
        with pytest.raises(DeviceError):
            robot.move_to(goal(0.0), timeout_s=5.0)
        np.testing.assert_array_equal(controller.machine.joints_deg(), at_rest)
        assert not controller.machine.is_running()


def test_r7_another_system_behind_the_address_gets_no_write() -> None:
    with running() as (controller, robot):
        robot.move_to(goal(5.0), timeout_s=10.0)
        controller.reboot(system_id="{other}")
        controller.machine.ctrlstate = "motoron"
        controller.machine.program.start()
        before = len(writes(controller))
        with pytest.raises(DeviceLost, match=r"\{other\}"):
            robot.move_to(goal(0.0), timeout_s=5.0)
        assert not [path for path in writes(controller)[before:] if "symbol" in path or "start" in path]


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


# N4: two programs


def _claimed(controller: VirtualController, owner: str) -> None:
    controller.machine.program.symbols.put("mm_owner", owner)


def test_n4_a_second_program_may_only_read_and_is_told_who_has_the_robot() -> None:
    with running() as (controller, first):
        _claimed(controller, "other-computer/4711")  # what the first one wrote, as another computer sees it
        second = connect(controller)
        second.pose()
        with pytest.raises(DeviceError, match=r"computer other-computer, process 4711.*may only read"):
            second.move_to(goal(5.0), timeout_s=10.0)
        assert orders(controller) == 0
        second.stop()  # anybody may stop
        second.close()
        assert controller.machine.program.symbols.text("mm_owner") == '"other-computer/4711"'
        _claimed(controller, "")
        first.move_to(goal(5.0), timeout_s=10.0)


def test_n4_the_claim_of_a_living_program_on_this_computer_is_respected_and_that_of_an_ended_one_is_not() -> None:
    mailbox = plugin_module("robot_abb", "mailbox")
    here = mailbox.own_name().partition("/")[0]
    with running() as (controller, robot):
        _claimed(controller, f"{here}/{os.getppid()}")
        with pytest.raises(DeviceError, match="may only read"):
            robot.move_to(goal(5.0), timeout_s=10.0)
        ended = subprocess.Popen([sys.executable, "-c", ""])
        ended.wait()
        _claimed(controller, f"{here}/{ended.pid}")
        robot.move_to(goal(5.0), timeout_s=10.0)


def test_n4_the_claim_of_another_computer_is_taken_over_only_where_the_settings_say_so() -> None:
    with running(take_over=True) as (controller, robot):
        _claimed(controller, "other-computer/4711")
        robot.move_to(goal(5.0), timeout_s=10.0)
        assert "other" not in controller.machine.program.symbols.text("mm_owner")
