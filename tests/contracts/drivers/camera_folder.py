"""The camera of recorded images on a folder of images written for it."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

import cv2
import numpy as np

from measureapp.devices.camera import Camera
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.project.rig_file import read_rig

KIND = "camera"


@contextmanager
def connected(time_scale: float) -> Iterator[Camera]:
    rig = read_rig("paper").at_resolution("quarter")
    left = rig.camera("left")
    loaded = load_driver(None, "camera_folder", "camera")
    with TemporaryDirectory() as folder:
        for exposure_us in (20_000, 40_000):
            for number in range(3):
                pixels = np.full((left.height_px, left.width_px), exposure_us // 1000 + number, np.uint8)
                cv2.imwrite(str(Path(folder) / f"{number}_{exposure_us}us.png"), pixels)
        settings = loaded.settings.model_validate(
            {"folder": folder, "exposure_in_name": r"_(?P<us>\d+)us", "readout_ms": 20.0, "time_scale": time_scale}
        )
        camera: Camera = loaded.entry(DeviceRequest("left", rig, settings, Links({})))
        yield camera
        camera.close()
