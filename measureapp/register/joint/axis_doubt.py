"""Doubt about the axes: many views that contradict their kinematic positions in one pattern tell of the axes, not of the views.

A table whose error motions changed after the calibration displaces every view as its angle says. Tested one by one, sound views then exceed the
limits of their positions and would be left out. Here the pairs of views are asked first whether displacements of one pattern, of a size that is
estimated, explain them better than the errors that the calibration states.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from measureapp.arrays import FloatArray, IntArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import CAUCHY, CHI_SQUARE_MEDIAN, linearise_edge
from measureapp.register.pairs.icp import PairMeasurement

LEAST_MANY, MANY_SHARE = 3, 0.25  # of the views contradict: not single ones
LEAST_GAIN = 6.0  # of the logarithm of the likelihood, by one size more: what is said in words is false in one of two thousand scans
UNCHANGED = 0.8  # probability a priori that the axes are as calibrated
LARGEST_MM = 0.2  # rms of the displacements; more is no axis but a part or a head that was moved
FACTORS = np.geomspace(0.05, 200.0, 160)  # of the pattern's standard deviation
WORDS = (
    "The views contradict the calibrated axes in one pattern: what is left between them {follows} ({size_mm:.3f} mm rms beyond the stated errors). "
    "The views are kept and the uncertainties contain it; {what} is doubted. {remedy}"
)


@dataclass(frozen=True, slots=True, eq=False)
class AxisPattern:
    """Displacements of N views that one cause has in common, of unknown size."""

    follows: str  # what they follow, after "what is left between the views …"
    what: str  # the doubted part
    remedy: str
    motions: FloatArray  # (6N, K), motions of each camera in its frame (mm, rad) by independent unit causes

    def select(self, rows: IntArray) -> AxisPattern:
        """Return the pattern of the views to which ``rows`` belong."""
        return replace(self, motions=np.asarray(self.motions)[rows])


@dataclass(frozen=True, slots=True, eq=False)
class AxisDoubt:
    """A pattern that explains the pairs, and its size."""

    pattern: AxisPattern
    factor: float  # rms over the posterior of the size, in which also stands that the axes are as calibrated
    gain: float  # of the logarithm of the likelihood
    size_mm: float  # rms displacement of the views' centres relative to each other, most likely
    evidence: float  # logarithm of the likelihood averaged over sizes

    @property
    def is_certain(self) -> bool:
        """Whether it is worth a sentence."""
        return self.gain >= LEAST_GAIN

    @property
    def covariance(self) -> FloatArray:
        """Covariance (6N, 6N) of the kinematic poses, to be added to the stated one, as motions of each camera in its frame."""
        return np.asarray(self.factor**2 * self.pattern.motions @ self.pattern.motions.T)

    @property
    def sentence(self) -> str:
        """The doubt in words."""
        pattern = self.pattern
        return WORDS.format(follows=pattern.follows, what=pattern.what, remedy=pattern.remedy, size_mm=self.size_mm)


def are_many(contradicting: int, views: int) -> bool:
    """Whether so many views contradict their positions that their axes may be to blame."""
    return contradicting >= max(LEAST_MANY, MANY_SHARE * views)


def doubt_axes(
    patterns: Sequence[AxisPattern],
    kinematic: Sequence[RigidTransform],
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
    kinematic_covariance: FloatArray,
    carry: FloatArray,
) -> AxisDoubt | None:
    """Return the pattern that explains the pairs best; None without one of a size that an axis may have.

    The marginal likelihood of the pairs' errors is evaluated for covariance Σ + f² B Bᵀ of the kinematic poses over the factor f. By how much the
    covariance is widened follows from the posterior of f: where the stated errors suffice, by nothing that matters [1]_. What is said in words
    takes a likelihood ratio that is significant.

    Parameters
    ----------
    kinematic : N kinematic poses part_from_camera
    centres_mm : (N, 3), centre of each view in the part's frame
    kinematic_covariance : (6N, 6N), stated, as motions about the centres in the part's frame
    carry : (6N, 6N), from motions of each camera in its frame to those about the centres

    References
    ----------
    .. [1] D. J. C. MacKay, Information Theory, Inference, and Learning Algorithms, 2003, chapter 28.
    """
    if not pairs or not patterns:
        return None
    information, pull = _surface_information(kinematic, pairs, centres_mm, kinematic_covariance)
    share = np.linalg.inv(np.eye(len(information)) + information @ kinematic_covariance)
    left, right = share @ information, share @ pull  # (Σ + A⁻¹)⁻¹ and its product with what the pairs say
    tried = [_weigh(pattern, carry @ pattern.motions, left, right) for pattern in patterns if pattern.motions.any()]
    best = max(tried, key=lambda one: one.evidence, default=None)
    return best if best is not None and best.size_mm <= LARGEST_MM else None


def _weigh(pattern: AxisPattern, motions: FloatArray, left: FloatArray, right: FloatArray) -> AxisDoubt:
    values, vectors = np.linalg.eigh(motions.T @ left @ motions)
    values, along = np.maximum(values, 0.0), (vectors.T @ (motions.T @ right)) ** 2
    square = FACTORS[:, None] ** 2
    gains = 0.5 * np.sum(square * along / (1 + square * values) - np.log1p(square * values), axis=1)
    best = int(np.argmax(gains))
    shifts = motions.reshape(-1, 6, motions.shape[1])[:, :3]
    apart = shifts - shifts.mean(axis=0)
    size = float(FACTORS[best] * np.sqrt(np.mean(np.sum(apart**2, axis=(1, 2)))))
    top = max(float(gains[best]), 0.0)
    likely = np.exp(gains - top) / len(FACTORS)
    whole = (1 - UNCHANGED) * likely.sum() + UNCHANGED * np.exp(-top)
    factor = float(np.sqrt((1 - UNCHANGED) * np.sum(likely * FACTORS**2) / whole))
    return AxisDoubt(pattern, factor, float(gains[best]), size, top + float(np.log(likely.sum())))


def _surface_information(
    kinematic: Sequence[RigidTransform], pairs: Sequence[PairMeasurement], centres_mm: FloatArray, kinematic_covariance: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return what the pairs tell of the errors x of the poses: A (6N, 6N) and b (6N,) of exp(-½ xᵀ A x + bᵀ x).

    Pairs that contradict all others lose weight (Cauchy), relative to what is usual: a pattern in all of them does not.
    """
    size = 6 * len(kinematic)
    parts, squares = [], []
    for pair in pairs:
        error, by_target, by_source = linearise_edge(kinematic, pair, centres_mm)
        rows = np.concatenate([6 * pair.target + np.arange(6), 6 * pair.source + np.arange(6)])
        both = np.hstack([by_target, by_source])
        axes = both @ kinematic_covariance[np.ix_(rows, rows)] @ both.T
        parts.append((error, both, rows))
        squares.append(float(error @ np.linalg.solve(np.eye(6) + pair.information @ axes, pair.information @ error)))
    usual = max(1.0, float(np.median(squares)) / CHI_SQUARE_MEDIAN)
    information, pull = np.zeros((size, size)), np.zeros(size)
    for pair, (error, both, rows), square in zip(pairs, parts, squares, strict=True):
        weighted = both.T @ pair.information / (1 + square / usual / (CAUCHY**2 * CHI_SQUARE_MEDIAN))
        information[np.ix_(rows, rows)] += weighted @ both
        pull[rows] -= weighted @ error
    return information, pull
