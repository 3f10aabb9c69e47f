"""Innovation test: views whose surfaces contradict their kinematic positions, each tested against its neighbours before registration.

The joint estimate cannot detect them: the tight priors of a calibrated rig hold a displaced view in place, and its pairs then appear as
outliers. Instead, each view alone is registered to its neighbours without its prior, and the correction is compared with its expected
covariance from the kinematic errors and the pairs (Y. Bar-Shalom et al., Estimation with Applications to Tracking and Navigation, Wiley
2001, section 5.4).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np
from scipy.special import chdtri, ndtr

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import CAUCHY, CHI_SQUARE_MEDIAN, linearise_edge
from measureapp.register.pairs.icp import PairMeasurement

ROUNDS = 20


@dataclass(frozen=True, slots=True, eq=False)
class FreeCorrection:
    """Correction of one view by its pairs alone, without its prior."""

    change: FloatArray  # (6,), translation (mm) and rotation (rad) about the view's centre in the part's frame
    covariance: FloatArray  # (6, 6), expected from the kinematic errors and the pairs

    @property
    def distance(self) -> float:
        """The Mahalanobis distance of the correction."""
        return float(np.sqrt(self.change @ np.linalg.solve(self.covariance, self.change)))


def innovation_limit(sigmas: float, views: int) -> float:
    """Return the limit of the Mahalanobis distance for ``views`` tests together, at the significance of ``sigmas`` (Bonferroni)."""
    return float(np.sqrt(chdtri(6, 2 * ndtr(-sigmas) / views)))


def estimate_free_correction(
    view: int,
    kinematic: Sequence[RigidTransform],
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
    kinematic_covariance: FloatArray,
    loose: FloatArray,
) -> FreeCorrection | None:
    """Estimate the correction of ``view`` that fits its neighbours at their kinematic positions; None without pairs.

    The weight of a pair includes the kinematic errors between its two views, so that no neighbour decides alone by a pair that is known
    better than its own position. Pairs that contradict the majority lose weight (Cauchy).

    Parameters
    ----------
    kinematic : N kinematic poses part_from_camera
    centres_mm : (N, 3), centre of each view in the part's frame
    kinematic_covariance : (6N, 6N), of the kinematic poses, as motions about the centres in the part's frame
    loose : (6,), standard deviations of the weak prior for directions without pairs
    """
    own = [pair for pair in pairs if view in (pair.target, pair.source)]
    if not own:
        return None
    parts = [_PairTerm.of(view, pair, kinematic, centres_mm, kinematic_covariance) for pair in own]
    change, normal, scatter, gain = np.zeros(6), np.eye(6), np.eye(6), np.zeros((6, kinematic_covariance.shape[0]))
    for _ in range(ROUNDS):
        normal, scatter, right, gain = np.diag(loose**-2.0), np.diag(loose**-2.0), np.zeros(6), np.zeros((6, kinematic_covariance.shape[0]))
        for part in parts:
            left = part.error + part.by_view @ change
            robust = 1 / (1 + left @ part.weight @ left / (CAUCHY**2 * CHI_SQUARE_MEDIAN))
            weighted = robust * part.by_view.T @ part.weight
            normal += weighted @ part.by_view
            scatter += robust * part.by_view.T @ part.scatter @ part.by_view
            right -= weighted @ part.error
            gain[:, 6 * view : 6 * view + 6] += weighted @ part.by_view
            gain[:, 6 * part.neighbour : 6 * part.neighbour + 6] += weighted @ part.by_neighbour
        step = np.linalg.solve(normal, right) - change
        change = change + step
        if np.abs(step).max() < 1e-9:
            break
    inverse = np.linalg.inv(normal)
    lever = inverse @ gain
    return FreeCorrection(change, lever @ kinematic_covariance @ lever.T + inverse @ scatter @ inverse)


@dataclass(frozen=True, slots=True, eq=False)
class _PairTerm:
    """Linearised error of one pair."""

    neighbour: int
    error: FloatArray  # (6,)
    by_view: FloatArray  # (6, 6), derivative of the error
    by_neighbour: FloatArray  # (6, 6)
    weight: FloatArray  # (6, 6), inverse covariance of the error from the pair and the kinematic errors between its views
    scatter: FloatArray  # (6, 6), covariance of the weighted error from the pair alone

    @classmethod
    def of(
        cls, view: int, pair: PairMeasurement, kinematic: Sequence[RigidTransform], centres_mm: FloatArray, kinematic_covariance: FloatArray
    ) -> Self:
        error, by_target, by_source = linearise_edge(kinematic, pair, centres_mm)
        mine, other, neighbour = (by_target, by_source, pair.source) if pair.target == view else (by_source, by_target, pair.target)
        rows = np.concatenate([6 * view + np.arange(6), 6 * neighbour + np.arange(6)])
        both = np.hstack([mine, other])
        axes = both @ kinematic_covariance[np.ix_(rows, rows)] @ both.T
        share = np.linalg.inv(np.eye(6) + pair.information @ axes)  # H (I + Σ H)⁻¹ = (I + H Σ)⁻¹ H, also where H is singular
        return cls(neighbour, error, mine, other, share @ pair.information, share @ pair.information @ share.T)
