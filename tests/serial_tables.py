"""The driver of serial rotary tables connected to its virtual peers."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.peers.serial_controllers import Esp301, Ps90, Shot, Smc100
from measureapp.peers.serial_table import Controller, TableAxis, on_serial
from measureapp.project.rig_file import read_rig

FAST = {"poll_s": 0.002, "settled_s": 0.02}
# command table: (counts per degree, controller)
CONTROLLERS: dict[str, tuple[float, Callable[[TableAxis], Controller]]] = {
    "newport_esp301": (1.0, Esp301),
    "newport_smc100": (1.0, Smc100),
    "owis_ps90": (1000.0, Ps90),
    "sigma_koki_shot": (400.0, Shot),
}


@dataclass
class Connected:
    """A driver and the axis of its peer."""

    device: Any
    axis: TableAxis
    controller: Controller


def connect(settings: dict[str, object], link: dict[str, object], limits_deg: tuple[float, float] | None = None) -> tuple[Any, Links]:
    """Connect the driver alone; ``limits_deg``: other limits than the rig has."""
    rig = read_rig("paper")
    if limits_deg is not None:
        rig = rig.model_copy(update={"table": rig.table.model_copy(update={"limits_deg": limits_deg})})
    shared = Links({"line": link})
    loaded = load_driver(None, "table_serial", "rotary-table")
    try:
        chosen = loaded.settings.model_validate({"link": "line", **FAST, **settings})
        return loaded.entry(DeviceRequest("table", rig, chosen, shared)), shared
    except BaseException:
        shared.close()
        raise


@contextmanager
def serial_table(
    controller: str = "newport_smc100",
    speed_deg: float = 3000.0,
    start: float = 0.0,
    link: dict[str, object] | None = None,
    **settings: object,
) -> Iterator[Connected]:
    """Yield a table on one of the virtual controllers, over a pair of pseudo-terminals."""
    scale, make = CONTROLLERS[controller]
    axis = TableAxis(start, scale * speed_deg, 20 * scale * speed_deg)
    chosen = {"speed": speed_deg, "acceleration": 20 * speed_deg, "absolute_encoder": True, **settings}
    virtual = make(axis)
    with on_serial(virtual) as port:
        table, shared = connect({"controller": controller, **chosen}, {"port": port, **(link or {})})
        try:
            yield Connected(table, axis, virtual)
        finally:
            shared.close()
