"""The GenICam driver on the fake camera of Aravis."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import genicam_camera
import pytest

from measureapp.devices.camera import Camera

KIND = "camera"


@contextmanager
def connected(time_scale: float) -> Iterator[Camera]:
    """The driver on a program that others wrote; it always takes its own time: 25 images per second."""
    if genicam_camera.MISSING:
        pytest.skip(genicam_camera.MISSING)
    with genicam_camera.fake_camera(), genicam_camera.connected() as camera:
        yield camera
