"""Axis drivers connected to their virtual peers."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from measureapp.data.rig import RigDescription
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import PluginKind, load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.peers.modbus_axis import Drive, SimpleMemory, ToyoMemory
from measureapp.peers.modbus_device import Framing, ModbusDevice, on_serial, on_tcp
from measureapp.project.rig_file import read_rig

FAST = {"poll_s": 0.002, "settled_s": 0.02, "absolute_encoder": True}
PATIENT_S = 1.0  # on a busy computer a reply may take long
NAMES: dict[PluginKind, str] = {"linear-guide": "guide", "rotary-table": "table"}


@dataclass
class Connected:
    """A driver and its peer."""

    device: Any
    peer: ModbusDevice
    drive: Drive


def connect(kind: PluginKind, settings: dict[str, object], links: dict[str, dict[str, object]]) -> tuple[Any, Links]:
    """Connect the driver alone."""
    shared = Links(links)
    loaded = load_driver(None, "axis_modbus", kind)
    rig: RigDescription = read_rig("paper")
    try:
        return loaded.entry(DeviceRequest(NAMES[kind], rig, loaded.settings.model_validate(settings), shared)), shared
    except BaseException:
        shared.close()
        raise


@contextmanager
def toyo_guide(
    speed_mm: float = 2000.0, framing: Framing = "ascii", reply_timeout_s: float = 0.15, **settings: object
) -> Iterator[Connected]:
    """A guide on a TOYO controller, over a pair of pseudo-terminals; 100 pulses per mm."""
    drive = Drive(speed=100 * speed_mm, acceleration=2000 * speed_mm)
    peer = ModbusDevice(ToyoMemory(drive))
    with on_serial(peer, framing) as port:
        link = {"port": port, "framing": framing, "reply_timeout_s": reply_timeout_s}
        chosen = {"drive": "toyo_xc100", "link": "bus", "speed": speed_mm, "acceleration": 20 * speed_mm, **FAST, **settings}
        guide, shared = connect("linear-guide", chosen, {"bus": link})
        yield Connected(guide, peer, drive)
        shared.close()


@contextmanager
def simple_table(speed_deg: float = 3000.0, **settings: object) -> Iterator[Connected]:
    """A table on the simple axis, over TCP; 10 000 counts per degree."""
    drive = Drive(speed=1e4 * speed_deg, acceleration=2e5 * speed_deg)
    peer = ModbusDevice(SimpleMemory(drive))
    with on_tcp(peer) as port:
        chosen = {
            "drive": "simple_axis",
            "link": "bus",
            "speed": speed_deg,
            "acceleration": 20 * speed_deg,
            "tolerance": 0.0005,
            **FAST,
            **settings,
        }
        table, shared = connect("rotary-table", chosen, {"bus": {"host": "127.0.0.1", "tcp_port": port}})
        yield Connected(table, peer, drive)
        shared.close()
