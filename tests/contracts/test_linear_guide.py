"""What every linear guide driver must do."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from measureapp.devices.rig import Rig
from measureapp.errors import DeviceTimeout, LimitError

TOLERANCE_MM = 0.01


def test_the_guide_reads_back_where_it_was_sent(rig: Rig) -> None:
    for goal_mm in (*rig.guide.limits_mm, 12.345, 0.0):
        rig.guide.move_to(goal_mm, timeout_s=30.0)
        assert rig.guide.position_mm() == pytest.approx(goal_mm, abs=TOLERANCE_MM)


@pytest.mark.parametrize("beyond_mm", [0.1, 1000.0])
def test_a_goal_beyond_the_limits_is_refused_before_moving(rig: Rig, beyond_mm: float) -> None:
    before = rig.guide.position_mm()
    for goal_mm in (rig.guide.limits_mm[0] - beyond_mm, rig.guide.limits_mm[1] + beyond_mm, float("nan")):
        with pytest.raises(LimitError):
            rig.guide.move_to(goal_mm, timeout_s=30.0)
    assert rig.guide.position_mm() == before


def test_a_move_that_takes_too_long_is_a_timeout(slow_rig: Rig) -> None:
    with pytest.raises(DeviceTimeout):
        slow_rig.guide.move_to(500.0, timeout_s=0.01)


def test_a_stop_from_another_thread_cancels_the_move(slow_rig: Rig, cancelled_by: Callable[..., bool]) -> None:
    assert cancelled_by(slow_rig.guide.stop, lambda: slow_rig.guide.move_to(600.0, timeout_s=30.0))
    assert abs(slow_rig.guide.position_mm() - 600.0) > TOLERANCE_MM
