"""Processor time of the tests by room, stated at the end of a run of several rooms: it tells which room outgrows its share of ten minutes."""

from __future__ import annotations

import os
from collections import Counter
from collections.abc import Iterator, Sequence

import pytest

PROPERTY = "processor_s"
BUDGET_S = 2 * 600.0  # ten minutes on two processors
SHARE = 0.1  # of it, for one room
SHOWN_S = 5.0

_began: dict[str, float] = {}
_rooms: Counter[str] = Counter()


def processor_s() -> float:
    """Return the processor time of this process and of those it started and waited for."""
    times = os.times()
    return times.user + times.system + times.children_user + times.children_system


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_setup(item: pytest.Item) -> Iterator[None]:
    """Note when a test begins, its fixtures included."""
    _began[item.nodeid] = processor_s()
    return (yield)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_teardown(item: pytest.Item) -> Iterator[None]:
    """Give the report of a test, which also reaches the process that started this one, the time it took."""
    try:
        return (yield)
    finally:
        item.user_properties.append((PROPERTY, processor_s() - _began.pop(item.nodeid)))


def pytest_runtest_logreport(report: pytest.TestReport) -> None:
    """Add up what the tests of a room took."""
    if report.when == "teardown":
        _rooms[room_of(report.nodeid)] += sum(value for name, value in report.user_properties if name == PROPERTY)


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Write the table, where more than one room ran long enough to matter."""
    lines = table(_rooms)
    if len(lines) > 2:
        terminalreporter.section("processor time by room")
        for line in lines:
            terminalreporter.write_line(line)


def room_of(nodeid: str) -> str:
    """Return the room of a test: the folder below `tests`, or the file where it lies in none."""
    return nodeid.partition("::")[0].removeprefix("tests/").partition("/")[0]


def table(rooms: Counter[str]) -> Sequence[str]:
    """Return a line for each room that took a while, the longest first, and one for the whole; what exceeds its share says so."""
    limit_s = SHARE * BUDGET_S
    lines = [
        f"{room:<22}{seconds:8.1f} s{f'  more than its share of {limit_s:.0f} s' if seconds > limit_s else ''}"
        for room, seconds in rooms.most_common()
        if seconds > SHOWN_S
    ]
    return [*lines, f"{'all rooms':<22}{rooms.total():8.1f} s of {BUDGET_S:.0f} s"]
