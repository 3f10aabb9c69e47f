"""What every linear guide driver must do."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from measureapp.devices.linear_guide import LinearGuideAxis
from measureapp.errors import DeviceTimeout, LimitError

TOLERANCE_MM = 0.01


def test_the_guide_reads_back_where_it_was_sent(guide: LinearGuideAxis) -> None:
    for goal_mm in (*guide.limits_mm, 12.345, 0.0):
        guide.move_to(goal_mm, timeout_s=30.0)
        assert guide.position_mm() == pytest.approx(goal_mm, abs=TOLERANCE_MM)


@pytest.mark.parametrize("beyond_mm", [0.1, 1000.0])
def test_a_goal_beyond_the_limits_is_refused_before_moving(guide: LinearGuideAxis, beyond_mm: float) -> None:
    before = guide.position_mm()
    for goal_mm in (guide.limits_mm[0] - beyond_mm, guide.limits_mm[1] + beyond_mm, float("nan")):
        with pytest.raises(LimitError):
            guide.move_to(goal_mm, timeout_s=30.0)
    assert guide.position_mm() == before


def test_a_move_that_takes_too_long_is_a_timeout(slow_guide: LinearGuideAxis) -> None:
    low, high = slow_guide.limits_mm
    with pytest.raises(DeviceTimeout):
        slow_guide.move_to(low + 0.9 * (high - low), timeout_s=0.01)


def test_a_stop_from_another_thread_cancels_the_move(slow_guide: LinearGuideAxis, cancelled_by: Callable[..., bool]) -> None:
    goal_mm = slow_guide.limits_mm[0]
    assert cancelled_by(slow_guide.stop, lambda: slow_guide.move_to(goal_mm, timeout_s=30.0))
    assert abs(slow_guide.position_mm() - goal_mm) > TOLERANCE_MM


def test_a_stop_while_nothing_moves_leaves_the_next_move_alone(guide: LinearGuideAxis) -> None:
    guide.stop()
    guide.move_to(1.0, timeout_s=30.0)
    assert guide.position_mm() == pytest.approx(1.0, abs=TOLERANCE_MM)


def test_a_guide_that_is_referenced_stays_so(guide: LinearGuideAxis) -> None:
    guide.home(timeout_s=30.0)
    assert guide.status().ready
    assert guide.status().text
