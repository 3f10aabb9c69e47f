"""What every rotary table driver must do."""

from __future__ import annotations

from collections.abc import Callable
from math import radians

import pytest

from measureapp.devices.rotary_table import RotaryTable
from measureapp.errors import DeviceTimeout, LimitError

TOLERANCE_RAD = radians(0.001)


def test_the_table_reads_back_where_it_was_sent(table: RotaryTable) -> None:
    for goal_rad in (*table.limits_rad, radians(12.345), 0.0):
        table.move_to(goal_rad, timeout_s=60.0)
        assert table.angle_rad() == pytest.approx(goal_rad, abs=TOLERANCE_RAD)


@pytest.mark.parametrize("beyond_deg", [0.1, 1000.0])
def test_a_goal_beyond_the_limits_is_refused_before_moving(table: RotaryTable, beyond_deg: float) -> None:
    before = table.angle_rad()
    low, high = table.limits_rad
    for goal_rad in (low - radians(beyond_deg), high + radians(beyond_deg), float("nan")):
        with pytest.raises(LimitError):
            table.move_to(goal_rad, timeout_s=60.0)
    assert table.angle_rad() == before


def test_a_move_that_takes_too_long_is_a_timeout(slow_table: RotaryTable) -> None:
    with pytest.raises(DeviceTimeout):
        slow_table.move_to(radians(90.0), timeout_s=0.01)


def test_a_stop_from_another_thread_cancels_the_move(slow_table: RotaryTable, cancelled_by: Callable[..., bool]) -> None:
    assert cancelled_by(slow_table.stop, lambda: slow_table.move_to(radians(180.0), timeout_s=30.0))
    assert abs(slow_table.angle_rad() - radians(180.0)) > TOLERANCE_RAD


def test_a_stop_while_nothing_moves_leaves_the_next_move_alone(table: RotaryTable) -> None:
    table.stop()
    table.move_to(radians(1.0), timeout_s=30.0)
    assert table.angle_rad() == pytest.approx(radians(1.0), abs=TOLERANCE_RAD)


def test_a_table_that_is_referenced_stays_so(table: RotaryTable) -> None:
    table.home(timeout_s=30.0)
    assert table.status().ready
    assert table.status().text
