"""The loop closure as a test of the error model: false alarms as rare as stated, contradictions found."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from measureapp.arrays import FloatArray
from measureapp.pipeline.consistency.dependence import CHANCE, Dependence, compare_with_expected
from measureapp.register.joint.loop_closure import SharedMotions, find_worst_loop
from measureapp.register.joint.pose_graph import linearise_edge
from measureapp.register.pairs.icp import PairMeasurement
from tests.register.joint.test_innovation import PAIR_SIGMAS, PAIRS, VIEWS, by_axes, drawn
from tests.register.joint.test_loop_closure import NAMES, RADII, jointly

RATE = 0.05
LOOPED = PAIRS.index((0, 2))  # a pair that a loop of few steps runs over
SHARED = 2  # errors that all clouds share
SHARED_SIZE = 1.5  # of what they do to a pair, in the pair's standard deviations


def moved_by(pairs: list[PairMeasurement], motions: FloatArray) -> list[PairMeasurement]:
    """Return pairs whose measured sources are moved by (E, 6)."""
    return [replace(pair, change=pair.change + motion) for pair, motion in zip(pairs, motions, strict=True)]


def shared_motions(kinematic, pairs, centres, covariance, of_pairs: FloatArray) -> SharedMotions:
    """Return what the joint estimate makes of motions (E, 6, K) of the pairs."""
    matrix, right = np.linalg.inv(covariance), np.zeros((6 * VIEWS, of_pairs.shape[2]))
    for pair, motions in zip(pairs, of_pairs, strict=True):
        _, by_target, by_source = linearise_edge(kinematic, pair, centres)
        rows = np.r_[6 * pair.target + np.arange(6), 6 * pair.source + np.arange(6)]
        both = np.hstack([by_target, by_source])
        matrix[np.ix_(rows, rows)] += both.T @ pair.information @ both
        right[rows] += both.T @ pair.information @ motions
    return SharedMotions(of_pairs, np.linalg.solve(matrix, right))


def closed(rng: np.random.Generator, view_mm: float, wrong: FloatArray | None = None, *, stated: bool = True) -> Dependence:
    """Draw pairs that err by their noise and by shared errors (which may be stated or not), and test the worst loop."""
    covariance = by_axes(0.1, view_mm)
    kinematic, pairs, centres = drawn(covariance, rng)
    of_pairs = SHARED_SIZE * PAIR_SIGMAS[:, None] * np.random.default_rng(8).normal(size=(len(pairs), 6, SHARED))
    pairs = moved_by(pairs, of_pairs @ rng.normal(size=SHARED))
    if wrong is not None:
        pairs[LOOPED] = replace(pairs[LOOPED], change=pairs[LOOPED].change + wrong)
    shared = shared_motions(kinematic, pairs, centres, covariance, of_pairs) if stated else None
    poses = jointly(kinematic, pairs, centres, covariance)
    found = find_worst_loop(poses, pairs, centres, RADII, covariance, NAMES, shared)
    assert found is not None
    assert found.loops >= 1 and 1 <= found.freedom <= 6
    return compare_with_expected(found.gap_mm, found.sigma_mm, found.freedom, found.loops)


@pytest.mark.parametrize(
    ("view_mm", "draws"), [(0.5, 120), pytest.param(0.5, 600, marks=pytest.mark.slow), pytest.param(0.01, 600, marks=pytest.mark.slow)]
)
def test_sound_loops_are_called_contradictory_as_rarely_as_stated(view_mm: float, draws: int) -> None:
    rng = np.random.default_rng(21)
    found = [closed(rng, view_mm) for _ in range(draws)]
    probabilities = np.array([one.probability for one in found])
    # several loops share pairs, so that the bound for independent ones is not reached
    assert RATE / 6 < np.mean(probabilities < RATE) < RATE + 4 * np.sqrt(RATE * (1 - RATE) / draws)
    assert np.sum(probabilities < CHANCE) <= 4  # 0.6 expected of 600
    assert [one.unexplained_mm > 0 for one in found] == list(probabilities < CHANCE)


def test_what_all_clouds_share_is_a_contradiction_if_the_model_does_not_state_it() -> None:
    rng = np.random.default_rng(22)
    assert np.mean([closed(rng, 0.5, stated=False).unexplained_mm > 0 for _ in range(20)]) > 0.1


@pytest.mark.parametrize("direction", range(3))
def test_a_pair_that_errs_by_fifteen_of_its_standard_deviations_is_found(direction: int) -> None:
    rng, wrong = np.random.default_rng(23), np.zeros(6)
    wrong[direction] = 15 * np.sqrt(1 + SHARED * SHARED_SIZE**2) * PAIR_SIGMAS[direction]
    found = [closed(rng, 0.5, wrong) for _ in range(8)]
    assert all(one.unexplained_mm > 0 for one in found)
