"""A robot that somebody or something stops, or that is not where it should be: rows R3-R7 of the list of faults to survive."""

from __future__ import annotations

import socket
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from abb_cell import connect, goal, orders, running, writes
from robot_requests import Background, until

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, MotionError
from measureapp.peers.rws.arm import flange_pose
from measureapp.peers.rws.machine import Machine
from measureapp.resources import resource

MODULE = Path(resource("rapid/MeasureApp.mod")).read_text(encoding="ascii")


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
