"""The driver of a second screen on a screen that exists in memory only."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from measureapp.data.rig import RigDescription
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.projector import Projector
from measureapp.devices.request import DeviceRequest
from measureapp.project.rig_file import read_rig

KIND = "projector"
PLUGIN = "projector_second_screen"
WIDTH_PX, HEIGHT_PX = 228, 285


def rig(width_px: int = WIDTH_PX, height_px: int = HEIGHT_PX) -> RigDescription:
    described = read_rig("paper").model_dump()
    described["projector"] |= {"name": "projector", "width_px": width_px, "height_px": height_px}
    return RigDescription.model_validate(described)


@contextmanager
def screens(**sizes: tuple[int, int]) -> Iterator[None]:
    """Give new processes these screens, by name, one beside the other, under Qt's platform without a display."""
    x, described = 0, []
    for name, (width, height) in sizes.items():
        place = {"name": name, "x": x, "y": 0, "width": width, "height": height}
        described.append(place | {"logicalDpi": 96, "logicalBaseDpi": 96, "dpr": 1.0})
        x += width
    before = os.environ.get("QT_QPA_PLATFORM")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "screens.json"
        file.write_text(json.dumps({"screens": described}))
        os.environ["QT_QPA_PLATFORM"] = f"offscreen:configfile={file}"
        try:
            yield
        finally:
            os.environ["QT_QPA_PLATFORM"] = before or "offscreen"


def connect(description: RigDescription | None = None, **settings: Any) -> Projector:
    """Connect the driver to the screen ``beamer``."""
    driver = load_driver(None, PLUGIN, "projector")
    chosen = driver.settings.model_validate({"name": "beamer", "latency_s": 0.0} | settings)
    return driver.entry(DeviceRequest("projector", description or rig(), chosen, Links({})))


@contextmanager
def connected(time_scale: float) -> Iterator[Projector]:
    """The driver on a screen in memory; time_scale 0: without latency, 1: with the latency of a usual projector."""
    with screens(main=(640, 480), beamer=(WIDTH_PX, HEIGHT_PX)):
        projector = connect(latency_s=0.1 * time_scale)
    try:
        yield projector
    finally:
        projector.close()
