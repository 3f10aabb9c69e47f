"""The driver on screens that exist in memory only, with the real process of the window."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

import numpy as np
import psutil
import pytest
from contracts.drivers.projector_second_screen import HEIGHT_PX, WIDTH_PX, connect, rig, screens

from measureapp.devices.projector import DARK, PLAIN_LIGHT, TriggeringProjector
from measureapp.errors import DeviceError, DeviceLost, DeviceTimeout, InputError
from measureapp.progress import Cancelled

ROOT = Path(__file__).resolve().parents[3]


def images(count: int = 3) -> np.ndarray:
    return np.random.default_rng(1).integers(0, 256, (count, HEIGHT_PX, WIDTH_PX), np.uint8)


@pytest.fixture
def projector() -> Iterator[Any]:
    with screens(main=(640, 480), beamer=(WIDTH_PX, HEIGHT_PX)):
        driver = connect()
    driver.load(images())
    yield driver
    driver.close()


def test_what_is_shown_reads_back(projector: Any) -> None:
    for index in (0, 2, PLAIN_LIGHT, DARK, 1):
        projector.show(index, timeout_s=2.0)
        assert projector.shown() == index


def test_one_frame_lasts_as_long_as_the_screen_s(projector: Any) -> None:
    assert projector.frame_us == 16_667
    assert not isinstance(projector, TriggeringProjector)


def test_the_latency_is_waited_for() -> None:
    with screens(beamer=(WIDTH_PX, HEIGHT_PX)):
        slow = connect(latency_s=0.2, frame_us=8_333)
    with closing(slow):
        began = time.monotonic()
        slow.show(PLAIN_LIGHT, timeout_s=2.0)
        assert time.monotonic() - began >= 0.2
        assert slow.frame_us == 8_333
        with pytest.raises(DeviceTimeout):
            slow.show(DARK, timeout_s=0.1)


def test_images_of_another_size_and_images_that_do_not_exist_are_refused(projector: Any) -> None:
    with pytest.raises(DeviceError, match="does not support images of shape"):
        projector.load(images()[:, :-1])
    projector.show(1, timeout_s=2.0)
    with pytest.raises(DeviceError, match="3 images and cannot show image 3"):
        projector.show(3, timeout_s=2.0)
    assert projector.shown() == 1


@pytest.mark.timed
def test_a_stop_makes_it_dark_and_ends_a_waiting_call() -> None:
    with screens(beamer=(WIDTH_PX, HEIGHT_PX)):
        slow = connect(latency_s=2.0)
    slow.load(images())
    outcome: list[BaseException] = []

    def wait() -> None:
        try:
            slow.show(0, timeout_s=5.0)
        except BaseException as error:
            outcome.append(error)

    thread = threading.Thread(target=wait)
    thread.start()
    while slow.shown() != 0:
        time.sleep(0.005)
    asked = time.monotonic()
    slow.stop()
    thread.join(1.0)
    assert time.monotonic() - asked < 0.2
    assert isinstance(outcome[0], Cancelled)
    assert slow.shown() == DARK
    slow.close()


@pytest.mark.timed
@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no signal that kills a process without its doing")
def test_a_window_whose_process_dies_is_lost_and_named(projector: Any) -> None:
    os.kill(projector._window._process.pid, signal.SIGKILL)
    began = time.monotonic()
    with pytest.raises(DeviceLost, match="the process of its window"):
        while time.monotonic() - began < 2.0:
            projector.show(0, timeout_s=2.0)
    assert time.monotonic() - began < 1.0
    assert not projector.status().ready


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no signal that pauses a process")
def test_a_window_that_hangs_is_a_timeout(projector: Any) -> None:
    process = projector._window._process.pid
    os.kill(process, signal.SIGSTOP)
    try:
        with pytest.raises(DeviceTimeout, match=r"did not follow the command show within 0\.2 s"):
            projector.show(0, timeout_s=0.2)
    finally:
        os.kill(process, signal.SIGCONT)
    projector.show(1, timeout_s=2.0)
    assert projector.shown() == 1


def test_the_window_goes_with_the_program_that_opened_it() -> None:
    code = (
        "import sys; sys.path.insert(0, 'tests')\n"
        "from contracts.drivers.projector_second_screen import connect, screens\n"
        "with screens(beamer=(228, 285)):\n    driver = connect()\n"
        "print(driver._window._process.pid, flush=True)\n"
        "import os; os._exit(9)\n"
    )
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True, check=False, timeout=60)
    process = int(done.stdout)
    end = time.monotonic() + 3.0
    while alive(process) and time.monotonic() < end:
        time.sleep(0.02)
    assert not alive(process)


def alive(process: int) -> bool:
    return psutil.pid_exists(process) and psutil.Process(process).status() != psutil.STATUS_ZOMBIE


def test_closing_ends_the_process_and_may_be_repeated(projector: Any) -> None:
    projector.close()
    projector.close()
    assert projector._window._process.poll() is not None
    assert not Path(projector._folder.name).exists()
    with pytest.raises(DeviceLost, match="its window was closed"):
        projector.show(0, timeout_s=1.0)


def test_a_screen_that_is_not_there_is_named_with_those_that_are() -> None:
    with screens(main=(640, 480)), pytest.raises(DeviceError, match=r"No screen has name 'beamer' \(connected: main 640 × 480 px\)"):
        connect()


def test_a_screen_of_another_size_is_refused() -> None:
    with screens(beamer=(640, 480)), pytest.raises(InputError, match="has 640 × 480 px, and the patterns have 228 × 285 px"):
        connect()


def test_settings_that_name_no_screen_are_refused() -> None:
    with pytest.raises(InputError, match="name no screen") as refused:
        connect(name="")
    assert "python -m ui.second_screen list" in refused.value.hint


def test_a_computer_without_a_display_is_said_in_words(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("QT_QPA_PLATFORM", "no-such-platform")
    with pytest.raises(DeviceError, match=r"the process of its window ended with code .*\(.*\)"):
        connect()


def test_the_state_names_screen_and_mode(projector: Any) -> None:
    projector.show(2, timeout_s=1.0)
    assert projector.status().text == "image 2 on the screen beamer, 228 × 285 px at 60 Hz"


def test_an_image_of_the_size_of_a_lightcrafter_costs_less_than_a_frame_of_processor_time() -> None:
    with screens(beamer=(912, 1140)):
        driver = connect(rig(912, 1140))
    with closing(driver):
        driver.load(np.random.default_rng(1).integers(0, 256, (8, 1140, 912), np.uint8))
        process = psutil.Process(driver._window._process.pid)
        before = process.cpu_times()
        for index in range(40):
            driver.show(index % 8, timeout_s=5.0)
            assert driver.shown() == index % 8
        after = process.cpu_times()
    assert (after.user + after.system - before.user - before.system) / 40 < 1 / 60
