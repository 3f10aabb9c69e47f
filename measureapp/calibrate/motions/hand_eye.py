"""Hand-eye calibration (AX = XB) and robot-world/hand-eye calibration (AX = ZB): seven closed-form solutions, then a joint refinement."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import partial

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.boards.pose import BoardPose
from measureapp.calibrate.least_squares import Minimum
from measureapp.calibrate.motions.axis_noise import AxisNoise
from measureapp.calibrate.motions.chain import POSE_LABELS, Chain, Free, poses_of, roots_of
from measureapp.calibrate.motions.chain_state import ChainState
from measureapp.calibrate.motions.hand_eye_methods import METHODS
from measureapp.calibrate.motions.pose_checks import board_deviations, check_board_size, check_direction, check_units
from measureapp.calibrate.motions.propagation import add_camera_covariance, camera_sensitivity, marginal_cost
from measureapp.calibrate.motions.relative import Degeneracy, motions_between
from measureapp.calibrate.motions.robot_world import ROBOT_WORLD_METHODS
from measureapp.calibrate.poses import mean_pose, stack_matrices
from measureapp.data.calibration import HandEye, LabelledCovariance
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalise
from measureapp.progress import NoProgress, Progress

LEAST_POSES = 3
ADVISED_POSES = 10
LARGEST_RATIO = 2.0  # of the residuals over what was expected, as in the joint calibration of the rig


@dataclass(frozen=True, slots=True, eq=False)
class HandEyeProblem:
    """Robot poses with the board pose observed at each; the board does not move."""

    base_from_flange: tuple[RigidTransform, ...]
    boards: tuple[BoardPose, ...]
    noise: AxisNoise = field(default_factory=AxisNoise)
    camera_jacobian: FloatArray | None = None  # (N, 6, C), change of the board poses with the parameters of ``camera_prior``
    camera_prior: LabelledCovariance | None = None  # covariance of the camera parameters


@dataclass(frozen=True, slots=True, eq=False)
class HandEyeEstimate:
    """X by one method, with the scatter of the board in the base frame."""

    flange_from_camera: RigidTransform
    residual_mm: FloatArray  # (N,), distance of the board's origin from its mean place
    residual_rad: FloatArray  # (N,), turn against its mean orientation


@dataclass(frozen=True, slots=True, eq=False)
class HandEyeSolution:
    """X by every method that has an answer, refined, and how far the motions are from degenerate."""

    methods: Mapping[str, HandEyeEstimate]
    refused: Mapping[str, str]
    refined: HandEyeEstimate
    hand_eye: HandEye
    standard_deviations: Mapping[str, float]
    covariance: FloatArray  # (6, 6) of the refined X: rotation (rad), translation (mm) in the flange frame
    base_from_board: RigidTransform
    degeneracy: Degeneracy
    spread_mm: float  # largest distance between the methods' translations
    part_in_camera_mm: FloatArray  # (3,), a point in front of the camera as far away as the board was, in place of the part
    spread_at_part_mm: float  # largest distance between that point transformed to the flange by each method
    influence_mm: FloatArray  # (N,), displacement of that point in the flange frame without the pose (leave-one-out)
    sigma_ratio: float  # residuals over those expected of robot and images; about 1 where the stated noise is right
    chain: Chain
    minimum: Minimum[ChainState]

    @property
    def warnings(self) -> tuple[str, ...]:
        """Objections in addition to its covariance."""
        if self.sigma_ratio <= LARGEST_RATIO:
            return ()
        return (
            f"The residuals are {self.sigma_ratio:.1f} times as large as expected: the board moved, the robot is less accurate than stated, or "
            "robot poses belong to other images. Check that the board is fixed, state the robot's errors, or take the poses again.",
        )


def shortfalls(problem: HandEyeProblem) -> tuple[str, ...]:
    """Say what a problem still lacks to determine the hand-eye transform well."""
    count = len(problem.boards)
    if count < LEAST_POSES:
        return (f"{LEAST_POSES - count} more poses are needed.",)
    try:
        _, degeneracy = motions_between(stack_matrices(problem.base_from_flange), poses_of(problem.boards))
    except CalibrationError as error:
        return (str(error),)
    missing = () if degeneracy.verdict == "good" else (f"The motions are {degeneracy.verdict}.",)
    few = ADVISED_POSES - count
    return (*missing, f"{few} more poses would average the robot's errors better.") if few > 0 else missing


def solve(problem: HandEyeProblem, progress: Progress | None = None) -> HandEyeSolution:
    """Find flange_from_camera by Tsai-Lenz, Park-Martin, Horaud, Daniilidis, Andreff, Shah and Li-Wang-Wu, then refine it.

    The refinement minimises the errors of the board poses (weighted by their information) and of the robot poses (by
    ``noise``) over X, the board's place and one error per robot pose. Where board poses come from images, their
    information contains the pixel noise of all cameras.

    Raises
    ------
    CalibrationError
        Fewer than three poses, parallel rotation axes, poses in metres, or poses given the wrong way round.
    """
    progress = progress or NoProgress()
    robot, camera = stack_matrices(problem.base_from_flange), poses_of(problem.boards)
    if len(robot) != len(camera):
        raise CalibrationError(f"{len(robot)} robot poses do not belong to {len(camera)} board poses.", "Give one of each per position.")
    motions, degeneracy = motions_between(robot, camera)
    check_units(camera, motions)
    check_direction(robot, camera)
    check_board_size(robot, camera, motions)
    methods, refused = {}, {}
    solvers: dict[str, Callable[[], FloatArray]] = {name: partial(method, motions) for name, method in METHODS.items()}
    solvers |= {name: partial(_without_board, method, robot, camera) for name, method in ROBOT_WORLD_METHODS.items()}
    for done, (name, solver) in enumerate(solvers.items()):
        progress.report(done, len(solvers) + 1, name)
        try:
            methods[name] = _estimate(solver(), robot, camera)
        except CalibrationError as error:
            refused[name] = str(error)
    progress.report(len(solvers), len(solvers) + 1, "refining")
    best = min(methods.values(), key=lambda estimate: float(np.mean(estimate.residual_mm)))
    solution = _refine(problem, best, methods, refused, degeneracy)
    progress.report(1, 1)
    return solution


def _without_board(
    method: Callable[[FloatArray, FloatArray], tuple[FloatArray, FloatArray]], robot: FloatArray, camera: FloatArray
) -> FloatArray:
    return method(robot, camera)[0]


def _refine(
    problem: HandEyeProblem,
    start: HandEyeEstimate,
    methods: Mapping[str, HandEyeEstimate],
    refused: Mapping[str, str],
    degeneracy: Degeneracy,
) -> HandEyeSolution:
    robot, camera = stack_matrices(problem.base_from_flange), poses_of(problem.boards)
    count = len(robot)
    chain = Chain(
        base_from_flange=robot,
        guide_mm=np.zeros(count),
        table_rad=np.zeros(count),
        camera_from_board=camera,
        roots=roots_of(problem.boards),
        robot_group=np.arange(count),
        table_group=np.zeros(count, np.intp),
        noise=problem.noise,
        free=Free(guide=False, axis=False),
        camera_jacobian=problem.camera_jacobian,
    )
    x = start.flange_from_camera.matrix
    board = mean_pose(robot @ x @ camera)
    minimum = chain.adjust(
        ChainState(x, np.array([0.0, 1, 0]), 1.0, np.zeros(3), np.array([0.0, 0, 1]), board, np.zeros((count, 6)), np.zeros(0))
    )
    beyond = marginal_cost(chain, minimum, minimum.covariance(1.0), problem.camera_prior)
    variance = max(beyond / max(chain.freedom(), 1), 1.0)
    covariance = minimum.covariance(variance)
    camera_jacobian = camera_sensitivity(chain, minimum, covariance, variance)
    covariance = add_camera_covariance(covariance, camera_jacobian, problem.camera_prior)[:6, :6]
    deviations = np.sqrt(np.diag(covariance))
    refined = _estimate(minimum.state.flange_from_camera, robot, camera)
    hand_eye = HandEye(
        refined.flange_from_camera,
        rotation_sigma_rad=float(deviations[:3].max()),
        translation_sigma_mm=float(deviations[3:].max()),
        residual_mm=float(np.sqrt(np.mean(refined.residual_mm**2))),
        residual_rad=float(np.sqrt(np.mean(refined.residual_rad**2))),
        method="joint refinement",
    )
    part = np.array([0.0, 0.0, float(np.median(np.linalg.norm(camera[:, :3, 3], axis=1)))])
    return HandEyeSolution(
        methods=methods,
        refused=refused,
        refined=refined,
        hand_eye=hand_eye,
        standard_deviations=dict(zip(POSE_LABELS, (float(value) for value in deviations), strict=True)),
        covariance=covariance,
        base_from_board=RigidTransform(orthonormalise(minimum.state.guide_from_board), "base", "board"),
        degeneracy=degeneracy,
        spread_mm=_spread([estimate.flange_from_camera.translation_mm for estimate in methods.values()]),
        part_in_camera_mm=part,
        spread_at_part_mm=_spread([estimate.flange_from_camera.apply(part) for estimate in methods.values()]),
        influence_mm=_influence(chain, minimum, part),
        sigma_ratio=float(np.sqrt(beyond / max(chain.freedom(), 1))),
        chain=chain,
        minimum=minimum,
    )


def _spread(points_mm: Sequence[FloatArray]) -> float:
    """Return the largest distance between two of the points."""
    points = np.array(points_mm)
    return float(np.max(np.linalg.norm(points[:, None] - points[None], axis=2)))


def _influence(chain: Chain, minimum: Minimum[ChainState], part_in_camera_mm: FloatArray) -> FloatArray:
    """Leave-one-out influence (N,): displacement of a point at the part without each sighting, by one Gauss-Newton step, mm."""
    jacobian, residual = chain.jacobian(minimum.state), chain.residuals(minimum.state)
    turn = minimum.state.flange_from_camera[:3, :3] @ part_in_camera_mm
    moves = []
    for first in range(0, 6 * len(chain.guide_mm), 6):
        own = jacobian[first : first + 6]
        step = np.linalg.solve(minimum.hessian - own.T @ own, own.T @ residual[first : first + 6])
        moves.append(np.linalg.norm(np.cross(step[:3], turn) + step[3:6]))
    return np.array(moves)


def _estimate(x: FloatArray, robot: FloatArray, camera: FloatArray) -> HandEyeEstimate:
    length, angle = board_deviations(x, robot, camera)
    return HandEyeEstimate(RigidTransform(orthonormalise(x), "flange", "camera"), length, angle)
