"""The driver on pylon's own emulation of cameras: software sequences, formats, damaged buffers, refused values, the time of a bracket."""

from __future__ import annotations

import logging
import os
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from measureapp.data.rig import RigDescription
from measureapp.devices.head import SoftwareHead
from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import LoadedDriver
from measureapp.devices.request import DeviceRequest
from measureapp.errors import DeviceError, DeviceTimeout, FrameError
from measureapp.project.rig_file import read_rig

os.environ.setdefault("PYLON_CAMEMU", "3")  # number of emulated cameras; read when the first factory is made
pytest.importorskip("pypylon", reason="pip install pypylon")

_log = logging.getLogger(__name__)
EXPOSURES_US = (100_000, 80_000, 60_000, 40_000, 20_000)
PATTERNS = 8
READOUT_S = 0.06853  # of 1944 rows
LARGEST_RATIO = 1.1  # of the bracket's duration to the sum of exposures and read-outs; measured: 1.04


def emulated_rig(**camera: object) -> RigDescription:
    rig = read_rig("paper")
    cameras = tuple(one.model_copy(update={"serial": f"0815-{number:04}", **camera}) for number, one in enumerate(rig.cameras))
    return rig.model_copy(update={"cameras": cameras})


@pytest.fixture
def connect_all(loaded: LoadedDriver) -> Iterator[Callable[..., dict[str, Any]]]:
    with ExitStack() as held:

        def connected(count: int = 1, rig: RigDescription | None = None, **settings: object) -> dict[str, Any]:
            described = rig or emulated_rig(width_px=640, height_px=480)
            chosen = loaded.settings.model_validate({"row_us": 0.0, **settings})
            cameras = {}
            for one in described.cameras[:count]:
                cameras[one.name] = loaded.entry(DeviceRequest(one.name, described, chosen, Links({})))
                held.callback(cameras[one.name].close)
            return cameras

        yield connected


class Screen:
    """A projector that shows at once, and any exposure is right."""

    name, frame_us = "screen", 0

    def show(self, index: int, *, timeout_s: float) -> None:
        """Nothing to show."""


def take(camera: Any, count: int) -> list[Any]:
    camera.arm(count, "software")
    frames = []
    for _ in range(count):
        camera.trigger()
        frames.append(camera.next_frame(timeout_s=3.0))
        camera.wait_ready(timeout_s=3.0)
    camera.disarm()
    return frames


@pytest.mark.parametrize(("bit_depth", "dtype", "brightest"), [(8, np.uint8, 255), (10, np.uint16, 1020), (12, np.uint16, 4080)])
def test_images_have_the_depth_of_the_rig_description(
    connect_all: Callable[..., dict[str, Any]], bit_depth: int, dtype: type, brightest: int
) -> None:
    (camera,) = connect_all(rig=emulated_rig(width_px=640, height_px=480, bit_depth=bit_depth)).values()
    (frame,) = take(camera, 1)
    assert (frame.pixels.shape, frame.pixels.dtype) == ((480, 640), dtype)
    assert frame.pixels.max() == brightest, "the emulation's wedge, in the lower bits"


@pytest.mark.parametrize(
    ("pixel_type", "bits", "raw", "pixels"),
    [
        ("Mono12packed", 12, [0xAB, 0x21, 0xCD], [0xAB1, 0xCD2]),
        ("Mono12p", 12, [0xAB, 0x21, 0xCD], [0x1AB, 0xCD2]),
        ("Mono10packed", 12, [0xAB, 0x21, 0xCD], [0x2AD, 0x336]),
        ("Mono10p", 10, [0xAB, 0x21, 0xCD, 0x12, 0x34], [0x1AB, 0x348, 0x12C, 0x0D0]),
    ],
)
def test_the_library_unpacks_packed_formats_into_the_lower_bits(
    module: Callable[[str], ModuleType], pixel_type: str, bits: int, raw: list[int], pixels: list[int]
) -> None:
    pylon = module("opening").load_pylon()
    image = pylon.PylonImage()
    width = len(pixels)
    image.AttachMemoryView(memoryview(np.array(raw, np.uint8)), getattr(pylon, f"PixelType_{pixel_type}"), width, 1, 0)
    assert image.GetArray().tolist() == [pixels]


def test_a_sequence_has_the_exposures_set_and_numbers_without_gaps(connect_all: Callable[..., dict[str, Any]]) -> None:
    (camera,) = connect_all().values()
    for exposure_us in (30_000, 5_000):
        camera.set_exposure_us(exposure_us)
        frames = take(camera, 5)
        assert [frame.number for frame in frames] == list(range(5))
        assert {frame.exposure_us for frame in frames} == {exposure_us}


