"""Logins, mastership and two programs, with faults at the virtual controller: rows R1, R2 and N4 of the list of faults to survive."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time

import pytest
from abb_cell import connect, goal, orders, running, writes
from robot_requests import Background, plugin_module

from measureapp.errors import DeviceError, MotionError
from measureapp.peers.rws import VirtualController, virtual_controller

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
