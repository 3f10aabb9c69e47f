"""Errors that are alike over a whole surface: how large they are is told by what they leave after a fit."""

from __future__ import annotations

import numpy as np
import pytest

from measureapp.register.pairs.smooth_errors import estimate_smooth_errors

NOISE_MM, SMOOTH_MM = 0.006, 0.005
DRAWS, POINTS = 30, 500
RADIUS_MM = 50.0


def corner() -> tuple[np.ndarray, np.ndarray]:
    """Points on three faces that meet, about their centre, and their normals; of rms radius ``RADIUS_MM``."""
    rng = np.random.default_rng(0)
    axis = rng.integers(0, 3, POINTS)
    points = rng.uniform(0, 1, (POINTS, 3))
    points[np.arange(POINTS), axis] = 0
    points -= points.mean(axis=0)
    return points * (RADIUS_MM / np.sqrt(np.mean(np.sum(points**2, axis=1)))), np.eye(3)[axis]


def field(points: np.ndarray, length_mm: float) -> np.ndarray:
    """Return a root of the covariance of an error of variance one that changes over ``length_mm``."""
    apart = np.sum((points[:, None] - points[None]) ** 2, axis=2)
    values, vectors = np.linalg.eigh(np.exp(-apart / (2 * length_mm**2)))
    chosen = values > 1e-9
    return np.asarray(vectors[:, chosen] * np.sqrt(values[chosen]))


def fitted(length_mm: float | None, scale: float = 1.0) -> np.ndarray:
    """Return the fits' errors squared over what is predicted, (DRAWS,)."""
    points, normal = corner()
    points = points * scale
    rng = np.random.default_rng(1)
    jacobian = np.column_stack([normal, np.cross(points, normal)])
    weight = np.full(POINTS, 1 / (scale * NOISE_MM) ** 2)
    inverse = np.linalg.inv((jacobian * weight[:, None]).T @ jacobian)
    root = None if length_mm is None else field(points, length_mm * scale)
    squares = []
    for _ in range(DRAWS):
        error = rng.normal(0, NOISE_MM * scale, POINTS)
        if root is not None:
            error += SMOOTH_MM * scale * root @ rng.normal(size=root.shape[1])
        change = -inverse @ (jacobian.T @ (weight * error))
        _, scatter = estimate_smooth_errors(points, normal, jacobian, weight, error + jacobian @ change)
        squares.append(change @ np.linalg.solve(inverse + inverse @ scatter @ inverse, change) / 6)
    return np.array(squares)


@pytest.mark.parametrize("length", [0.5, 1.0, 2.0])
def test_fits_are_off_as_far_as_they_say_whatever_the_length_of_the_errors(length: float) -> None:
    squares = fitted(length * RADIUS_MM)
    # the length is not known: within a factor of two of the standard deviation, and three deviations of the mean of 30 draws
    spread = 1 + 3 * np.sqrt(2 / (6 * DRAWS))
    assert 0.5 / spread < np.sqrt(squares.mean()) < 2 * spread


def test_without_smooth_errors_little_more_is_claimed_than_noise_leaves() -> None:
    # what noise cannot exclude is a smooth error as large as the noise of a patch (half-Cauchy): twice its variance in a motion that
    # holds few patterns, some times as much in one that sums them all up
    assert 0.4 < np.sqrt(fitted(None).mean()) < 1


def test_the_unit_of_length_does_not_matter() -> None:
    np.testing.assert_allclose(fitted(RADIUS_MM, 1 / 25.4), fitted(RADIUS_MM), rtol=1e-6)


def test_a_surface_of_one_place_claims_nothing() -> None:
    normal = np.tile([0.0, 0.0, 1.0], (40, 1))
    deviation, scatter = estimate_smooth_errors(np.zeros((40, 3)), normal, np.hstack([normal, np.zeros((40, 3))]), np.ones(40), np.ones(40))
    assert deviation == 0 and not scatter.any()
