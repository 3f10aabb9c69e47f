"""Errors that change slowly over the common surface of two views: how large they are, and how far they move the views.

What is left of the distances after a fit holds no shift and no turn, so that errors which are alike over the whole surface hide in
the result itself. They show in how the rest bends: a smooth error has a share of every order. Its variance is estimated beside that of
the noise of patches from the contrasts that no motion changes (restricted maximum likelihood; H. D. Patterson, R. Thompson, Biometrika
58(3), 545-554, 1971), as the mean over the values that the data allow, with the prior that A. Gelman recommends where little is known
of the ratio of two deviations (half-Cauchy; Bayesian Analysis 1(3), 515-534, 2006). So few patches give a large value, and none gives zero.

What the rest cannot tell is how much of the error is a shift and a turn: that follows from the distance over which it changes, taken to be
as long as the surface. Decision 9 says how much hangs on it.
"""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray, IntArray

LENGTH = 1.0  # of the common surface's rms radius: the distance over which the errors change
PATCHES = 3.0  # per rms radius: far finer than what is looked for
LEAST_SHARE = 0.1  # of the usual weight of a patch; lighter ones, at borders, say too little
RATIOS = np.geomspace(0.01, 100.0, 121)  # deviation of the smooth error over that of a patch's noise
NEGLIGIBLE = 1e-12
LEFT_OUT = 1e-2  # of a smooth error's variance at any patch: what its patterns need not explain


def smooth_errors(
    arm_mm: FloatArray, normal: FloatArray, jacobian: FloatArray, weight: FloatArray, left_mm: FloatArray
) -> tuple[float, FloatArray]:
    """Return the standard deviation of the smooth errors (mm) and their covariance (6, 6) of ``jacobian.T @ (weight * error)``.

    Parameters
    ----------
    arm_mm, normal : (K, 3), points about their centre and directions of the distances
    jacobian : (K, 6), of the distances by a small motion
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
    kept = weights > LEAST_SHARE * np.median(weights)
    weights, sums = weights[kept], sums[kept]
    gradient, places = sums[:, :6], sums[:, 7:] / weights[:, None]
    _, patterns = pivoted(places, LENGTH * radius, LEFT_OUT)
    root = np.sqrt(weights)
    scale = np.array([1.0] * 3 + [1 / radius] * 3)
    variance = _smooth_variance(gradient * scale / root[:, None], sums[:, 6] / root, patterns * root[:, None])
    by_patterns = gradient.T @ patterns
    return float(np.sqrt(variance)), variance * by_patterns @ by_patterns.T


def pivoted(places_mm: FloatArray, length_mm: float, left_out: float) -> tuple[IntArray, FloatArray]:
    """Return the places (M,) from whose values a smooth error of variance one is known at all places (P, 3) but for a share ``left_out`` of its
    variance, and patterns (P, M) whose products sum to its covariance (pivoted Cholesky decomposition).
    """
    left, patterns = np.ones(len(places_mm)), np.empty((0, len(places_mm)))
    chosen: list[int] = []
    while len(left) and left.max() > left_out:
        most = int(np.argmax(left))
        alike = np.exp(-np.sum((places_mm - places_mm[most]) ** 2, axis=1) / (2 * length_mm**2))
        patterns = np.vstack([patterns, (alike - patterns[:, most] @ patterns) / np.sqrt(left[most])])
        left -= patterns[-1] ** 2
        chosen.append(most)
    return np.array(chosen, np.int64), patterns.T


def _smooth_variance(motions: FloatArray, left: FloatArray, patterns: FloatArray) -> float:
    """Return the variance of the smooth error by patches whose noise is equal in these units; zero where motions explain everything.

    Parameters
    ----------
    motions : (P, 6), what the motions would change
    left : (P,), what is left
    patterns : (P, M), of a smooth error of variance one
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
    elsewhere = max(float(left @ left) - float(np.sum(squares)), 0.0)  # where no pattern reaches
    spread = 1 + RATIOS[:, None] ** 2 * share
    noise = (np.sum(squares / spread, axis=1) + elsewhere) / freedom
    if noise.max() <= NEGLIGIBLE:
        return 0.0
    likelihood = -0.5 * (freedom * np.log(noise) + np.sum(np.log(spread), axis=1))
    trust = np.exp(likelihood - likelihood.max()) * RATIOS / (1 + RATIOS**2)  # the grid is even in the ratio's logarithm
    return float(np.sum(trust * RATIOS**2 * noise) / np.sum(trust) / typical)
