"""Recorded images come in the order and at the exposures of the recording; what does not fit is named."""

from __future__ import annotations

import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from pydantic import ValidationError

from measureapp.devices.links import Links
from measureapp.devices.plugin_loader import load_driver
from measureapp.devices.request import DeviceRequest
from measureapp.errors import DeviceError, DeviceTimeout, InputError, LimitError
from measureapp.project.rig_file import read_rig

SIZE = (48, 64)  # rows, columns
Connect = Callable[..., Any]


def write(folder: Path, name: str, level: int, size: tuple[int, int] = SIZE, dtype: type = np.uint8) -> None:
    (folder / name).parent.mkdir(exist_ok=True)
    assert cv2.imwrite(str(folder / name), np.full(size, level, dtype))


@pytest.fixture
def connect(tmp_path: Path) -> Connect:
    def connected(bit_depth: int = 8, **settings: object) -> Any:
        rig = read_rig("paper")
        left = rig.cameras[0].model_copy(update={"width_px": SIZE[1], "height_px": SIZE[0], "bit_depth": bit_depth})
        rig = rig.model_copy(update={"cameras": (left, *rig.cameras[1:])})
        loaded = load_driver(None, "camera_folder", "camera")
        chosen = loaded.settings.model_validate({"folder": str(tmp_path), **settings})
        return loaded.entry(DeviceRequest("left", rig, chosen, Links({})))

    return connected


def levels(camera: Any, count: int, *, trigger: str = "software") -> list[int]:
    """The grey levels of a sequence, whose images are numbered."""
    camera.arm(count, trigger)
    found = []
    for number in range(count):
        if trigger == "software":
            camera.trigger()
        frame = camera.next_frame(timeout_s=1.0)
        assert frame.number == number
        found.append(int(frame.pixels[0, 0]))
    camera.disarm()
    return found


@pytest.mark.parametrize(("order", "expected"), [("name", [1, 10, 2]), ("number", [1, 2, 10])])
def test_images_come_in_the_order_of_their_names_or_numbers(tmp_path: Path, connect: Connect, order: str, expected: list[int]) -> None:
    for number in (10, 2, 1):
        write(tmp_path, f"image{number}.png", number)
    write(tmp_path, "other.bmp", 99)
    assert levels(connect(order=order), 3) == expected


def test_a_recording_loops_over_sequences_restarts_or_ends(tmp_path: Path, connect: Connect) -> None:
    for number in range(3):
        write(tmp_path, f"{number}.png", number)
    looping = connect()
    assert [levels(looping, 2), levels(looping, 2)] == [[0, 1], [2, 0]]
    restarting = connect(at_arm="restart")
    assert [levels(restarting, 2), levels(restarting, 2)] == [[0, 1], [0, 1]]
    ending = connect(at_end="end")
    assert levels(ending, 3) == [0, 1, 2]
    ending.arm(1, "software")
    with pytest.raises(DeviceError, match="has ended after 3 images"):
        ending.trigger()


