"""The driver on cameras of a stand-in for pylon; the emulation of pylon itself is in `test_emulated.py`."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import ExitStack
from importlib import import_module
from types import ModuleType
from typing import Any
from unittest.mock import patch

import pytest

from measureapp.data.rig import RigDescription
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import LoadedDriver, load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.project.rig_file import read_rig

from .fake_pylon import FakeCamera, FakePylon

SERIAL = "24000001"
Connect = Callable[..., Any]


def rig_of(**camera: object) -> RigDescription:
    """The reference rig at a quarter of its resolution, its first camera with the given serial number and more."""
    rig = read_rig("paper").at_resolution("quarter")
    return rig.model_copy(update={"cameras": (rig.cameras[0].model_copy(update={"serial": SERIAL, **camera}), *rig.cameras[1:])})


@pytest.fixture
def loaded() -> LoadedDriver:
    return load_driver(None, "camera_basler", "camera")


@pytest.fixture
def module(loaded: LoadedDriver) -> Callable[[str], ModuleType]:
    """Import a module of the plugin."""
    package = loaded.module.__name__.rpartition(".")[0]
    return lambda name: import_module(f"{package}.{name}")


@pytest.fixture
def fake() -> FakeCamera:
    return FakeCamera(SERIAL)


@pytest.fixture
def connect(loaded: LoadedDriver) -> Iterator[Connect]:
    """Connect the rig's first camera, among the fake ones given, with settings."""
    with ExitStack() as held:

        def connected(*cameras: FakeCamera, rig: RigDescription | None = None, **settings: object) -> Any:
            held.enter_context(patch.object(loaded.module, "load_pylon", lambda: FakePylon(*cameras)))
            chosen = loaded.settings.model_validate({"row_us": 0.0, "answer_s": 0.3, "open_retry_s": 0.0, **settings})
            camera = loaded.entry(DeviceRequest("left", rig or rig_of(), chosen, Links({})))
            held.callback(camera.close)
            return camera

        yield connected
