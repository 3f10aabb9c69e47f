"""Further viewpoints: between those of a plan, by their gain for their time, with chances learnt from a scan."""

from __future__ import annotations

from itertools import combinations

import numpy as np
import pytest

from measureapp.planning.chances import GREY, INCIDENCE_DEG, Chances
from measureapp.planning.next_views import Holes, between_angles, choose_by_gain, free_id, numbered_id, repeats
from measureapp.planning.viewpoints import plan_around_part
from measureapp.project.rig_file import read_rig


def holes(chance: list[list[float]], seconds: list[float] | None = None, overlap: list[float] | None = None) -> Holes:
    table = np.array(chance)
    count, samples = table.shape
    ones = np.ones(count)
    return Holes(
        np.ones(samples),
        np.ones(samples),
        table,
        (table > 0).sum(axis=1).astype(float),
        ones if overlap is None else np.array(overlap),
        10 * ones if seconds is None else np.array(seconds),
    )


def test_viewpoints_between_those_of_a_plan_halve_the_angles_of_its_table() -> None:
    rig = read_rig("paper")
    plan = plan_around_part(rig, "test", radius_mm=60.0, height_mm=60.0, count=4)
    made = between_angles(tuple(plan), rig, None)
    own = {viewpoint.table_deg % 360 for viewpoint in plan}
    assert len(made) == 4 and len({one.id for one in made}) == 4
    assert {one.flange for one in made} == {viewpoint.flange for viewpoint in plan}
    for one in made:
        gaps = sorted(min((one.table_deg - angle) % 360, (angle - one.table_deg) % 360) for angle in own)
        assert gaps[0] == pytest.approx(gaps[1], abs=0.01)
        assert rig.table.limits_deg[0] <= one.table_deg <= rig.table.limits_deg[1]


def test_repeats_differ_by_their_id_alone() -> None:
    plan = plan_around_part(read_rig("paper"), "test", radius_mm=60.0, height_mm=60.0, count=3)
    for once, again in zip(plan, repeats(tuple(plan)), strict=True):
        assert again.id != once.id and again.model_copy(update={"id": once.id}) == once


def test_a_free_id_is_the_wanted_one_or_the_next_number() -> None:
    assert free_id("next01", {"view01"}) == "next01"
    assert free_id("a", {"a", "a2"}) == "a3"


def test_each_choice_counts_what_those_before_it_leave() -> None:
    chosen = choose_by_gain(holes([[1, 1, 1, 0, 0], [0, 1, 1, 0, 0], [0, 0, 0, 1, 0.5]]), 5, 0.01, 0.1)
    assert [(one.candidate, one.area_mm2) for one in chosen] == [(0, 3.0), (2, 1.5)]


def test_the_greedy_choice_is_within_its_bound_of_the_best_set() -> None:
    """Expected coverage is submodular, so that greedy reaches at least 1 - 1/e of the best set of equal cost."""
    rng = np.random.default_rng(2)
    for _ in range(10):
        one = holes((rng.random((8, 40)) * (rng.random((8, 40)) < 0.3)).tolist())
        chosen = choose_by_gain(one, 3, 1e-9, 0.0)
        best = max(float((1 - np.prod(1 - one.chance[list(some)], axis=0)).sum()) for some in combinations(range(8), 3))
        reached = float((1 - np.prod(1 - one.chance[[gain.candidate for gain in chosen]], axis=0)).sum())
        assert sum(gain.area_mm2 for gain in chosen) == pytest.approx(reached)
        assert reached >= (1 - 1 / np.e) * best


def test_the_gain_for_the_time_decides_and_views_without_overlap_are_left_out() -> None:
    assert [one.candidate for one in choose_by_gain(holes([[1, 1, 1], [1, 1, 0]], [30.0, 10.0]), 1, 0.01, 0.1)] == [1]
    assert [one.candidate for one in choose_by_gain(holes([[1, 1, 1], [1, 1, 0]], overlap=[0.05, 0.5]), 1, 0.01, 0.1)] == [1]


def test_a_view_without_overlap_becomes_possible_by_those_before_it() -> None:
    """The second candidate sees nothing that is measured, but half of what the first is expected to measure."""
    one = holes([[1, 1, 1, 1, 0, 0], [0, 0, 1, 1, 1, 1]], overlap=[0.5, 0.0])
    assert [gain.candidate for gain in choose_by_gain(one, 2, 0.01, 0.2)] == [0, 1]
    left_out = holes([[1, 1, 1, 1, 0, 0], [0, 0, 1, 1, 1, 1]], overlap=[0.5, -1.0])
    assert [gain.candidate for gain in choose_by_gain(left_out, 2, 0.01, 0.2)] == [0]


def test_new_viewpoints_are_numbered_on() -> None:
    assert numbered_id("next", {"next01", "next02", "view01"}) == "next03"


def test_chances_are_recovered_by_incidence_and_grey_level() -> None:
    rng = np.random.default_rng(1)
    views, points = 12, 3000
    incidence = rng.uniform(0, 80, (views, points))
    grey = rng.choice([0.05, 0.4, 0.9], points)
    truth = np.array([[0.5, 0.98, 0.7], [0.4, 0.95, 0.6], [0.3, 0.8, 0.5], [0.05, 0.2, 0.1]])
    rows, columns = np.searchsorted(INCIDENCE_DEG, incidence), np.broadcast_to(np.searchsorted(GREY, grey), incidence.shape)
    alive = rng.random(points) > 0.1
    measured = (rng.random((views, points)) < truth[rows, columns]) & alive
    learnt = Chances.learn(np.ones((views, points), bool), measured, incidence, grey)
    counts = np.zeros_like(truth)
    np.add.at(counts, (rows, columns), 1)
    # binomial scatter, plus the points that are alive and were never measured by chance, plus the prior
    assert np.all(np.abs(learnt.table - truth) < 4 * np.sqrt(truth * (1 - truth) / (0.9 * counts)) + 0.02)
    assert learnt.hopeless == pytest.approx(0.1, abs=0.02)


def test_a_point_that_failed_often_is_less_likely_to_be_measured_again() -> None:
    rng = np.random.default_rng(4)
    measured = (rng.random((6, 500)) < 0.9) & (rng.random(500) > 0.2)
    learnt = Chances.learn(np.ones((6, 500), bool), measured, np.full((6, 500), 20.0), np.full(500, 0.4))
    chance = learnt.of(np.full((1, 4), 20.0), np.full(4, 0.4), np.array([0.0, 1.0, 2.0, 5.0]))[0]
    assert chance[0] == pytest.approx(0.9 * 0.8, abs=0.06)
    assert np.all(np.diff(chance) < 0) and chance[-1] < 0.01
