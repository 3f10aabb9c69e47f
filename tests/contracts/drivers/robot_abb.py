"""The ABB driver on its virtual controller."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from robot_requests import connect_robot

from measureapp.devices.robot import Robot
from measureapp.peers.rws import virtual_controller

KIND = "robot"


@contextmanager
def connected(time_scale: float) -> Iterator[Robot]:
    """The driver on its virtual peer; time_scale 0: as fast as possible, 1: moves last as long as in reality."""
    with virtual_controller(time_scale=time_scale) as controller:
        robot = connect_robot("robot_abb", address=controller.url, poll_s=0.02, reads_apart_s=0.02, settle_s=0.3 * time_scale)
        try:
            yield robot
        finally:
            robot.close()
