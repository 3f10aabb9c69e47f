"""Moves of an ABB robot on the virtual controller, in both versions of Robot Web Services."""

from __future__ import annotations

import random
import time
from typing import Any

import numpy as np
import pytest
from abb_cell import START, connect, goal, orders, running, writes
from robot_requests import Background, Stalls, connect_robot, until

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, LimitError, MotionError
from measureapp.geometry.transform import RigidTransform
from measureapp.peers.rws import virtual_controller
from measureapp.progress import Cancelled


@pytest.mark.parametrize("version", [1, 2])
def test_the_robot_reads_back_the_pose_it_was_sent_to(version: int) -> None:
    with running(version=version) as (controller, robot):
        for millimetres in (20.0, 60.0, 0.0):
            robot.move_to(goal(millimetres), timeout_s=10.0)
            off = robot.pose().inverse() @ goal(millimetres)
            assert np.linalg.norm(off.translation_mm) < 0.005
            assert off.angle_rad < 5e-6
        assert orders(controller) == 3
        assert robot.status().ready
        assert "automatic mode" in robot.status().text
        assert "RobotWare 6.15" in robot.status().identity


def test_nothing_is_left_at_the_controller_after_closing() -> None:
    with running() as (controller, robot):
        robot.move_to(goal(5.0), timeout_s=10.0)
        assert len(controller.sessions.active) == 2
        robot.close()
        robot.close()
        assert controller.sessions.active == {}
        assert controller.sessions.masters == {}
        assert controller.machine.program.symbols.text("mm_owner") == '""'
        assert not robot.status().ready
        with pytest.raises(DeviceLost, match="was closed"):
            robot.pose()
        assert controller.sessions.active == {}  # no login by the back door


def test_one_session_is_reused_for_all_calls_and_one_is_kept_for_stops() -> None:
    with running() as (controller, robot):
        for turn in range(10):
            robot.move_to(goal(float(turn)), timeout_s=10.0)
            robot.pose()
        robot.stop()
        assert controller.sessions.opened == 2


def test_the_number_that_starts_a_move_is_written_last_and_once() -> None:
    with running() as (controller, robot):
        robot.move_to(goal(20.0), timeout_s=10.0)
        written = [path.split("?")[0].rsplit("/", 1)[1] for path in writes(controller) if "action=set&" in path]
    assert written[-2:] == ["mm_order", "mm_cmd"]
    assert written.count("mm_cmd") == 1


def test_a_pose_out_of_reach_is_refused_before_anything_is_written() -> None:
    with running() as (controller, robot):
        before = len(writes(controller))
        far = RigidTransform.from_parts(np.eye(3), [5000.0, 0.0, 0.0], "base", "flange")
        with pytest.raises(LimitError):
            robot.move_to(far, timeout_s=10.0)
        assert len(writes(controller)) == before
        robot.move_to(goal(1.0), timeout_s=10.0)  # a refused goal is no fault


def test_reading_the_pose_writes_nothing() -> None:
    with running() as (controller, robot):
        before = len(writes(controller))
        np.testing.assert_allclose(robot.pose().matrix, START.matrix, atol=1e-4)
        robot.status()
        assert len(writes(controller)) == before


def test_motors_are_switched_on_at_the_first_move_only_where_the_settings_say_so() -> None:
    with running() as (controller, robot):
        controller.machine.switch_motors_off()
        robot.move_to(goal(5.0), timeout_s=10.0)
        assert controller.machine.ctrlstate == "motoron"
    with running(switch_motors_on=False) as (controller, robot):
        controller.machine.switch_motors_off()
        with pytest.raises(MotionError, match=r"motors off.*Switch the motors on"):
            robot.move_to(goal(5.0), timeout_s=10.0)


def test_connecting_moves_nothing_and_starts_nothing() -> None:
    with running() as (controller, _robot):
        assert not controller.machine.is_running()
        assert {path.split("?")[0].rsplit("/", 1)[1] for path in writes(controller)} == {"rapid", "mm_owner"}