@pytest.mark.parametrize(("suffix", "pattern"), [("{us}us", r"_(?P<us>\d+)us"), ("{ms}ms", r"_(?P<ms>[\d.]+)ms")])
def test_the_exposure_set_chooses_the_images_recorded_with_it(tmp_path: Path, connect: Connect, suffix: str, pattern: str) -> None:
    for exposure_us in (20_000, 40_000):
        for number in range(2):
            write(tmp_path, f"{number}_{suffix.format(us=exposure_us, ms=exposure_us // 1000)}.png", exposure_us // 1000 + number)
    camera = connect(exposure_in_name=pattern)
    assert camera.exposure_limits_us == (20_000, 40_000)
    for exposure_us in (40_000, 20_000):
        camera.set_exposure_us(exposure_us)
        assert levels(camera, 2) == [exposure_us // 1000, exposure_us // 1000 + 1]
    with pytest.raises(LimitError, match=r"no images recorded at 30000 µs\. Choose one of 20000, 40000 µs"):
        camera.set_exposure_us(30_000)


def test_an_unknown_exposure_is_reported_as_set(tmp_path: Path, connect: Connect) -> None:
    write(tmp_path, "0.png", 5)
    camera = connect()
    camera.set_exposure_us(12_345)
    camera.arm(1, "software")
    camera.trigger()
    assert camera.next_frame(timeout_s=1.0).exposure_us == 12_345


def test_a_manifest_lists_images_of_folders_with_their_exposures(tmp_path: Path, connect: Connect) -> None:
    for name, level in (("b/1.png", 1), ("a/2.png", 2), ("a/3.png", 3)):
        write(tmp_path, name, level)
    tables = [("b/1.png", 100), ("a/2.png", 50), ("a/3.png", 100)]
    (tmp_path / "images.toml").write_text("".join(f'[[image]]\nfile = "{name}"\nexposure_us = {us}\n' for name, us in tables))
    camera = connect(manifest="images.toml")
    camera.set_exposure_us(100)
    assert levels(camera, 2) == [1, 3]
    camera.set_exposure_us(50)
    assert levels(camera, 1) == [2]


def test_a_hardware_sequence_takes_an_image_for_each_one_fetched_and_no_more(tmp_path: Path, connect: Connect) -> None:
    for number in range(3):
        write(tmp_path, f"{number}.png", number)
    camera = connect()
    assert levels(camera, 3, trigger="hardware") == [0, 1, 2]
    camera.arm(1, "hardware")
    camera.next_frame(timeout_s=1.0)
    with pytest.raises(DeviceTimeout):
        camera.next_frame(timeout_s=0.01)


@pytest.mark.timed
def test_at_real_time_exposures_and_read_outs_are_waited_for(tmp_path: Path, connect: Connect) -> None:
    write(tmp_path, "0.png", 5)
    camera = connect(time_scale=1.0, readout_ms=30.0)
    camera.set_exposure_us(20_000)
    camera.arm(2, "software")
    start = time.monotonic()
    camera.trigger()
    camera.wait_ready(timeout_s=1.0)
    assert 0.050 <= time.monotonic() - start < 0.5
    camera.trigger()
    assert camera.next_frame(timeout_s=1.0).number == 0, "transferred during the next exposure"
    with pytest.raises(DeviceTimeout):
        camera.next_frame(timeout_s=0.01)


def test_what_is_missing_is_named_when_connecting(tmp_path: Path, connect: Connect) -> None:
    with pytest.raises(InputError, match=r"has no file \*\.png"):
        connect()
    with pytest.raises(InputError, match=r"nowhere of recorded images does not exist"):
        connect(folder=str(tmp_path / "nowhere"))
    with pytest.raises(InputError, match=r"manifest .*images\.toml cannot be read"):
        connect(manifest="images.toml")
    (tmp_path / "images.toml").write_text('[[image]]\nfile = "0.png"\n')
    with pytest.raises(InputError, match=r"1 images of .*images\.toml are missing, the first is .*0\.png"):
        connect(manifest="images.toml")
    write(tmp_path, "0.png", 5)
    with pytest.raises(InputError, match=r"0\.png has no exposure by the pattern"):
        connect(exposure_in_name=r"_(?P<us>\d+)us")


@pytest.mark.parametrize("text", ["[[image", "[[image]]\nfile = 3\n", '[[image]]\nfile = "0.png"\nexposure = 3\n', ""])
def test_a_manifest_that_is_none_is_refused(tmp_path: Path, connect: Connect, text: str) -> None:
    (tmp_path / "images.toml").write_text(text)
    with pytest.raises(InputError, match=r"images\.toml"):
        connect(manifest="images.toml")


def test_a_manifest_with_and_without_exposures_is_refused(tmp_path: Path, connect: Connect) -> None:
    write(tmp_path, "0.png", 5)
    (tmp_path / "images.toml").write_text('[[image]]\nfile = "0.png"\nexposure_us = 5\n[[image]]\nfile = "0.png"\n')
    with pytest.raises(InputError, match="Give every exposure"):
        connect(manifest="images.toml")


def test_images_of_another_size_or_depth_are_named_with_what_fits(tmp_path: Path, connect: Connect) -> None:
    write(tmp_path, "0.png", 5, (20, 30))
    with pytest.raises(InputError, match=r"0\.png has 30 × 20 px, and camera left 64 × 48 px"):
        connect()
    write(tmp_path, "0.png", 5)
    with pytest.raises(InputError, match=r"has 8-bit pixels, which does not fit the 12 bit"):
        connect(bit_depth=12)
    write(tmp_path, "0.png", 5000, dtype=np.uint16)
    with pytest.raises(InputError, match="has 16-bit pixels, which does not fit the 8 bit"):
        connect()
    with pytest.raises(InputError, match="levels up to 5000, which does not fit the 12 bit"):
        connect(bit_depth=12)
    write(tmp_path, "0.png", 4095, dtype=np.uint16)
    camera = connect(bit_depth=12)
    assert levels(camera, 1) == [4095]


def test_an_image_that_vanishes_or_is_cut_off_is_named_and_the_sequence_goes_on(tmp_path: Path, connect: Connect) -> None:
    for number in range(3):
        write(tmp_path, f"{number}.png", number)
    camera = connect()
    (tmp_path / "0.png").unlink()
    whole = (tmp_path / "1.png").read_bytes()
    (tmp_path / "1.png").write_bytes(whole[: len(whole) // 2])
    camera.arm(3, "software")
    for _ in range(3):
        camera.trigger()
    with pytest.raises(InputError, match=r"0\.png cannot be read"):
        camera.next_frame(timeout_s=1.0)
    with pytest.raises(InputError, match=r"1\.png is truncated"):
        camera.next_frame(timeout_s=1.0)
    assert camera.next_frame(timeout_s=1.0).number == 2
    assert not camera.status().ready
    with pytest.raises(DeviceError, match="All 3 images"):
        camera.trigger()


@pytest.mark.parametrize("pattern", ["(", r"_(\d+)us"])
def test_a_pattern_that_finds_no_exposure_is_refused(connect: Connect, pattern: str) -> None:
    with pytest.raises(ValidationError, match=r"regular expression|no group"):
        connect(exposure_in_name=pattern)
