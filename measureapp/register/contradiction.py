"""Views that the surfaces put elsewhere than the axes allow: each view against all its neighbours, before anything is adjusted.

The joint estimate cannot tell: priors as tight as a calibrated rig's hold a displaced view in place, and its pairs then look
like outliers. So every view is set free alone, where its pairs together say it lies, and that is compared with what the errors
of the axes and of the pairs let expect (an innovation test; Y. Bar-Shalom et al., Estimation with Applications to Tracking and
Navigation, Wiley 2001, section 5.4).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.stats import chi2, norm

from measureapp.arrays import FloatArray
from measureapp.geometry.transform import RigidTransform
from measureapp.register.icp import PairMeasurement
from measureapp.register.pose_graph import CAUCHY, CHI_SQUARE_MEDIAN, edge_error

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

    Pairs that contradict the majority of the view's pairs lose weight (Cauchy).

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
    parts = [edge_error(kinematic, pair, centres_mm) for pair in own]
    change, normal, gain = np.zeros(6), np.eye(6), np.zeros((6, by_axes.shape[0]))
    for _ in range(ROUNDS):
        normal, right, gain = np.diag(loose**-2.0), np.zeros(6), np.zeros((6, by_axes.shape[0]))
        for pair, (error, by_target, by_source) in zip(own, parts, strict=True):
            mine, other, neighbour = (by_target, by_source, pair.source) if pair.target == view else (by_source, by_target, pair.target)
            left = error + mine @ change
            weighted = pair.information / (1 + left @ pair.information @ left / (CAUCHY**2 * CHI_SQUARE_MEDIAN))
            normal += mine.T @ weighted @ mine
            right -= mine.T @ weighted @ error
            gain[:, 6 * view : 6 * view + 6] += mine.T @ weighted @ mine
            gain[:, 6 * neighbour : 6 * neighbour + 6] += mine.T @ weighted @ other
        step = np.linalg.solve(normal, right) - change
        change = change + step
        if np.abs(step).max() < 1e-9:
            break
    inverse = np.linalg.inv(normal)
    lever = inverse @ gain
    return FreeCorrection(change, lever @ by_axes @ lever.T + inverse)
