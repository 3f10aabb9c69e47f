"""The innovation of a view: as large as expected where axes and pairs err as they say, far larger where a view was displaced."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.stats import kstest

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform, rotation_about
from measureapp.register.joint.innovation_test import estimate_free_correction, innovation_limit
from measureapp.register.pairs.icp import PairMeasurement, apply_motion

VIEWS, SIGMAS = 6, 3.0
PAIRS = [(i, (i + step) % VIEWS) for i in range(VIEWS) for step in (1, 2)]
LOOSE = SIGMAS * np.array([0.5] * 3 + [np.radians(0.05)] * 3)
PAIR_SIGMAS = np.array([0.004] * 3 + [0.004 / 50] * 3)


def closed_loop() -> tuple[list[RigidTransform], FloatArray]:
    """Poses part_from_camera around a part, and what each sees the middle of."""
    camera = RigidTransform.from_parts(np.column_stack([[0, 1, 0], [0, 0, -1], [-1, 0, 0]]), [500.0, 0, 20], "part", "camera")
    angles = 2 * np.pi * np.arange(VIEWS) / VIEWS
    turns = [RigidTransform.from_parts(rotation_about([0, 0, 1], angle), np.zeros(3), "part", "part") for angle in angles]
    return [turn @ camera for turn in turns], np.stack([turn.apply(np.array([40.0, 0, 20])) for turn in turns])


def by_axes(station_mm: float, view_mm: float) -> FloatArray:
    """Errors that all views share, and errors of their own, as motions about the centres."""
    common = np.diag([station_mm**2] * 3 + [(station_mm / 400) ** 2] * 3)
    own = np.diag([view_mm**2] * 3 + [(view_mm / 400) ** 2] * 3)
    return np.kron(np.ones((VIEWS, VIEWS)), common) + np.kron(np.eye(VIEWS), own)


def drawn(covariance: FloatArray, rng: np.random.Generator) -> tuple[list[RigidTransform], list[PairMeasurement], FloatArray]:
    """Return poses by the axes and pairs, both in error as stated, and the views' centres."""
    truth, centres = closed_loop()
    errors = rng.multivariate_normal(np.zeros(6 * VIEWS), covariance).reshape(-1, 6)
    kinematic = [apply_motion(pose, error, centre) for pose, error, centre in zip(truth, errors, centres, strict=True)]
    nothing = np.empty(0, np.int64)
    pairs = []
    for i, j in PAIRS:
        middle = truth[i].inverse().apply((centres[i] + centres[j]) / 2)
        between = apply_motion(truth[i].inverse() @ truth[j], rng.normal(0, PAIR_SIGMAS), middle)
        pairs.append(PairMeasurement(i, j, between, middle, np.zeros(6), np.diag(PAIR_SIGMAS**-2.0), 0.01, nothing, nothing, 0.004))
    return kinematic, pairs, centres


@pytest.mark.parametrize("draws", [100, pytest.param(300, marks=pytest.mark.slow)])
@pytest.mark.parametrize(("station_mm", "view_mm"), [(0.02, 0.02), (0.1, 0.005), (0.3, 0.1)])
def test_innovations_of_clean_views_are_distributed_as_chi_square(station_mm: float, view_mm: float, draws: int) -> None:
    rng, covariance = np.random.default_rng(1), by_axes(station_mm, view_mm)
    squares = []
    for draw in range(draws):
        kinematic, pairs, centres = drawn(covariance, rng)
        free = estimate_free_correction(draw % VIEWS, kinematic, pairs, centres, covariance, LOOSE)
        assert free is not None
        squares.append(free.distance**2)
    assert abs(np.mean(squares) - 6) < 4 * np.sqrt(12 / draws)
    assert kstest(squares, "chi2", (6,)).pvalue > 1e-3


@pytest.mark.parametrize("displaced", range(VIEWS))
def test_a_view_displaced_by_two_millimetres_exceeds_what_clean_views_reach_in_every_direction(displaced: int) -> None:
    rng, covariance = np.random.default_rng(2), by_axes(0.1, 0.05)
    for _ in range(10):
        kinematic, pairs, centres = drawn(covariance, rng)
        shift = rng.normal(size=3)
        slip = np.concatenate([2 * shift / np.linalg.norm(shift), np.zeros(3)])
        kinematic[displaced] = apply_motion(kinematic[displaced], slip, centres[displaced])
        distances = [
            one.distance for i in range(VIEWS) if (one := estimate_free_correction(i, kinematic, pairs, centres, covariance, LOOSE))
        ]
        assert int(np.argmax(distances)) == displaced
        assert distances[displaced] > innovation_limit(SIGMAS, VIEWS)


def test_a_view_without_pairs_says_nothing() -> None:
    kinematic, pairs, centres = drawn(by_axes(0.1, 0.05), np.random.default_rng(3))
    own = [pair for pair in pairs if 2 not in (pair.target, pair.source)]
    assert estimate_free_correction(2, kinematic, own, centres, by_axes(0.1, 0.05), LOOSE) is None
