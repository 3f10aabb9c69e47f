"""Whether deviations between views depend on a property of their points, beyond what the error model expects."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.special import chdtrc

from measureapp.arrays import FloatArray, IntArray

LEAST_POINTS = 40  # of a class
WEAK = 0.05  # share of the strongest contrast's information below which a contrast of classes is not determined
ALMOST_ONE = 1 - 1e-15
CHANCE = 1e-3  # probability below which chance does not explain a deviation


@dataclass(frozen=True, slots=True)
class Dependence:
    """Mean deviations of the classes of a property, all as standard deviations of a point in mm."""

    observed_mm: float
    expected_mm: float
    unexplained_mm: float
    probability: float


def estimate_dependence(distance_mm: FloatArray, expected_mm: FloatArray, own: IntArray, other: IntArray) -> Dependence | None:
    """Estimate the error of each class from deviations that are the error of their own class less that of the other's.

    The errors are the least-squares solution without the contrasts that the deviations hardly determine. Their weighted mean square is a
    quadratic form of normal errors under the model, whose distribution is approximated by a scaled chi-square with equal mean and
    variance (F. E. Satterthwaite, Biometrics Bulletin 2(6), 110-114, 1946). Where chance does not explain it, the mean square less its
    expectation remains unexplained.

    Parameters
    ----------
    distance_mm : (N,)
    expected_mm : (N, K), deviations by independent errors of the model, one standard deviation each
    own, other : (N,) class of each of the two points; negative: none

    Returns
    -------
    None with fewer than two classes of enough points, or where both points always share a class.
    """
    known = (own >= 0) & (other >= 0)
    size = int(max(own.max(initial=-1), other.max(initial=-1))) + 1
    counts = np.bincount(own[known], minlength=size) + np.bincount(other[known], minlength=size)
    usable = counts >= LEAST_POINTS
    rows = np.flatnonzero(known & usable[own] & usable[other])
    classes, number = np.unique(np.concatenate([own[rows], other[rows]]), return_inverse=True)
    if len(classes) < 2:
        return None
    design = np.zeros((len(rows), len(classes)))
    place = np.arange(len(rows))
    np.add.at(design, (place, number[: len(rows)]), 1.0)
    np.add.at(design, (place, number[len(rows) :]), -1.0)
    values, vectors = np.linalg.eigh(design.T @ design)
    strong = values > WEAK * max(float(values[-1]), 1.0)
    if not strong.any():
        return None
    inverse = (vectors[:, strong] / values[strong]) @ vectors[:, strong].T
    found = inverse @ (design.T @ distance_mm[rows])
    left = distance_mm[rows] - design @ found
    noise = float(left @ left) / max(len(rows) - int(strong.sum()), 1)
    model = inverse @ (design.T @ expected_mm[rows])
    weight = np.bincount(number, minlength=len(classes)) / len(number)
    root = np.sqrt(weight)[:, None]
    spread = (root * (model @ model.T + noise * inverse)) * root.T
    return _compare(float(weight @ found**2), float(np.trace(spread)), float(np.sum(spread**2)))


def _compare(observed: float, expected: float, squares: float, trials: int = 1) -> Dependence:
    """Compare a mean square with its expectation under the model, the trace of its covariance (whose squares sum to ``squares``).

    It is the least probable of ``trials``: the probability that none of them is less probable bounds that of a false alarm (Z. Šidák,
    Journal of the American Statistical Association 62, 626-633, 1967).
    """
    if expected <= 0 or squares <= 0:
        return Dependence(observed**0.5, 0.0, observed**0.5, 0.0 if observed > 0 else 1.0)
    freedom = expected**2 / squares
    probability = float(-np.expm1(trials * np.log1p(-min(chdtrc(freedom, observed * freedom / expected), ALMOST_ONE))))
    unexplained = max(observed - expected, 0.0) ** 0.5 if probability < CHANCE else 0.0
    return Dependence(observed**0.5, expected**0.5, unexplained, probability)


def compare_with_expected(observed_mm: float, expected_mm: float, freedom: float, trials: int = 1) -> Dependence:
    """Compare the least probable of ``trials`` rms deviations, of ``freedom`` degrees of freedom, with the rms the model expects."""
    return _compare(observed_mm**2, expected_mm**2, expected_mm**4 / freedom, trials)
