"""The driver on the fake camera of Aravis, a program that others wrote, over loopback."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from genicam_camera import NAME, PERIOD_S, SERIAL, connect, connected, fake_camera, needs_fake_camera, ramp, rig_with

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, FrameError, InputError, LimitError
from measureapp.progress import Cancelled

pytestmark = needs_fake_camera
RAMP_EXPOSURE_US = 10_000  # at which the fake camera does not scale its ramp
LOST_S = 4.0
WAIT_S = 30.0  # for what takes 3 s where nothing else runs
STOP_S = 0.2


def first_of_a_sequence(camera: Any, frames: int = 1) -> Any:
    camera.set_exposure_us(RAMP_EXPOSURE_US)
    camera.arm(frames, "software")
    camera.trigger()
    return camera.next_frame(timeout_s=WAIT_S)


def process_of(camera: Any) -> subprocess.Popen[bytes]:
    return camera._link._process


def outcome_of(call: Callable[[], object]) -> tuple[threading.Thread, list[BaseException | None]]:
    """Run a call on a thread of its own, and note what it raised."""
    outcome: list[BaseException | None] = []

    def body() -> None:
        try:
            call()
        except (DeviceError, Cancelled) as error:
            outcome.append(error)
        else:
            outcome.append(None)

    thread = threading.Thread(target=body)
    thread.start()
    return thread, outcome


def test_a_wrong_serial_number_lists_the_cameras_that_were_found() -> None:
    with fake_camera(), pytest.raises(DeviceError, match=rf"serial number 4711 was found \(found: Aravis Fake {SERIAL} at 127.0.0.1\)"):
        connect(rig_with("4711"))


def test_no_camera_at_all_is_said_in_words() -> None:
    # "none", unless another test has a camera on this computer at the moment
    with pytest.raises(DeviceError, match=r"serial number 4711 was found \(found: (none|.*127\.0\.0\.1)"):
        connect(rig_with("4711"))


@pytest.mark.parametrize(("size_px", "count"), [(512, 50), (2048, 20)])
def test_every_image_is_exact_to_the_pixel_and_belongs_to_its_trigger(size_px: int, count: int) -> None:
    with fake_camera(), connected(size_px=size_px, packet_size_bytes=9000) as camera:
        begins = int(first_of_a_sequence(camera, count).pixels[0, 0])
        for number in range(1, count):
            camera.trigger()
            frame = camera.next_frame(timeout_s=2.0)
            assert (frame.number, frame.exposure_us) == (number, RAMP_EXPOSURE_US)
            np.testing.assert_array_equal(frame.pixels, ramp(begins + number, size_px))
        counted = camera.statistics()
    assert (counted.frames, counted.failed_frames, counted.lost_packets) == (count, 0, 0)


@pytest.mark.parametrize(("lost_per_1000", "packet_size_bytes", "count"), [(1, 1500, 40), (10, 3000, 30), (50, 9000, 40)])
def test_an_image_with_lost_packets_is_never_taken_for_a_good_one(lost_per_1000: int, packet_size_bytes: int, count: int) -> None:
    """The fake camera cannot send packets again, so that every loss damages an image: of 180, 88 or 30 packets, every sixth, second or nearly all."""
    good, begins = [], set()
    with fake_camera(lost_per_1000), connected(packet_size_bytes=packet_size_bytes, buffers=4) as camera:
        camera.set_exposure_us(RAMP_EXPOSURE_US)
        camera.arm(count, "software")
        for _ in range(count):
            camera.trigger()
            try:
                good.append(frame := camera.next_frame(timeout_s=2.0))
            except FrameError as error:
                assert "incomplete" in error.message
                continue
            grey = int(frame.pixels[0, 0])
            np.testing.assert_array_equal(frame.pixels, ramp(grey))
            begins.add((grey - frame.number) % 255)
        counted = camera.statistics()
    assert len(begins) <= 1, "each image belongs to its trigger"
    assert (counted.frames, counted.failed_frames) == (len(good), count - len(good))
    assert (counted.lost_packets or 0) > 0
    assert 0 < len(good) < count


def test_settings_are_read_back_and_refused_beyond_the_limits_of_the_camera() -> None:
    with fake_camera():
        with connected(gain=3) as camera:
            assert camera._link.call("read", "GainRaw") == 3
            camera.set_exposure_us(12_345)
            assert camera.exposure_us() == 12_345
        with pytest.raises(LimitError, match=r"does not support GainRaw 11"), connected(gain=11):
            pass
        with pytest.raises(LimitError, match=r"does not support Width 4096"), connected(size_px=4096):
            pass


def test_a_pixel_format_that_the_camera_lacks_is_refused_with_those_it_has() -> None:
    with fake_camera(), pytest.raises(InputError, match=r"no pixel format for 12 bit .* has .*Mono8.*Mono16"), connected(bit_depth=12):
        pass


def test_a_hardware_trigger_on_a_line_that_the_camera_lacks_is_refused_with_those_it_has() -> None:
    with (
        fake_camera(),
        connected() as camera,
        pytest.raises(InputError, match=r"TriggerSource cannot be Line1 \(possible: Line0, Software\)"),
    ):
        camera.arm(1, "hardware")


def test_an_armed_hardware_trigger_without_a_pulse_is_a_timeout() -> None:
    with fake_camera(), connected(trigger_line="Line0") as camera:
        camera.arm(1, "hardware")
        with pytest.raises(DeviceTimeout):
            camera.next_frame(timeout_s=3 * PERIOD_S)
        with pytest.raises(DeviceError, match="not armed for software triggers"):
            camera.trigger()


def test_packet_size_and_delay_are_set() -> None:
    with fake_camera():
        with connected(packet_size_bytes=4000, packet_delay_us=20.0) as camera:
            assert camera._link.call("packets", 4000, 20_000) == (4000, 20_000)
            packets_at_4000 = packets_of_one_image(camera)
        with connected(packet_size_bytes=9000) as camera:
            assert packets_of_one_image(camera) < packets_at_4000


def packets_of_one_image(camera: Any) -> int:
    first_of_a_sequence(camera)
    return int(camera.statistics().packets)


def test_a_camera_that_another_program_controls_is_refused_and_free_once_it_is_closed() -> None:
    with fake_camera():
        with connected() as camera:
            with pytest.raises(DeviceError, match=rf"Another program controls camera {NAME} \({SERIAL}\)"):
                connect(rig_with(), control_wait_s=0.0)
            assert first_of_a_sequence(camera).number == 0, "the first program is not disturbed"
        with connected(control_wait_s=0.0) as camera:
            assert first_of_a_sequence(camera).number == 0


@pytest.mark.timed
def test_a_camera_process_that_is_killed_is_a_lost_camera_which_can_be_connected_again() -> None:
    with fake_camera():
        with connected() as camera:
            first_of_a_sequence(camera, 3)
            process_of(camera).kill()
            started = time.monotonic()
            with pytest.raises(DeviceLost, match="signal 9"):
                camera.next_frame(timeout_s=10.0)
            assert time.monotonic() - started < LOST_S
            with pytest.raises(DeviceLost):
                camera.trigger()
            assert not camera.status().ready
        with connected(control_wait_s=10.0) as camera:  # once the heartbeat of the killed process has run out
            assert first_of_a_sequence(camera).number == 0


def test_a_program_that_is_killed_leaves_neither_a_process_nor_its_hold_on_the_camera() -> None:
    program = (
        "import genicam_camera, sys, time\n"
        "camera = genicam_camera.connect(genicam_camera.rig_with())\n"
        "camera.arm(3, 'software'); camera.trigger()\n"
        "print(camera._link._process.pid, flush=True)\n"
        "time.sleep(60)\n"
    )
    with fake_camera():
        variables = {**os.environ, "PYTHONPATH": os.pathsep.join(path for path in sys.path if path)}
        command = [sys.executable, "-c", program]
        with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=variables) as killed:
            assert killed.stdout is not None
            child = int(killed.stdout.readline())
            killed.kill()
        wait_until(lambda: not is_running(child), within_s=WAIT_S)
        with connected(control_wait_s=0.0) as camera:
            assert first_of_a_sequence(camera).number == 0


def is_running(process: int) -> bool:
    try:
        os.kill(process, 0)
    except ProcessLookupError:
        return False
    with open(f"/proc/{process}/stat", encoding="utf-8") as file:  # noqa: PTH123
        return file.read().rpartition(")")[2].split()[0] != "Z"  # where nobody waits for it


def wait_until(condition: Callable[[], bool], within_s: float) -> None:
    end = time.monotonic() + within_s
    while not condition():
        assert time.monotonic() < end, "it did not happen in time"
        time.sleep(0.02)


@pytest.mark.timed
def test_a_camera_that_falls_silent_is_lost_within_four_seconds() -> None:
    with fake_camera() as peer, connected() as camera:
        first_of_a_sequence(camera, 3)
        peer.hang()
        started = time.monotonic()
        with pytest.raises(DeviceLost, match=f"Camera {NAME} does not answer any more"):
            camera.next_frame(timeout_s=30.0)
        assert time.monotonic() - started < LOST_S
        started = time.monotonic()
        camera.close()
        assert time.monotonic() - started < LOST_S
        assert process_of(camera).poll() is not None


def test_control_lost_to_a_heartbeat_that_ran_out_is_found() -> None:
    with fake_camera(), connected() as camera:
        first_of_a_sequence(camera, 3)
        process_of(camera).send_signal(signal.SIGSTOP)
        try:
            with connected(control_wait_s=WAIT_S):  # the camera gives its control away once the heartbeat has run out
                pass
        finally:
            process_of(camera).send_signal(signal.SIGCONT)
        with pytest.raises(DeviceLost):
            camera.next_frame(timeout_s=WAIT_S)


@pytest.mark.timed
@pytest.mark.parametrize("silent", [False, True])
def test_a_stop_takes_effect_within_200_ms_also_when_the_camera_is_silent(silent: bool) -> None:
    with fake_camera() as peer, connected() as camera:
        first_of_a_sequence(camera, 3)
        if silent:
            peer.hang()
        thread, outcome = outcome_of(lambda: camera.next_frame(timeout_s=30.0))
        time.sleep(0.7)  # it asks the silent camera by then
        started = time.monotonic()
        camera.stop()
        thread.join()
        assert time.monotonic() - started < STOP_S
        assert isinstance(outcome[0], Cancelled)
        if silent:
            peer.go_on()


def test_a_close_ends_a_waiting_call_and_may_be_repeated() -> None:
    with fake_camera(), connected() as camera:
        first_of_a_sequence(camera, 3)
        thread, outcome = outcome_of(lambda: camera.next_frame(timeout_s=30.0))
        camera.close()
        camera.close()
        thread.join()
        assert isinstance(outcome[0], Cancelled | DeviceLost)
        assert process_of(camera).poll() == 0
        with pytest.raises(DeviceLost, match="closed"):
            camera.exposure_us()
