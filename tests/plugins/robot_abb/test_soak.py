"""Many moves with random faults of cell and network: whatever returns without an error was at its goal, and nothing resumes by itself."""

from __future__ import annotations

import random
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from abb_cell import connect, goal

from measureapp.errors import DeviceError, DeviceLost
from measureapp.peers.rws import LinkFaults, VirtualController, virtual_controller
from measureapp.peers.rws.arm import flange_pose
from measureapp.progress import Cancelled

SECONDS = 0.15  # about the duration of a move: an event happens at a random moment of it


def events(controller: VirtualController, robot: Any) -> list[Callable[[], object]]:
    machine = controller.machine
    return [
        machine.press_emergency_stop,
        machine.open_guard,
        machine.switch_motors_off,
        lambda: machine.turn_key("MANR"),
        lambda: machine.stop_program("50204: Motion supervision"),
        controller.reboot,
        lambda: controller.reboot(system_id="{other}"),
        controller.server.break_connections,
        controller.sessions.end_all,
        robot.stop,
        robot.stop,
        lambda: setattr(controller.faults, "half_open", True),
        lambda: setattr(machine.program, "goal_error_deg", np.array([0.0, 0.3, 0.0, 0.0, 0.0, 0.0])),
        lambda: setattr(machine, "frozen_deg", machine.joints_deg()),
    ]


def make_well(controller: VirtualController) -> None:
    machine = controller.machine
    for name, value in vars(LinkFaults()).items():
        setattr(controller.faults, name, value)
    with machine.lock:
        machine.frozen_deg, machine.program.goal_error_deg = None, np.zeros(6)
        machine.opmode, machine.ctrlstate = "AUTO", "motoroff"


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_no_move_that_returns_ended_elsewhere(seed: int) -> None:
    chance = random.Random(seed)
    arrived = failed = stopped = 0
    with virtual_controller(time_scale=0.05) as controller:
        robot = connect(controller, reply_timeout_s=0.1, loss_s=0.5)
        for turn in range(80):
            wanted = goal(40.0 * chance.random())
            controller.faults.drops_answer = lambda _: chance.random() < 0.02
            controller.faults.delay_after_s = lambda _: 0.15 if chance.random() < 0.01 else 0.0
            happens = chance.choice(events(controller, robot)) if turn % 2 else lambda: None
            timer = threading.Timer(chance.random() * SECONDS, _quiet(happens))
            timer.start()
            try:
                robot.move_to(wanted, timeout_s=20.0)
            except Cancelled:
                stopped += 1
            except DeviceError:
                failed += 1
            else:
                arrived += 1
                true = flange_pose(controller.machine.axes.positions()).inverse() @ wanted
                frozen = controller.machine.frozen_deg is not None or bool(controller.machine.program.goal_error_deg.any())
                assert frozen or np.linalg.norm(true.translation_mm) < 0.1
            timer.join()
            at_rest = controller.machine.axes.positions()
            make_well(controller)
            if not robot.status().ready or turn % 2:
                robot.close()
                controller.sessions.end_all()
                robot = connect(controller, reply_timeout_s=0.1, loss_s=0.5)
            if not controller.machine.program.running:
                np.testing.assert_array_equal(controller.machine.axes.positions(), at_rest)
        robot.close()
    assert arrived > 40
    assert failed > 8
    assert stopped > 0


def _quiet(action: Callable[[], object]) -> Callable[[], None]:
    def run() -> None:
        try:
            action()
        except DeviceLost:
            return  # a stop of a robot that is lost already

    return run
