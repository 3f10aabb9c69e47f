"""The driver on its virtual controller, with intervals short enough for tests."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from robot_requests import connect_robot

from measureapp.geometry.transform import RigidTransform
from measureapp.peers.rws import VirtualController, virtual_controller
from measureapp.peers.rws.arm import flange_pose

START = flange_pose(np.array([0.0, 0.0, 0.0, 0.0, 30.0, 0.0]))
FAST = {"poll_s": 0.02, "reads_apart_s": 0.02, "settle_s": 0.0, "login_patience_s": 0.0}


def goal(millimetres: float) -> RigidTransform:
    """A pose near the start: tilted, and so far along the flange's axis."""
    return START @ RigidTransform.from_vector([0.05, 0.0, 0.02], [0.0, 0.0, -millimetres], "flange", "flange")


def connect(controller: VirtualController, **settings: Any) -> Any:
    """Connect the driver."""
    return connect_robot("robot_abb", address=controller.url, **{**FAST, **settings})


@contextmanager
def running(*, time_scale: float = 0.0, version: Any = 1, **settings: Any) -> Iterator[tuple[VirtualController, Any]]:
    """A virtual controller and the driver connected to it; afterwards nothing may be left at the controller."""
    with virtual_controller(time_scale=time_scale, version=version) as controller:
        robot = connect(controller, version=f"{version}.0", **settings)
        try:
            yield controller, robot
        finally:
            robot.close()


def orders(controller: VirtualController) -> int:
    """How many orders were begun."""
    return int(controller.machine.program.symbols.number("mm_cmd"))


def writes(controller: VirtualController) -> list[str]:
    """Paths of all calls that change something."""
    return [path for method, path in controller.server.requests if method != "GET"]
