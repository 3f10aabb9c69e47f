"""The scatter of stops and the scales of the error motions from the sightings of a calibration, and what the motions amount to."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import minimize_scalar

from measureapp.arrays import FloatArray
from measureapp.calibrate.least_squares import Minimum
from measureapp.calibrate.motions.chain import Chain
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.calibrate.motions.error_motions import evidence_of, refine_scales
from measureapp.calibrate.motions.propagation import marginal_cost, whiten_camera_jacobian
from measureapp.calibrate.poses import change_between
from measureapp.data.calibration import LabelledCovariance
from measureapp.errors import CalibrationError

STOPS_MM = (3e-4, 0.1)  # scatters that are tried
NEAR = 0.2  # in the logarithm: the evidence is flat there


def variance_of(ratio: float, freedom: int) -> float:
    """Return the factor of the covariance: 1, or that of the residuals where they are significantly larger than expected."""
    return ratio**2 if ratio > 1 + 2 / np.sqrt(2 * max(freedom, 1)) else 1.0


def refine_motions(
    chain: Chain, minimum: Minimum[ChainState], camera_prior: LabelledCovariance | None
) -> tuple[Chain, Minimum[ChainState]]:
    """Return chain and minimum with the scatter of stops, and the scales of the error motions, as the sightings have them.

    Both are those of the largest evidence: a scatter from view to view that is not allowed for is explained by error motions which swing
    between the views, many times as large as the true ones. Unchanged without error motions to estimate.
    """
    if chain.motions is None or chain.noise.motion_spread <= 0:
        return chain, minimum
    without = _refined(chain, minimum, camera_prior)
    if without is None:
        return chain, minimum  # `solution_of` names what is undetermined
    tried = [without]

    def lack(log_mm: float) -> float:
        scattered = chain.with_stops(float(np.exp(log_mm)))
        one = _refined(scattered, scattered.adjust(tried[-1].state), camera_prior)
        tried.extend([] if one is None else [one])
        return np.inf if one is None else -one.evidence

    if np.bincount(chain.robot_group).max() > 1:
        minimize_scalar(lack, bounds=np.log(STOPS_MM), method="bounded", options={"xatol": NEAR})
    best = max(tried, key=lambda one: one.evidence)
    return best.chain, best.chain.adjust(best.state)


@dataclass(frozen=True, slots=True, eq=False)
class _Refined:
    """A chain with refined scales, before it is adjusted."""

    chain: Chain
    state: ChainState
    evidence: float  # logarithm, but for a constant


def _refined(chain: Chain, minimum: Minimum[ChainState], camera_prior: LabelledCovariance | None) -> _Refined | None:
    """Return the chain with the scales of its error motions as the sightings have them; None where something is undetermined."""
    model = chain.motions
    assert model is not None
    cameras = None
    if camera_prior is not None and chain.camera_jacobian is not None:
        seen = -whiten_camera_jacobian(chain)
        own = np.linalg.inv(camera_prior.covariance) + seen.T @ seen
        cameras = (chain.jacobian(minimum.state).T @ seen, own, seen.T @ chain.residuals(minimum.state))
    try:
        known = minimum.covariance()
    except CalibrationError:
        return None
    ratio = float(np.sqrt(marginal_cost(chain, minimum, known, camera_prior) / max(chain.freedom(), 1)))
    precision, pull = evidence_of(
        minimum.hessian,
        chain.motion_rows,
        model.prior_sigma,
        minimum.state.motions,
        variance_of(ratio, chain.freedom()),
        cameras,
    )
    refined, gain = refine_scales(model, precision, pull, chain.noise.motion_spread)
    return _Refined(replace(chain, motions=refined), minimum.state, _log_evidence(chain, minimum, cameras) + gain)


def _log_evidence(chain: Chain, minimum: Minimum[ChainState], cameras: tuple[FloatArray, FloatArray, FloatArray] | None) -> float:
    """Return the logarithm of the evidence by Laplace's approximation, but for what stays the same for all scatters of stops.

    Parameters
    ----------
    cameras : as for `evidence_of`
    """
    hessian, cost = minimum.hessian, minimum.cost
    if cameras is not None:
        mixed, own, pulled = cameras
        hessian = np.block([[hessian, mixed], [mixed.T, own]])
        slope = np.concatenate([np.zeros(len(mixed)), pulled])
        cost -= float(slope @ np.linalg.solve(hessian, slope))
    return float(np.sum(np.linalg.slogdet(chain.roots)[1]) - 0.5 * np.linalg.slogdet(hessian)[1] - 0.5 * cost)


def explained_mm(chain: Chain, state: ChainState) -> float:
    """Return by how much the error motions move the board in the camera between the sightings, rms about their mean; 0 without any."""
    if chain.motions is None:
        return 0.0
    still = replace(state, motions=np.zeros_like(state.motions))
    shifts = change_between(chain.predict(still), chain.predict(state))[:, 3:]
    return float(np.sqrt(np.mean(np.sum((shifts - shifts.mean(axis=0)) ** 2, axis=1))))
