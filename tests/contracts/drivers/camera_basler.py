"""The Basler driver on an emulated camera of pylon."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from measureapp.devices.camera import Camera
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.project.rig_file import read_rig

os.environ.setdefault("PYLON_CAMEMU", "3")  # number of emulated cameras; read when the first factory is made
KIND = "camera"


@contextmanager
def connected(time_scale: float) -> Iterator[Camera]:
    pytest.importorskip("pypylon", reason="pip install pypylon")
    rig = read_rig("paper").at_resolution("quarter")
    emulated = rig.model_copy(update={"cameras": (rig.cameras[0].model_copy(update={"serial": "0815-0000"}), *rig.cameras[1:])})
    loaded = load_driver(None, "camera_basler", "camera")
    settings = loaded.settings.model_validate({"row_us": 35.0 * time_scale})
    camera: Camera = loaded.entry(DeviceRequest(emulated.cameras[0].name, emulated, settings, Links({})))
    yield camera
    camera.close()
