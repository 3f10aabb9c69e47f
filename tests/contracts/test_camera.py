"""What every camera driver must do."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
import pytest

from measureapp.devices.camera import Camera, Frame
from measureapp.errors import DeviceError, DeviceTimeout, LimitError

EXPOSURES_US = (40_000, 20_000)
PERIOD_S = 0.2  # more than that of virtual cameras, which take two triggers within one for one


def take(camera: Camera, count: int) -> list[Frame]:
    camera.arm(count, "software")
    frames = []
    for _ in range(count):
        camera.trigger()
        camera.wait_ready(timeout_s=5.0)
        frames.append(camera.next_frame(timeout_s=5.0))
    camera.disarm()
    return frames


def test_an_exposure_reads_back_as_it_was_set(camera: Camera) -> None:
    for exposure_us in EXPOSURES_US:
        camera.set_exposure_us(exposure_us)
        assert abs(camera.exposure_us() - exposure_us) <= camera.exposure_step_us


def test_an_impossible_exposure_is_refused_and_changes_nothing(camera: Camera) -> None:
    camera.set_exposure_us(40_000)
    before = camera.exposure_us()
    for impossible in (camera.exposure_limits_us[0] - 1, camera.exposure_limits_us[1] + 1):
        with pytest.raises(LimitError):
            camera.set_exposure_us(impossible)
    assert camera.exposure_us() == before


def test_an_image_has_the_size_and_depth_the_camera_states(camera: Camera) -> None:
    (frame,) = take(camera, 1)
    assert frame.pixels.shape == (camera.height_px, camera.width_px)
    assert frame.pixels.dtype == (np.uint8 if camera.bit_depth == 8 else np.uint16)
    assert int(frame.pixels.max()) < 2**camera.bit_depth


def test_images_are_numbered_from_zero_in_every_sequence_with_exposure_and_serial(camera: Camera) -> None:
    camera.set_exposure_us(20_000)
    for _ in range(2):
        frames = take(camera, 3)
        assert [frame.number for frame in frames] == [0, 1, 2]
        for frame in frames:
            assert frame.serial == camera.serial
            assert frame.exposure_us is not None
            assert abs(frame.exposure_us - 20_000) <= camera.exposure_step_us


def test_the_image_before_can_be_fetched_while_the_next_is_exposed(camera: Camera) -> None:
    camera.arm(3, "software")
    camera.trigger()
    camera.wait_ready(timeout_s=20.0)
    numbers = []
    for _ in range(2):
        time.sleep(PERIOD_S)
        camera.trigger()
        numbers.append(camera.next_frame(timeout_s=20.0).number)
        camera.wait_ready(timeout_s=20.0)
    numbers.append(camera.next_frame(timeout_s=20.0).number)
    camera.disarm()
    assert numbers == [0, 1, 2]


def test_an_image_is_the_receiver_s_own(camera: Camera) -> None:
    first, _ = take(camera, 2)
    kept = first.pixels.copy()
    take(camera, 2)
    np.testing.assert_array_equal(first.pixels, kept)


def test_a_trigger_without_arming_is_refused(camera: Camera) -> None:
    camera.disarm()
    with pytest.raises(DeviceError):
        camera.trigger()


def test_an_image_that_nothing_triggered_is_a_timeout(camera: Camera) -> None:
    camera.arm(1, "software")
    with pytest.raises(DeviceTimeout):
        camera.next_frame(timeout_s=0.05)
    camera.disarm()


def test_a_stop_from_another_thread_cancels_a_waiting_call(slow_camera: Camera, cancelled_by: Callable[..., bool]) -> None:
    slow_camera.arm(1, "software")
    assert cancelled_by(slow_camera.stop, lambda: slow_camera.next_frame(timeout_s=20.0))
    slow_camera.disarm()
    assert len(take(slow_camera, 1)) == 1, "the next sequence is not affected"


def test_a_thermometer_says_a_temperature_and_a_camera_without_one_says_so(camera: Camera) -> None:
    warm = camera.temperature_c()
    assert warm is None or -40.0 < warm < 100.0


def test_a_lens_tells_its_setting_or_nothing(camera: Camera) -> None:
    setting = camera.lens()
    assert all(value is None or value > 0 for value in (setting.focus_mm, setting.f_number))


def test_a_camera_tells_its_state_and_counts_its_images(camera: Camera) -> None:
    before = camera.statistics().frames
    take(camera, 2)
    assert camera.statistics().frames == before + 2
    status = camera.status()
    assert status.ready
    assert status.text


def test_the_exposure_may_change_while_the_image_before_is_on_its_way(camera: Camera) -> None:
    camera.set_exposure_us(40_000)
    camera.arm(2, "software")
    camera.trigger()
    camera.wait_ready(timeout_s=20.0)
    time.sleep(PERIOD_S)
    camera.set_exposure_us(20_000)
    camera.trigger()
    first = camera.next_frame(timeout_s=20.0)
    camera.wait_ready(timeout_s=20.0)
    second = camera.next_frame(timeout_s=20.0)
    camera.disarm()
    for frame, exposure_us in ((first, 40_000), (second, 20_000)):
        assert frame.exposure_us is not None
        assert abs(frame.exposure_us - exposure_us) <= camera.exposure_step_us
