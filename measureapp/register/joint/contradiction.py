"""Views that the surfaces put elsewhere than the axes allow: each view against all its neighbours, before anything is adjusted.

The joint estimate cannot tell: priors as tight as a calibrated rig's hold a displaced view in place, and its pairs then look
like outliers. So every view is set free alone, where its pairs together say it lies, and that is compared with what the errors
of the axes and of the pairs let expect (an innovation test; Y. Bar-Shalom et al., Estimation with Applications to Tracking and
Navigation, Wiley 2001, section 5.4).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np
from scipy.stats import chi2, norm

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.joint.pose_graph import CAUCHY, CHI_SQUARE_MEDIAN, edge_error
from measureapp.register.pairs.icp import PairMeasurement

ROUNDS = 20


@dataclass(frozen=True, slots=True, eq=False)
class FreeCorrection:
    """Where its pairs alone would put one view."""

    change: FloatArray  # (6,), shift (mm) and turn (rad) about the view's centre in the part's frame
    covariance: FloatArray  # (6, 6), expected of it by the errors of axes and pairs

    @property
    def distance(self) -> float:
        """The correction in standard deviations of what is expected (Mahalanobis distance)."""
        return float(np.sqrt(self.change @ np.linalg.solve(self.covariance, self.change)))


def quantile(sigmas: float, views: int) -> float:
    """Return the distance that none of ``views`` clean views exceeds but as rarely as a single number exceeds ``sigmas``."""
    return float(np.sqrt(chi2.isf(2 * norm.sf(sigmas) / views, 6)))


def free_correction(
    view: int,
    kinematic: Sequence[RigidTransform],
    pairs: Sequence[PairMeasurement],
    centres_mm: FloatArray,
    by_axes: FloatArray,
    loose: FloatArray,
) -> FreeCorrection | None:
    """Return how ``view`` has to move to fit its neighbours where the axes put them; None without pairs.

    A pair counts as much as it and the axes' errors between its two views allow, so that no neighbour alone decides by a pair that is
    known better than where the neighbour stands. Pairs that contradict the majority of the view's pairs lose weight (Cauchy).

    Parameters
    ----------
    kinematic : N poses part_from_camera by the axes
    centres_mm : (N, 3), the middle of each view in the part's frame
    by_axes : (6N, 6N), covariance of the poses by the axes, as motions about the centres in the part's frame
    loose : (6,), standard deviations that hold the view where no pair does
    """
    own = [pair for pair in pairs if view in (pair.target, pair.source)]
    if not own:
        return None
    parts = [_Part.of(view, pair, kinematic, centres_mm, by_axes) for pair in own]
    change, normal, scatter, gain = np.zeros(6), np.eye(6), np.eye(6), np.zeros((6, by_axes.shape[0]))
    for _ in range(ROUNDS):
        normal, scatter, right, gain = np.diag(loose**-2.0), np.diag(loose**-2.0), np.zeros(6), np.zeros((6, by_axes.shape[0]))
        for part in parts:
            left = part.error + part.by_view @ change
            trust = 1 / (1 + left @ part.weight @ left / (CAUCHY**2 * CHI_SQUARE_MEDIAN))
            carried = trust * part.by_view.T @ part.weight
            normal += carried @ part.by_view
            scatter += trust * part.by_view.T @ part.scatter @ part.by_view
            right -= carried @ part.error
            gain[:, 6 * view : 6 * view + 6] += carried @ part.by_view
            gain[:, 6 * part.neighbour : 6 * part.neighbour + 6] += carried @ part.by_neighbour
        step = np.linalg.solve(normal, right) - change
        change = change + step
        if np.abs(step).max() < 1e-9:
            break
    inverse = np.linalg.inv(normal)
    lever = inverse @ gain
    return FreeCorrection(change, lever @ by_axes @ lever.T + inverse @ scatter @ inverse)


@dataclass(frozen=True, slots=True, eq=False)
class _Part:
    """What one pair says about a view."""

    neighbour: int
    error: FloatArray  # (6,)
    by_view: FloatArray  # (6, 6), derivative of the error
    by_neighbour: FloatArray  # (6, 6)
    weight: FloatArray  # (6, 6), inverse covariance of the error by the pair and by what the axes leave open between the two
    scatter: FloatArray  # (6, 6), covariance of the weighted error by the pair alone

    @classmethod
    def of(cls, view: int, pair: PairMeasurement, kinematic: Sequence[RigidTransform], centres_mm: FloatArray, by_axes: FloatArray) -> Self:
        error, by_target, by_source = edge_error(kinematic, pair, centres_mm)
        mine, other, neighbour = (by_target, by_source, pair.source) if pair.target == view else (by_source, by_target, pair.target)
        rows = np.concatenate([6 * view + np.arange(6), 6 * neighbour + np.arange(6)])
        both = np.hstack([mine, other])
        axes = both @ by_axes[np.ix_(rows, rows)] @ both.T
        share = np.linalg.inv(np.eye(6) + pair.information @ axes)  # H (I + Σ H)⁻¹ = (I + H Σ)⁻¹ H, also where H is singular
        return cls(neighbour, error, mine, other, share @ pair.information, share @ pair.information @ share.T)
