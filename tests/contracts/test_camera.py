"""What every camera driver must do."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.devices.rig import Rig
from measureapp.errors import DeviceTimeout, LimitError


def test_an_exposure_reads_back_as_it_was_set(rig: Rig) -> None:
    for camera in rig.cameras.values():
        for exposure_us in rig.description.exposures_us:
            camera.set_exposure_us(exposure_us)
            assert camera.exposure_us() == exposure_us


def test_an_impossible_exposure_is_refused_and_changes_nothing(rig: Rig) -> None:
    camera = next(iter(rig.cameras.values()))
    camera.set_exposure_us(40_000)
    with pytest.raises(LimitError):
        camera.set_exposure_us(0)
    assert camera.exposure_us() == 40_000


def test_an_image_has_the_size_and_depth_the_camera_states(rig: Rig) -> None:
    for camera in rig.cameras.values():
        image = camera.grab(timeout_s=5.0)
        assert image.pixels.shape == (camera.height_px, camera.width_px)
        assert image.pixels.dtype == (np.uint8 if camera.bit_depth == 8 else np.uint16)
        assert int(image.pixels.max()) < 2**camera.bit_depth


def test_an_image_says_which_one_it_is(rig: Rig) -> None:
    count = 3
    rig.projector.load(np.zeros((count, rig.projector.height_px, rig.projector.width_px), np.uint8))
    for camera in rig.cameras.values():
        camera.set_exposure_us(20_000)
        before = camera.grab(timeout_s=5.0).frame_number
        for index in range(count):
            rig.projector.show(index, timeout_s=1.0)
            image = camera.grab(timeout_s=5.0)
            assert (image.frame_number, image.pattern_index) == (before + 1 + index, index)
            assert (image.exposure_us, image.serial) == (20_000, camera.serial)


def test_every_camera_has_a_serial_number_of_its_own(rig: Rig) -> None:
    assert len({camera.serial for camera in rig.cameras.values()}) == len(rig.cameras)


def test_an_image_that_takes_too_long_is_a_timeout(slow_rig: Rig) -> None:
    camera = next(iter(slow_rig.cameras.values()))
    camera.set_exposure_us(20_000)
    with pytest.raises(DeviceTimeout):
        camera.grab(timeout_s=0.001)


def test_a_thermometer_says_a_temperature_and_a_camera_without_one_says_so(rig: Rig) -> None:
    for camera in rig.cameras.values():
        warm = camera.temperature_c()
        assert warm is None or -40.0 < warm < 100.0


def test_a_lens_tells_its_setting_or_nothing(rig: Rig) -> None:
    for camera in rig.cameras.values():
        setting = camera.lens()
        assert all(value is None or value > 0 for value in (setting.focus_mm, setting.f_number))
