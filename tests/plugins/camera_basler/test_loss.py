"""Cameras that are not there, belong to another program, vanish, or whose library never returns."""

from __future__ import annotations

import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import pytest

from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, PluginError
from measureapp.progress import Cancelled

from .conftest import SERIAL, Connect
from .fake_pylon import FakeCamera, PylonError

LOSS_S = 4.0
STOP_S = 0.2


def lasts(call: Callable[[], Any]) -> float:
    start = time.monotonic()
    call()
    return time.monotonic() - start


def lost(call: Callable[[], Any]) -> float:
    """How long a call takes to find the camera lost."""

    def refused() -> None:
        with pytest.raises(DeviceLost):
            call()

    return lasts(refused)


def test_a_wrong_serial_number_is_answered_with_those_that_are_there(connect: Connect) -> None:
    others = FakeCamera("24000007"), FakeCamera("24000008")
    with pytest.raises(DeviceError, match=f"serial number {SERIAL} answers. Found: acA2500-14gm 24000007 at 192.168.0.11, .*24000008 at"):
        connect(*others)


def test_no_camera_at_all_is_told_with_what_to_check(connect: Connect) -> None:
    with pytest.raises(DeviceError, match=r"None was found\..*network card"):
        connect()


def test_a_camera_of_another_program_is_named_after_trying_again(connect: Connect, fake: FakeCamera) -> None:
    fake.held_for_s = 100.0
    with pytest.raises(
        DeviceError, match=r"left \(acA2500-14gm 24000001 at 192.168.0.11\) is controlled by another program; it was tried for 1 s"
    ):
        connect(fake, open_retry_s=1.0)
    assert fake.attempts >= 2


def test_a_camera_whose_owner_died_is_taken_when_its_heartbeat_has_run_out(connect: Connect, fake: FakeCamera) -> None:
    fake.held_for_s = 0.7
    camera = connect(fake, open_retry_s=4.0)
    assert camera.status().ready
    assert fake.attempts > 1


def test_a_camera_that_fails_to_open_for_another_reason_is_not_tried_again(
    connect: Connect, fake: FakeCamera, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail() -> None:
        raise PylonError("The network interface is down.")

    monkeypatch.setattr(fake, "Open", fail)
    with pytest.raises(DeviceError, match="cannot be opened: The network interface is down"):
        connect(fake, open_retry_s=4.0)


def test_a_missing_library_is_named_with_what_to_install(module: Callable[[str], Any], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pypylon.pylon", None)
    with pytest.raises(PluginError, match="pip install pypylon"):
        module("opening").load_pylon()


@pytest.mark.timed
def test_a_camera_without_power_is_lost_within_4_s_also_while_a_long_wait_is_on(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake, answer_s=1.5)
    camera.arm(5, "software")
    fake.is_removed = True
    assert lost(lambda: camera.next_frame(timeout_s=60.0)) < LOSS_S
    with pytest.raises(DeviceLost, match="does not answer any more: it was removed"):
        camera.trigger()
    assert not camera.status().ready
    assert "does not answer any more" in camera.status().text


def test_a_camera_that_answers_is_not_lost_when_an_image_is_late(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    camera.arm(1, "hardware")
    with pytest.raises(DeviceTimeout):
        camera.next_frame(timeout_s=1.6)
    fake.fire()
    assert camera.next_frame(timeout_s=1.0).number == 0


@pytest.mark.timed
@pytest.mark.parametrize("answer_s", [0.3, 1.5])
def test_calls_that_never_return_are_left_to_their_thread_and_the_camera_is_lost(
    connect: Connect, fake: FakeCamera, answer_s: float
) -> None:
    camera = connect(fake, answer_s=answer_s)
    camera.arm(5, "software")
    fake.retrieve_blocks.set()
    try:
        assert lost(lambda: camera.next_frame(timeout_s=60.0)) < LOSS_S
        assert lasts(camera.close) < LOSS_S
    finally:
        fake.retrieve_blocks.clear()


@pytest.mark.timed
def test_a_trigger_that_never_returns_is_a_loss_and_closing_returns_anyway(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake, answer_s=1.5)
    camera.arm(5, "software")
    fake.control_blocks.set()
    try:
        assert lost(camera.trigger) < LOSS_S
        assert lasts(camera.stop) < STOP_S
        assert lasts(camera.close) < LOSS_S
    finally:
        fake.control_blocks.clear()


@pytest.mark.timed
@pytest.mark.parametrize("blocks", ["control_blocks", "retrieve_blocks", ""])
def test_a_stop_cancels_a_waiting_call_within_200_ms_also_while_the_library_blocks(connect: Connect, fake: FakeCamera, blocks: str) -> None:
    camera = connect(fake, answer_s=1.5)
    camera.arm(5, "software")
    call = camera.trigger if blocks == "control_blocks" else lambda: camera.next_frame(timeout_s=60.0)
    outcome: list[str] = []

    def body() -> None:
        try:
            call()
        except Cancelled:
            outcome.append("cancelled")

    if blocks:
        getattr(fake, blocks).set()
    thread = threading.Thread(target=body)
    thread.start()
    time.sleep(0.1)
    start = time.monotonic()
    camera.stop()
    thread.join(2.0)
    ended = time.monotonic() - start
    if blocks:
        getattr(fake, blocks).clear()
    assert outcome == ["cancelled"]
    assert ended < STOP_S


def test_a_failure_of_the_library_is_told_and_does_not_lose_a_camera_that_answers(
    connect: Connect, fake: FakeCamera, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail() -> None:
        raise PylonError("No memory left. : RuntimeException thrown (file 'x.h', line 1)")

    camera = connect(fake)
    camera.arm(2, "software")
    monkeypatch.setattr(fake, "ExecuteSoftwareTrigger", fail)
    with pytest.raises(DeviceError, match="Camera left failed: No memory left"):
        camera.trigger()
    assert camera.status().ready


def test_a_closed_camera_says_so_and_can_be_closed_again(connect: Connect, fake: FakeCamera) -> None:
    camera = connect(fake)
    camera.close()
    camera.close()
    assert fake.closed == 1
    with pytest.raises(DeviceLost, match="is closed"):
        camera.exposure_us()
    camera.disarm()
