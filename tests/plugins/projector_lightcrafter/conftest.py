"""The driver's modules, and a projector on its virtual peer."""

from __future__ import annotations

import importlib
from collections.abc import Iterator
from types import ModuleType
from typing import Any

import pytest
from contracts.drivers.projector_lightcrafter import PLUGIN, connect, contract_images

from measureapp.devices.plugin_loader import load_driver
from measureapp.peers.lightcrafter import VirtualLightCrafter


def module(name: str) -> ModuleType:
    load_driver(None, PLUGIN, "projector")
    return importlib.import_module(f"_measureapp_plugins.{PLUGIN}.{name}")


@pytest.fixture
def peer() -> VirtualLightCrafter:
    return VirtualLightCrafter(load_s=0.0)


@pytest.fixture
def projector(peer: VirtualLightCrafter) -> Iterator[Any]:
    """The driver with its eight images loaded."""
    driver = connect(peer)
    driver.load(contract_images())
    peer.commands.clear()
    yield driver
    driver.close()
