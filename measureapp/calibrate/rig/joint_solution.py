"""From the minimum of the joint problem to the calibrated rig, with one labelled covariance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.cameras.prior import perturb_cameras
from measureapp.calibrate.least_squares import Minimum
from measureapp.calibrate.motions.axis_noise import SAME_POSE
from measureapp.calibrate.motions.chain import POSE_LABELS, Chain, groups_of
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.calibrate.motions.linear_guide import paper_error_mm
from measureapp.calibrate.motions.propagation import add_camera_covariance, camera_sensitivity, marginal_cost
from measureapp.calibrate.poses import apply_changes, change_between
from measureapp.calibrate.rig.doubts import doubts
from measureapp.calibrate.rig.motion_scales import explained_mm, variance_of
from measureapp.calibrate.rig.observability import WeakDirection, unobservable, weakest
from measureapp.calibrate.rig.stages import RigStages
from measureapp.data.calibration import (
    CameraArrayCalibration,
    HandEye,
    LabelledCovariance,
    LinearGuide,
    Provenance,
    RigCalibration,
    RobotStation,
    RotationAxis,
)
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalise

LEAST_SLIDES = 3


@dataclass(frozen=True, slots=True, eq=False)
class RigResidual:
    """Residual of an observed board pose against the chain."""

    name: str
    distance_mm: float
    angle_deg: float
    robot_error_mm: float  # estimated error of the robot's pose
    robot_error_deg: float


@dataclass(frozen=True, slots=True, eq=False)
class RigSolution:
    """The calibrated rig with residuals and unobservable parameters."""

    calibration: RigCalibration
    stages: RigStages  # the solution stage by stage, which the joint one started from
    residuals: tuple[RigResidual, ...]
    rejected: dict[str, str]  # observation -> reason
    standard_deviations: dict[str, float]
    parameters: tuple[str, ...]  # rows of `covariance`
    covariance: FloatArray
    joint_parameters: tuple[
        str, ...
    ]  # rows of `joint_covariance`: `parameters`, then errors of every approach and angle, error motions, cameras
    joint_covariance: FloatArray
    joint_given_cameras: FloatArray  # the same for cameras without error: for differences in which their common error cancels
    chain: Chain
    state: ChainState
    paper_cost_mm: float  # error over the travel of these sightings if the guide is assumed to run along +Y with scale 1, as in the paper
    sigma_ratio: float  # residuals over those expected; about 1 where the stated noise is right
    guide_from_board: RigidTransform  # the board's place with the table at 0
    weak_directions: tuple[WeakDirection, ...] = ()
    not_observable: tuple[str, ...] = ()
    warnings: tuple[str, ...] = ()
    cameras: LabelledCovariance | None = None  # covariance of the camera parameters; None where they were estimated or it is not known
    camera_jacobian: FloatArray | None = None  # (P, C), how the rows of `joint_given_cameras` follow the parameters of `cameras`


def solution_of(
    chain: Chain,
    minimum: Minimum[ChainState],
    names: Sequence[str],
    cameras: CameraArrayCalibration,
    stages: RigStages,
    *,
    rejected: dict[str, str],
    not_seen: tuple[str, ...],
    camera_prior: LabelledCovariance | None,
) -> RigSolution:
    """Return the calibrated rig at the minimum of ``chain``.

    Raises
    ------
    CalibrationError
        Some parameters change no residual; the message names them.
    """
    state = minimum.state
    plain = _given_cameras(chain, minimum, 1.0)
    ratio = float(np.sqrt(marginal_cost(chain, minimum, plain, camera_prior) / max(chain.freedom(), 1)))
    variance = variance_of(ratio, chain.freedom())
    given_cameras = plain * variance
    camera_jacobian = None if camera_prior is None else camera_sensitivity(chain, minimum, given_cameras, variance)
    joint = add_camera_covariance(given_cameras, camera_jacobian, camera_prior)
    covariance = joint[: len(chain.labels), : len(chain.labels)]
    if camera_prior is not None and chain.cameras_freed:
        cameras = perturb_cameras(cameras, camera_prior.parameters, state.camera_changes)
    deviations = dict(zip(chain.labels, np.sqrt(np.diag(covariance)).tolist(), strict=True))
    change = change_between(chain.camera_from_board, chain.predict(state))
    distances, angles = np.linalg.norm(change[:, 3:], axis=1), np.linalg.norm(change[:, :3], axis=1)
    motions = None if chain.motions is None else chain.motions.motions(state.motions, explained_mm(chain, state))
    return RigSolution(
        calibration=RigCalibration(
            cameras,
            _hand_eye(state, deviations, distances, angles),
            _guide(state, deviations, _straightness(chain, distances)),
            _axis(state, deviations, covariance, chain.labels, distances),
            Provenance(method="joint calibration of the rig"),
            _stations(chain, state),
            motions=motions,
        ),
        stages=stages,
        residuals=_residuals(names, distances, angles, state.robot_changes[chain.robot_group]),
        rejected=rejected,
        standard_deviations=deviations,
        parameters=chain.labels,
        covariance=covariance,
        joint_parameters=_joint_labels(chain, camera_prior),
        joint_covariance=joint,
        joint_given_cameras=given_cameras,
        chain=chain,
        state=state,
        paper_cost_mm=paper_error_mm(state.guide_direction, state.guide_scale) * float(np.ptp(chain.guide_mm)),
        sigma_ratio=ratio,
        guide_from_board=RigidTransform(orthonormalise(state.guide_from_board), "guide", "board"),
        weak_directions=weakest(covariance, chain.labels),
        not_observable=not_seen,
        warnings=doubts(ratio, motions, chain.noise),
        cameras=None if camera_jacobian is None else camera_prior,
        camera_jacobian=camera_jacobian,
    )


def _hand_eye(state: ChainState, deviations: dict[str, float], distances: FloatArray, angles: FloatArray) -> HandEye:
    return HandEye(
        RigidTransform(orthonormalise(state.flange_from_camera), "flange", "camera"),
        rotation_sigma_rad=_largest(deviations, "hand_eye.rotation"),
        translation_sigma_mm=_largest(deviations, "hand_eye.x_mm", "hand_eye.y_mm", "hand_eye.z_mm"),
        residual_mm=float(np.sqrt(np.mean(distances**2))),
        residual_rad=float(np.sqrt(np.mean(angles**2))),
        method="joint calibration of the rig",
    )


def _given_cameras(chain: Chain, minimum: Minimum[ChainState], variance: float) -> FloatArray:
    try:
        return minimum.covariance(variance)
    except CalibrationError as error:
        lost = "; ".join(direction.sentence for direction in unobservable(minimum.hessian, chain.labels)) or error.message
        raise CalibrationError(f"The observations do not determine the rig: {lost}.", error.hint) from error


def _joint_labels(chain: Chain, camera_prior: LabelledCovariance | None) -> tuple[str, ...]:
    robot = tuple(f"robot {number + 1}.{label}" for number in range(chain.robot_poses) for label in POSE_LABELS)
    table = tuple(f"table {number + 1}.angle_rad" for number in range(chain.table_angles))
    motions = tuple(f"error motion {number + 1}" for number in range(len(chain.motion_rows)))
    cameras = camera_prior.parameters if camera_prior is not None and chain.cameras_freed else ()
    return (*chain.labels, *robot, *table, *motions, *cameras)


def _residuals(names: Sequence[str], distances: FloatArray, angles: FloatArray, robot: FloatArray) -> tuple[RigResidual, ...]:
    return tuple(
        RigResidual(
            name, float(distance), float(np.rad2deg(angle)), float(np.linalg.norm(error[3:])), float(np.rad2deg(np.linalg.norm(error[:3])))
        )
        for name, distance, angle, error in zip(names, distances, angles, robot, strict=True)
    )


def repeatable_errors(chain: Chain, poses: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return how the errors at ``poses`` (V, 4, 4) follow from those of the approaches: gains (V, G) of rotations and of translations.

    The best linear prediction k K⁻¹ of what repeats, from approaches that scatter [1]_.

    References
    ----------
    .. [1] C. E. Rasmussen, C. K. I. Williams, Gaussian Processes for Machine Learning, MIT Press 2006, eq. 2.25.
    """
    correlation = chain.noise.correlation(poses, chain.approach_poses)
    turn, shift = chain.noise.robot_covariances(chain.approach_poses)
    noise = chain.noise
    return np.linalg.solve(turn, noise.robot_rad**2 * correlation.T).T, np.linalg.solve(shift, noise.robot_mm**2 * correlation.T).T


