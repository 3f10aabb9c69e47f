"""The heartbeat finds stalls, names their place and stack, and does not count what other programs cause."""

from __future__ import annotations

import time

from tests.ui.heartbeat import Heartbeat


def _busy(seconds: float) -> None:
    end = time.thread_time() + seconds
    while time.thread_time() < end:
        pass


def test_a_busy_window_is_found_with_its_stack(qtbot):
    with Heartbeat(limit_ms=30.0) as heart:
        qtbot.wait(100)
        with heart.at("working"):
            _busy(0.2 * heart.factor)
        qtbot.wait(60)
    worst = heart.over()[0]
    assert worst.place == "working"
    assert 150.0 < worst.own_ms < 300.0
    assert "_busy" in worst.stacks[0] and "test_heartbeat.py" in heart.report()


def test_sleep_is_no_work_and_is_stated_apart(qtbot):
    with Heartbeat(limit_ms=30.0) as heart:
        qtbot.wait(60)
        time.sleep(0.15 * heart.factor)
        qtbot.wait(60)
    asleep = max(heart.stalls, key=lambda stall: stall.waited_ms)
    assert asleep.waited_ms > 100.0 and asleep.own_ms < 50.0


def test_what_the_test_itself_does_is_overlooked(qtbot):
    with Heartbeat(limit_ms=60.0) as heart:
        qtbot.wait(60)
        with heart.pause():
            _busy(0.3)
        qtbot.wait(60)
    assert heart.over() == []