def test_a_move_that_takes_too_long_is_stopped() -> None:
    with running(time_scale=1.0) as (controller, robot):
        with pytest.raises(DeviceTimeout):
            robot.move_to(goal(100.0), timeout_s=0.6)
        at_rest = controller.machine.joints_deg()
        time.sleep(0.1)
        np.testing.assert_array_equal(controller.machine.joints_deg(), at_rest)


def test_a_move_whose_time_is_over_before_it_begins_is_not_ordered() -> None:
    with running() as (controller, robot):
        with pytest.raises(DeviceTimeout):
            robot.move_to(goal(100.0), timeout_s=0.01)
        assert orders(controller) == 0


@pytest.mark.timed
def test_the_predicted_duration_covers_the_real_one() -> None:
    with running(time_scale=1.0) as (_, robot):
        robot.move_to(goal(0.0), timeout_s=30.0)
        here = robot._controller.joints_deg()
        prediction = robot._predicted_s(here, robot._arm.joints_for(goal(150.0), here))
        began = time.monotonic()
        robot.move_to(goal(150.0), timeout_s=30.0)
        assert time.monotonic() - began < 1.5 * prediction + 2.0


def test_a_lower_speed_at_the_pendant_lengthens_the_prediction() -> None:
    with running() as (controller, robot):
        here, there = np.zeros(6), np.full(6, 20.0)
        fast = robot._predicted_s(here, there)
        controller.machine.program.speed_ratio = 0.25
        assert robot._predicted_s(here, there) > 3.0 * fast


def test_two_moves_at_a_time_are_refused() -> None:
    with running(time_scale=1.0) as (controller, robot):
        moving = Background(lambda: robot.move_to(goal(50.0), timeout_s=30.0))
        until(lambda: orders(controller) == 1)
        with pytest.raises(DeviceError, match="moving already"):
            robot.move_to(goal(0.0), timeout_s=30.0)
        robot.stop()
        moving.wait()


@pytest.mark.timed
def test_a_stop_takes_effect_within_200_ms_a_hundred_times() -> None:
    effects, ends = [], []
    with Stalls() as stalls, running(time_scale=1.0) as (controller, robot):
        for turn in range(100):
            begun = orders(controller)
            wanted = goal(200.0 * (turn % 2))
            moving = Background(lambda: robot.move_to(wanted, timeout_s=30.0))  # noqa: B023
            until(lambda: orders(controller) > begun)  # noqa: B023
            time.sleep(random.Random(turn).uniform(0.0, 0.05))
            began = time.monotonic()
            robot.stop()
            at_rest = controller.machine.joints_deg()
            assert isinstance(moving.wait(), Cancelled)
            rested_at = controller.machine.rested_at
            effects.append(rested_at - began - stalls.within(began, rested_at))
            ends.append(moving.ended_at - began)
            np.testing.assert_array_equal(controller.machine.joints_deg(), at_rest)
    print(f"stop took effect after at most {max(effects) * 1e3:.0f} ms, the move ended after at most {max(ends) * 1e3:.0f} ms")  # noqa: T201
    assert max(effects) < 0.2
    assert max(ends) < 1.0


@pytest.mark.timed
def test_a_stop_does_not_wait_for_a_reply_to_another_call() -> None:
    with running(time_scale=1.0, reply_timeout_s=1.5) as (controller, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: orders(controller) == 1)
        controller.faults.delay_after_s = lambda request: 1.0 if "panel" in request[1] else 0.0
        time.sleep(0.1)
        began = time.monotonic()
        robot.stop()
        assert time.monotonic() - began < 0.2
        assert not controller.machine.is_running()
        controller.faults.delay_after_s = lambda _: 0.0
        assert isinstance(moving.wait(), Cancelled)


def test_a_stop_without_a_move_leaves_the_next_move_alone() -> None:
    with running() as (_, robot):
        robot.stop()
        robot.move_to(goal(3.0), timeout_s=10.0)
        robot.stop()
        robot.move_to(goal(1.0), timeout_s=10.0)
        np.testing.assert_allclose(robot.pose().matrix, goal(1.0).matrix, atol=1e-3)


