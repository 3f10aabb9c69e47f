"""How the uncertainty of the cameras enters solutions made from board poses, without the corners of the board."""

from __future__ import annotations

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.least_squares import Minimum
from measureapp.calibrate.motions.chain import Chain
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.data.calibration import LabelledCovariance

POSE = 6


def _by_cameras(chain: Chain) -> FloatArray:
    """Return what the parameters of the cameras take from the whitened residuals, (6 N + K, C)."""
    seen = (chain.roots @ np.asarray(chain.by_cameras)).reshape(POSE * len(chain.guide_mm), -1)
    return np.vstack([seen, np.zeros((chain.table_angles, seen.shape[1]))])


def cost_beyond_cameras(
    chain: Chain, minimum: Minimum[ChainState], covariance: FloatArray, camera_prior: LabelledCovariance | None
) -> float:
    """Return the sum of squares without what errors of the cameras within their covariance explain: as if they had been freed."""
    if camera_prior is None or chain.cameras_freed or chain.by_cameras is None:
        return minimum.cost
    jacobian, seen = chain.jacobian(minimum.state), _by_cameras(chain)
    mixed = jacobian.T @ seen
    normal = np.linalg.inv(camera_prior.covariance) + seen.T @ seen - mixed.T @ covariance @ mixed
    pull = seen.T @ chain.residuals(minimum.state)
    return max(minimum.cost - float(pull @ np.linalg.solve(normal, pull)), 0.0)


def following_cameras(chain: Chain, minimum: Minimum[ChainState], covariance: FloatArray, variance: float) -> FloatArray | None:
    """Return how the solution follows the parameters of cameras that are not freed, (P, C); None where the sightings do not say.

    Parameters
    ----------
    covariance : (P, P), of the solution for cameras without error, ``variance`` times the inverse of the normal matrix
    """
    if chain.cameras_freed or chain.by_cameras is None:
        return None
    return np.asarray(covariance / variance @ (chain.jacobian(minimum.state).T @ _by_cameras(chain)))


def with_cameras(covariance: FloatArray, gain: FloatArray | None, camera_prior: LabelledCovariance | None) -> FloatArray:
    """Add K Σ Kᵀ for cameras that are not freed, K being the change of the solution with their parameters (`following_cameras`)."""
    if camera_prior is None or gain is None:
        return covariance
    return np.asarray(covariance + gain @ camera_prior.covariance @ gain.T)
