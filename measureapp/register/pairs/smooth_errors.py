"""Restricted maximum likelihood of spatially correlated errors between two views: their variance and their effect on the pose.

Residuals after registration contain no rigid motion, so that errors correlated over the whole surface hide in the pose itself. They
show in the bending of the residuals, because a smooth error has components of every order. Their variance is estimated jointly with the
noise of patches from contrasts that no motion changes (restricted maximum likelihood; H. D. Patterson, R. Thompson, Biometrika 58(3),
545-554, 1971), as the posterior mean with a half-Cauchy prior on the ratio of the deviations (A. Gelman, Bayesian Analysis 1(3),
515-534, 2006). Few patches therefore give a large value, not zero.

The residuals do not show the rigid part of the error: it follows from the correlation length, which is assumed equal to the size of the
surface (sensitivity: decision 9).
"""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray

CORRELATION_LENGTH = 1.0  # in rms radii of the common surface
PATCHES = 3.0  # per rms radius, far finer than the correlation length
LEAST_WEIGHT = 0.1  # of the median weight of a patch; lighter ones at borders are ignored
RATIOS = np.geomspace(0.01, 100.0, 121)  # standard deviation of the smooth error over that of a patch's noise
NEGLIGIBLE = 1e-12
NEGLECTED_VARIANCE = 1e-2  # share of the variance at any patch that the basis need not explain


def estimate_smooth_errors(
    arm_mm: FloatArray, normal: FloatArray, jacobian: FloatArray, weight: FloatArray, left_mm: FloatArray
) -> tuple[float, FloatArray]:
    """Estimate the standard deviation of the smooth errors (mm), and the covariance (6, 6) of ``jacobian.T @ (weight * error)``.

    Parameters
    ----------
    arm_mm, normal : (K, 3), points relative to their centre, and directions of the distances
    jacobian : (K, 6), of the distances with respect to a small motion
    weight : (K,), all positive
    left_mm : (K,), distances after the fit
    """
    from measureapp.register.grid.kernels import dominant_faces, voxel_keys

    radius = float(np.sqrt(np.mean(np.sum(arm_mm**2, axis=1))))
    if radius < NEGLIGIBLE:
        return 0.0, np.zeros((6, 6))
    keys = voxel_keys(np.ascontiguousarray(arm_mm), dominant_faces(np.ascontiguousarray(normal)), radius / PATCHES)
    patch = np.unique(keys, return_inverse=True)[1]
    weights = np.bincount(patch, weight)
    rows = np.column_stack([jacobian * weight[:, None], left_mm * weight, arm_mm * weight[:, None]])
    sums = np.column_stack([np.bincount(patch, column, len(weights)) for column in rows.T])
    kept = weights > LEAST_WEIGHT * np.median(weights)
    weights, sums = weights[kept], sums[kept]
    gradient, places = sums[:, :6], sums[:, 7:] / weights[:, None]
    _, patterns = pivoted_cholesky(places, CORRELATION_LENGTH * radius, NEGLECTED_VARIANCE)
    root = np.sqrt(weights)
    scale = np.array([1.0] * 3 + [1 / radius] * 3)
    variance = _estimate_smooth_variance(gradient * scale / root[:, None], sums[:, 6] / root, patterns * root[:, None])
    by_patterns = gradient.T @ patterns
    return float(np.sqrt(variance)), variance * by_patterns @ by_patterns.T


def pivoted_cholesky(places_mm: FloatArray, length_mm: float, neglected: float) -> tuple[IntArray, FloatArray]:
    """Pivoted Cholesky decomposition of a Gaussian covariance of variance one over places (P, 3).

    Returns the pivots (M,), and the basis (P, M) whose products sum to the covariance but for a share ``neglected`` of the variance.
    """
    left, patterns = np.ones(len(places_mm)), np.empty((0, len(places_mm)))
    chosen: list[int] = []
    while len(left) and left.max() > neglected:
        most = int(np.argmax(left))
        correlation = np.exp(-np.sum((places_mm - places_mm[most]) ** 2, axis=1) / (2 * length_mm**2))
        patterns = np.vstack([patterns, (correlation - patterns[:, most] @ patterns) / np.sqrt(left[most])])
        left -= patterns[-1] ** 2
        chosen.append(most)
    return np.array(chosen, np.int64), patterns.T


def _estimate_smooth_variance(motions: FloatArray, left: FloatArray, patterns: FloatArray) -> float:
    """Return the variance of the smooth error from patches of equal noise (in these units); zero without degrees of freedom.

    Parameters
    ----------
    motions : (P, 6), effect of rigid motions
    left : (P,), residuals
    patterns : (P, M), basis of a smooth error of variance one
    """
    freedom = len(left) - motions.shape[1]
    if freedom < 2:
        return 0.0
    typical = float(np.mean(np.sum(patterns**2, axis=1)))
    explained = np.linalg.qr(motions)[0]
    left, patterns = (values - explained @ (explained.T @ values) for values in (left, patterns))
    vectors, strength, _ = np.linalg.svd(patterns, full_matrices=False)
    share = strength[:freedom] ** 2 / typical
    squares = (vectors.T @ left)[:freedom] ** 2
    elsewhere = max(float(left @ left) - float(np.sum(squares)), 0.0)  # outside the span of the basis
    spread = 1 + RATIOS[:, None] ** 2 * share
    noise = (np.sum(squares / spread, axis=1) + elsewhere) / freedom
    if noise.max() <= NEGLIGIBLE:
        return 0.0
    likelihood = -0.5 * (freedom * np.log(noise) + np.sum(np.log(spread), axis=1))
    trust = np.exp(likelihood - likelihood.max()) * RATIOS / (1 + RATIOS**2)  # the grid is uniform in the logarithm of the ratio
    return float(np.sum(trust * RATIOS**2 * noise) / np.sum(trust) / typical)
