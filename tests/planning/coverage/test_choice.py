"""The choice of viewpoints on random problems, against the same greedy method without any shortcut."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from measureapp.planning.coverage.greedy import LEAST_GAIN, STATION_COST, Goal, choose
from measureapp.planning.coverage.improve import components, improve
from measureapp.planning.coverage.value import Problem
from measureapp.progress import NoProgress


def random_problem(seed: int, *, candidates: int = 60, samples: int = 150, required_mm: float | None = None) -> Problem:
    """Discs on a square, each seen with a random standard deviation."""
    rng = np.random.default_rng(seed)
    places, centres = rng.random((samples, 2)), rng.random((candidates, 2))
    off = np.linalg.norm(centres[:, None] - places, axis=2)
    sigma = np.where(off < rng.uniform(0.12, 0.3, (candidates, 1)), rng.uniform(0.02, 0.06, (candidates, samples)), np.nan)
    return Problem.of(sigma.astype(np.float32), rng.uniform(0.5, 1.5, samples), np.arange(candidates) // 6, required_mm)


def exhaustive_greedy(problem: Problem, goal: Goal) -> list[int]:
    """In each step compute every gain anew, and take the best ratio of gain to cost among those with enough overlap."""
    chosen: list[int] = []
    while not goal.reached(problem, chosen):
        information = problem.information(chosen) if chosen else np.zeros(len(problem.areas))
        stations = {int(problem.station[one]) for one in chosen}
        ratios = {}
        for one in range(len(problem.station)):
            gain = problem.gain(one, information)
            if one not in chosen and gain > LEAST_GAIN:
                ratios[one] = gain / (1.0 if int(problem.station[one]) in stations else 1.0 + STATION_COST)
        if not ratios:
            break
        overlapping = [one for one in ratios if not chosen or problem.overlap(one, information > 0.0) >= goal.overlap]
        pool = overlapping or [max(ratios, key=lambda one: (problem.overlap(one, information > 0.0), ratios[one], -one))]
        chosen.append(max(pool, key=lambda one: (ratios[one], -one)))
    return chosen


@pytest.mark.parametrize("required_mm", [None, 0.03])
@pytest.mark.parametrize("seed", range(8))
def test_the_lazy_choice_is_that_of_computing_every_gain_anew(seed: int, required_mm: float | None) -> None:
    problem = random_problem(seed, required_mm=required_mm)
    most = problem.covered_area(problem.information(list(range(60))))
    goal = Goal(0.97 * most)
    assert choose(problem, goal, NoProgress()) == exhaustive_greedy(problem, goal)


@pytest.mark.parametrize("seed", range(8))
def test_exchanges_need_no_more_viewpoints_cover_as_much_and_keep_all_connected(seed: int) -> None:
    problem = random_problem(seed)
    goal = Goal(0.97 * problem.covered_area(problem.information(list(range(60)))))
    chosen = choose(problem, goal, NoProgress())
    better = improve(problem, chosen, goal, NoProgress())
    assert len(better) <= len(chosen)
    assert len(set(better)) == len(better)
    assert problem.covered_area(problem.information(better)) >= goal.area - 1e-9
    assert components(problem, better, goal.overlap) <= components(problem, chosen, goal.overlap)


def test_exchanges_find_fewer_viewpoints_in_most_problems() -> None:
    saved = []
    for seed in range(12):
        problem = random_problem(seed)
        goal = Goal(0.97 * problem.covered_area(problem.information(list(range(60)))))
        chosen = choose(problem, goal, NoProgress())
        saved.append(len(chosen) - len(improve(problem, chosen, goal, NoProgress())))
    assert sum(one > 0 for one in saved) >= 6


@pytest.mark.parametrize("count", [1, 3, 7])
def test_a_given_number_of_viewpoints_is_kept_and_exchanges_only_add_value(count: int) -> None:
    problem = random_problem(5)
    goal = Goal(1.0, count)
    chosen = choose(problem, goal, NoProgress())
    better = improve(problem, chosen, goal, NoProgress())
    assert len(chosen) == len(better) == count
    assert problem.total(better) >= problem.total(chosen) - 1e-9


def test_with_a_required_standard_deviation_poor_views_are_repeated_until_it_is_reached() -> None:
    sigma = np.full((4, 10), 0.04, np.float32)
    problem = Problem.of(sigma, np.ones(10), np.zeros(4, int), 0.02)
    chosen = choose(problem, Goal(1.0), NoProgress())
    assert len(chosen) == 4  # each halves no more than a quarter of the variance
    assert len(choose(Problem.of(sigma, np.ones(10), np.zeros(4, int), None), Goal(1.0), NoProgress())) == 1


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 10_000), st.booleans(), st.data())
def test_the_value_is_monotone_and_submodular(seed: int, required: bool, data: st.DataObject) -> None:
    problem = random_problem(seed, candidates=12, samples=40, required_mm=0.03 if required else None)
    large = data.draw(st.lists(st.integers(0, 10), min_size=1, max_size=8, unique=True))
    small = large[: data.draw(st.integers(0, len(large)))]
    with_small = problem.total([*small, 11]) - (problem.total(small) if small else 0.0)
    with_large = problem.total([*large, 11]) - problem.total(large)
    assert -1e-9 <= with_large <= with_small + 1e-6


@pytest.mark.parametrize("required_mm", [None, 0.03])
def test_the_area_with_each_candidate_added_is_that_of_the_larger_set(required_mm: float | None) -> None:
    problem = random_problem(2, required_mm=required_mm)
    chosen = [3, 17, 40]
    found = problem.covered_with(problem.information(chosen))
    truth = [problem.covered_area(problem.information([*chosen, one])) for one in range(60)]
    assert found == pytest.approx(truth, abs=1e-6)