def test_an_interrupted_move_is_not_continued_by_whatever_starts_the_program_later() -> None:
    with running(time_scale=1.0) as (controller, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: orders(controller) == 1)
        robot.stop()
        moving.wait()
        at_rest = controller.machine.joints_deg()
        controller.machine.program.start()
        time.sleep(0.2)
        np.testing.assert_array_equal(controller.machine.joints_deg(), at_rest)


@pytest.mark.parametrize(("refused", "proof"), [(("action=stop",), "run"), (("action=stop", "mm_abort"), "motors")])
def test_the_next_way_to_stop_is_taken_where_one_is_refused(refused: tuple[str, ...], proof: str) -> None:
    with running(time_scale=1.0) as (controller, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: orders(controller) == 1)
        time.sleep(0.05)
        controller.faults.drops_request = lambda request: request[0] == "POST" and any(part in request[1] for part in refused)
        robot.stop()
        at_rest = controller.machine.joints_deg()
        assert isinstance(moving.wait(), Cancelled)
        np.testing.assert_array_equal(controller.machine.joints_deg(), at_rest)
        assert controller.machine.ctrlstate == ("motoroff" if proof == "motors" else "motoron")
        controller.faults.drops_request = lambda _: False


def test_a_stop_that_nothing_confirms_asks_for_the_emergency_stop() -> None:
    with running() as (controller, robot):
        robot.move_to(goal(1.0), timeout_s=10.0)
        controller.faults.drops_request = lambda request: request[0] == "POST"
        with pytest.raises(DeviceLost, match="Press the emergency stop"):
            robot.stop()
        controller.faults.drops_request = lambda _: False


def test_closing_during_a_move_stops_the_robot() -> None:
    with running(time_scale=1.0) as (controller, robot):
        moving = Background(lambda: robot.move_to(goal(200.0), timeout_s=30.0))
        until(lambda: orders(controller) == 1)
        time.sleep(0.05)
        robot.close()
        moving.wait()
        assert not controller.machine.is_running()
        assert controller.sessions.masters == {}
        assert controller.sessions.active == {}


@pytest.mark.parametrize(
    ("settings", "words"),
    [
        ({"user": "nobody"}, "refuses user 'nobody'"),
        ({"password": "wrong"}, "user and password"),
        ({"task": "T_ROB2"}, "MeasureApp.mod"),
        ({"mechanical_unit": "ROB_9"}, "refused 'joints'"),
        ({"system_id": "{0000}"}, "the settings expect {0000}"),
        ({"version": "2.0"}, "refuses user"),
    ],
)
def test_wrong_settings_are_told_in_words(settings: dict[str, Any], words: str) -> None:
    with virtual_controller() as controller:
        with pytest.raises(DeviceError) as caught:
            connect(controller, **settings)
        assert words in str(caught.value)
        assert caught.value.hint or caught.value.message
        assert controller.sessions.active == {}


def test_another_module_is_refused_with_both_versions() -> None:
    with virtual_controller() as controller:
        controller.machine.program.symbols.put("mm_program", "0123456789abcdef")
        with pytest.raises(DeviceError, match=r"0123456789abcdef.*needs 'MM 1.0'"):
            connect(controller)
        assert controller.sessions.active == {}


def test_a_kinematic_model_of_another_arm_is_refused() -> None:
    with virtual_controller() as controller:
        controller.machine.robtarget_offset_mm = 12.0
        with pytest.raises(DeviceError, match=r"12\.0 mm off"):
            connect(controller)
        assert controller.sessions.active == {}


@pytest.mark.timed
def test_an_address_without_a_controller_is_told_within_two_seconds() -> None:
    began = time.monotonic()
    with pytest.raises(DeviceLost, match=r"127\.0\.0\.1:9"):
        connect_robot("robot_abb", address="http://127.0.0.1:9")
    assert time.monotonic() - began < 2.0