def _stations(chain: Chain, state: ChainState) -> tuple[RobotStation, ...]:
    """Return every robot pose with its estimated repeatable error, common to its approaches."""
    approach_poses = chain.approach_poses
    same = groups_of(approach_poses[:, :3].reshape(-1, 12), SAME_POSE)
    poses = approach_poses[np.unique(same, return_index=True)[1]]
    turn, shift = repeatable_errors(chain, poses)
    errors = apply_changes(
        np.tile(np.eye(4), (len(poses), 1, 1)), np.hstack([turn @ state.robot_changes[:, :3], shift @ state.robot_changes[:, 3:]])
    )
    return tuple(
        RobotStation(RigidTransform(pose, "base", "flange"), RigidTransform(orthonormalise(pose @ error), "base", "flange"))
        for pose, error in zip(poses, errors, strict=True)
    )


def _straightness(chain: Chain, distances_mm: FloatArray) -> float:
    """Return the rms distance from the straight line over slides with one robot pose, where its error cannot enter; 0 without such."""
    slid = [
        distances_mm[chain.robot_group == number]
        for number in range(chain.robot_poses)
        if len(np.unique(chain.guide_mm[chain.robot_group == number])) >= LEAST_SLIDES
    ]
    return float(np.sqrt(np.mean(np.concatenate(slid) ** 2))) if slid else 0.0


def _largest(deviations: dict[str, float], *starts: str) -> float:
    return max((value for name, value in deviations.items() if name.startswith(starts)), default=0.0)


def _guide(state: ChainState, deviations: dict[str, float], straightness_mm: float) -> LinearGuide:
    return LinearGuide(
        state.guide_direction,
        state.guide_scale,
        direction_sigma_rad=_largest(deviations, "guide.direction"),
        scale_sigma=_largest(deviations, "guide.scale"),
        straightness_mm=straightness_mm,
    )


def _axis(
    state: ChainState, deviations: dict[str, float], covariance: FloatArray, labels: tuple[str, ...], distances: FloatArray
) -> RotationAxis:
    """Return the axis with its point next to the board, where its position is most certain."""
    along = float(state.axis_direction @ (state.guide_from_board[:3, 3] - state.axis_point_mm))
    rows = [labels.index(f"axis.{name}") for name in ("direction_1_rad", "direction_2_rad", "point_1_mm", "point_2_mm")]
    carry = np.hstack([along * np.eye(2), np.eye(2)])
    point_covariance = carry @ covariance[np.ix_(rows, rows)] @ carry.T
    return RotationAxis(
        state.axis_point_mm + along * state.axis_direction,
        state.axis_direction,
        "guide",
        point_sigma_mm=float(np.sqrt(np.linalg.eigvalsh(point_covariance)[-1])),
        direction_sigma_rad=_largest(deviations, "axis.direction"),
        residual_mm=float(np.sqrt(np.mean(distances**2))),
    )
