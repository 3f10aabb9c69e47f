"""The template of a camera driver, as a stranger finds it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from unittest.mock import patch

from measureapp.devices.camera import Camera
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.project.rig_file import read_rig
from measureapp.resources import resource

KIND = "camera"


@contextmanager
def connected(time_scale: float) -> Iterator[Camera]:
    with patch("measureapp.devices.plugin_loader.is_allowed", lambda folder: True):
        loaded = load_driver(resource("plugin_template").parent, "camera_template", "camera")
    settings = loaded.settings.model_validate({"readout_ms": 10.0 * time_scale})
    camera: Camera = loaded.entry(DeviceRequest("left", read_rig("paper").at_resolution("quarter"), settings, Links({})))
    yield camera
    camera.close()
