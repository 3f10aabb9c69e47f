"""When an axis counts as being at rest is decided by its reads alone."""

from __future__ import annotations

import pytest

from measureapp.devices.settling import Settling, allowed_s


def observe(settling: Settling, *reads: tuple[float, float, bool]) -> list[str]:
    return [settling.observe(*read) for read in reads]


def test_two_reads_that_agree_at_the_goal_are_an_arrival_and_one_is_not() -> None:
    settling = Settling(10.0, 0.02, 0.1)
    assert observe(settling, (0.0, 10.0, False), (0.05, 10.0, False), (0.1, 10.01, False)) == ["moving", "moving", "arrived"]


def test_an_axis_that_passes_through_its_goal_has_not_arrived() -> None:
    settling = Settling(10.0, 0.02, 0.1)
    assert set(observe(settling, *((0.11 * step, 9.9 + 0.05 * step, False) for step in range(10)))) == {"moving"}


def test_an_axis_that_creeps_by_less_than_the_tolerance_per_read_is_compared_with_the_first_of_them() -> None:
    settling = Settling(10.0, 0.02, 0.1)
    assert set(observe(settling, *((0.03 * step, 9.99 + 0.009 * step, False) for step in range(4)))) == {"moving"}


def test_an_axis_whose_drive_reports_motion_has_not_arrived() -> None:
    settling = Settling(10.0, 0.02, 0.1)
    assert set(observe(settling, *((0.2 * step, 10.0, True) for step in range(10)))) == {"moving"}


def test_rest_away_from_the_goal_is_told_after_a_second() -> None:
    settling = Settling(10.0, 0.02, 0.1)
    assert observe(settling, (0.0, 9.5, False), (0.9, 9.5, False), (1.1, 9.5, False)) == ["moving", "moving", "elsewhere"]
    assert settling.distance(9.5) == pytest.approx(0.5)


def test_positions_modulo_one_turn_are_compared_the_shorter_way() -> None:
    settling = Settling(0.0, 0.02, 0.1, lambda one, other: (one - other + 180.0) % 360.0 - 180.0)
    assert observe(settling, (0.0, 359.995, False), (0.2, 0.005, False)) == ["moving", "arrived"]


def test_a_move_may_take_half_as_long_again_as_predicted_and_two_seconds() -> None:
    assert allowed_s(10.0, 60.0) == 17.0
    assert allowed_s(10.0, 5.0) == 5.0
