"""Shares of work on threads: in order, with their exceptions, and never waiting for a thread that is busy elsewhere."""

from __future__ import annotations

import os
import threading
import time

import pytest

from measureapp.arrays import in_bands


def test_shares_are_consecutive_and_in_order() -> None:
    shares = in_bands(lambda start, stop: (start, stop), 1000, 7)
    assert [start for start, _ in shares] == [0, *(stop for _, stop in shares[:-1])]
    assert shares[-1][1] == 1000
    assert len(shares) == 7


def test_nothing_to_share_calls_nothing() -> None:
    assert in_bands(lambda start, stop: pytest.fail("called"), 0) == []


@pytest.mark.parametrize("failing", range(4))
def test_an_exception_of_any_share_is_raised_after_all_threads_are_done(failing: int) -> None:
    running = []

    def work(start: int, _stop: int) -> None:
        running.append(start)
        time.sleep(0.01)
        running.remove(start)
        if start == failing:
            raise ZeroDivisionError

    with pytest.raises(ZeroDivisionError):
        in_bands(work, 4, 4)
    assert running == []


def test_shares_may_be_shared_again() -> None:
    def work(start: int, stop: int) -> int:
        return sum(in_bands(lambda a, b: sum(range(start + a, start + b)), stop - start, 5))

    assert sum(in_bands(work, 1000, 10)) == sum(range(1000))


@pytest.mark.skipif((os.cpu_count() or 1) < 2, reason="one processor has no helper to keep busy")
def test_a_busy_helper_is_not_waited_for() -> None:
    held, let_go = threading.Event(), threading.Event()

    def hold(_start: int, _stop: int) -> None:
        if threading.current_thread() is caller:
            held.wait(10)
        else:
            held.set()
            let_go.wait(10)

    caller = threading.Thread(target=lambda: in_bands(hold, 64, 64))
    caller.start()
    try:
        assert held.wait(10)
        assert in_bands(lambda start, stop: stop - start, 8, 8) == [1] * 8
        assert not let_go.is_set()
    finally:
        let_go.set()
        caller.join()
