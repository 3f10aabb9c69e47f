"""Optimal design of robot poses: the next pose that adds most information on the hand-eye transform."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.motions.chain import Chain
from measureapp.calibrate.motions.chain_derivatives import derivatives
from measureapp.calibrate.motions.chain_state import POSE, ChainState
from measureapp.calibrate.motions.hand_eye import HandEyeSolution
from measureapp.calibrate.poses import stack_matrices
from measureapp.calibrate.projection import cross_matrices
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform

Criterion = Literal["part", "A", "D"]
CHOSEN = 2 * POSE  # hand-eye transform and place of the board


@dataclass(frozen=True, slots=True, eq=False)
class Proposal:
    """The gain of a candidate pose."""

    candidate: int  # its index
    base_from_flange: RigidTransform
    sigma_at_part_mm: float  # predicted, the largest over all directions, with this pose added
    gain: float  # relative decrease of the criterion: variance at the part, trace, or sixth root of the determinant


def propose(
    solution: HandEyeSolution,
    candidates: Sequence[RigidTransform],
    *,
    information: FloatArray | None = None,
    criterion: Criterion = "part",
) -> tuple[Proposal, ...]:
    """Order candidate poses by what they add to the Fisher information of the hand-eye transform, the best first.

    A further sighting adds Jᵀ (Σ_board + E Σ_robot Eᵀ)⁻¹ J to the information of hand-eye transform and board, with J and E the
    derivatives of the observed board pose [1]_. The criterion is the largest variance of a point at the part (``part``, E-optimal
    there), the mean one (``A``) or the volume of the hand-eye transform's confidence ellipsoid (``D``).

    Parameters
    ----------
    candidates : base_from_flange of poses the robot can reach and from which the board is visible
    information : (6, 6) of a future board pose; default: the mean of the present ones

    Raises
    ------
    CalibrationError
        No candidates.

    References
    ----------
    .. [1] V. V. Fedorov, Theory of Optimal Experiments, Academic Press 1972, chapter 2.
    """
    if not candidates:
        raise CalibrationError("There are no candidate poses.", "Give poses the robot can reach and from which the board is visible.")
    chain, state = solution.chain, solution.minimum.state
    if information is None:
        information = np.mean(np.swapaxes(chain.roots, 1, 2) @ chain.roots, axis=0)
    known = np.linalg.inv(solution.minimum.covariance()[:CHOSEN, :CHOSEN])
    lever = lever_at(solution.part_in_camera_mm, state)
    before = _value(np.linalg.inv(known), lever, criterion)
    added = _added_information(chain, state, stack_matrices(candidates), information)
    proposals = []
    for index, (candidate, covariance) in enumerate(zip(candidates, np.linalg.inv(known + added), strict=True)):
        sigma = float(np.sqrt(np.linalg.eigvalsh(lever @ covariance[:POSE, :POSE] @ lever.T)[-1]))
        proposals.append(Proposal(index, candidate, sigma, 1 - _value(covariance, lever, criterion) / before))
    return tuple(sorted(proposals, key=lambda proposal: -proposal.gain))


def lever_at(point_in_camera_mm: FloatArray, state: ChainState) -> FloatArray:
    """Return the derivatives (3, 6) of a point in the camera frame with respect to the hand-eye transform."""
    return np.hstack([-cross_matrices((state.flange_from_camera[:3, :3] @ point_in_camera_mm)[None])[0], np.eye(3)])


def _value(covariance: FloatArray, lever: FloatArray, criterion: Criterion) -> float:
    own = covariance[:POSE, :POSE]
    at_part = lever @ own @ lever.T
    if criterion == "part":
        return float(np.linalg.eigvalsh(at_part)[-1])
    return float(np.trace(at_part)) if criterion == "A" else float(np.exp(np.linalg.slogdet(own)[1] / POSE))


def _added_information(chain: Chain, state: ChainState, candidates: FloatArray, information: FloatArray) -> FloatArray:
    """Return the information (N, 12, 12) of hand-eye transform and board in one more sighting from each of the candidates (N, 4, 4)."""
    still = np.zeros(len(candidates))
    by = derivatives(state, candidates, still, still, np.zeros((len(candidates), POSE)))
    noise = chain.noise
    robot = np.diag([noise.robot_rad**2 + noise.robot_repeat_rad**2] * 3 + [noise.robot_mm**2 + noise.robot_repeat_mm**2] * 3)
    weight = np.linalg.inv(np.linalg.inv(information) + by.robot @ robot @ np.swapaxes(by.robot, 1, 2))
    named = np.concatenate([by.hand_eye, by.board], axis=2)
    return np.asarray(np.swapaxes(named, 1, 2) @ weight @ named)
