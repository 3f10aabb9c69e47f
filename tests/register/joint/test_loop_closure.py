"""Pairs close around the part as well as their uncertainty lets expect, and an error in one of them shows in full."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.data.cloud import LoopClosure
from measureapp.register.joint.loop_closure import find_worst_loop
from measureapp.register.joint.pose_graph import linearise_edge
from measureapp.register.pairs.icp import apply_motion
from tests.register.joint.test_innovation import PAIR_SIGMAS, VIEWS, by_axes, closed_loop, drawn

NAMES = [f"v{i}" for i in range(VIEWS)]
RADII = np.full(VIEWS, 50.0)


def jointly(kinematic, pairs, centres, covariance):
    """Poses by pairs and axes together, in one step: the errors are small."""
    matrix, right = np.linalg.inv(covariance), np.zeros(6 * VIEWS)
    for pair in pairs:
        error, by_target, by_source = linearise_edge(kinematic, pair, centres)
        rows = np.r_[6 * pair.target + np.arange(6), 6 * pair.source + np.arange(6)]
        both = np.hstack([by_target, by_source])
        matrix[np.ix_(rows, rows)] += both.T @ pair.information @ both
        right[rows] -= both.T @ pair.information @ error
    steps = np.linalg.solve(matrix, right).reshape(-1, 6)
    return [apply_motion(pose, step, centre) for pose, step, centre in zip(kinematic, steps, centres, strict=True)]


def ring_of(kinematic, pairs, centres, covariance) -> LoopClosure | None:
    return find_worst_loop(jointly(kinematic, pairs, centres, covariance), pairs, centres, RADII, covariance, NAMES)


def neighbours(pairs):
    return [pair for pair in pairs if (pair.source - pair.target) % VIEWS == 1]


@pytest.mark.parametrize("draws", [40, pytest.param(100, marks=pytest.mark.slow)])
@pytest.mark.parametrize("view_mm", [0.5, 0.004])
def test_gaps_are_as_large_as_expected(view_mm: float, draws: int) -> None:
    rng, covariance = np.random.default_rng(1), by_axes(0.1, view_mm)
    ratios = []
    for _ in range(draws):
        kinematic, pairs, centres = drawn(covariance, rng)
        found = ring_of(kinematic, neighbours(pairs), centres, covariance)
        assert found is not None and len(found.viewpoints) == VIEWS
        ratios.append((found.gap_mm / found.sigma_mm) ** 2)
    # a mean of squares of at least three numbers that matter: its relative variance is 2/3 at most per draw
    assert abs(np.mean(ratios) - 1) < 4 * np.sqrt(2 / 3 / draws)


def test_an_axis_in_the_wrong_place_leaves_no_gap_where_only_some_pairs_see_it() -> None:
    rng, shared_mm, draws = np.random.default_rng(6), 0.1, 30
    by_shift = np.vstack([np.vstack([pose.rotation, np.zeros((3, 3))]) for pose in closed_loop()[0]])
    covariance = shared_mm**2 * by_shift @ by_shift.T + by_axes(0.1, 0.004)
    ratios, sigmas = [], []
    for _ in range(draws):
        kinematic, pairs, centres = drawn(covariance, rng)
        around = [
            replace(pair, information=pair.information * np.diag([1e-6 ** (k % 2), 1, 1, 1, 1, 1]))
            for k, pair in enumerate(neighbours(pairs))
        ]
        found = ring_of(kinematic, around, centres, covariance)
        assert found is not None
        ratios.append((found.gap_mm / found.sigma_mm) ** 2)
        sigmas.append(found.sigma_mm)
    assert np.mean(ratios) < 1 + 4 * np.sqrt(2 / draws)  # less than one: blind pairs are drawn as good as the others
    # six pairs whose shifts and turns add up, the turns by arms of up to 80 mm between centres
    assert max(sigmas) < np.sqrt(VIEWS * 3) * np.hypot(PAIR_SIGMAS[0], 80 * PAIR_SIGMAS[3]) < shared_mm / 2


def test_loose_axes_leave_the_gap_to_the_pairs_alone() -> None:
    covariance = by_axes(0.1, 0.5)
    kinematic, pairs, centres = drawn(covariance, np.random.default_rng(2))
    found = ring_of(kinematic, neighbours(pairs), centres, covariance)
    # six pairs whose shifts and turns add up, the turns by the arms from where the pairs lie to the first view
    assert found is not None
    arms = np.linalg.norm(centres - centres[0], axis=1)
    shifts, turns = VIEWS * 3 * PAIR_SIGMAS[0] ** 2, VIEWS * 3 * PAIR_SIGMAS[3] ** 2 * 2 / 3 * RADII[0] ** 2
    assert np.sqrt(shifts + turns) * 0.95 < found.sigma_mm < np.sqrt(shifts + turns + VIEWS * 3 * PAIR_SIGMAS[3] ** 2 * arms.max() ** 2)


@pytest.mark.parametrize("wrong", range(VIEWS))
def test_an_error_of_one_pair_shows_in_full(wrong: int) -> None:
    covariance = by_axes(0.1, 0.5)
    kinematic, pairs, centres = drawn(covariance, np.random.default_rng(3))
    around = neighbours(pairs)
    clean = ring_of(kinematic, around, centres, covariance)
    around[wrong] = replace(around[wrong], change=np.array([0.2, 0, 0, 0, 0, 0]))
    spoiled = ring_of(kinematic, around, centres, covariance)
    assert clean is not None and spoiled is not None
    assert clean.gap_mm < 3 * clean.sigma_mm
    assert abs(spoiled.gap_mm - 0.2) < 3 * spoiled.sigma_mm


def test_the_worst_of_several_loops_is_reported_from_its_first_view() -> None:
    covariance = by_axes(0.1, 0.5)
    kinematic, pairs, centres = drawn(covariance, np.random.default_rng(4))
    pairs = [replace(pair, change=np.array([0, 0, 0.3, 0, 0, 0])) if (pair.target, pair.source) == (1, 3) else pair for pair in pairs]
    found = ring_of(kinematic, pairs, centres, covariance)
    assert found is not None
    assert found.viewpoints[0] == min(found.viewpoints)
    assert ("v1" in found.viewpoints and "v3" in found.viewpoints) == (found.gap_mm > 0.1)
    assert found.gap_mm > 0.1


def test_views_of_one_side_leave_nothing_to_close() -> None:
    covariance = by_axes(0.1, 0.5)
    kinematic, pairs, centres = drawn(covariance, np.random.default_rng(5))
    assert ring_of(kinematic, [pair for pair in neighbours(pairs) if 5 not in (pair.target, pair.source)], centres, covariance) is None
    assert ring_of(kinematic, [], centres, covariance) is None
