"""The driver, through Aravis, on our virtual camera: what the fake camera of Aravis cannot do."""

from __future__ import annotations

import time
from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from genicam_camera import NAME, SERIAL, SIZE_PX, connect, connected, needs_library, rig_with, virtual_camera

from measureapp.devices.camera import Frame
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, FrameError, SequenceError
from measureapp.peers.gige_camera import Faults, GigeCamera, noise

pytestmark = needs_library
EXPOSURE_US = 1000
LOST_S = 4.0


@pytest.fixture
def peer() -> Iterator[GigeCamera]:
    with virtual_camera() as camera:
        yield camera


def shows(frame: Frame, exposure: int, bits: int = 8) -> bool:
    """Tell whether an image is the one of this exposure, to the last pixel."""
    return bool(np.array_equal(frame.pixels, noise(SIZE_PX, SIZE_PX, bits)(exposure, 0.0)))


def arm(camera: Any, frames: int, trigger: str = "software") -> None:
    camera.set_exposure_us(EXPOSURE_US)
    camera.arm(frames, trigger)


def take(camera: Any) -> Frame:
    camera.trigger()
    return camera.next_frame(timeout_s=2.0)


@pytest.mark.parametrize("lost_share", [0.001, 0.01, 0.05])
def test_lost_packets_are_sent_again_counted_and_the_images_exact(peer: GigeCamera, lost_share: float) -> None:
    count = 60
    with connected() as camera:
        arm(camera, count)
        peer.faults = Faults(lost_share=lost_share)
        for number in range(count):
            frame = take(camera)
            assert frame.number == number
            assert shows(frame, number)
        counted = camera.statistics()
        told = camera.status().text
    assert ("of the packets were sent again" in told) == (counted.resend_share > 0.001)
    sent = count * 182  # of 1500 bytes, with leader and trailer
    lost = sent * lost_share
    assert (counted.frames, counted.failed_frames, counted.lost_packets) == (count, 0, 0)
    assert sent - count <= counted.packets <= 1.2 * sent  # on a busy machine, some are requested twice
    assert lost - 5 * lost**0.5 <= counted.resent_packets <= 3 * lost + 0.2 * sent
    assert counted.resend_share == counted.resent_packets / counted.packets


@pytest.mark.parametrize("faults", [Faults(lost_share=0.003, resends=False), Faults(lost_share=0.01, lost_again_share=0.9)])
def test_an_image_that_stays_incomplete_is_refused_and_the_others_keep_their_numbers(peer: GigeCamera, faults: Faults) -> None:
    count, good = 50, 0
    with connected(buffers=4) as camera:
        arm(camera, count)
        peer.faults = faults
        for number in range(count):
            try:
                frame = take(camera)
            except FrameError as error:
                assert not isinstance(error, SequenceError)
                assert "incomplete" in error.message
                continue
            good += 1
            assert frame.number == number
            assert shows(frame, number)
        counted = camera.statistics()
    assert 0 < good < count
    assert (counted.frames, counted.failed_frames) == (good, count - good)
    assert (counted.lost_packets or 0) >= count - good


def test_each_pulse_on_the_line_gives_one_image(peer: GigeCamera) -> None:
    with connected() as camera:
        arm(camera, 5, "hardware")
        for number in range(5):
            camera.wait_ready(timeout_s=1.0)
            peer.pulse()
            frame = camera.next_frame(timeout_s=1.0)
            assert frame.number == number
            assert shows(frame, number)


def test_a_pulse_that_came_too_early_gives_no_image_and_is_missed(peer: GigeCamera) -> None:
    with connected() as camera:
        camera.set_exposure_us(50_000)
        camera.arm(2, "hardware")
        peer.pulse()
        time.sleep(0.01)
        peer.pulse()
        assert camera.next_frame(timeout_s=1.0).number == 0
        with pytest.raises(DeviceTimeout):
            camera.next_frame(timeout_s=0.3)


def test_two_exposures_for_one_trigger_are_found(peer: GigeCamera) -> None:
    with connected() as camera:
        arm(camera, 3)
        assert take(camera).number == 0
        peer.expose_unasked()
        with pytest.raises(SequenceError, match="Image 2 arrived after 1 triggers"):
            camera.next_frame(timeout_s=1.0)


