"""The order of viewpoints: each robot pose once, and as short as trying all orders finds."""

from __future__ import annotations

from itertools import permutations

import numpy as np
import pytest

from measureapp.data.plan import FlangePose, Viewpoint
from measureapp.planning.order import path_time_s, shortest_order
from measureapp.planning.travel import AxisSpeeds, travel_times_s
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.geometry.robot_file import arm_of
from measureapp.project.rig_file import read_rig

RIG = read_rig("paper")
ARM = arm_of(RIG)
SPEEDS = AxisSpeeds()


def viewpoints(stations: int, angles: int, seed: int = 1) -> list[Viewpoint]:
    """Viewpoints of a few robot poses, in random order."""
    rng = np.random.default_rng(seed)
    ring = tuple(plan_around_part(RIG, "ring", radius_mm=100, height_mm=70, count=16, arm=ARM))
    poses = list(dict.fromkeys(one.flange for one in ring))[:stations]
    made = [
        Viewpoint(
            id=f"v{station}{turn}", flange=pose, guide_mm=float(rng.choice([0.0, 100.0])), table_deg=round(float(rng.uniform(-180, 180)), 1)
        )
        for station, pose in enumerate(poses)
        for turn in range(angles)
    ]
    return [made[place] for place in rng.permutation(len(made))]


def visits(ordered: list[Viewpoint]) -> list[FlangePose]:
    return [one.flange for place, one in enumerate(ordered) if place == 0 or ordered[place - 1].flange != one.flange]


@pytest.mark.parametrize("seed", range(4))
def test_each_robot_pose_is_visited_once_and_every_viewpoint_is_kept(seed: int) -> None:
    wanted = viewpoints(3, 5, seed)
    order = shortest_order(wanted, travel_times_s(wanted, RIG, ARM, SPEEDS))
    assert sorted(order) == list(range(15))
    assert len(visits([wanted[place] for place in order])) == 3


@pytest.mark.parametrize("seed", range(4))
def test_within_one_robot_pose_no_order_is_shorter(seed: int) -> None:
    wanted = viewpoints(1, 7, seed)
    times = travel_times_s(wanted, RIG, ARM, SPEEDS)
    order = shortest_order(wanted, times)
    best = min(path_time_s(one, times) for one in permutations(range(7)))
    assert path_time_s(order, times) == pytest.approx(best, rel=0.02)


@pytest.mark.parametrize("seed", range(3))
def test_over_several_robot_poses_the_order_is_close_to_the_shortest_that_visits_each_once(seed: int) -> None:
    wanted = viewpoints(3, 2, seed)
    times = travel_times_s(wanted, RIG, ARM, SPEEDS)
    paths = [one for one in permutations(range(6)) if len(visits([wanted[place] for place in one])) == 3]
    best = min(path_time_s(one, times) for one in paths)
    assert path_time_s(shortest_order(wanted, times), times) <= 1.1 * best


def test_a_large_random_path_is_much_shorter_than_in_the_given_order() -> None:
    wanted = viewpoints(1, 40)
    times = travel_times_s(wanted, RIG, ARM, SPEEDS)
    assert path_time_s(shortest_order(wanted, times), times) < 0.5 * path_time_s(range(40), times)


def test_an_order_respects_that_ways_there_and_back_differ() -> None:
    """Only one direction around a ring is quick: the path follows it."""
    times = np.full((6, 6), 10.0)
    times[np.arange(6), (np.arange(6) + 1) % 6] = 1.0
    wanted = [one.model_copy(update={"table_deg": 10.0 * place}) for place, one in enumerate(viewpoints(1, 6))]
    assert path_time_s(shortest_order(wanted, times), times) == 5.0


def test_turning_the_table_costs_less_than_moving_the_robot() -> None:
    first, *_ = viewpoints(1, 1)
    other = viewpoints(2, 1)[0] if viewpoints(2, 1)[0].flange != first.flange else viewpoints(2, 1)[1]
    turned = first.model_copy(update={"id": "turned", "table_deg": first.table_deg + 30.0})
    moved = first.model_copy(update={"id": "moved", "flange": other.flange})
    times = travel_times_s([first, turned, moved], RIG, ARM, SPEEDS)
    assert 0.0 < times[0, 1] < times[0, 2]
    assert times[0, 0] == 0.0


def test_without_a_model_of_the_arm_the_way_of_the_flange_counts() -> None:
    wanted = viewpoints(3, 1)
    times = travel_times_s(wanted, RIG, None, SPEEDS)
    assert (times[~np.eye(3, dtype=bool)] > SPEEDS.settle_s).all()
