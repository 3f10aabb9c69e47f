"""A call that waits ends by a stop, or when its time is up, and a later call is not affected."""

from __future__ import annotations

import threading
import time

import pytest

from measureapp.devices.attempt import Stops
from measureapp.errors import DeviceTimeout
from measureapp.progress import Cancelled


@pytest.mark.timed
def test_a_stop_ends_a_wait_at_once() -> None:
    stops = Stops()
    attempt = stops.begin("Waiting", 5.0)
    timer = threading.Timer(0.03, stops.stop)
    timer.start()
    began = time.monotonic()
    with pytest.raises(Cancelled):
        attempt.wait(5.0)
    assert time.monotonic() - began < 0.5
    timer.join()


def test_a_stop_before_a_call_leaves_it_alone() -> None:
    stops = Stops()
    stops.stop()
    attempt = stops.begin("Waiting", 1.0)
    attempt.wait(0.0)
    attempt.check()


def test_time_that_is_up_is_said_with_the_call_and_its_limit() -> None:
    with pytest.raises(DeviceTimeout, match=r"Showing image 3 did not end within 0\.01 s"):
        Stops().begin("Showing image 3", 0.01).wait(1.0)


def test_calls_with_limits_of_their_own_wait_by_the_count_of_stops() -> None:
    stops = Stops()
    began = stops.count
    stops.wait(0.001, began)
    stops.stop()
    with pytest.raises(Cancelled):
        stops.wait(5.0, began)
    stops.check(stops.count)
