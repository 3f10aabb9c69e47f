"""A whole virtual cell for drivers to talk to: robot controller, guide and table on loopback, all moving one simulated world."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from math import radians
from typing import Protocol

from measureapp.arrays import FloatArray
from measureapp.data.rig import DriverChoice, RigDescription
from measureapp.geometry.transform import RigidTransform
from measureapp.peers.modbus_axis import Drive, SimpleMemory, ToyoMemory
from measureapp.peers.modbus_device import ModbusDevice, on_serial, on_tcp
from measureapp.peers.rws import virtual_controller
from measureapp.peers.rws.arm import flange_pose

COUNTS_PER_MM, COUNTS_PER_DEG = 100.0, 10_000.0
FAST, REAL = 1e6, 1.0  # factor on speeds
QUICK_READS = {"poll_s": 0.01, "settled_s": 0.02}
QUICK_ROBOT = {"poll_s": 0.02, "reads_apart_s": 0.02, "settle_s": 0.0}


class Moved(Protocol):
    """What is told where the axes come to rest, for instance a simulated world."""

    def move_robot(self, base_from_flange: RigidTransform) -> None:
        """The flange is here."""

    def move_guide(self, position_mm: float) -> None:
        """The slide is here."""

    def turn_table(self, angle_rad: float) -> None:
        """The table is here."""


@dataclass(frozen=True, slots=True)
class CellAddresses:
    """Where the peers of a cell are found."""

    robot_url: str
    guide_port: str  # serial
    table_port: int  # TCP


@contextmanager
def virtual_cell(world: Moved, *, realtime: bool = False) -> Iterator[CellAddresses]:
    """Run peers that move ``world``; without ``realtime`` axes arrive at once."""
    factor = REAL if realtime else FAST

    def robot_rests(joints_deg: FloatArray) -> None:
        world.move_robot(flange_pose(joints_deg))

    guide = Drive(speed=300.0 * COUNTS_PER_MM * factor, acceleration=1_000.0 * COUNTS_PER_MM * factor**2)
    table = Drive(speed=30.0 * COUNTS_PER_DEG * factor, acceleration=100.0 * COUNTS_PER_DEG * factor**2)
    guide.on_rest = lambda counts: world.move_guide(counts / COUNTS_PER_MM)
    table.on_rest = lambda counts: world.turn_table(radians(counts / COUNTS_PER_DEG))
    with (
        virtual_controller(time_scale=1.0 if realtime else 0.0, on_rest=robot_rests) as controller,
        on_serial(ModbusDevice(ToyoMemory(guide)), "rtu") as guide_port,
        on_tcp(ModbusDevice(SimpleMemory(table))) as table_port,
    ):
        robot_rests(controller.machine.joints_deg())
        yield CellAddresses(controller.url, guide_port, table_port)


def rig_at(
    addresses: CellAddresses, description: RigDescription, head: Mapping[str, object] | None = None, *, realtime: bool = False
) -> RigDescription:
    """Return ``description`` with the true drivers of robot, guide and table, and cameras and projector of the link "cell".

    Parameters
    ----------
    head : settings of the virtual rig behind that link
    """
    reads, robot = ({}, {}) if realtime else (QUICK_READS, QUICK_ROBOT)
    image = DriverChoice(driver="virtual_rig", settings={"link": "cell"})
    devices = {
        **{camera.name: image for camera in description.cameras},
        "projector": image,
        "robot": DriverChoice(driver="robot_abb", settings={"address": addresses.robot_url, **robot}),
        "guide": DriverChoice(
            driver="axis_modbus", settings={"drive": "toyo_xc100", "link": "guide", "speed": 300.0, "absolute_encoder": True, **reads}
        ),
        "table": DriverChoice(
            driver="axis_modbus", settings={"drive": "simple_axis", "link": "table", "speed": 30.0, "tolerance": 0.001, **reads}
        ),
    }
    links: dict[str, dict[str, object]] = {
        "cell": dict(head or {}),
        "guide": {"port": addresses.guide_port, "framing": "rtu"},
        "table": {"host": "127.0.0.1", "tcp_port": addresses.table_port},
    }
    composed = description.model_dump() | {
        "name": f"{description.name}, through its drivers",
        "driver": "",
        "driver_settings": {},
        "devices": {name: choice.model_dump() for name, choice in devices.items()},
        "links": links,
    }
    return RigDescription.model_validate(composed)