def test_a_buffer_forced_to_fail_is_refused_and_the_next_image_has_its_own_number(connect_all: Callable[..., dict[str, Any]]) -> None:
    (camera,) = connect_all().values()
    nodes = camera._stream._camera.GetNodeMap()
    camera.arm(3, "software")
    numbers = []
    for trigger in range(3):
        if trigger == 1:
            nodes.GetNode("ForceFailedBufferCount").SetValue(1)
            nodes.GetNode("ForceFailedBuffer").Execute()
        camera.trigger()
        if trigger == 1:
            with pytest.raises(FrameError, match="damaged or incomplete"):
                camera.next_frame(timeout_s=3.0)
        else:
            numbers.append(camera.next_frame(timeout_s=3.0).number)
        camera.wait_ready(timeout_s=3.0)
    assert numbers == [0, 2]
    assert camera.statistics().failed_frames == 1


def test_values_outside_the_camera_s_range_are_refused_in_its_words(connect_all: Callable[..., dict[str, Any]]) -> None:
    with pytest.raises(DeviceError, match=r"refused GainRaw = 100000: .* equal or smaller than Max = 1023"):
        connect_all(gain=100_000)
    with pytest.raises(DeviceError, match="has 4096 pixels of width, fewer than the 5000"):
        connect_all(rig=emulated_rig(width_px=5000))


def test_a_wrong_serial_number_lists_the_emulated_cameras(connect_all: Callable[..., dict[str, Any]]) -> None:
    with pytest.raises(DeviceError, match="Found: Emulation 0815-0000, Emulation 0815-0001, Emulation 0815-0002"):
        connect_all(rig=emulated_rig(serial="4711"))


def test_a_trigger_line_without_pulses_is_a_timeout(connect_all: Callable[..., dict[str, Any]]) -> None:
    (camera,) = connect_all().values()
    camera.arm(2, "hardware")
    with pytest.raises(DeviceTimeout, match=r"no image within 0.1 s\."):
        camera.next_frame(timeout_s=0.1)


def test_a_camera_is_not_ready_before_its_rows_are_read_out(connect_all: Callable[..., dict[str, Any]]) -> None:
    (camera,) = connect_all(row_us=100.0).values()
    camera.set_exposure_us(20_000)
    for trigger in ("software", "hardware"):
        camera.arm(1, trigger)
        if trigger == "software":
            camera.trigger()
        start = time.monotonic()
        camera.wait_ready(timeout_s=1.0)
        assert time.monotonic() - start >= 0.020 + 480 * 100e-6
    camera.arm(1, "software")
    camera.trigger()
    with pytest.raises(DeviceTimeout, match="ready within"):
        camera.wait_ready(timeout_s=0.01)


@pytest.mark.timed
def test_the_bracket_of_three_full_cameras_takes_little_more_than_its_exposures_and_read_outs(
    connect_all: Callable[..., dict[str, Any]],
) -> None:
    """Five exposures of eight patterns at 5 MP; the emulation has no link, so no time for transfers is in it."""
    cameras = connect_all(3, emulated_rig(), row_us=35.0)
    triggered: list[float] = []
    for camera in cameras.values():
        _note_triggers(camera, triggered)
    head = SoftwareHead(cameras, Screen())  # type: ignore[arg-type]
    head.prepare(range(PATTERNS), EXPOSURES_US)
    ratios = []
    while len(ratios) < 3 and min(ratios, default=LARGEST_RATIO) >= LARGEST_RATIO:  # again where other programs took the processors
        start = time.monotonic()
        shots = [(shot.pattern, shot.exposure_us) for shot in head.acquire()]
        ratios.append((time.monotonic() - start) / (PATTERNS * sum(exposure_us * 1e-6 + READOUT_S for exposure_us in EXPOSURES_US)))
        assert shots == [(pattern, exposure_us) for exposure_us in EXPOSURES_US for pattern in range(PATTERNS)]
    skews_ms = np.ptp(np.reshape(triggered, (-1, 3)), axis=1) * 1e3
    _log.info("%.3f of exposures and read-outs; skew: median %.2f ms, largest %.2f ms", min(ratios), np.median(skews_ms), skews_ms.max())
    assert min(ratios) < LARGEST_RATIO
    assert np.median(skews_ms) < 1.0, "30 rows"


def _note_triggers(camera: Any, times: list[float]) -> None:
    stream = camera._stream
    execute = stream.trigger

    def noted() -> None:
        times.append(time.monotonic())
        execute()

    stream.trigger = noted
