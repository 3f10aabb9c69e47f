"""What a driver is asked to connect."""

from __future__ import annotations

from dataclasses import dataclass

from measureapp.data.model import Model
from measureapp.data.rig import RigDescription
from measureapp.devices.links import Links


@dataclass(frozen=True, slots=True, eq=False)
class DeviceRequest:
    """One device of a rig, for the entry function of its driver: ``connect(request) -> device``.

    ``settings`` is an instance of the model that the plugin's manifest names.
    """

    name: str  # as in the rig description: of a camera, or "projector", "robot", "guide", "table"; of a whole rig "rig"
    rig: RigDescription
    settings: Model
    links: Links
