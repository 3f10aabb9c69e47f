"""States of all devices of a connected rig, read at the same time; nothing moves."""

from __future__ import annotations

from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

from measureapp.acquire.device_call import call_device
from measureapp.devices.rig import Device, Rig
from measureapp.devices.status import DeviceStatus
from measureapp.errors import MeasureError

STATUS_WITHIN_S = 1.0


@dataclass(frozen=True, slots=True)
class DeviceState:
    """One device of a rig: its name in the rig description, its kind, and what its driver reads."""

    name: str
    kind: str
    status: DeviceStatus


def read_states(rig: Rig) -> tuple[DeviceState, ...]:
    """Read the state of every device; one that fails or does not answer is not ready, with the reason."""
    named = tuple(_named(rig))
    with ThreadPoolExecutor(len(named), "states") as pool:
        statuses = pool.map(lambda entry: _read(entry[0], entry[2]), named)
        return tuple(DeviceState(name, kind, status) for (name, kind, _), status in zip(named, statuses, strict=True))


def _named(rig: Rig) -> Iterator[tuple[str, str, Device]]:
    """Yield name, kind and driver of every device, in the order in which people look at a cell."""
    for name, camera in rig.cameras.items():
        yield name, "camera", camera
    yield "projector", "projector", rig.projector
    yield "robot", "robot", rig.robot
    yield "guide", "linear guide", rig.guide
    yield "table", "rotary table", rig.table


def _read(name: str, device: Device) -> DeviceStatus:
    try:
        return call_device(f"The {name}", device.status, STATUS_WITHIN_S, lambda: None, lambda: None)
    except MeasureError as error:
        return DeviceStatus(False, error.message, error.hint)
