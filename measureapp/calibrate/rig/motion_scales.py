"""The scales of the error motions from the sightings of a calibration, and what the motions amount to."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from measureapp.calibrate.least_squares import Minimum
from measureapp.calibrate.motions.chain import Chain
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.calibrate.motions.error_motions import evidence_of, refine_scales
from measureapp.calibrate.motions.propagation import marginal_cost, whiten_camera_jacobian
from measureapp.calibrate.poses import change_between
from measureapp.data.calibration import LabelledCovariance
from measureapp.errors import CalibrationError


def variance_of(ratio: float, freedom: int) -> float:
    """Return the factor of the covariance: 1, or that of the residuals where they are significantly larger than expected."""
    return ratio**2 if ratio > 1 + 2 / np.sqrt(2 * max(freedom, 1)) else 1.0


def refine_motions(
    chain: Chain, minimum: Minimum[ChainState], camera_prior: LabelledCovariance | None
) -> tuple[Chain, Minimum[ChainState]]:
    """Return chain and minimum with the scales of the error motions as the sightings have them; unchanged without such motions."""
    model = chain.motions
    if model is None or chain.noise.motion_spread <= 0:
        return chain, minimum
    cameras = None
    if camera_prior is not None and chain.camera_jacobian is not None:
        seen = -whiten_camera_jacobian(chain)
        own = np.linalg.inv(camera_prior.covariance) + seen.T @ seen
        cameras = (chain.jacobian(minimum.state).T @ seen, own, seen.T @ chain.residuals(minimum.state))
    try:
        known = minimum.covariance()
    except CalibrationError:
        return chain, minimum  # `solution_of` names what is undetermined
    ratio = float(np.sqrt(marginal_cost(chain, minimum, known, camera_prior) / max(chain.freedom(), 1)))
    precision, pull = evidence_of(
        minimum.hessian,
        chain.motion_rows,
        model.prior_sigma,
        minimum.state.motions,
        variance_of(ratio, chain.freedom()),
        cameras,
    )
    refined = replace(chain, motions=refine_scales(model, precision, pull, chain.noise.motion_spread))
    return refined, refined.adjust(minimum.state)


def explained_mm(chain: Chain, state: ChainState) -> float:
    """Return by how much the error motions move the board in the camera between the sightings, rms about their mean; 0 without any."""
    if chain.motions is None:
        return 0.0
    still = replace(state, motions=np.zeros_like(state.motions))
    shifts = change_between(chain.predict(still), chain.predict(state))[:, 3:]
    return float(np.sqrt(np.mean(np.sum((shifts - shifts.mean(axis=0)) ** 2, axis=1))))
