"""A USB3 Vision camera has no packets; there is no such camera to test with, so that a scripted one stands in for the camera process."""

from __future__ import annotations

import sys
from typing import Any

import numpy as np
import pytest
from genicam_camera import SIZE_PX, rig_with

from measureapp.devices.plugin_loader import load_driver

FEATURES = {
    "AcquisitionMode": "Continuous",
    "ExposureTime": 5000.0,
    "Width": SIZE_PX,
    "Height": SIZE_PX,
    "PixelFormat": "Mono8",
    "TriggerMode": "Off",
    "TriggerSource": "Line0",
}
ENTRIES = {
    "AcquisitionMode": ["Continuous"],
    "PixelFormat": ["Mono8"],
    "TriggerMode": ["Off", "On"],
    "TriggerSource": ["Line0", "Software"],
}


class ScriptedLink:
    """A camera process with one image."""

    def __init__(self) -> None:
        self.values: dict[str, Any] = dict(FEATURES)
        self.called: list[str] = []
        self.grey = np.arange(SIZE_PX**2, dtype=np.uint32).astype(np.uint8)

    def call(self, method: str, *arguments: Any, **_: Any) -> Any:
        self.called.append(method)
        return getattr(self, f"_{method}", lambda *_: None)(*arguments)

    def frame(self, timeout_s: float) -> dict[str, Any]:
        layout = {"width": SIZE_PX, "height": SIZE_PX, "format": 0x01080001, "size": self.grey.size, "start": 0}
        return {"sequence": 1, "slot": 0, "status": 0, "block": 0, "time_ns": 2_000_000_000, "exposure_us": None, **layout}

    def raw(self, start: int, size: int) -> Any:
        return self.grey[start : start + size]

    def share(self, slots: int, slot_bytes: int) -> None:
        assert slot_bytes >= self.grey.size

    def _available(self, feature: str) -> bool:
        return feature in self.values

    def _read(self, feature: str) -> Any:
        return self.values[feature]

    def _write(self, feature: str, value: Any) -> None:
        self.values[feature] = value

    def _entries(self, feature: str) -> list[str]:
        return ENTRIES[feature]

    def _bounds(self, feature: str) -> tuple[float, float, float]:
        return (10.0, 1e6, 0.0) if feature == "ExposureTime" else (16, 4096, 16)

    def _payload_bytes(self) -> int:
        return self.grey.size

    def _statistics(self) -> dict[str, int]:
        return {"n_completed_buffers": 1}


def test_a_usb3_camera_delivers_images_and_counts_no_packets() -> None:
    loaded = load_driver(None, "camera_genicam", "camera")
    link = ScriptedLink()
    settings = loaded.settings.model_validate({"link_mbit_per_s": 3200})
    camera = loaded.module.GenicamCamera(rig_with().cameras[0], settings, link)
    assert camera.transfer_s == pytest.approx(SIZE_PX**2 * 8 / 3.2e9)
    camera.arm(1, "software")
    camera.trigger()
    frame = camera.next_frame(timeout_s=1.0)
    np.testing.assert_array_equal(frame.pixels.ravel(), link.grey)
    assert (frame.number, frame.exposure_us, frame.device_time_s) == (0, 5000, 2.0)
    counted = camera.statistics()
    assert (counted.frames, counted.packets, counted.resent_packets, counted.resend_share) == (1, None, None, None)
    assert "give_back" in link.called


@pytest.mark.parametrize(
    ("packets", "cameras", "seconds"),
    [((1500, 0), 1, 0.0424), ((1500, 0), 3, 0.1271), ((9000, 0), 3, 0.1221), ((1500, 100_000), 3, 0.3866)],
)
def test_the_transfer_of_five_megapixels_takes_what_the_link_allows(packets: tuple[int, int], cameras: int, seconds: float) -> None:
    module = sys.modules[load_driver(None, "camera_genicam", "camera").module.set_up.__module__]
    assert module.transfer_s(2592 * 1944, packets, 1000, cameras) == pytest.approx(seconds, rel=2e-3)
