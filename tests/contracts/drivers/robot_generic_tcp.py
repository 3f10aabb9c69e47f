"""The driver of the line protocol on its virtual robot."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

from robot_requests import connect_robot

from measureapp.devices.robot import Robot
from measureapp.peers.line_robot import line_robot

KIND = "robot"


@contextmanager
def connected(time_scale: float) -> Iterator[Robot]:
    """The driver on its virtual peer; time_scale 0: as fast as possible, 1: moves last as long as in reality."""
    with line_robot(time_scale=time_scale) as (_, port):
        robot = connect_robot("robot_generic_tcp", host="127.0.0.1", port=port, reads_apart_s=0.02)
        try:
            yield robot
        finally:
            robot.close()