def test_an_image_that_was_lost_as_a_whole_leaves_a_gap_in_the_numbers(peer: GigeCamera) -> None:
    with connected() as camera:
        arm(camera, 3)
        assert take(camera).number == 0
        peer.lose_image()
        with pytest.raises(DeviceTimeout):
            camera.trigger()
            camera.next_frame(timeout_s=0.2)
        frame = take(camera)
        assert frame.number == 2
        assert shows(frame, 2)


def test_an_image_that_arrives_twice_is_refused(peer: GigeCamera) -> None:
    with connected() as camera:
        arm(camera, 3)
        take(camera)
        take(camera)
        peer.send_last_again()
        time.sleep(0.05)
        frame = take(camera)  # Aravis itself drops packets of an image that is complete
        assert frame.number == 2
        assert shows(frame, 2)


def test_an_image_with_another_exposure_than_set_is_refused(peer: GigeCamera) -> None:
    with connected() as camera:
        arm(camera, 2)
        assert take(camera).exposure_us == EXPOSURE_US
        peer.faults = Faults(wrong_exposure_us=200)
        with pytest.raises(FrameError, match=r"exposed for 1200\.0 µs instead of 1000 µs"):
            take(camera)


@pytest.mark.parametrize("feature", ["GainAuto", "TriggerMode", "Gain"])
def test_a_setting_that_the_camera_forgets_ends_the_connecting(peer: GigeCamera, feature: str) -> None:
    peer.faults = Faults(ignores=frozenset({feature}))
    with pytest.raises(DeviceError, match=rf"{feature} is \w+ after (Off|On|6) was written"), connected(gain=6.0) as camera:
        camera.arm(1, "software")


def test_an_exposure_that_the_camera_forgets_is_found(peer: GigeCamera) -> None:
    with connected() as camera:
        peer.faults = Faults(ignores=frozenset({"ExposureTime"}))
        with pytest.raises(DeviceError, match="ExposureTime is 5000 after 20000 was written"):
            camera.set_exposure_us(20_000)


@pytest.mark.parametrize(
    ("bit_depth", "pixel_format", "bytes_per_pixel"),
    [(12, "auto", 1.5), (12, "Mono12Packed", 1.5), (12, "Mono12", 2), (10, "auto", 2), (16, "auto", 2)],
)
def test_deeper_and_packed_images_are_exact(bit_depth: int, pixel_format: str, bytes_per_pixel: float) -> None:
    with virtual_camera(bits=bit_depth), connected(bit_depth=bit_depth, pixel_format=pixel_format, exposure_chunk=False) as camera:
        arm(camera, 3)
        for number in range(3):
            frame = take(camera)
            assert shows(frame, number, bit_depth)
            assert frame.pixels.dtype == np.uint16
        assert camera._facts.payload_bytes == SIZE_PX * SIZE_PX * bytes_per_pixel


def test_a_camera_reports_temperature_shutter_and_read_out_where_it_can(peer: GigeCamera) -> None:
    with connected() as camera:
        assert camera.temperature_c() == 41.5
        assert camera.shutter == "rolling"
        assert camera.readout_s == pytest.approx(0.002)
        assert camera.status().identity == f"Virtual {SERIAL}, firmware 1.0"


@pytest.mark.timed
def test_the_camera_is_ready_when_exposure_and_read_out_have_ended(peer: GigeCamera) -> None:
    with connected() as camera:
        camera.set_exposure_us(100_000)
        camera.arm(2, "software")
        started = time.monotonic()
        camera.trigger()
        with pytest.raises(DeviceTimeout, match="not ready"):
            camera.wait_ready(timeout_s=0.02)
        camera.wait_ready(timeout_s=1.0)
        assert 0.102 <= time.monotonic() - started < 0.4
        camera.trigger()
        assert [camera.next_frame(timeout_s=1.0).number for _ in range(2)] == [0, 1]


def test_the_host_of_the_program_that_controls_the_camera_is_named(peer: GigeCamera) -> None:
    peer.seize("192.168.0.9")
    with pytest.raises(DeviceError, match=rf"A program on 192\.168\.0\.9 controls camera {NAME}"):
        connect(rig_with(), control_wait_s=0.2)


@pytest.mark.timed
def test_control_seized_by_another_program_is_a_lost_camera_within_four_seconds(peer: GigeCamera) -> None:
    with connected() as camera:
        arm(camera, 2)
        take(camera)
        peer.seize("192.168.0.9")
        started = time.monotonic()
        with pytest.raises(DeviceLost, match="no longer controlled by this program"):
            camera.next_frame(timeout_s=10.0)
        assert time.monotonic() - started < LOST_S
