"""The driver of the LightCrafter on its virtual peer."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache
from typing import Any

import numpy as np

from measureapp.data.rig import RigDescription
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.projector import TriggeringProjector
from measureapp.devices.request import DeviceRequest
from measureapp.peers.lightcrafter import VirtualLightCrafter
from measureapp.project.rig_file import read_rig

KIND = "projector"
PLUGIN = "projector_lightcrafter"
SIZE = (1140, 912)


def contract_images() -> np.ndarray:
    """Return eight images that are declared to be in the flash of the peer, in three flash images; also their first ones alone."""
    rows = np.arange(SIZE[0], dtype=np.uint8)[:, None]
    return np.stack([np.broadcast_to(rows + 10 * index, SIZE) for index in range(8)])


@cache
def declared() -> tuple[dict[str, Any], ...]:
    """Return the declarations of `contract_images` and of plain grey ones, for the settings."""
    load_driver(None, PLUGIN, "projector")
    from _measureapp_plugins.projector_lightcrafter.sequence import pattern_hash

    sets = {"rows": contract_images(), "grey": np.full((8, *SIZE), 200, np.uint8)}
    return tuple(
        {"name": f"{name} {count}", "hash": pattern_hash(images[:count]), "images": tuple(range(-(-count // 3)))}
        for name, images in sets.items()
        for count in range(1, len(images) + 1)
    )


def rig(sequence: str = "hardware") -> RigDescription:
    described = read_rig("paper").model_dump()
    described["projector"] |= {"name": "LightCrafter", "width_px": SIZE[1], "height_px": SIZE[0]}
    described["head"] = {"sequence": sequence}
    return RigDescription.model_validate(described)


def connect(peer: VirtualLightCrafter, sequence: str = "hardware", **settings: Any) -> TriggeringProjector:
    """Connect the driver to a peer."""
    driver = load_driver(None, PLUGIN, "projector")
    chosen = driver.settings.model_validate({"poll_s": 0.001, "reply_timeout_s": 0.15, "flash": declared()} | settings)
    return driver.entry(DeviceRequest("projector", rig(sequence), chosen, Links({})), lambda name, serial: peer)


@contextmanager
def connected(time_scale: float) -> Iterator[TriggeringProjector]:
    """The driver on its virtual peer; time_scale 0: as fast as possible, 1: images are loaded as slowly as in reality."""
    projector = connect(VirtualLightCrafter(load_s=0.2 * time_scale))
    try:
        yield projector
    finally:
        projector.close()
