"""Where the reference camera sits on the flange: five closed solutions side by side, then a joint refinement."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from measureapp.arrays import FloatArray
from measureapp.calibrate.board_pose import BoardPose
from measureapp.calibrate.chain import POSE_LABELS, AxisNoise, Chain, ChainState, Free, poses_of, roots_of
from measureapp.calibrate.hand_eye_methods import METHODS, park_martin
from measureapp.calibrate.motions import Degeneracy, Motions, motions_between
from measureapp.calibrate.poses import change_between, inverted, mean_pose, stacked
from measureapp.data.calibration import HandEye
from measureapp.errors import CalibrationError
from measureapp.geometry.transform import RigidTransform, orthonormalised
from measureapp.progress import NoProgress, Progress

LEAST_POSES = 3
ADVISED_POSES = 10
SWAPPED_SHARE = 0.3  # inverted poses that fit better than this share of the residual were given the wrong way round
LEAST_SWAPPED_MM = 1.0
METRE_SCALES = (100.0, 0.01)
SHORTEST_DISTANCE_MM = 5.0


@dataclass(frozen=True, slots=True, eq=False)
class HandEyeProblem:
    """Robot poses with the board pose seen at each; the board stands still."""

    base_from_flange: tuple[RigidTransform, ...]
    boards: tuple[BoardPose, ...]
    noise: AxisNoise = field(default_factory=AxisNoise)


@dataclass(frozen=True, slots=True, eq=False)
class HandEyeEstimate:
    """X by one method, and how constant the board stays in the base frame with it."""

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


class HandEyeDraft:
    """Collects poses until they determine the hand-eye transform."""

    def __init__(self, noise: AxisNoise | None = None) -> None:
        self._noise = noise or AxisNoise()
        self._pairs: list[tuple[RigidTransform, BoardPose]] = []

    def add(self, base_from_flange: RigidTransform, board: BoardPose) -> None:
        """Add one pose of the robot with the board pose seen there."""
        self._pairs.append((base_from_flange, board))

    def remove(self, index: int) -> None:
        """Take a pose out again."""
        del self._pairs[index]

    def shortfalls(self) -> tuple[str, ...]:
        """Say what is still missing."""
        if len(self._pairs) < LEAST_POSES:
            return (f"{LEAST_POSES - len(self._pairs)} more poses are needed.",)
        try:
            problem = self.problem()
            _, degeneracy = motions_between(stacked(problem.base_from_flange), poses_of(problem.boards))
        except CalibrationError as error:
            return (str(error),)
        missing = () if degeneracy.verdict == "good" else (f"The motions are {degeneracy.verdict}.",)
        few = ADVISED_POSES - len(self._pairs)
        return (*missing, f"{few} more poses would average the robot's errors better.") if few > 0 else missing

    def problem(self) -> HandEyeProblem:
        """Return what was collected."""
        return HandEyeProblem(tuple(flange for flange, _ in self._pairs), tuple(board for _, board in self._pairs), self._noise)


def solve(problem: HandEyeProblem, progress: Progress | None = None) -> HandEyeSolution:
    """Find flange_from_camera by Tsai-Lenz, Park-Martin, Horaud, Daniilidis and Andreff, then refine it.

    The refinement minimises the errors of the board poses (weighted by their information) and of the robot poses (by
    ``noise``) over X, the board's place and one error per robot pose. Where board poses come from images, their
    information carries the pixel errors of all cameras.

    Raises
    ------
    CalibrationError
        Fewer than three poses, parallel rotation axes, poses in metres, or poses given the wrong way round.
    """
    progress = progress or NoProgress()
    robot, camera = stacked(problem.base_from_flange), poses_of(problem.boards)
    if len(robot) != len(camera):
        raise CalibrationError(f"{len(robot)} robot poses do not belong to {len(camera)} board poses.", "Give one of each per position.")
    motions, degeneracy = motions_between(robot, camera)
    _check_units(camera, motions)
    _check_direction(robot, camera)
    methods, refused = {}, {}
    for done, (name, method) in enumerate(METHODS.items()):
        progress.report(done, len(METHODS) + 1, name)
        try:
            methods[name] = _estimate(method(motions), robot, camera)
        except CalibrationError as error:
            refused[name] = str(error)
    progress.report(len(METHODS), len(METHODS) + 1, "refining")
    best = min(methods.values(), key=lambda estimate: float(np.mean(estimate.residual_mm)))
    solution = _refined(problem, best, methods, refused, degeneracy)
    progress.report(1, 1)
    return solution


def _refined(
    problem: HandEyeProblem,
    start: HandEyeEstimate,
    methods: Mapping[str, HandEyeEstimate],
    refused: Mapping[str, str],
    degeneracy: Degeneracy,
) -> HandEyeSolution:
    robot, camera = stacked(problem.base_from_flange), poses_of(problem.boards)
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
    )
    x = start.flange_from_camera.matrix
    board = mean_pose(robot @ x @ camera)
    minimum = chain.adjusted(
        ChainState(x, np.array([0.0, 1, 0]), 1.0, np.zeros(3), np.array([0.0, 0, 1]), board, np.zeros((count, 6)), np.zeros(0))
    )
    variance = minimum.cost / max(chain.freedom(), 1)
    covariance = minimum.covariance(max(variance, 1.0))[:6, :6]
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
    places = np.array([estimate.flange_from_camera.translation_mm for estimate in methods.values()])
    return HandEyeSolution(
        methods=methods,
        refused=refused,
        refined=refined,
        hand_eye=hand_eye,
        standard_deviations=dict(zip(POSE_LABELS, (float(value) for value in deviations), strict=True)),
        covariance=covariance,
        base_from_board=RigidTransform(orthonormalised(minimum.state.guide_from_board), "base", "board"),
        degeneracy=degeneracy,
        spread_mm=float(np.max(np.linalg.norm(places[:, None] - places[None], axis=2))),
    )


def _estimate(x: FloatArray, robot: FloatArray, camera: FloatArray) -> HandEyeEstimate:
    length, angle = _deviations(x, robot, camera)
    return HandEyeEstimate(RigidTransform(orthonormalised(x), "flange", "camera"), length, angle)


def _deviations(x: FloatArray, robot: FloatArray, camera: FloatArray) -> tuple[FloatArray, FloatArray]:
    boards = robot @ x @ camera
    change = change_between(np.broadcast_to(mean_pose(boards), boards.shape), boards)
    return np.linalg.norm(change[:, 3:], axis=1), np.linalg.norm(change[:, :3], axis=1)


def _check_units(camera: FloatArray, motions: Motions) -> None:
    distance = float(np.median(np.linalg.norm(camera[:, :3, 3], axis=1)))
    if distance < SHORTEST_DISTANCE_MM:
        raise CalibrationError(f"The board poses put the board {distance:.3f} mm from the camera.", "They seem to be in metres: give mm.")
    rotation = park_martin(motions)[:3, :3]
    rows = np.concatenate([motions.flange[:, :3, :3] - np.eye(3), motions.flange[:, :3, 3:]], axis=2).reshape(-1, 4)
    right = (motions.camera[:, :3, 3] @ rotation.T).ravel()
    scale = float(np.linalg.lstsq(rows, right, rcond=None)[0][3])
    if scale > METRE_SCALES[0] or 0 < scale < METRE_SCALES[1]:
        which = "robot" if scale > 1 else "board"
        raise CalibrationError(
            f"The translations of the {which} poses are about {max(scale, 1 / scale):.0f} times too small for those of the others.",
            f"The {which} poses seem to be in metres: give mm.",
        )


def _check_direction(robot: FloatArray, camera: FloatArray) -> None:
    """Refuse poses given as their inverses. Raises CalibrationError.

    Inverting the robot poses or the board poses spoils A X = X B in the same way; only the board's place before the camera
    tells which. Inverting both leaves an equation of the same form.
    """
    hint = "Give base_from_flange for the robot and camera_from_board for the board."
    distance = camera[:, 2, 3]
    own = _misfit(robot, camera)
    spoiled = own > LEAST_SWAPPED_MM and _misfit(inverted(robot), camera) < SWAPPED_SHARE * own
    if np.all(distance <= 0) or (spoiled and np.median(distance) <= 0):
        raise CalibrationError("The board lies behind the camera: the board poses seem to be board_from_camera.", hint)
    if spoiled:
        raise CalibrationError("The robot poses seem to be flange_from_base (or the board poses board_from_camera).", hint)


def _misfit(robot: FloatArray, camera: FloatArray) -> float:
    """Return how much the board moves in the base frame with Park's solution, mm; infinite without one."""
    try:
        motions, _ = motions_between(robot, camera)
    except CalibrationError:
        return float("inf")
    return float(np.mean(_deviations(park_martin(motions), robot, camera)[0]))
